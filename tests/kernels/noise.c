/* SPDX-License-Identifier: Apache-2.0
 *
 * Noise: derivatives against differences of the values, bounds, zeros, and no
 * step from one cell to the next.
 */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "core_kernels.h"

#define CHUNK 4096u
#define ONE 2147483648.0         /* value noise is left in these units */
#define AXIAL_SLOPE_BOUND 1.3472 /* of noise.h */

static float a[CORE_INPUTS][CHUNK], r[CORE_OUTPUTS][CHUNK];
static const float *const in[CORE_INPUTS] = {a[0], a[1], a[2], a[3]};
static float *const out[CORE_OUTPUTS] = {r[0], r[1], r[2], r[3]};
static uint64_t state = 3;

/* A kind of noise: its coordinates come first, its slopes follow the value. */
typedef struct {
  int f, dimensions, axial; /* axial: which coordinate is, or -1 */
  double unit, bound;
} noise;

static const noise kinds[] = {
    {CORE_noise_value1, 1, -1, ONE, 1.0},    {CORE_noise_value1_cubic, 1, -1, ONE, 1.0},
    {CORE_noise_value2, 2, -1, ONE, 1.0},    {CORE_noise_axial1, 1, 0, 1.0, 0.5},
    {CORE_noise_axial2, 2, 0, 1.0, 0.5},     {CORE_noise_axial3, 3, 1, 1.0, 0.5},
    {CORE_noise_gradient3, 3, -1, 1.0, 1.2},
};
#define KINDS (sizeof kinds / sizeof kinds[0])

static double uniform(double lo, double hi) {
  return lo + (hi - lo) * ((double)core_random(&state) + 0.5) / 4294967296.0;
}

/* Dyadic places that stay `margin` off the lattice planes: inside a cell the
 * noise is a polynomial, and x + h is exact. */
static void places(int dimensions, double margin) {
  for (uint32_t i = 0; i < CHUNK; i++) {
    for (int c = 0; c < CORE_INPUTS; c++) {
      double x = floor(uniform(-300, 300)) + uniform(margin, 1.0 - margin);
      a[c][i] = (float)(floor(x * 4096.0) / 4096.0);
    }
    a[dimensions][i] = core_float(core_random(&state));
  }
}

static double shifted[5][CHUNK];

/* Derivative along one axis from five values, to the fourth order in h. */
static void differences(const noise *n, int axis, double h, double *d) {
  float centre[CHUNK];
  for (uint32_t i = 0; i < CHUNK; i++) centre[i] = a[axis][i];
  for (int k = 0; k < 5; k++) {
    for (uint32_t i = 0; i < CHUNK; i++) a[axis][i] = centre[i] + (float)((k - 2) * h);
    core_scalar_1.run[n->f](CHUNK, in, out);
    for (uint32_t i = 0; i < CHUNK; i++) shifted[k][i] = (double)r[0][i] / n->unit;
  }
  for (uint32_t i = 0; i < CHUNK; i++) {
    a[axis][i] = centre[i];
    d[i] = (shifted[0][i] - 8.0 * shifted[1][i] + 8.0 * shifted[3][i] - shifted[4][i]) / (12.0 * h);
  }
}

static void slopes(void **unused) {
  (void)unused;
  int bad = 0;
  for (uint32_t k = 0; k < KINDS; k++) {
    const noise *n = &kinds[k];
    double worst = 0.0, steepest = 0.0;
    for (int round = 0; round < 32; round++) {
      static double d[CHUNK];
      places(n->dimensions, 3.0 / 64.0);
      for (int axis = 0; axis < n->dimensions; axis++) {
        differences(n, axis, 1.0 / 64.0, d);
        core_scalar_1.run[n->f](CHUNK, in, out);
        for (uint32_t i = 0; i < CHUNK; i++) {
          double slope = (double)r[1 + axis][i] / n->unit;
          worst = fmax(worst, fabs(slope - d[i]));
          steepest = fmax(steepest, fabs(slope));
        }
      }
    }
    print_message("%-20s slopes to %.2f, off the values' differences by %.2g at most\n",
                  core_descriptions[n->f].name, steepest, worst);
    bad += !(worst < 1e-4);
  }
  assert_int_equal(bad, 0);
}

/* The same for the sum of octaves, whose footprint takes the seed's place. */
static void fractal_slopes(void **unused) {
  (void)unused;
  static const noise n = {CORE_noise_fractal3, 3, -1, 1.0, 0.0};
  double worst = 0.0;
  for (int round = 0; round < 16; round++) {
    static double d[CHUNK];
    places(3, 3.0 / 64.0);
    for (uint32_t i = 0; i < CHUNK; i++) {
      /* near the origin: further out x * 19 rounds by what the steps are of */
      for (int c = 0; c < 3; c++) a[c][i] = fmodf(a[c][i], 2.0f);
      a[3][i] = (float)uniform(0.0, 0.6);
    }
    for (int axis = 0; axis < 3; axis++) {
      /* short steps: the finest octave is nineteen times finer, and its lattice
       * planes lie anywhere */
      differences(&n, axis, 1.0 / 4096.0, d);
      core_scalar_1.run[n.f](CHUNK, in, out);
      for (uint32_t i = 0; i < CHUNK; i++) {
        worst = fmax(worst, fabs((double)r[1 + axis][i] - d[i]));
      }
    }
  }
  print_message("%-20s off the values' differences by %.2g at most\n", "noise_fractal3", worst);
  assert_true(worst < 0.01);
}

