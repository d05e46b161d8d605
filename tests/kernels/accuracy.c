/* SPDX-License-Identifier: Apache-2.0
 *
 * The elementary functions against the C library in double: the largest errors
 * are printed, and must stay within what maths.h and filter.h say of them.
 * One lane speaks for all: see core.c.
 */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <cmocka.h>

#include "core_kernels.h"

#define CHUNK 4096u

static float a[CHUNK], b[CHUNK], r[CHUNK], q[CHUNK];
static const float *const in[CORE_INPUTS] = {a, b, b, b};
static float *const out[CORE_OUTPUTS] = {r, q, r, q};
static uint64_t state;

static double uniform(double lo, double hi) {
  return lo + (hi - lo) * ((double)core_random(&state) + 0.5) / 4294967296.0;
}

/* The largest error of a function so far, and where it was. */
typedef struct {
  double error, at;
} worst;

static void look(worst *w, double error, double at) {
  if (!(error <= w->error)) *w = (worst){error, at};
}

static int report(const char *what, worst w, double bound) {
  print_message("%-44s %.3g at %.9g (allowed %.3g)%s\n", what, w.error, w.at, bound,
                w.error <= bound ? "" : "  TOO LARGE");
  return !(w.error <= bound);
}

static double relative(double x, double truth) { return fabs(x - truth) / fabs(truth); }

static void run(int f) { core_scalar_1.run[f](CHUNK, in, out); }

/* Every float of 1..4: the guess from the bits repeats with every factor 4. */
static void test_inverse_root(void **unused) {
  (void)unused;
  worst w = {0, 0}, wide = {0, 0};
  for (uint32_t c = 0; c < (1u << 24) / CHUNK; c++) {
    for (uint32_t i = 0; i < CHUNK; i++) a[i] = core_float(0x3f800000u + c * CHUNK + i);
    run(CORE_inverse_root);
    for (uint32_t i = 0; i < CHUNK; i++) look(&w, relative(r[i], 1.0 / sqrt(a[i])), a[i]);
  }
  for (uint32_t c = 0; c < 256; c++) {
    for (uint32_t i = 0; i < CHUNK; i++) a[i] = core_input(DOMAIN_POSITIVE, c * CHUNK + i, &state);
    run(CORE_inverse_root);
    for (uint32_t i = 0; i < CHUNK; i++) look(&wide, relative(r[i], 1.0 / sqrt(a[i])), a[i]);
  }
  int bad = report("inverse_root, relative, every float of 1..4", w, 3e-7);
  bad += report("inverse_root, relative, any size", wide, 3e-7);
  assert_int_equal(bad, 0);
}

/* Of sine and cosine of scale * x for |x| in lo..hi, quarter turns among them. */
static worst sine_errors(int f, double scale, double lo, double hi) {
  worst w = {0, 0};
  const float quarter = scale > 1.0 ? 0.25f : 1.57079633f;
  for (uint32_t c = 0; c < 256; c++) {
    for (uint32_t i = 0; i < CHUNK; i++) {
      a[i] = (float)(uniform(lo, hi) * (i & 1 ? 1.0 : -1.0));
      if (i < 64 && hi < 1e5) a[i] = quarter * rintf(a[i] / quarter);
    }
    run(f);
    for (uint32_t i = 0; i < CHUNK; i++) {
      double x = scale * fmod(a[i], scale > 1.0 ? 1.0 : 1e9);
      look(&w, fabs(r[i] - sin(x)), a[i]);
      look(&w, fabs(q[i] - cos(x)), a[i]);
    }
  }
  return w;
}

static void test_sine_cosine(void **unused) {
  (void)unused;
  int bad = report("sine_cosine, |x| < 8", sine_errors(CORE_sine_cosine, 1, 0, 8), 2e-7);
  bad += report("sine_cosine, 8..100", sine_errors(CORE_sine_cosine, 1, 8, 100), 3e-7);
  bad += report("sine_cosine, 100..1000", sine_errors(CORE_sine_cosine, 1, 100, 1000), 3e-7);
  bad += report("sine_cosine, 1000..20000", sine_errors(CORE_sine_cosine, 1, 1000, 20000), 1e-6);
  assert_int_equal(bad, 0);
}

/* Up to 2^21: from there the floats of x * 4 are whole numbers, and the half
 * that is added to them is rounded. */
