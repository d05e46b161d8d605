/* SPDX-License-Identifier: Apache-2.0
 *
 * Vessels are round and rays straight across the stem at every height, and both follow the fibres,
 * whatever the grain has turned below.
 */
#include <math.h>
#include <stdlib.h>

#include "cmocka_all.h"
#include "wood.h"

typedef struct {
  const char *preset, *parameters;
} turned;

static const turned woods_turned[] = {
    {"sapele", ""},         {"iroko", ""},
    {"pommele_sapele", ""}, {"afrormosia", ""},
    {"kusunoki", ""},       {"beech", "grain=spiral; spiral_slope=0.12"},
    {"lignum_vitae", ""},   {"walnut", "grain=spiral; spiral_slope=0.05"},
};
enum { WOODS = sizeof woods_turned / sizeof *woods_turned };
static const double heights[] = {0, 250, 1500, 3600};

static int by_number(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* An output over n x n points of a level square, at the step given, from (x, y, z) on. */
static void square(const sozai_texture *t, int what, double x, double y, double z, int n,
                   double step, float *out) {
  points p = {0};
  for (int i = 0; i < n; i++) {
    points_clear(&p);
    for (int k = 0; k < n; k++) points_add(&p, x + step * k, y, z + step * i, 0);
    points_ask(&p, t);
    for (int k = 0; k < n; k++) out[n * i + k] = p.out[what][k];
  }
  points_free(&p);
}

/* How much longer than wide what is seen there is: of an ellipse's share, gradients' squares along
 * its two axes go as the square of that. lean: tangent of the long way's angle to x. */
static double aspect(const float *v, int n, double *lean) {
  double xx = 0, xz = 0, zz = 0;
  for (int i = 1; i + 1 < n; i++) {
    for (int k = 1; k + 1 < n; k++) {
      double gx = (double)v[n * i + k + 1] - (double)v[n * i + k - 1];
      double gz = (double)v[n * (i + 1) + k] - (double)v[n * (i - 1) + k];
      xx += gx * gx;
      xz += gx * gz;
      zz += gz * gz;
    }
  }
  double middle = (xx + zz) / 2, apart = hypot((xx - zz) / 2, xz);
  if (middle <= 0) return 0;
  *lean = tan(0.5 * atan2(-2 * xz, zz - xx));
  return sqrt((middle + apart) / fmax(middle - apart, 1e-9 * middle));
}

enum { TILES = 36, SIDE = 120 };

/* Tiles along +x, where x is the radius. */
static void vessels_are_round(void **state) {
  (void)state;
  static float v[SIDE * SIDE];
  for (int k = 0; k < WOODS; k++) {
    sozai_texture *t = wood_make(woods_turned[k].preset, woods_turned[k].parameters);
    double level = 0;
    for (unsigned h = 0; h < sizeof heights / sizeof *heights; h++) {
      double of[TILES], unused;
      int n = 0;
      for (int i = 0; i < TILES; i++) {
        square(t, VESSEL, 30 + 3.3 * i, heights[h] + 0.37 * i, 0, SIDE, 0.02, v);
        double a = aspect(v, SIDE, &unused);
        if (a > 0) of[n++] = a;
      }
      assert_true(n > TILES / 2);
      qsort(of, (size_t)n, sizeof *of, by_number);
      double median = of[n / 2], most = of[9 * n / 10];
      if (h == 0) level = median;
      CHECK(median < level + 0.25 && most < 2.0,
            "%-14s %6.0f mm up vessels are %.2f times as long as wide (median), %.2f (9 of 10)\n",
            woods_turned[k].preset, heights[h], median, most);
    }
    textures->destroy(t);
  }
}

static void rays_are_straight(void **state) {
  (void)state;
  static float v[SIDE * SIDE];
  for (int k = 0; k < WOODS; k++) {
    sozai_texture *t = wood_make(woods_turned[k].preset, woods_turned[k].parameters);
    for (unsigned h = 1; h < sizeof heights / sizeof *heights; h++) {
      double of[TILES];
      int n = 0;
      for (int i = 0; i < TILES; i++) {
        double lean;
        square(t, RAY, 30 + 3.3 * i, heights[h] + 0.37 * i, 0, SIDE, 0.02, v);
        if (aspect(v, SIDE, &lean) > 3) of[n++] = fabs(lean);
      }
      if (n < TILES / 4) continue; /* no rays to speak of */
      qsort(of, (size_t)n, sizeof *of, by_number);
      CHECK(of[n / 2] < 0.35 && of[9 * n / 10] < 1,
            "%-14s %6.0f mm up rays lean by a tangent of %.2f to the radius (median), %.2f\n",
            woods_turned[k].preset, heights[h], of[n / 2], of[9 * n / 10]);
    }
    textures->destroy(t);
  }
}

/* Along a fibre a vessel goes on, but for where a bolt ends: within it or not changes as seldom as
 * that. */
static void vessels_follow_fibres(void **state) {
  (void)state;
  enum { N = 2000, STEPS = 100 };
  const double step = 0.05;
  for (int k = 0; k < WOODS; k++) {
    sozai_texture *t = wood_make(woods_turned[k].preset, woods_turned[k].parameters);
    points p = {0}, next = {0};
    uniform_seed(31);
    for (int i = 0; i < N; i++)
      points_add(&p, 30 + 90 * uniform(), 1500 + 500 * uniform(), 6 * uniform(), 0);
    points_ask(&p, t);
    int within = 0, left = 0;
    float *first = malloc(N * sizeof *first);
    for (int i = 0; i < N; i++) first[i] = p.out[VESSEL][i];
    for (int s = 0; s < STEPS; s++) {
      points_clear(&next);
      points_along_fibre(&p, (float)step, &next);
      points_ask(&next, t);
      points swap = p;
      p = next;
      next = swap;
    }
    for (int i = 0; i < N; i++) {
      if (first[i] < 0.95f) continue;
      within++;
      left += p.out[VESSEL][i] < 0.5f;
    }
    free(first);
    CHECK(within > 20 && left < 0.45 * within,
          "%-14s of %d points within vessels %d are out of them %.0f mm along the fibre\n",
          woods_turned[k].preset, within, left, STEPS * step);
    points_free(&p);
    points_free(&next);
    textures->destroy(t);
  }
}

/* How much of what one line across a face shows the next one shows, half a millimetre along the
 * fibres: correlation of vessels. */
static double goes_on(points *line, points *next, const sozai_texture *t) {
  points_ask(line, t);
  points_clear(next);
  points_along_fibre(line, 0.5f, next);
  points_ask(next, t);
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0, n = (double)line->count;
  for (uint32_t i = 0; i < line->count; i++) {
    double x = (double)line->out[VESSEL][i], y = (double)next->out[VESSEL][i];
    a += x;
    b += y;
    aa += x * x;
    bb += y * y;
    ab += x * y;
  }
  return (ab - a * b / n) / sqrt((aa - a * a / n) * (bb - b * b / n) + 1e-12);
}

/* Vessels end each at its own height: at none is a face sliced across. */
static void no_height_where_all_end(void **state) {
  (void)state;
  static const char *const woods_sliced[] = {"sapele", "iroko", "zebrano", "pommele_sapele",
                                             "afrormosia"};
  enum { N = 1600, LEVELS = 240 };
  for (size_t k = 0; k < sizeof woods_sliced / sizeof *woods_sliced; k++) {
    sozai_texture *t = wood_make(woods_sliced[k], "");
    points line = {0}, next = {0};
    double least = 1, mean = 0;
    for (int l = 0; l < LEVELS; l++) {
      points_clear(&line);
      for (int i = 0; i < N; i++) points_add(&line, 0.05 * i - 40, 1500 + 0.5 * l, 70, 0);
      double same = goes_on(&line, &next, t);
      mean += same / LEVELS;
      least = fmin(least, same);
    }
    CHECK(least > mean - 0.3,
          "%-14s lines of 80 mm show %.2f of the next, in the mean, and %.2f at least\n",
          woods_sliced[k], mean, least);
    points_free(&line);
    points_free(&next);
    textures->destroy(t);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(vessels_are_round), cmocka_unit_test(rays_are_straight),
      cmocka_unit_test(vessels_follow_fibres), cmocka_unit_test(no_height_where_all_end)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
