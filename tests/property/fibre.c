/* SPDX-License-Identifier: Apache-2.0
 *
 * Shifted brightness: within its limits, and one number to a fibre.
 */
#include <math.h>

#include "cmocka_all.h"
#include "wood.h"

#define PI 3.14159265358979
/* Nothing else colours the wood. */
#define BARE                                                                                       \
  "porosity=none; earlywood_colour=0.5 0.5 0.5 @ lin_rec709; "                                     \
  "latewood_colour=0.5 0.5 0.5 @ lin_rec709; "

static void shift_stays_within_its_limit(void **state) {
  (void)state;
  for (int k = 0; k <= 4; k++) {
    char text[256];
    snprintf(text, sizeof text, BARE "fibre_brightness=%g", 0.1 * k);
    sozai_texture *t = wood_make(NULL, text);
    points p = {0};
    uniform_seed(31);
    for (int i = 0; i < 200000; i++) {
      points_add(&p, 300 * (uniform() - 0.5), 300 * (uniform() - 0.5), 300 * (uniform() - 0.5), 0);
    }
    points_ask(&p, t);
    double low = 9, high = -9, mean = 0;
    for (unsigned i = 0; i < p.count; i++) {
      double shift = (double)p.out[ALBEDO][i] / 0.5 - 1;
      low = fmin(low, shift);
      high = fmax(high, shift);
      mean += shift / p.count;
    }
    double limit = 0.1 * k;
    CHECK(high <= limit + 1e-5 && low >= -limit - 1e-5 && high >= 0.7 * limit &&
              low <= -0.7 * limit && fabs(mean) < 0.01,
          "limit %.1f: shifts of %+.3f to %+.3f, mean %+.4f\n", limit, low, high, mean);
    points_free(&p);
    textures->destroy(t);
  }
}

/* Along the fibres of wavy grain the brightness holds; along the stem's axis,
 * which crosses fibres, it does not. */
static void one_brightness_to_a_fibre(void **state) {
  (void)state;
  enum { FIBRES = 200, STEPS = 200 };
  sozai_texture *t = wood_make(NULL, BARE "fibre_brightness=0.4; grain=wavy; wave_length=15; "
                                          "wave_slope=0.15");
  points p = {0}, axis = {0};
  uniform_seed(32);
  double at[FIBRES][3], first[FIBRES], along = 0, across = 0;
  for (int i = 0; i < FIBRES; i++) {
    double r = 20 + 100 * uniform(), theta = 2 * PI * uniform();
    at[i][0] = r * cos(theta);
    at[i][1] = 100 * uniform();
    at[i][2] = r * sin(theta);
    points_add(&axis, at[i][0], at[i][1], at[i][2], 0);
    points_add(&axis, at[i][0], at[i][1] + 7.5, at[i][2], 0);
  }
  for (int n = 0; n < STEPS; n++) {
    points_clear(&p);
    for (int i = 0; i < FIBRES; i++) points_add(&p, at[i][0], at[i][1], at[i][2], 0);
    points_ask(&p, t);
    /* the midpoint rule, 0.1 mm a step */
    points half = {0};
    for (int i = 0; i < FIBRES; i++) {
      double a = (double)p.out[ALBEDO][i];
      if (n == 0) first[i] = a;
      along = fmax(along, fabs(a - first[i]));
      points_add(&half, at[i][0] + 0.05 * (double)p.out[FIBER][i],
                 at[i][1] + 0.05 * (double)p.out[FIBER + 1][i],
                 at[i][2] + 0.05 * (double)p.out[FIBER + 2][i], 0);
    }
    points_ask(&half, t);
    for (int i = 0; i < FIBRES; i++) {
      for (int c = 0; c < 3; c++) at[i][c] += 0.1 * (double)half.out[FIBER + c][i];
    }
    points_free(&half);
  }
  points_ask(&axis, t);
  for (unsigned i = 0; i < axis.count; i += 2) {
    across += fabs((double)(axis.out[ALBEDO][i] - axis.out[ALBEDO][i + 1])) / FIBRES;
  }
  CHECK(along < 0.01 && across > 0.03,
        "20 mm along %d fibres albedo changes by %.4f at most; 7.5 mm straight up by %.3f on "
        "average\n",
        FIBRES, along, across);
  points_free(&p);
  points_free(&axis);
  textures->destroy(t);
}

/* The wood is lighter and darker along the stem by as much as was asked, slowly. */
static void drift_along_the_stem(void **state) {
  (void)state;
  enum { N = 40000 };
  static const double drifts[] = {0, 0.03, 0.1};
  for (int k = 0; k < 3; k++) {
    char text[400];
    snprintf(text, sizeof text, BARE "fibre_brightness=0; drift=%g; drift_length=500", drifts[k]);
    sozai_texture *t = wood_make(NULL, text);
    points p = {0};
    uniform_seed(33);
    for (int i = 0; i < N; i++) {
      double y = 800000 * (uniform() - 0.5);
      points_add(&p, 60, y, 0, 0);
      points_add(&p, 60, y + 10, 0, 0);
    }
    points_ask(&p, t);
    double mean = 0, square = 0, most = 0;
    for (unsigned i = 0; i < p.count; i++) {
      double a = (double)p.out[ALBEDO][i] / 0.5;
      mean += a / p.count;
      square += a * a / p.count;
      if (i & 1) most = fmax(most, fabs(a - (double)p.out[ALBEDO][i - 1] / 0.5));
    }
    double sd = sqrt(fmax(square - mean * mean, 0));
    CHECK(fabs(mean - 1) < 0.01 && fabs(sd - drifts[k]) <= 0.1 * drifts[k] + 1e-6 &&
              most <= 0.15 * drifts[k] + 1e-6,
          "drift %.2f: mean %.4f, sd %.4f, within 10 mm at most %.4f\n", drifts[k], mean, sd, most);
    points_free(&p);
    textures->destroy(t);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(shift_stays_within_its_limit),
      cmocka_unit_test(one_brightness_to_a_fibre),
      cmocka_unit_test(drift_along_the_stem),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
