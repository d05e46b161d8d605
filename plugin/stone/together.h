/* SPDX-License-Identifier: Apache-2.0
 *
 * Layers that lie over one another, looked at under one footprint: where a body covers
 * what is dark, its share and the dark's do not simply multiply. What the looks of two
 * layers have seen at the same places gives the covariance by which they do not.
 */
#ifndef SOZAI_STONE_TOGETHER_H
#define SOZAI_STONE_TOGETHER_H

#include "looks.h"

/* A number that a look has seen, another look to each lane. own: the lanes' numbers. same: that
 * it is one look to all of them. */
INLINE vf seen_pick(const vf *of, vi slot, vi own, int same) {
#if LANES > 1
  if (same) return of[slot[0]];
  return gather((const float *)of, slot * splati(LANES) + own);
#else
  (void)own;
  (void)same;
  return of[slot];
#endif
}

/* Which of a layer's looks along a side is nearest to place i. rate: its looks to a place. */
INLINE vi seen_slot(int i, vf rate) {
  vi slot;
  (void)vfloor(splat((float)i + 0.5f) * rate, &slot);
  return slot;
}

/* Whether all lanes took as many looks. */
INLINE int seen_alike(const cells_grid *a, const cells_grid *b) {
  vf other = splat(0.0f);
  for (int k = 0; k < 2; k++) {
    other = other + vabs(a->n[k] - splat(lane(a->n[k], 0)));
    other = other + vabs(b->n[k] - splat(lane(b->n[k], 0)));
  }
  return !any(gt(other, splat(0.0f)));
}

/* The covariance over the footprint of what a layer covers of each of its parts with the shares of
 * another, below it: `parts` of them, of looks in rows of all. Zero where either was not looked at
 * in parts. */
INLINE void seen_covariance_as(const int parts, const cells_grid *above, const vf *covered,
                               const cells_grid *below, const vf (*of)[CELLS_STEPS * CELLS_STEPS],
                               vf *out) {
  static const int32_t numbers[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  vf zero = splat(0.0f), one = splat(1.0f), n[2], rate[2][2], sum = zero, each;
  vf alone[CELLS_PARTS], both[CELLS_PARTS];
  vi own;
  memcpy(&own, numbers, sizeof own);
  int same = seen_alike(above, below);
  for (int k = 0; k < parts; k++) alone[k] = both[k] = zero;
  for (int k = 0; k < 2; k++) {
    n[k] = vmax(above->n[k], below->n[k]);
    rate[0][k] = above->n[k] / n[k];
    rate[1][k] = below->n[k] / n[k];
  }
  each = one / (n[0] * n[1]);
  for (int j = 0; j < CELLS_STEPS; j++) {
    vm row = lt(splat((float)j), n[1]);
    if (!any(row)) break;
    vi upper = seen_slot(j, rate[0][1]) * splati(CELLS_STEPS);
    vi lower = seen_slot(j, rate[1][1]) * splati(CELLS_STEPS);
    for (int i = 0; i < CELLS_STEPS; i++) {
      vm there = and_(row, lt(splat((float)i), n[0]));
      if (!any(there)) break;
      vi slot = upper + seen_slot(i, rate[0][0]), under = lower + seen_slot(i, rate[1][0]);
      slot = seli(there, slot, splati(0));
      under = seli(there, under, splati(0));
      vf cover = sel(there, seen_pick(covered, slot, own, same), zero);
      sum = sum + cover;
      for (int k = 0; k < parts; k++) {
        vf x = sel(there, seen_pick(of[k], under, own, same), zero);
        alone[k] = alone[k] + x;
        both[k] = both[k] + cover * x;
      }
    }
  }
  vf counts = above->weight * below->weight;
  for (int k = 0; k < parts; k++) {
    vf c = (both[k] - sum * alone[k] * each) * each;
    out[k] = sel(gt(counts, zero), c * counts, zero);
  }
}

STAGE void seen_covariance(const cells_grid *above, const vf *covered, const cells_seen *seen,
                           vf out[CELLS_PARTS]) {
  seen_covariance_as(CELLS_PARTS, above, covered, &seen->grid, seen->of, out);
}

/* The same with the third kind's share. grid: its layer's. */
STAGE vf seen_covariance_third(const cells_grid *above, const vf *covered, const cells_grid *grid,
                               const vf (*thirds)[CELLS_STEPS * CELLS_STEPS]) {
  vf out;
  seen_covariance_as(1, above, covered, grid, thirds, &out);
  return out;
}

#endif
