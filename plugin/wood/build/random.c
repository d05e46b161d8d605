/* SPDX-License-Identifier: Apache-2.0
 *
 * What varies between woods of the same settings: numbers of a seed.
 */
#include "parts.h"

#include "../../core/scalar.h"

/* Middles of equally likely parts of the normal distribution, scaled so that
 * their standard deviation is 1: for ring widths, and for vessel radii. */
#define QUANTILES 512
static double quantiles[QUANTILES], radius_quantiles[WOOD_RADII];

static void scaled_quantiles(double *out, int count) {
  scalar_normal_quantiles(out, count);
  double square = 0.0;
  for (int i = 0; i < count; i++) square += out[i] * out[i];
  for (int i = 0; i < count; i++) out[i] /= __builtin_sqrt(square / count);
}

void wood_build_prepare(void) {
  scaled_quantiles(quantiles, QUANTILES);
  scaled_quantiles(radius_quantiles, WOOD_RADII);
}

double wood_normal(uint32_t seed, uint32_t stream, uint32_t k) {
  return quantiles[(uint32_t)(wood_uniform(seed, stream, k) * QUANTILES)];
}

double wood_radius_quantile(int i) { return radius_quantiles[i]; }
