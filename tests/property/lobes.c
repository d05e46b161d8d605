/* SPDX-License-Identifier: Apache-2.0
 *
 * What a host builds wood's cones from: `fiber_lobe` and `ray_lobe`, axes as long as their shares,
 * with `cone_colour`, `cone_width` and `ray_lustre`. Put together by the paper's formula they are
 * the lobes of `radiance`; and they may be averaged.
 */
#include <stdlib.h>
#include <string.h>

#include "cmocka_all.h"
#include "cone_formula.h"
#include "wood.h"

static void add_anywhere(points *p, double wide, double footprint) {
  double l[3], v[3];
  unsigned i = points_add(p, wide * uniform(), wide * uniform(), 0, footprint);
  direction(0.3 + 0.7 * uniform(), 2 * PI * uniform(), l);
  direction(0.3 + 0.7 * uniform(), 2 * PI * uniform(), v);
  for (int c = 0; c < 3; c++) p->light[c][i] = (float)l[c], p->view[c][i] = (float)v[c];
}

static double vector_at(const points *p, int what, unsigned i, double unit[3]) {
  for (int c = 0; c < 3; c++) unit[c] = (double)p->out[what + c][i];
  double length = sqrt(dot(unit, unit));
  for (int c = 0; c < 3; c++) unit[c] /= fmax(length, 1e-9);
  return length;
}

/* What a host would make of a point's channels. */
static double rebuilt(const points *p, unsigned i, double *fibres, double *rays) {
  double l[3], v[3], axis[3], width = (double)p->out[CONE_WIDTH][i], sum;
  for (int c = 0; c < 3; c++) l[c] = (double)p->light[c][i], v[c] = (double)p->view[c][i];
  *fibres = vector_at(p, FIBER_LOBE, i, axis);
  sum = *fibres * lobe_of(l, v, axis, 1.55, width, 0);
  *rays = vector_at(p, RAY_LOBE, i, axis);
  sum += *rays * (double)p->out[RAY_LUSTRE][i] * lobe_of(l, v, axis, 1.55, width, 0);
  return (double)p->out[CONE_COLOUR][i] * sum;
}

#define DARK                                                                                       \
  BLACK "vessel_colour=0 0 0; sapwood_vessel_colour=0 0 0; ray_colour=0 0 0; "                     \
        "parenchyma_colour=0 0 0; sapwood_parenchyma_colour=0 0 0; joint_colour=0 0 0; "           \
        "fibre_brightness=0; coat=0; specular_tint=0; reflection=fibre_cone; "

/* Of woods with vessels and rays, cut each way and laid: black but for their lobes. */
static const char *const woods_seen[][2] = {
    {"mizunara", "cut=quarter"},
    {"mizunara", "cut=flat"},
    {"mizunara", "cut=end"},
    {"mizunara", "layout=herringbone; joint_width=8; bevel=0; cupping=0"},
    {"white_oak", "cut=rift; ray_lustre=5; fibre_reflectance=0.4"},
    {"silky_oak", "cut=quarter"},
    {"keyaki", "cut=flat; reflection=fibre_cone"},
    {"sugi", "cut=quarter; reflection=fibre_cone"},
};

static void radiance_of_channels(void **state) {
  (void)state;
  for (size_t k = 0; k < sizeof woods_seen / sizeof *woods_seen; k++) {
    char text[1024];
    snprintf(text, sizeof text, DARK "%s", woods_seen[k][1]);
    sozai_texture *t = wood_make(woods_seen[k][0], text);
    points p = {0};
    uniform_seed(71);
    for (int i = 0; i < 6000; i++) add_anywhere(&p, 400, 0);
    points_ask(&p, t);
    double worst = 0, most_of[2] = {0}, least = 9;
    for (unsigned i = 0; i < p.count; i++) {
      double share[2], want = rebuilt(&p, i, &share[0], &share[1]);
      /* of the red: all that is not black is the lobes' */
      double off = fabs((double)p.out[RADIANCE][i] - want) / (0.01 + want);
      worst = fmax(worst, off);
      least = fmin(least, share[0]);
      for (int c = 0; c < 2; c++) most_of[c] = fmax(most_of[c], share[c]);
    }
    points_free(&p);
    textures->destroy(t);
    CHECK(worst < 2e-5, "%s, %s: %.2g off radiance; fibres of %.2f to %.2f, rays to %.2f\n",
          woods_seen[k][0], woods_seen[k][1], worst, least, most_of[0], most_of[1]);
  }
}