static void test_turns(void **unused) {
  (void)unused;
  static const double ends[] = {0, 1, 1000, 0x1p20, 0x1p21};
  int bad = 0;
  for (int k = 0; k < 4; k++) {
    char what[64];
    snprintf(what, sizeof what, "sine_cosine_turns, %g..%g", ends[k], ends[k + 1]);
    bad += report(what,
                  sine_errors(CORE_sine_cosine_turns, 2.0 * 3.14159265358979323846, ends[k],
                              ends[k + 1] * 0.999999),
                  2e-7);
  }
  assert_int_equal(bad, 0);
}

static void test_arctan2(void **unused) {
  (void)unused;
  worst w = {0, 0};
  for (uint32_t c = 0; c < 1024; c++) {
    for (uint32_t i = 0; i < CHUNK; i++) {
      /* up to 1e30 in 1e-28: where den stays above what guards the division */
      double size = exp(uniform(-60, 60)), angle = uniform(-3.14159265, 3.14159265);
      a[i] = (float)(size * sin(angle));
      b[i] = (float)(size * cos(angle));
      if (i % 64 == 0) a[i] = i & 64 ? 0.0f : -0.0f;
      if (i % 64 == 1) b[i] = i & 64 ? 0.0f : -0.0f;
    }
    run(CORE_arctan2);
    for (uint32_t i = 0; i < CHUNK; i++) {
      /* -0 counts as 0 for x: no turn to -pi */
      double truth = atan2((double)a[i], b[i] == 0.0f ? 0.0 : (double)b[i]);
      if (a[i] == 0.0f && b[i] == 0.0f) truth = 0.0;
      look(&w, fabs(r[i] - truth), truth);
    }
  }
  a[0] = b[0] = 0.0f;
  run(CORE_arctan2);
  assert_true(r[0] == 0.0f);
  assert_int_equal(report("arctan2, at the angle", w, 3e-7), 0);
}

static void test_arcsin(void **unused) {
  (void)unused;
  worst w = {0, 0};
  for (uint32_t c = 0; c < 512; c++) {
    for (uint32_t i = 0; i < CHUNK; i++) a[i] = core_input(DOMAIN_UNIT, c * CHUNK + i, &state);
    run(CORE_arcsin);
    for (uint32_t i = 0; i < CHUNK; i++) {
      look(&w, fabs(r[i] - asin(fmax(-1.0, fmin(1.0, a[i])))), a[i]);
    }
  }
  assert_int_equal(report("arcsin", w, 5e-7), 0);
}

/* Every float of 1/2..2, around the zero, and others of any size. */
static void test_log2(void **unused) {
  (void)unused;
  worst w = {0, 0}, wide = {0, 0};
  for (uint32_t c = 0; c < (1u << 24) / CHUNK; c++) {
    for (uint32_t i = 0; i < CHUNK; i++) a[i] = core_float(0x3f000000u + c * CHUNK + i);
    run(CORE_log2_);
    for (uint32_t i = 0; i < CHUNK; i++) {
      if (a[i] != 1.0f) look(&w, relative(r[i], log2(a[i])), a[i]);
      if (a[i] == 1.0f) assert_true(r[i] == 0.0f);
    }
  }
  for (uint32_t c = 0; c < 256; c++) {
    for (uint32_t i = 0; i < CHUNK; i++) a[i] = core_input(DOMAIN_POSITIVE, c * CHUNK + i, &state);
    run(CORE_log2_);
    for (uint32_t i = 0; i < CHUNK; i++) {
      if (a[i] != 1.0f) look(&wide, relative(r[i], log2(a[i])), a[i]);
    }
  }
  int bad = report("log2_, relative, every float of 1/2..2", w, 3e-7);
  bad += report("log2_, relative, any size", wide, 3e-7);
  assert_int_equal(bad, 0);
}

static void test_exp2(void **unused) {
  (void)unused;
  worst w = {0, 0};
  for (uint32_t c = 0; c < 512; c++) {
    for (uint32_t i = 0; i < CHUNK; i++) {
      a[i] = (float)(c & 1 ? uniform(-126.0, 127.49) : uniform(-1.0, 1.0));
      if (i == 0) a[i] = -126.0f;
      if (i == 1) a[i] = 127.49999f;
      if (i == 2) a[i] = -126.00001f;
      if (i == 3) a[i] = -1e30f;
      if (i == 4) a[i] = -INFINITY;
    }
    run(CORE_exp2_);
    for (uint32_t i = 0; i < CHUNK; i++) {
      if (a[i] < -126.0f) assert_true(r[i] == 0.0f);
      if (a[i] >= -126.0f) look(&w, relative(r[i], exp2(a[i])), a[i]);
    }
  }
  assert_int_equal(report("exp2_, relative, -126..127.5", w, 3e-7), 0);
}

