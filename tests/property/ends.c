/* SPDX-License-Identifier: Apache-2.0
 *
 * Open ends of cells: as much darker as asked for, on end grain and, for rays, on the
 * tangential face; nothing on faces along them, nor where no normal says how a face lies.
 */
#include <math.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

#define PLAIN                                                                                      \
  "pith_wander=0; undulation=0; section_wobble=0; slope_noise=0; taper=0; porosity=none; "         \
  "fibre_brightness=0; specular=0; "
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

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(end_grain_is_darker),
                                     cmocka_unit_test(grows_with_the_turn),
                                     cmocka_unit_test(rays_are_dark_on_the_tangential_face),
                                     cmocka_unit_test(nothing_without_normals)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
