/* SPDX-License-Identifier: Apache-2.0
 *
 * What layers of vessels, and canals, have in common: their radii.
 */
#include "parts.h"

double wood_build_radii(wood_vessels *v, double diameter_um, double spread) {
  double square = 0.0;
  for (int i = 0; i < WOOD_RADII; i++) {
    double k = 1.0 + spread * wood_radius_quantile(i);
    if (k < 0.2) k = 0.2;
    square += k * k;
    v->inverse_square[i] = (float)(1.0 / (k * k));
  }
  v->radius = (float)(0.5e-3 * diameter_um);
  /* disc.top is 2.5 at the most; a little farther, so that rounding leaves
   * nothing beyond it */
  v->farthest = 2.5001f / v->inverse_square[WOOD_RADII - 1];
  return square / WOOD_RADII;
}

/* The blurred disc's half length is sqrt(end (R^2 + e^2 / (12 * 0.2552))). */
float wood_longest_footprint(double clear, double radius, double end) {
  double e2 = (clear * clear / end - radius * radius) * 12.0 * 0.2552;
  double least = radius * radius;
  if (e2 < least) e2 = least;
  return (float)__builtin_sqrt(e2);
}