/* The axis is `fiber`'s and the shares are those that vessels, rays and joints leave. */
static void shares(void **state) {
  (void)state;
  sozai_texture *t = wood_make("mizunara", "layout=strip; joint_width=10; bevel=0");
  points p = {0};
  uniform_seed(72);
  for (int i = 0; i < 20000; i++) add_anywhere(&p, 600, 0);
  points_ask(&p, t);
  double axes = 0, sum = 0;
  unsigned joints = 0, flakes = 0;
  for (unsigned i = 0; i < p.count; i++) {
    double lobe[3], fiber[3], ray[3], edge = (double)p.out[BOARD_EDGE][i];
    double fibres = vector_at(&p, FIBER_LOBE, i, lobe), rays = vector_at(&p, RAY_LOBE, i, ray);
    vector_at(&p, FIBER, i, fiber);
    if (edge < -1) {
      joints++;
      assert_true(fibres < 1e-3 && rays < 1e-3);
    }
    if (edge < 1) continue;
    double covered = (double)p.out[RAY][i], open = (double)p.out[VESSEL][i];
    if (fibres > 0.01) axes = fmax(axes, 1 - dot(lobe, fiber));
    sum = fmax(sum, fabs(fibres - (1 - open) * (1 - covered)));
    /* where they would shine more than they are lit there is less of it: rays that a face cuts
     * across */
    assert_true(rays < covered + 1e-5);
    if (fabs(ray[2]) < 0.4) sum = fmax(sum, fabs(rays - covered));
    flakes += rays > 0.5;
  }
  points_free(&p);
  textures->destroy(t);
  CHECK(axes < 1e-6 && sum < 1e-5 && joints > 100 && flakes > 100,
        "%u places in joints, %u in flakes: axes %.1g off, shares %.1g\n", joints, flakes, axes,
        sum);
}

/* Hosts read these once. */
static void the_same_all_over(void **state) {
  (void)state;
  static const char *const texts[] = {"cut=flat", "cut=end", "cut=quarter; fibre_reflectance=0.5"};
  for (int k = 0; k < 3; k++) {
    sozai_texture *t = wood_make("mizunara", texts[k]);
    points p = {0};
    uniform_seed(75);
    for (int i = 0; i < 2000; i++) add_anywhere(&p, 300, 3 * uniform());
    points_ask(&p, t);
    for (unsigned i = 0; i < p.count; i++) {
      assert_true(p.out[RAY_LUSTRE][i] == 2);
      for (int c = 0; c < 3; c++)
        assert_true(p.out[CONE_COLOUR + c][i] == p.out[CONE_COLOUR + c][0]);
    }
    points_free(&p);
    textures->destroy(t);
  }
}

/* A point's rays do not depend on whose come with it, where edges are soft: wide and uneven ones.
 */
