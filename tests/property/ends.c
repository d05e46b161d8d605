/* SPDX-License-Identifier: Apache-2.0
 *
 * Open ends of cells: as much darker as asked for, on end grain and, for rays, on the
 * tangential face; nothing on faces along them, nor where no normal says how a face lies.
 * Checks of end grain: as many and as long as asked for, from the pith outwards.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

#define PLAIN                                                                                      \
  "pith_wander=0; undulation=0; section_wobble=0; slope_noise=0; taper=0; porosity=none; "         \
  "fibre_brightness=0; specular=0; "
#define PI 3.14159265358979
enum { POINTS = 400 };

/* Albedos at the same points of a tangential face's wood, the normal `along` the stem and else
 * along the radius or, at `round`, round it. */
static void ask(sozai_texture *t, double along, int round, float albedo[POINTS][3], float *ray) {
  points p = {0};
  double rest = sqrt(1 - along * along);
  for (int i = 0; i < POINTS; i++) {
    double a = 0.011 * i, c = cos(a), s = sin(a);
    unsigned n = points_add(&p, 60 * c, 0.37 * i, 60 * s, 0);
    p.normal[0][n] = (float)(rest * (round ? -s : c));
    p.normal[1][n] = (float)along;
    p.normal[2][n] = (float)(rest * (round ? c : s));
  }
  points_ask(&p, t);
  for (int i = 0; i < POINTS; i++) {
    for (int c = 0; c < 3; c++) albedo[i][c] = p.out[ALBEDO + c][i];
    if (ray) ray[i] = p.out[RAY][i];
  }
  points_free(&p);
}

static float before[POINTS][3], after[POINTS][3], ray[POINTS];

static void end_grain_is_darker(void **state) {
  (void)state;
  for (int k = 1; k <= 3; k++) {
    char text[512];
    double shade = 0.3 * k;
    snprintf(text, sizeof text,
             PLAIN "ray_density=0; earlywood_colour=0.7 0.5 0.3 @ lin_rec709; "
                   "latewood_colour=0.7 0.5 0.3 @ lin_rec709; heartwood_years=100000; end_shade=%g",
             shade);
    sozai_texture *t = wood_make(NULL, text);
    double worst = 0;
    ask(t, 0, 0, before, NULL);
    ask(t, 1, 0, after, NULL);
    for (int i = 0; i < POINTS; i++)
      for (int c = 0; c < 3; c++) {
        double a = (double)before[i][c];
        worst = fmax(worst, fabs((double)after[i][c] / a - (1 - shade)));
      }
    CHECK(worst < 1e-5, "shade %.1f: end grain %.4f %.4f %.4f of a face's, off by %.1e\n", shade,
          (double)(after[0][0] / before[0][0]), (double)(after[0][1] / before[0][1]),
          (double)(after[0][2] / before[0][2]), worst);
    textures->destroy(t);
  }
}

static void grows_with_the_turn(void **state) {
  (void)state;
  sozai_texture *t = wood_make(NULL, PLAIN "ray_density=0; end_shade=0.5");
  double last = 2;
  ask(t, 0, 0, before, NULL);
  ask(t, sin(0.0872), 0, after, NULL);
  assert_memory_equal(before, after, sizeof before);
  for (int degrees = 10; degrees <= 90; degrees += 10) {
    double share = 0;
    ask(t, sin(degrees * 0.017453293), 1, after, NULL);
    for (int i = 0; i < POINTS; i++) share += (double)(after[i][1] / before[i][1]) / POINTS;
    CHECK(share < last, "a face %d degrees off the fibres has %.4f of the light\n", degrees, share);
    last = share;
  }
  textures->destroy(t);
}

