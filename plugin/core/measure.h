/* SPDX-License-Identifier: Apache-2.0
 *
 * Means, at creation, of what has no formula: the same bits for any width.
 */
#ifndef SOZAI_CORE_MEASURE_H
#define SOZAI_CORE_MEASURE_H

#include "hash1.h"
#include "lanes.h"

/* Points at..at+LANES-1 of those spread at random from 0 to `extent`, which is a power
 * of two, along an axis. */
INLINE vf measure_place(uint32_t at, uint32_t axis, float extent) {
  vf r = splat(0.0f);
  for (uint32_t k = 0; k < LANES; k++) {
    uint32_t h = hash1((at + k) * 3u + axis + 0x3c6ef372u);
    set_lane(&r, k, (float)(h >> 8) * (extent / 16777216.0f));
  }
  return r;
}

/* One after the other, so that the sum has the same bits for any width. */
INLINE void measure_add(double *sum, vf x) {
  for (uint32_t k = 0; k < LANES; k++) *sum += (double)lane(x, k);
}

#endif