/* A footprint above every octave's spacing leaves nothing. */
static void fractal_fades(void **unused) {
  (void)unused;
  places(3, 0.0);
  for (uint32_t i = 0; i < CHUNK; i++) a[3][i] = 1.0f;
  core_scalar_1.run[CORE_noise_fractal3](CHUNK, in, out);
  for (uint32_t i = 0; i < CHUNK; i++) {
    assert_true(r[0][i] == 0.0f && r[1][i] == 0.0f && r[2][i] == 0.0f && r[3][i] == 0.0f);
  }
}

static void bounds(void **unused) {
  (void)unused;
  int bad = 0;
  for (uint32_t k = 0; k < KINDS; k++) {
    const noise *n = &kinds[k];
    double most = 0.0, steepest = 0.0;
    for (int round = 0; round < 256; round++) {
      places(n->dimensions, 0.0);
      core_scalar_1.run[n->f](CHUNK, in, out);
      for (uint32_t i = 0; i < CHUNK; i++) {
        most = fmax(most, fabs((double)r[0][i]) / n->unit);
        if (n->axial >= 0) steepest = fmax(steepest, fabs((double)r[1 + n->axial][i]));
      }
    }
    print_message("%-20s within %.4f (allowed %.1f)", core_descriptions[n->f].name, most, n->bound);
    if (n->axial >= 0) {
      print_message(", slope along its axis within %.4f (allowed %.4f)", steepest,
                    AXIAL_SLOPE_BOUND);
    }
    print_message("\n");
    bad += !(most <= n->bound) + !(steepest <= AXIAL_SLOPE_BOUND);
  }
  assert_int_equal(bad, 0);
}

/* The bound itself: with gradients of +-1 at both ends the slope can reach
 * |1 - w - f w'| + |w + (f - 1) w'|. */
static void slope_bound(void **unused) {
  (void)unused;
  double most = 0.0;
  for (int i = 0; i <= 1000000; i++) {
    double f = i / 1e6, w = f * f * f * (10.0 + f * (-15.0 + f * 6.0));
    double dw = 30.0 * f * f * (1.0 - f) * (1.0 - f);
    most = fmax(most, fabs(1.0 - w - f * dw) + fabs(w + (f - 1.0) * dw));
  }
  print_message("the slope's bound is %.6f\n", most);
  assert_true(most <= AXIAL_SLOPE_BOUND && most > AXIAL_SLOPE_BOUND - 2e-4);
}

/* Exactly zero on the axis's lattice planes: not nearly. */
static void axial_zeros(void **unused) {
  (void)unused;
  for (uint32_t k = 0; k < KINDS; k++) {
    const noise *n = &kinds[k];
    if (n->axial < 0) continue;
    for (int round = 0; round < 16; round++) {
      places(n->dimensions, 0.0);
      for (uint32_t i = 0; i < CHUNK; i++) {
        a[n->axial][i] = i < 16 ? 0.0f : (float)floor(uniform(-1e6, 1e6));
      }
      core_scalar_1.run[n->f](CHUNK, in, out);
      for (uint32_t i = 0; i < CHUNK; i++) {
        assert_true(r[0][i] == 0.0f);
        for (int c = 0; c < n->dimensions; c++) {
          if (c != n->axial) assert_true(r[1 + c][i] == 0.0f);
        }
      }
    }
  }
}

/* On either side of a lattice plane: value and slopes agree. */
static void no_seams(void **unused) {
  (void)unused;
  static float before[CORE_OUTPUTS][CHUNK];
  for (uint32_t k = 0; k < KINDS; k++) {
    const noise *n = &kinds[k];
    double worst = 0.0;
    for (int axis = 0; axis < n->dimensions; axis++) {
      places(n->dimensions, 0.0);
      for (uint32_t i = 0; i < CHUNK; i++) a[axis][i] = (float)floor(uniform(-100, 100));
      core_scalar_1.run[n->f](CHUNK, in, out);
      for (int o = 0; o <= n->dimensions; o++) {
        for (uint32_t i = 0; i < CHUNK; i++) before[o][i] = r[o][i];
      }
      for (uint32_t i = 0; i < CHUNK; i++) a[axis][i] = nextafterf(a[axis][i], -1e9f);
      core_scalar_1.run[n->f](CHUNK, in, out);
      for (int o = 0; o <= n->dimensions; o++) {
        for (uint32_t i = 0; i < CHUNK; i++) {
          worst = fmax(worst, fabs((double)r[o][i] - (double)before[o][i]) / n->unit);
        }
      }
    }
    print_message("%-20s steps by %.2g at most at a cell's border\n", core_descriptions[n->f].name,
                  worst);
    assert_true(worst < 3e-4);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(slopes),  cmocka_unit_test(fractal_slopes), cmocka_unit_test(fractal_fades),
      cmocka_unit_test(bounds),  cmocka_unit_test(slope_bound),    cmocka_unit_test(axial_zeros),
      cmocka_unit_test(no_seams)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
