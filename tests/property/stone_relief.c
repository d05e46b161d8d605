/* SPDX-License-Identifier: Apache-2.0
 *
 * Finishes and holes: the normal is the height's own, by finite differences; and what a
 * footprint averages out of the slopes is the variance that roughness gains.
 */
#include <math.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

enum { STONE_NORMAL = 6, STONE_HEIGHT = 9, STONE_ROUGHNESS = 10 };
static const char *const finishes[] = {"sawn",   "polished",      "honed",
                                       "flamed", "bush_hammered", "split"};

static sozai_texture *make(const char *finish) {
  const sozai_value v[] = {{.id = "finish", .kind = SOZAI_KIND_CHOICE, .text = finish},
                           {.id = "grain_size", .kind = SOZAI_KIND_FLOAT, .number = {3}}};
  sozai_texture *t;
  assert_int_equal(textures->create(NULL, "stone", NULL, v, 2, &t), SOZAI_OK);
  return t;
}

static void normal_is_the_heights(void **state) {
  (void)state;
  for (int f = 0; f < 6; f++) {
    sozai_texture *t = make(finishes[f]);
    points p = {0};
    uniform_seed(71);
    const double h = 0.02;
    for (int i = 0; i < 4000; i++) {
      double x[3];
      for (int c = 0; c < 3; c++) x[c] = 60 * (uniform() - 0.5);
      /* the point, and both ways along x and y of a face towards +z */
      points_add(&p, x[0], x[1], x[2], 0);
      for (int k = 0; k < 4; k++) {
        points_add(&p,
                   x[0] + (k == 0   ? h
                           : k == 1 ? -h
                                    : 0),
                   x[1] + (k == 2   ? h
                           : k == 3 ? -h
                                    : 0),
                   x[2], 0);
      }
    }
    points_ask(&p, t);
    double worst = 0, steepest = 0, height = 0;
    for (unsigned i = 0; i < p.count; i += 5) {
      const float *a = p.out[STONE_HEIGHT] + i;
      double dx = (double)(a[1] - a[2]) / (2 * h), dy = (double)(a[3] - a[4]) / (2 * h);
      double nz = (double)p.out[STONE_NORMAL + 2][i];
      double gx = -(double)p.out[STONE_NORMAL][i] / nz,
             gy = -(double)p.out[STONE_NORMAL + 1][i] / nz;
      worst = fmax(worst, hypot(gx - dx, gy - dy));
      steepest = fmax(steepest, hypot(dx, dy));
      height = fmax(height, fabs((double)a[0]));
    }
    CHECK(worst <= 0.004 + 0.01 * steepest && steepest > 0,
          "%-13s height within +-%.4f mm, slopes to %.4f: off finite differences by %.2g\n",
          finishes[f], height, steepest, worst);
    points_free(&p);
    textures->destroy(t);
  }
}

/* Holes' slopes are differences over the footprint, of places that the bends' slopes lead to:
 * in the mean they are the height's. */
static void normal_is_the_holes(void **state) {
  (void)state;
  sozai_texture *t;
  assert_int_equal(textures->create(NULL, "stone", "travertino", NULL, 0, &t), SOZAI_OK);
  points p = {0};
  uniform_seed(73);
  const double h = 0.003, s = 0.03;
  for (int i = 0; i < 20000; i++) {
    double x = 400 * uniform(), y = 400 * uniform(), z = 60 * (uniform() - 0.5);
    points_add(&p, x, y, z, s);
    for (int k = 0; k < 4; k++) {
      double d = k & 1 ? -h : h;
      points_add(&p, k < 2 ? x + d : x, k < 2 ? y : y + d, z, s);
    }
  }
  points_ask(&p, t);
  double off = 0, steep = 0;
  unsigned within = 0;
  for (unsigned i = 0; i < p.count; i += 5) {
    const float *a = p.out[STONE_HEIGHT] + i;
    if (a[0] > -0.02f) continue;
    double dx = (double)(a[1] - a[2]) / (2 * h), dy = (double)(a[3] - a[4]) / (2 * h);
    double nz = (double)p.out[STONE_NORMAL + 2][i];
    double gx = -(double)p.out[STONE_NORMAL][i] / nz, gy = -(double)p.out[STONE_NORMAL + 1][i] / nz;
    off += (gx - dx) * (gx - dx) + (gy - dy) * (gy - dy);
    steep += dx * dx + dy * dy;
    within++;
  }
  CHECK(within > 500 && off < 0.01 * steep,
        "in %u places within holes slopes of RMS %.3f: off finite differences by %.4f\n", within,
        sqrt(steep / within), sqrt(off / within));
  points_free(&p);
  textures->destroy(t);
}

/* Slope variance along an axis at a point, against what a footprint wide enough
 * to flatten all of it adds: alpha^2 = 2 variance. */
static void lost_slopes_are_roughness(void **state) {
  (void)state;
  for (int f = 0; f < 6; f++) {
    sozai_texture *t = make(finishes[f]);
    points p = {0};
    uniform_seed(72);
    enum { N = 40000 };
    for (int i = 0; i < N; i++) {
      double x[3];
      for (int c = 0; c < 3; c++) x[c] = 20000 * (uniform() - 0.5);
      points_add(&p, x[0], x[1], x[2], 0);
    }
    points_add(&p, 0, 0, 0, 5000);
    points_ask(&p, t);
    double variance = 0;
    for (int i = 0; i < N; i++) {
      double nz = (double)p.out[STONE_NORMAL + 2][i];
      double gx = (double)p.out[STONE_NORMAL][i] / nz, gy = (double)p.out[STONE_NORMAL + 1][i] / nz;
      variance += 0.5 * (gx * gx + gy * gy) / N;
    }
    double fine = (double)p.out[STONE_ROUGHNESS][0], wide = (double)p.out[STONE_ROUGHNESS][N];
    double gained = (wide * wide - fine * fine) / 2;
    /* full roughness cannot grow */
    CHECK(wide > 0.999 || fabs(gained - variance) <= 0.06 * variance + 1e-9,
          "%-13s slope variance %.6f, roughness %.3f to %.3f: gained %.6f (ratio %.3f)\n",
          finishes[f], variance, fine, wide, gained, gained / variance);
    points_free(&p);
    textures->destroy(t);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(normal_is_the_heights),
                                     cmocka_unit_test(normal_is_the_holes),
                                     cmocka_unit_test(lost_slopes_are_roughness)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
