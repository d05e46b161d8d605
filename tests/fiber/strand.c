/* SPDX-License-Identifier: Apache-2.0
 * Rows 1 and 2: strands as the paper's figures show them. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "fiber/strand.h"

#define PI 3.14159265358979323846
#define N 32

static strand_shape shape(double p0, double p1, double t0, double t1) {
  return (strand_shape){.vertices = N,
                        .seed = 1,
                        .length = 10,
                        .phi_min = p0,
                        .phi_max = p1,
                        .theta_min = t0,
                        .theta_max = t1};
}

static double distance(const double *a, const double *b) {
  return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
              (a[2] - b[2]) * (a[2] - b[2]));
}

static void segment(const double *v, int i, double out[3]) {
  for (int a = 0; a < 3; a++) out[a] = v[3 * i + 3 + a] - v[3 * i + a];
}

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3]) {
  for (int k = 0; k < 3; k++)
    out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

/* Degrees between segment i and the next. */
static double bend(const double *v, int i) {
  double a[3], b[3], n[3];
  segment(v, i, a);
  segment(v, i + 1, b);
  cross(a, b, n);
  return atan2(sqrt(dot(n, n)), dot(a, b)) * 180 / PI;
}

/* Degrees between the planes of bends i and i + 1, with its sign. */
static double twist(const double *v, int i) {
  double a[3], b[3], c[3], n[3], m[3], k[3];
  segment(v, i, a);
  segment(v, i + 1, b);
  segment(v, i + 2, c);
  cross(a, b, n);
  cross(b, c, m);
  cross(n, m, k);
  return atan2(dot(k, b) / sqrt(dot(b, b)), dot(n, m)) * 180 / PI;
}

static double mean_ratio(double p0, double p1, double t0, double t1) {
  strand_shape s = shape(p0, p1, t0, t1);
  double v[3 * N], sum = 0;
  for (uint32_t i = 0; i < 4000; i++) {
    strand_make(&s, i, v);
    sum += distance(v, v + 3 * (N - 1)) / s.length / 4000;
  }
  return sum;
}

static void figure_7(void **unused) {
  (void)unused;
  double b = mean_ratio(0, 0, 0, 10.8), c = mean_ratio(0, 0, -10.8, 10.8),
         d = mean_ratio(0, 36, 0, 10.8);
  print_message("end to end over length: b %.3f, c %.3f, d %.3f\n", b, c, d);
  assert_true(fabs(b - 0.68) < 0.01);
  assert_true(fabs(c - 0.97) < 0.005);
  assert_true(fabs(d - 0.95) < 0.005);
}

static const double table_1[10][4] = {
    {0, 0, 0, 0},         {0, 0, 3.6, 3.6},        {0, 0, 7.2, 7.2},  {3.6, 3.6, 3.6, 3.6},
    {7.2, 7.2, 3.6, 3.6}, {10.8, 10.8, 3.6, 3.6},  {0, 0, -3.6, 3.6}, {0, 0, -7.2, 7.2},
    {0, 0, -3.6, 7.2},    {21.0, 39.6, -3.6, 18.0}};

static void bends_in_range(void **unused) {
  (void)unused;
  for (int k = 0; k < 10; k++) {
    const double *t = table_1[k];
    strand_shape s = shape(t[0], t[1], t[2], t[3]);
    double v[3 * N], most = fmax(fabs(t[2]), fabs(t[3])), widest = 0;
    for (uint32_t strand = 0; strand < 200; strand++) {
      strand_make(&s, strand, v);
      for (int i = 0; i + 1 < N; i++)
        assert_true(fabs(distance(v + 3 * i, v + 3 * i + 3) - 10.0 / (N - 1)) < 1e-12);
      for (int i = 0; i + 2 < N; i++) {
        widest = fmax(widest, bend(v, i));
        assert_true(bend(v, i) <= most + 1e-6);
      }
    }
    /* and the range is used */
    assert_true(widest >= 0.98 * most);
  }
}

/* A sum of rotations would not turn on and on, nor by the same at each joint. */
static void rotations_multiply(void **unused) {
  (void)unused;
  double v[3 * N];
  strand_shape flat = shape(0, 0, 7.2, 7.2);
  strand_make(&flat, 3, v);
  double first[3], last[3], n[3];
  segment(v, 0, first);
  segment(v, N - 2, last);
  cross(first, last, n);
  double turned = atan2(sqrt(dot(n, n)), dot(first, last)) * 180 / PI;
  /* 30 joints of 7.2 degrees: 216, which is 144 the other way round */
  assert_true(fabs(turned - 144) < 1e-6);
  for (int i = 0; i < N; i++) assert_true(fabs(v[3 * i + 1]) < 1e-12); /* in a plane */
  strand_shape coil = shape(10.8, 10.8, 3.6, 3.6);
  strand_make(&coil, 3, v);
  for (int i = 0; i + 3 < N; i++) {
    assert_true(fabs(bend(v, i) - 3.6) < 1e-6);
    assert_true(fabs(twist(v, i) - 10.8) < 1e-5);
  }
}

static void straight_is_straight(void **unused) {
  (void)unused;
  double v[3 * N];
  strand_shape s = shape(0, 90, 0, 0);
  strand_make(&s, 5, v);
  assert_true(fabs(distance(v, v + 3 * (N - 1)) - 10) < 1e-12);
  assert_true(v[3] > 0 && v[4] == 0 && v[5] == 0); /* the first segment lies on x */
}

/* Rotations of strands: as often one way as another. */
static void turned_every_way(void **unused) {
  (void)unused;
  double mean[3] = {0, 0, 0}, square[3] = {0, 0, 0};
  for (uint32_t i = 0; i < 20000; i++) {
    double t[9], id = 0;
    strand_rotation(1, i, t);
    for (int a = 0; a < 3; a++) {
      mean[a] += t[3 * a] / 20000;
      square[a] += t[3 * a] * t[3 * a] / 20000;
      id += t[a] * t[a];
    }
    assert_true(fabs(id - 1) < 1e-12);
  }
  for (int a = 0; a < 3; a++) {
    assert_true(fabs(mean[a]) < 0.015);
    assert_true(fabs(square[a] - 1.0 / 3) < 0.01);
  }
}

static void sines(void **unused) {
  (void)unused;
  for (int i = -300000; i < 300000; i++) {
    double s, c, x = i * 0.00713;
    strand_sine_cosine(x, &s, &c);
    assert_true(fabs(s - sin(x)) < 1e-13 && fabs(c - cos(x)) < 1e-13);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(figure_7),           cmocka_unit_test(bends_in_range),
      cmocka_unit_test(rotations_multiply), cmocka_unit_test(straight_is_straight),
      cmocka_unit_test(turned_every_way),   cmocka_unit_test(sines)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
