/* SPDX-License-Identifier: Apache-2.0 */
#include "scalar.h"

#include <stdint.h>
#include <string.h>

#define LN2 0.693147180559945309417

static double whole(double x) {
  double n = (double)(int64_t)x;
  return n > x ? n - 1.0 : n;
}

double scalar_sin(double x) {
  double r = x - 2.0 * PI * whole(x / (2.0 * PI) + 0.5);
  /* Taylor's series to r^25 on -pi..pi: the last term is below 2e-13 */
  double term = r, sum = r;
  for (int k = 1; k <= 13; k++) {
    term *= -r * r / ((2.0 * k) * (2.0 * k + 1.0));
    sum += term;
  }
  return sum;
}

double scalar_cos(double x) { return scalar_sin(x + 0.5 * PI); }

double scalar_log(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  int64_t e = (int64_t)(bits >> 52) - 1022;
  bits = (bits & 0x000fffffffffffffull) | 0x3fe0000000000000ull;
  double m;
  memcpy(&m, &bits, sizeof m); /* 0.5 <= m < 1 */
  double t = (m - 0.75) / (m + 0.75), z = t * t, term = t, sum = t;
  for (int k = 3; k <= 25; k += 2) {
    term *= z;
    sum += term / k;
  }
  return 2.0 * sum + (double)e * LN2 - 0.287682072451780927439; /* ln 0.75 */
}

double scalar_exp(double x) {
  if (x < -700.0) return 0.0;
  if (x > 700.0) x = 700.0;
  double n = whole(x / LN2 + 0.5), r = x - n * LN2, term = 1.0, sum = 1.0;
  for (int k = 1; k <= 16; k++) {
    term *= r / k;
    sum += term;
  }
  uint64_t bits = (uint64_t)((int64_t)n + 1023) << 52;
  double scale;
  memcpy(&scale, &bits, sizeof scale);
  return sum * scale;
}

/* The normal distribution's lower tail by its power series, |x| < 6. */
static double normal_cdf(double x, double density) {
  double term = x, sum = x;
  for (int k = 1; k < 200 && (term > 1e-17 || term < -1e-17); k++) {
    term *= x * x / (2.0 * k + 1.0);
    sum += term;
  }
  return 0.5 + sum * density;
}

void scalar_normal_quantiles(double *out, int count) {
  /* Newton's method from one quantile to the next, from the middle out: the
   * starting point is never far off, and the other half is its mirror. */
  double x = 0.0;
  for (int i = count / 2; i < count; i++) {
    double p = (i + 0.5) / count;
    for (int k = 0; k < 6; k++) {
      double density = scalar_exp(-0.5 * x * x) / 2.50662827463100050242;
      x -= (normal_cdf(x, density) - p) / density;
    }
    out[i] = x;
    out[count - 1 - i] = -x;
  }
}
