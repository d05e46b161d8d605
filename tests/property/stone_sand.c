/* SPDX-License-Identifier: Apache-2.0
 *
 * What fills joints: grains of sand, each of one shade, that stand out of their ground; their
 * normal is their height's, and a wide footprint has their means.
 */
#include <math.h>
#include <stdio.h>

#include "cmocka_all.h"
#include "wood.h"

enum { S_NORMAL = 6, S_HEIGHT = 9 };

#define GRAIN 1.5    /* mm */
#define SLOPE2 0.085 /* as plugin/stone/sand.h has it */

/* Joints nearly as wide as their stones, of level ones whose edges are none. */
static sozai_texture *make(void) {
  char text[256];
  snprintf(text, sizeof text,
           "layout=stack; stone_length=500; stone_width=500; joint_width=200; joint_depth=4; "
           "edge_round=0; relief=0; joint_grain=%g; joint_colour=#a09484",
           GRAIN);
  return stone_make(NULL, text);
}

/* A place well within a joint; so near the middle that a step of a little part of a grain is not
 * rounded. */
static void place(double x[2]) {
  x[0] = 160 * (uniform() - 0.5);
  x[1] = 480 * (uniform() - 0.5);
}

static double at(const points *p, int what, unsigned i) { return (double)p->out[what][i]; }

static void slope_at(const points *p, unsigned i, double g[2]) {
  for (int c = 0; c < 2; c++) g[c] = -at(p, S_NORMAL + c, i) / at(p, S_NORMAL + 2, i);
}

/* But where a step meets a grain's outline. */
static void normal_is_the_heights(void **state) {
  (void)state;
  sozai_texture *t = make();
  points p = {0};
  uniform_seed(81);
  enum { N = 6000 };
  const double h = 0.002 * GRAIN;
  for (int i = 0; i < N; i++) {
    double x[2];
    place(x);
    points_add(&p, x[0], x[1], 0, 0);
    for (int k = 0; k < 4; k++) {
      double d = k & 1 ? -h : h;
      points_add(&p, k < 2 ? x[0] + d : x[0], k < 2 ? x[1] : x[1] + d, 0, 0);
    }
  }
  points_ask(&p, t);
  unsigned off = 0;
  double steep = 0, most = 0;
  for (unsigned i = 0; i < 5 * N; i += 5) {
    double g[2], d[2];
    slope_at(&p, i, g);
    for (unsigned c = 0; c < 2; c++)
      d[c] = (at(&p, S_HEIGHT, i + 1 + 2 * c) - at(&p, S_HEIGHT, i + 2 + 2 * c)) / (2 * h);
    most = fmax(most, hypot(d[0], d[1]));
    off += hypot(g[0] - d[0], g[1] - d[1]) > 0.02;
    steep += (g[0] * g[0] + g[1] * g[1]) / N;
  }
  CHECK(off < 0.05 * N && steep > 0.05,
        "slopes of RMS %.3f; of %d places %u are off finite differences by over 0.02\n",
        sqrt(steep), N, off);
  /* nor are there cliffs between grains, which no normal tells of */
  CHECK(most < 3, "the steepest difference is %.3f\n", most);
  points_free(&p);
  textures->destroy(t);
}

/* Means over many places, and what a footprint has that hides all grains. */
static void wide_footprints_have_the_means(void **state) {
  (void)state;
  sozai_texture *t = make();
  points p = {0};
  uniform_seed(82);
  enum { N = 200000 };
  for (int i = 0; i < N; i++) {
    double x[2];
    place(x);
    points_add(&p, x[0], x[1], 0, 0.01 * GRAIN);
  }
  points_add(&p, 0, 0, 0, 60);
  points_ask(&p, t);
  double height = 0, slope2 = 0, mean = 0, square = 0;
  for (unsigned i = 0; i < N; i++) {
    double g[2], a = at(&p, ALBEDO + 1, i);
    slope_at(&p, i, g);
    height += at(&p, S_HEIGHT, i) / N;
    slope2 += 0.5 * (g[0] * g[0] + g[1] * g[1]) / N;
    mean += a / N;
    square += a * a / N;
  }
  double sd = sqrt(square - mean * mean);
  CHECK(fabs(slope2 - SLOPE2) < 0.1 * SLOPE2, "slope variance along an axis %.4f (%.3f)\n", slope2,
        SLOPE2);
  CHECK(fabs(height - at(&p, S_HEIGHT, N)) < 0.01 * GRAIN,
        "height %.4f grains over that of a wide footprint (0 within 0.01)\n",
        (height - at(&p, S_HEIGHT, N)) / GRAIN);
  CHECK(fabs(mean - at(&p, ALBEDO + 1, N)) < 0.01 * mean && sd > 0.15 * mean && sd < 0.4 * mean,
        "albedo %.4f (wide %.4f), sd %.3f of it\n", mean, at(&p, ALBEDO + 1, N), sd / mean);
  points_free(&p);
  textures->destroy(t);
}

/* Places within a grain are alike, and other grains differ: how the shade goes with that a step
 * further on. */
static void grains_are_grains(void **state) {
  (void)state;
  static const double step[] = {0.02, 0.15, 0.5, 2.5};
  double with[4];
  sozai_texture *t = make();
  for (int k = 0; k < 4; k++) {
    points p = {0};
    uniform_seed(83);
    enum { N = 40000 };
    for (int i = 0; i < N; i++) {
      double x[2], turn = 6.2831853 * uniform();
      place(x);
      points_add(&p, x[0], x[1], 0, 0);
      points_add(&p, x[0] + step[k] * GRAIN * cos(turn), x[1] + step[k] * GRAIN * sin(turn), 0, 0);
    }
    points_ask(&p, t);
    double mean = 0, square = 0, both = 0;
    for (unsigned i = 0; i < 2 * N; i += 2) {
      double a = at(&p, ALBEDO + 1, i), b = at(&p, ALBEDO + 1, i + 1);
      mean += (a + b) / (2 * N);
      square += (a * a + b * b) / (2 * N);
      both += a * b / N;
    }
    with[k] = (both - mean * mean) / (square - mean * mean);
    points_free(&p);
  }
  CHECK(with[0] > 0.85 && with[1] < 0.9 * with[0] && with[2] < 0.4 && with[3] < 0.15,
        "correlation of albedo 0.02, 0.15, 0.5, 2.5 grains on: %.3f %.3f %.3f %.3f\n", with[0],
        with[1], with[2], with[3]);
  textures->destroy(t);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(normal_is_the_heights),
                                     cmocka_unit_test(wide_footprints_have_the_means),
                                     cmocka_unit_test(grains_are_grains)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