/* Rays look out of the tangential face, and lie along the radial one. */
static void rays_are_dark_on_the_tangential_face(void **state) {
  (void)state;
  sozai_texture *t =
      wood_make(NULL, PLAIN "ray_density=4; ray_height=2; ray_width=400; ray_shade=0.4; "
                            "ray_colour=0.6 0.6 0.6 @ lin_rec709");
  ask(t, 0, 1, before, ray);
  ask(t, 0, 0, after, ray);
  int rays = 0, others = 0;
  double worst = 0, beside = 0, wanted = 0.4;
  for (int i = 0; i < POINTS; i++) {
    double gone = (double)before[i][0] - (double)after[i][0];
    if (ray[i] > 0.2f) {
      rays++;
      worst = fmax(worst, fabs(gone / (0.6 * (double)ray[i]) - wanted));
    } else if (ray[i] == 0) {
      others++;
      beside = fmax(beside, fabs(gone));
    }
  }
  CHECK(rays > 20 && others > 20 && worst < 1e-4 && beside == 0,
        "%d in rays, %.4f of their light wanted gone, off by %.1e; %d beside them, off by %.1e\n",
        rays, wanted, worst, others, beside);
  textures->destroy(t);
}

/* No normal, no face: also where object space's +z, which a missing normal is read as elsewhere, is
 * the stem or the radius. */
static void nothing_without_normals(void **state) {
  (void)state;
  static const char *const cuts[][2] = {{"cut=end; end_shade=0.9", "cut=end; end_shade=0"},
                                        {"cut=flat; ray_shade=0.9", "cut=flat; ray_shade=0"}};
  static float point[3][20 * POINTS], albedo[2][20 * POINTS];
  for (int cut = 0; cut < 2; cut++) {
    for (int k = 0; k < 2; k++) {
      sozai_texture *t = wood_make("oak", cuts[cut][k]);
      float *out[ALBEDO + 2] = {0};
      sozai_batch in = {
          .size = sizeof in, .count = 20 * POINTS, .out = out, .out_count = ALBEDO + 2};
      for (int c = 0; c < 3; c++) {
        in.point[c] = point[c];
        for (int i = 0; i < 20 * POINTS; i++) point[c][i] = (float)(0.017 * i * (c + 1));
      }
      out[ALBEDO + 1] = albedo[k];
      assert_int_equal(textures->evaluate(t, &in), SOZAI_OK);
      textures->destroy(t);
    }
    assert_memory_equal(albedo[0], albedo[1], sizeof albedo[0]);
  }
}

/* Albedo over what it is without checks, along a circle or a radius of the section. */
static void walk(sozai_texture *t, double from, double angle, double step, int round, unsigned n,
                 double along, float *left) {
  points p = {0};
  for (unsigned i = 0; i < n; i++) {
    double r = from + (round ? 0 : i * step), a = angle + (round ? i * step / from : 0);
    unsigned j = points_add(&p, r * cos(a), 0, r * sin(a), 0);
    p.normal[0][j] = (float)(sqrt(1 - along * along) * cos(a));
    p.normal[1][j] = (float)along;
    p.normal[2][j] = (float)(sqrt(1 - along * along) * sin(a));
  }
  points_ask_only(&p, t, ONLY3(ALBEDO));
  for (unsigned i = 0; i < n; i++) left[i] = p.out[ALBEDO][i] / 0.7f;
  points_free(&p);
}