/* maths.h gives no bound: the logarithm's error grows with the exponent, but
 * so does what it cannot be seen in. */
static void test_power01(void **unused) {
  (void)unused;
  worst w = {0, 0};
  for (uint32_t c = 0; c < 512; c++) {
    for (uint32_t i = 0; i < CHUNK; i++) {
      a[i] = (float)(i & 1 ? uniform(0, 1) : 1.0 - exp(uniform(-16, 0)));
      b[i] = (float)exp(uniform(0, log(1000)));
      if (i == 0) a[i] = 0.0f;
      if (i == 2) a[i] = 1.0f;
    }
    run(CORE_power01);
    for (uint32_t i = 0; i < CHUNK; i++) look(&w, fabs(r[i] - pow(a[i], b[i])), a[i]);
    assert_true(r[0] <= 1e-30f && r[2] == 1.0f);
  }
  assert_int_equal(report("power01, absolute, exponents 1..1000", w, 4e-7), 0);
}

static void test_floor(void **unused) {
  (void)unused;
  for (uint32_t c = 0; c < 512; c++) {
    for (uint32_t i = 0; i < CHUNK; i++) a[i] = core_input(DOMAIN_WHOLE, c * CHUNK + i, &state);
    run(CORE_vfloor);
    for (uint32_t i = 0; i < CHUNK; i++) {
      assert_true((double)r[i] == floor(a[i]));
      assert_int_equal((int32_t)core_bits(q[i]), (int32_t)floor(a[i]));
    }
  }
}

/* sin(x)/x up to its first zero, and nothing after it. */
static void test_filter_wave(void **unused) {
  (void)unused;
  worst w = {0, 0};
  for (uint32_t c = 0; c < 256; c++) {
    for (uint32_t i = 0; i < CHUNK; i++) a[i] = (float)uniform(0, 1.5 / CORE_WAVE_FREQUENCY);
    a[0] = 0.0f;
    a[1] = 1.0f / CORE_WAVE_FREQUENCY;
    a[2] = 1e30f;
    run(CORE_filter_wave);
    for (uint32_t i = 0; i < CHUNK; i++) {
      double x = 3.14159265358979323846 * (double)a[i] * CORE_WAVE_FREQUENCY;
      double truth = x >= 3.14159265358979323846 ? 0.0 : x > 0.0 ? sin(x) / x : 1.0;
      look(&w, fabs(r[i] - truth), a[i]);
    }
    assert_true(r[0] == 1.0f && r[1] == 0.0f && r[2] == 0.0f);
  }
  assert_int_equal(report("filter_wave against sin(x)/x", w, 7e-4), 0);
}

/* 1 to half the size, 0 from twice the size, falling between. */
static void test_filter_keep(void **unused) {
  (void)unused;
  for (uint32_t i = 0; i < CHUNK; i++) a[i] = (float)i * 3.0f * CORE_KEEP_SIZE / CHUNK;
  run(CORE_filter_keep);
  for (uint32_t i = 0; i < CHUNK; i++) {
    assert_true(i == 0 || r[i] <= r[i - 1] + 1e-6f);
    if (a[i] <= 0.5f * CORE_KEEP_SIZE) assert_true(r[i] == 1.0f);
    if (a[i] >= 2.0f * CORE_KEEP_SIZE) assert_true(r[i] == 0.0f);
    double t = fmin(1.0, fmax(0.0, (a[i] / CORE_KEEP_SIZE - 0.5) / 1.5));
    assert_true(fabs(r[i] - (1.0 - t * t * (3.0 - 2.0 * t))) < 1e-6);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_inverse_root), cmocka_unit_test(test_sine_cosine),
      cmocka_unit_test(test_turns),        cmocka_unit_test(test_arctan2),
      cmocka_unit_test(test_arcsin),       cmocka_unit_test(test_log2),
      cmocka_unit_test(test_exp2),         cmocka_unit_test(test_power01),
      cmocka_unit_test(test_floor),        cmocka_unit_test(test_filter_wave),
      cmocka_unit_test(test_filter_keep)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
