/* SPDX-License-Identifier: Apache-2.0
 *
 * Directions that a batch gives: the light's and the eye's.
 */
#ifndef SOZAI_CORE_DIRECTIONS_H
#define SOZAI_CORE_DIRECTIONS_H

#include "lanes.h"

/* An input's direction at points i..i+n-1, unit, or `otherwise` where it is not given;
 * with zero_is_normal, also where what is given is none. */
INLINE void direction_of(const float *const from[3], uint32_t i, uint32_t n, const vf otherwise[3],
                         int zero_is_normal, vf out[3]) {
  for (int c = 0; c < 3; c++) out[c] = otherwise[c];
  if (!from[0]) return;
  vf v[3], size = splat(0.0f);
  for (int c = 0; c < 3; c++) {
    v[c] = load_lanes(from[c], i, n);
    size = size + vabs(v[c]);
  }
  vm given = and_(gt(size, splat(0.0f)), lt(size, splat(1e38f)));
  unit_direction(v);
  for (int c = 0; c < 3; c++) out[c] = zero_is_normal ? sel(given, v[c], otherwise[c]) : v[c];
}

#endif