static void ends_check_as_asked_for(void **state) {
  (void)state;
  static const struct {
    double count, width, length;
  } cases[] = {{2, 1.5, 80}, {6, 0.8, 40}, {12, 0.5, 15}};
  static const double radii[] = {45, 97, 160};
  enum { SEEDS = 8, MOST = 60000 };
  float *left = malloc(MOST * sizeof *left);
  for (int k = 0; k < 3; k++) {
    double found = 0, want = 0, longest = 0, split = 0, points = 0;
    for (int seed = 1; seed <= SEEDS; seed++) {
      char text[640];
      snprintf(text, sizeof text,
               PLAIN "ray_density=0; end_shade=0; earlywood_colour=0.7 0.5 0.3 @ lin_rec709; "
                     "latewood_colour=0.7 0.5 0.3 @ lin_rec709; heartwood_years=100000; seed=%d; "
                     "end_checks=%g; end_check_width=%g; end_check_length=%g",
               seed, cases[k].count, cases[k].width, cases[k].length);
      sozai_texture *t = wood_make(NULL, text);
      for (int r = 0; r < 3; r++) {
        unsigned n = (unsigned)(2 * PI * radii[r] / 0.025);
        walk(t, radii[r], 0, 0.025, 1, n, 1, left);
        for (unsigned i = 0; i < n; i++) {
          found += left[i] < 0.5f && left[(i + n - 1) % n] >= 0.5f;
          split += left[i] < 0.5f;
        }
        points += n;
        want += cases[k].count * 0.01 * 2 * PI * radii[r];
        /* on a face along the fibre there are none */
        walk(t, radii[r], 0, 0.025, 1, n, 0, left);
        for (unsigned i = 0; i < n; i++) assert_true(left[i] > 0.99f);
      }
      for (int line = 0; line < 200; line++) {
        double run = 0;
        walk(t, 20, 0.0314 * line, 0.25, 0, 600, 1, left);
        for (unsigned i = 0; i < 600; i++) {
          run = left[i] < 0.5f ? run + 0.25 : 0;
          longest = fmax(longest, run);
        }
      }
      textures->destroy(t);
    }
    /* a line that a check sways off meets part of it */
    CHECK(fabs(found - want) < 3 * sqrt(want) + 0.08 * want && longest <= cases[k].length &&
              longest > 0.25 * cases[k].length &&
              split / points * 100 < 0.6 * cases[k].count * cases[k].width,
          "%g to 100 mm, %g wide, %g long: %.0f met, %.0f wanted; %.4f of the wood split, a radius "
          "along %.1f mm at most\n",
          cases[k].count, cases[k].width, cases[k].length, found, want, split / points, longest);
  }
  free(left);
}

/* About the pith the most and the widest checks leave some wood, no deeper than they are wide. */
static void the_pith_does_not_fall_out(void **state) {
  (void)state;
  static const double sizes[] = {0, 0.1, 3, 1e4};
  sozai_texture *t = wood_make(
      NULL, PLAIN "end_checks=40; end_check_width=10; end_check_length=2000; ray_density=0");
  points p = {0};
  double darkest = 1, lowest = 0, mean = 0;
  for (int f = 0; f < 4; f++) {
    points_clear(&p);
    for (int i = 0; i < POINTS; i++) {
      double r = pow(10, -6 + 8.0 * i / POINTS);
      unsigned j = points_add(&p, r * cos(2.4 * i), 5, r * sin(2.4 * i), sizes[f]);
      for (int c = 0; c < 3; c++) p.normal[c][j] = c == 1 ? 1.0f : 0.0f;
    }
    points_ask(&p, t);
    for (int i = 0; i < POINTS; i++) {
      darkest = fmin(darkest, (double)p.out[ALBEDO][i]);
      lowest = fmin(lowest, (double)p.out[HEIGHT][i]);
      mean += (double)p.out[ALBEDO][i] / (4 * POINTS);
    }
  }
  CHECK(darkest > 0.01 && lowest > -0.6 && mean > 0.2,
        "albedo %.3f in the mean, %.3f at least; %.2f mm deep at most\n", mean, darkest, -lowest);
  points_free(&p);
  textures->destroy(t);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(ends_check_as_asked_for),
                                     cmocka_unit_test(the_pith_does_not_fall_out),
                                     cmocka_unit_test(end_grain_is_darker),
                                     cmocka_unit_test(grows_with_the_turn),
                                     cmocka_unit_test(rays_are_dark_on_the_tangential_face),
                                     cmocka_unit_test(nothing_without_normals)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
