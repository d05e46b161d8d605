/* SPDX-License-Identifier: Apache-2.0
 *
 * Lanes that lie close together, as neighbours of a raster do: what they have in
 * common. Only where lanes are many and it is cheap to ask.
 */
#ifndef SOZAI_CORE_PATCH_H
#define SOZAI_CORE_PATCH_H

#include "simd.h"

#ifdef SPREADS

/* Whether the lanes of a few vectors hold one number, or that and the next; the former in all
 * lanes, and which hold the latter. */
INLINE int one_apart(const vi *i, int count, vi *base, vm *upper) {
  __m512i first = _mm512_broadcastd_epi32(_mm512_castsi512_si128((__m512i)i[0]));
  uint32_t below = 0, far = 0;
  for (int n = 0; n < count; n++) below |= _mm512_cmplt_epi32_mask((__m512i)i[n], first);
  *base = (vi)first - splati(below != 0);
  for (int n = 0; n < count; n++) {
    __m512i d = (__m512i)(i[n] - *base);
    upper[n] = _mm512_test_epi32_mask(d, d);
    far |= _mm512_cmpgt_epu32_mask(d, _mm512_set1_epi32(1));
  }
  return far == 0;
}

/* Halves, quarters, pairs and neighbours change places. */
INLINE vf change_places(vf x, int step) {
  __m512 v = (__m512)x;
  if (step == 0) return (vf)_mm512_shuffle_f32x4(v, v, 0x4e);
  if (step == 1) return (vf)_mm512_shuffle_f32x4(v, v, 0xb1);
  if (step == 2) return (vf)_mm512_permute_ps(v, 0x4e);
  return (vf)_mm512_permute_ps(v, 0xb1);
}

/* The least of the lanes of x and the greatest of those of y, in all of them. */
INLINE void range_across(vf x, vf y, vf *least, vf *most) {
  UNROLL(4)
  for (int k = 0; k < 4; k++) {
    x = vmin(x, change_places(x, k));
    y = vmax(y, change_places(y, k));
  }
  *least = x;
  *most = y;
}
INLINE void range_of(vf v, vf *least, vf *most) { range_across(v, v, least, most); }

/* Of the numbers in all lanes of some vectors, in each lane rising: the second least, and
 * the third. */
INLINE vf second_of(const vf v[2]) {
  vf x = v[0], y = v[1];
  UNROLL(4)
  for (int k = 0; k < 4; k++) {
    vf a = change_places(x, k), b = change_places(y, k);
    y = vmin(vmin(y, b), vmax(x, a));
    x = vmin(x, a);
  }
  return y;
}
INLINE vf third_of(const vf v[3]) {
  vf x = v[0], y = v[1], z = v[2];
  UNROLL(4)
  for (int k = 0; k < 4; k++) {
    vf a = change_places(x, k), b = change_places(y, k), c = change_places(z, k);
    z = vmin(vmin(z, c), vmin(vmax(y, a), vmax(x, b)));
    y = vmin(vmin(y, b), vmax(x, a));
    x = vmin(x, a);
  }
  return z;
}

/* Which lanes, a bit to each. */
INLINE uint64_t lanes_of(vm m) { return m; }

/* Each lane's own number. */
INLINE vi lane_numbers(void) { return (vi){0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}; }

#endif
#endif
