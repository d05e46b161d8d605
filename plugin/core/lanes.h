/* SPDX-License-Identifier: Apache-2.0
 *
 * From a batch's arrays to lanes and back: what the header says of numbers
 * that are none.
 */
#ifndef SOZAI_CORE_LANES_H
#define SOZAI_CORE_LANES_H

#include "../../api/sozai.h"
#include "maths.h"

/* Lanes past the end of the batch repeat the last point: they must not send
 * the others into a branch of their own. */
static __attribute__((noinline, cold, unused)) void load_some(const float *p, uint32_t i,
                                                              uint32_t n, vf *out) {
  vf r = splat(p[i + n - 1]);
  for (uint32_t k = 0; k + 1 < n; k++) set_lane(&r, k, p[i + k]);
  *out = r;
}
INLINE vf load_lanes(const float *p, uint32_t i, uint32_t n) {
  if (__builtin_expect(n == LANES, 1)) return load(p + i);
  vf r;
  load_some(p, i, n, &r);
  return r;
}

static __attribute__((noinline, cold, unused)) void store_some(float *to, uint32_t i, uint32_t n,
                                                               const vf *x) {
  for (uint32_t k = 0; k < n; k++) to[i + k] = lane(*x, k);
}
INLINE void store_lanes_of(float *to, uint32_t i, uint32_t n, vf x) {
  if (__builtin_expect(n == LANES, 1)) {
    store(to + i, x);
    return;
  }
  store_some(to, i, n, &x);
}

/* Whether some numbers are to the bit what others are, in all lanes. */
INLINE int same_lanes(const vf *a, const vf *b, int count) {
  vi differ = splati(0);
  UNROLL(4)
  for (int k = 0; k < count; k++) differ |= bits_of(a[k]) ^ bits_of(b[k]);
  return !any(not_(eqi(differ, splati(0))));
}

/* Whether an input's direction at points i..i+n-1 is that of the block before, as on flat ground
 * it is: what has been made of it then need not be made again. */
INLINE int as_before(const float *const direction[3], uint32_t i, uint32_t n) {
  if (!direction[0] || n < LANES) return 0;
  vf now[3], before[3];
  UNROLL(3)
  for (int c = 0; c < 3; c++) {
    const float *at = direction[c] + i;
    now[c] = load(at);
    before[c] = load(at - LANES);
  }
  return same_lanes(now, before, 3);
}

/* NaN to 0, and the rest within a kilometre. */
INLINE vf finite_coordinate(vf x) {
  x = sel(eq(x, x), x, splat(0.0f));
  return clamp(x, splat(-1e6f), splat(1e6f));
}

/* A direction of any length to a unit one; +z where it has none. What is unit
 * already to a few units in the last place stays as it is. */
INLINE void unit_direction(vf v[3]) {
  vf square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  if (!any(not_(le(vabs(square - splat(1.0f)), splat(4e-7f))))) return;
  vm usual = and_(gt(square, splat(1e-20f)), lt(square, splat(1e20f)));
  if (any(not_(usual))) {
    /* too long or short to square, or not a direction at all */
    vf big = vmax(vmax(vabs(v[0]), vabs(v[1])), vabs(v[2]));
    /* NaN loses every comparison: a sum is NaN or infinite if any part is */
    vf all = vabs(v[0]) + vabs(v[1]) + vabs(v[2]);
    vm bad = not_(and_(gt(big, splat(1e-30f)), lt(all, splat(1e38f))));
    vf k = splat(1.0f) / sel(bad, splat(1.0f), big);
    for (int c = 0; c < 3; c++) {
      vf x = sel(bad, splat(c == 2 ? 1.0f : 0.0f), v[c] * k);
      v[c] = sel(usual, v[c], x);
    }
    square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  }
  vm off = gt(vabs(square - splat(1.0f)), splat(4e-7f));
  vf l = sel(off, inverse_root(square), splat(1.0f));
  for (int c = 0; c < 3; c++) v[c] = v[c] * l;
}

#endif
