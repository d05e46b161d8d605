/* SPDX-License-Identifier: Apache-2.0
 * The paper's matrix, mended, against Rodrigues' formula in vectors:
 * v cos b + (n x v) sin b + n (n . v)(1 - cos b). */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>

#include "tree/turn.h"

static double draw(void) { return 2.0 * rand() / RAND_MAX - 1.0; }

static void unit(double v[3]) {
  double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (int c = 0; c < 3; c++) v[c] /= length;
}

static void about_random_axes(void **unused) {
  (void)unused;
  double worst = 0, skew = 0, handed = 0;
  srand(7);
  for (int i = 0; i < 10000; i++) {
    double n[3] = {draw(), draw(), draw()}, v[3] = {draw(), draw(), draw()}, b = 3.2 * draw();
    if (i < 3) n[0] = n[1] = n[2] = 0, n[i] = 1;
    unit(n);
    unit(v);
    float axis[3], p[3], got[3], columns[3][3];
    for (int c = 0; c < 3; c++) axis[c] = (float)n[c], p[c] = (float)v[c];
    turn_about(axis, (float)cos(b), (float)sin(b), p, got);
    double dot = n[0] * v[0] + n[1] * v[1] + n[2] * v[2];
    double cross[3] = {n[1] * v[2] - n[2] * v[1], n[2] * v[0] - n[0] * v[2],
                       n[0] * v[1] - n[1] * v[0]};
    for (int c = 0; c < 3; c++) {
      double want = v[c] * cos(b) + cross[c] * sin(b) + n[c] * dot * (1 - cos(b));
      worst = fmax(worst, fabs(want - (double)got[c]));
      float e[3] = {0, 0, 0};
      e[c] = 1;
      turn_about(axis, (float)cos(b), (float)sin(b), e, columns[c]);
    }
    for (int r = 0; r < 3; r++)
      for (int s = 0; s < 3; s++) {
        double sum = 0;
        for (int c = 0; c < 3; c++) sum += (double)columns[r][c] * (double)columns[s][c];
        skew = fmax(skew, fabs(sum - (r == s)));
      }
    const float(*m)[3] = (const float(*)[3])columns;
    double det =
        (double)m[0][0] * ((double)m[1][1] * (double)m[2][2] - (double)m[1][2] * (double)m[2][1]) -
        (double)m[1][0] * ((double)m[0][1] * (double)m[2][2] - (double)m[0][2] * (double)m[2][1]) +
        (double)m[2][0] * ((double)m[0][1] * (double)m[1][2] - (double)m[0][2] * (double)m[1][1]);
    handed = fmax(handed, fabs(det - 1));
  }
  print_message("10000 axes: off by %.2g, from orthogonal by %.2g, determinant by %.2g\n", worst,
                skew, handed);
  assert_true(worst < 1e-6);
  assert_true(skew < 1e-6);
  assert_true(handed < 1e-6);
}

/* As it is printed, it is no rotation: v w for u w, axis (w, u, v). */
static void as_printed_it_fails(void **unused) {
  (void)unused;
  double w = 0.48, u = 0.6, v = 0.64, c = cos(1.0), s = sin(1.0);
  double x[3] = {u * u + (1 - u * u) * c, u * v * (1 - c) - w * s, v * w * (1 - c) + v * s};
  double length = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  print_message("as printed, a row's squares sum to %.4f\n", length);
  assert_true(fabs(length - 1) > 1e-3);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(about_random_axes),
                                     cmocka_unit_test(as_printed_it_fails)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
