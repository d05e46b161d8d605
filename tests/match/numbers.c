/* SPDX-License-Identifier: Apache-2.0
 *
 * CIEDE2000 by the pairs that its implementation notes print, small matrices by
 * what defines them, and moments through a palette by taking them again. */
#include "appearance.h"
#include "linear.h"
#include "moments.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h> /* after failure.h: it has a macro of that name, fail */

/* Sharma, Wu and Dalal, The CIEDE2000 color-difference formula (2005), table 1:
 * among them those where hues lie across 0 degrees, or one is none. */
static void differences(void **state) {
  (void)state;
  static const struct {
    double a[3], b[3], wanted;
  } pairs[] = {
      {{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
      {{50, 3.1571, -77.2803}, {50, 0, -82.7485}, 2.8615},
      {{50, -1.3802, -84.2814}, {50, 0, -82.7485}, 1.0},
      {{50, 0, 0}, {50, -1, 2}, 2.3669},
      {{50, 2.49, -0.001}, {50, -2.49, 0.0009}, 7.1792},
      {{50, 2.49, -0.001}, {50, -2.49, 0.0011}, 7.2195},
      {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
      {{50, 2.5, 0}, {61, -5, 29}, 22.8977},
      {{50, 2.5, 0}, {56, -27, -3}, 31.9030},
      {{50, 2.5, 0}, {58, 24, 15}, 19.4535},
      {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
      {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
  };
  for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
    assert_true(fabs(ciede2000(pairs[i].a, pairs[i].b) - pairs[i].wanted) < 5e-5);
    assert_true(fabs(ciede2000(pairs[i].b, pairs[i].a) - pairs[i].wanted) < 5e-5);
  }
}

static void matrices(void **state) {
  (void)state;
  static const double a[9] = {9.7, 3.6, 0.95, 3.6, 1.42, 0.38, 0.95, 0.38, 0.11};
  double values[3], v[9], root[9], square[9], inverse[9], one[9];
  symmetric_eigen(a, values, v);
  assert_true(values[0] >= values[1] && values[1] >= values[2] && values[2] > 0);
  symmetric_power(a, 0.5, 0, root);
  multiply(root, root, square);
  symmetric_power(a, -1, 0, inverse);
  multiply(a, inverse, one);
  for (int i = 0; i < 9; i++) {
    assert_true(fabs(square[i] - a[i]) < 1e-12);
    assert_true(fabs(one[i] - (i % 4 == 0)) < 1e-8);
  }
  double spent[9], b[3] = {1, -2, 3};
  memcpy(spent, a, sizeof spent);
  assert_true(solve_positive(spent, b, 3));
  for (int i = 0; i < 3; i++) {
    double sum = 0;
    for (int k = 0; k < 3; k++) sum += a[3 * i + k] * b[k];
    assert_true(fabs(sum - (i == 0 ? 1 : i == 1 ? -2 : 3)) < 1e-7);
  }
  double not_positive[4] = {1, 2, 2, 1}, c[2] = {1, 1};
  assert_false(solve_positive(not_positive, c, 2));
}

#define POINTS 5000
#define DIMENSIONS 4

static void through_a_palette(void **state) {
  (void)state;
  static float weights[POINTS * DIMENSIONS], colours[POINTS * 3];
  static uint8_t kept[POINTS];
  const double k[DIMENSIONS * 3] = {0.7, 0.5, 0.3, 0.4, 0.2, 0.1, 0.2, 0.1, 0.0, 0.1, 0.3, 0.6};
  uint32_t random = 1;
  for (int i = 0; i < POINTS * DIMENSIONS; i++) {
    random = random * 1664525u + 1013904223u;
    float u = (float)(random >> 8) / 16777216.0f;
    weights[i] = u * u; /* skewed */
  }
  for (int i = 0; i < POINTS; i++) {
    kept[i] = i % 3 == 0;
    for (int c = 0; c < 3; c++) {
      double sum = 0;
      for (int d = 0; d < DIMENSIONS; d++)
        sum += k[3 * d + c] * (double)weights[DIMENSIONS * i + d];
      colours[3 * i + c] = (float)sum;
    }
  }
  moments of_weights, wanted, got;
  moments_take(&of_weights, weights, DIMENSIONS, POINTS, kept, 1);
  moments_take(&wanted, colours, 3, POINTS, kept, 1);
  moments_through(&of_weights, k, &got);
  assert_int_equal(got.count, (POINTS + 2) / 3);
  for (int i = 0; i < 27; i++) {
    if (i < 3) assert_true(fabs(got.mean[i] - wanted.mean[i]) < 1e-6);
    if (i < 9) assert_true(fabs(got.covariance[i] - wanted.covariance[i]) < 1e-6);
    assert_true(fabs(got.third[i] - wanted.third[i]) < 1e-6);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(differences), cmocka_unit_test(matrices),
                                     cmocka_unit_test(through_a_palette)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