static void together_or_alone(void **state) {
  (void)state;
  enum { COUNT = 1000000 };
  sozai_texture *t =
      wood_make("mizunara", "cut=quarter; ray_height=20; ray_density=0.05; ray_width=600");
  points p = {0};
  uniform_seed(76);
  for (int i = 0; i < COUNT; i++) add_anywhere(&p, 400, 0.4 + 0.4 * uniform());
  float *together = malloc(COUNT * sizeof *together), ray, *out[RAY + 1] = {0};
  assert_non_null(together);
  points_ask_only(&p, t, 1ull << RAY);
  memcpy(together, p.out[RAY], COUNT * sizeof *together);
  unsigned apart = 0, some = 0;
  for (unsigned i = 0; i < p.count; i++) {
    sozai_batch one = {.size = sizeof one,
                       .count = 1,
                       .footprint = &p.footprint[i],
                       .out = out,
                       .out_count = RAY + 1};
    for (int c = 0; c < 3; c++) {
      one.point[c] = &p.point[c][i], one.normal[c] = &p.normal[c][i];
      one.light[c] = &p.light[c][i], one.view[c] = &p.view[c][i];
    }
    out[RAY] = &ray;
    assert_int_equal(textures->evaluate(t, &one), SOZAI_OK);
    apart += ray != together[i];
    some += ray > 0;
  }
  free(together);
  points_free(&p);
  textures->destroy(t);
  CHECK(apart == 0 && some > COUNT / 50, "of %u points with rays %u are others alone\n", some,
        apart);
}

/* Kawai's lobe is the fibres' everywhere, and rays have none. */
static void of_kawai(void **state) {
  (void)state;
  sozai_texture *t = wood_make("keyaki", "reflection=kawai; cut=quarter");
  points p = {0};
  uniform_seed(73);
  for (int i = 0; i < 2000; i++) add_anywhere(&p, 100, 0);
  points_ask(&p, t);
  for (unsigned i = 0; i < p.count; i++) {
    for (int c = 0; c < 3; c++) {
      assert_true(p.out[FIBER_LOBE + c][i] == p.out[FIBER + c][i]);
      assert_true(p.out[RAY_LOBE + c][i] == 0);
    }
    assert_true(p.out[RAY_LUSTRE][i] == 0);
  }
  points_free(&p);
  textures->destroy(t);
}

/* Under a footprint both are what its points' mean is: RMS of the three components. */
static void under_a_footprint(void **state) {
  (void)state;
  enum { SIDE = 16, PLACES = 400 };
  static const char *const cuts[] = {"cut=quarter", "cut=flat", "cut=end"};
  static const double footprints[] = {0.5, 3, 20};
  for (int c = 0; c < 3; c++) {
    sozai_texture *t = wood_make("mizunara", cuts[c]);
    for (int f = 0; f < 3; f++) {
      double square[2] = {0}, s = footprints[f];
      uniform_seed(74);
      for (int n = 0; n < PLACES; n++) {
        points p = {0}, q = {0};
        double x = 200 * uniform(), y = 200 * uniform();
        points_add(&p, x, y, 0, s);
        for (int i = 0; i < SIDE * SIDE; i++) {
          double u = (i % SIDE + 0.5) / SIDE - 0.5, v = ((double)(i / SIDE) + 0.5) / SIDE - 0.5;
          points_add(&q, x + s * u, y + s * v, 0, s / SIDE);
        }
        points_ask(&p, t);
        points_ask(&q, t);
        for (int k = 0; k < 6; k++) {
          double mean = 0;
          for (unsigned i = 0; i < q.count; i++) {
            mean += (double)q.out[FIBER_LOBE + k][i] / q.count;
          }
          double off = (double)p.out[FIBER_LOBE + k][0] - mean;
          square[k / 3] += off * off / PLACES;
        }
        points_free(&p);
        points_free(&q);
      }
      double most = s < 1 ? 0.03 : 0.1;
      CHECK(sqrt(square[0]) < most + 0.02 && sqrt(square[1]) < most,
            "mizunara, %s, under %g mm: fibres' lobe %.4f off, rays' %.4f\n", cuts[c], s,
            sqrt(square[0]), sqrt(square[1]));
    }
    textures->destroy(t);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(radiance_of_channels),
                                     cmocka_unit_test(shares),
                                     cmocka_unit_test(of_kawai),
                                     cmocka_unit_test(the_same_all_over),
                                     cmocka_unit_test(together_or_alone),
                                     cmocka_unit_test(under_a_footprint)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
