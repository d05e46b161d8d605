/* SPDX-License-Identifier: Apache-2.0
 *
 * Noise for what bends or clouds and is no surface, of which nobody asks for the
 * gradient: value noise, of three numbers from one hash or of one.
 */
#ifndef SOZAI_STONE_VALUE_H
#define SOZAI_STONE_VALUE_H

#include "../core/noise.h"
#include "../core/vectors.h"

/* sd of each, of all places, over HASH_ONE: corners' 1/3, times the mean of the blends'
 * squares, which is 26/35 along an axis for the cubic and 181/231 for the quintic. */
#define VALUE_SD_CUBIC 0.3697f
#define VALUE_SD 0.4004f
#define VALUE_SD_FLAT 0.4523f /* along two axes, quintic */

/* A lattice that stands aslant to the axes: its rows, of length 11. */
static const float value_aslant[3][3] = {
    {2.0f, 6.0f, 9.0f}, {6.0f, 7.0f, -6.0f}, {-9.0f, 6.0f, -2.0f}};

INLINE vu value_corner(const noise_axis a[3], int c, vu seed) {
  vu x = c & 1 ? a[0].high : a[0].low, y = c & 2 ? a[1].high : a[1].low;
  return x + y + ((c & 4 ? a[2].high : a[2].low) + seed);
}

#ifdef SPREADS
/* value_three of lanes that share a cell: its corners one to a lane. base: the hash term
 * of the first. */
INLINE vf value_three_shared(vu base, const noise_axis a[3], vf out[3]) {
  vu h = hash_upper(base + noise_corners());
  vf sum = splat(0.0f), end = sum;
  UNROLL(3)
  for (uint32_t k = 0; k < 3; k++) {
    vf v = to_float((vi)(h << (10 * k))), e[4], s[2];
    spread of = spread_of(v), right = spread_of(next_lane(v) - v);
    for (int i = 0; i < 4; i++) e[i] = splat(of.of[2 * i]) + splat(right.of[2 * i]) * a[0].w;
    for (int i = 0; i < 2; i++) s[i] = mix(e[2 * i], e[2 * i + 1], a[1].w);
    out[k] = mix(s[0], s[1], a[2].w);
    if (k == 0) {
      /* of the upper ends along x */
      spread up = spread_of(upper_lanes(v) - v);
      end = mix(splat(of.of[1]) + splat(up.of[1]) * a[1].w,
                splat(of.of[5]) + splat(up.of[5]) * a[1].w, a[2].w);
    } else {
      end = k == 1 ? mix(e[1], e[3], a[2].w) : s[1];
    }
    sum = sum + (out[k] * a[k].f - end * a[k].w);
  }
  return sum;
}

INLINE vf value_one_shared(vu base, const noise_axis a[3]) {
  vf v = hash_signed(base + noise_corners()), e[4];
  spread of = spread_of(v), right = spread_of(next_lane(v) - v);
  for (int i = 0; i < 4; i++) e[i] = splat(of.of[2 * i]) + splat(right.of[2 * i]) * a[0].w;
  return mix(mix(e[0], e[1], a[1].w), mix(e[2], e[3], a[1].w), a[2].w);
}
#endif

/* Value noise of three numbers within +-HASH_ONE that know nothing of each other; and
 * gradient noise, of which they are the corners' gradients: little besides, and with
 * next to nothing in it that is wider than its lattice. together: whether it may well be
 * that lanes share a cell, which changes nothing but the time. */
INLINE vf value_three(const vf p[3], vu seed, int together, vf out[3]) {
  static const uint32_t prime[3] = {HASH_X, HASH_Y, HASH_Z};
  noise_axis a[3];
  vf v[3][8], s[3][2], ends[3];
  for (int k = 0; k < 3; k++) a[k] = noise_split_cubic(p[k], prime[k]);
#ifdef SPREADS
  vu base = value_corner(a, 0, seed);
  if (together && alike((vi)base)) return value_three_shared(base, a, out);
#endif
  (void)together;
  for (int c = 0; c < 8; c++) {
    vu h = hash_upper(value_corner(a, c, seed));
    v[0][c] = to_float((vi)h);
    v[1][c] = to_float((vi)(h << 10));
    v[2][c] = to_float((vi)(h << 20));
  }
  for (int k = 0; k < 3; k++) {
    vf e[4];
    for (int i = 0; i < 4; i++) e[i] = mix(v[k][2 * i], v[k][2 * i + 1], a[0].w);
    for (int i = 0; i < 2; i++) s[k][i] = mix(e[2 * i], e[2 * i + 1], a[1].w);
    out[k] = mix(s[k][0], s[k][1], a[2].w);
    if (k == 1) ends[1] = mix(e[1], e[3], a[2].w);
  }
  /* a gradient times its corner's distance is that times the place in the cell, but for
   * what the upper ends along its axis have of it */
  ends[0] = mix(mix(v[0][1], v[0][3], a[1].w), mix(v[0][5], v[0][7], a[1].w), a[2].w);
  ends[2] = s[2][1];
  vf sum = splat(0.0f);
  for (int k = 0; k < 3; k++) sum = sum + (out[k] * a[k].f - ends[k] * a[k].w);
  return sum;
}

/* The three numbers of each corner, within +-HASH_ONE: of lanes that share a cell made one to a
 * lane. */
INLINE void value_corners(const noise_axis a[3], vu seed, vf v[3][8]) {
#ifdef SPREADS
  vu base = value_corner(a, 0, seed);
  if (alike((vi)base)) {
    vu h = hash_upper(base + noise_corners());
    UNROLL(3)
    for (uint32_t k = 0; k < 3; k++) {
      spread of = spread_of(to_float((vi)(h << (10 * k))));
      for (int c = 0; c < 8; c++) v[k][c] = splat(of.of[c]);
    }
    return;
  }
#endif
  for (int c = 0; c < 8; c++) {
    vu h = hash_upper(value_corner(a, c, seed));
    v[0][c] = to_float((vi)h);
    v[1][c] = to_float((vi)(h << 10));
    v[2][c] = to_float((vi)(h << 20));
  }
}

/* Numbers at the corners, blended; and how that grows along each axis. */
INLINE vf value_blend(const noise_axis a[3], const vf v[8], vf grows[3]) {
  vf dx[4], e[4], dy[2], s[2];
  for (int i = 0; i < 4; i++) {
    dx[i] = v[2 * i + 1] - v[2 * i];
    e[i] = v[2 * i] + dx[i] * a[0].w;
  }
  for (int i = 0; i < 2; i++) {
    dy[i] = e[2 * i + 1] - e[2 * i];
    s[i] = e[2 * i] + dy[i] * a[1].w;
  }
  grows[0] = mix(mix(dx[0], dx[1], a[1].w), mix(dx[2], dx[3], a[1].w), a[2].w) * a[0].dw;
  grows[1] = mix(dy[0], dy[1], a[2].w) * a[1].dw;
  grows[2] = (s[1] - s[0]) * a[2].dw;
  return mix(s[0], s[1], a[2].w);
}

/* value_three to the bit, and how its numbers grow along each axis; where `along` gives two
 * directions, along these. */
INLINE vf value_three_grown(const vf p[3], vu seed, const vf (*along)[3], vf out[3],
                            vf grows[3][3]) {
  static const uint32_t prime[3] = {HASH_X, HASH_Y, HASH_Z};
  noise_axis a[3];
  vf v[3][8], ends[3], sum = splat(0.0f);
  for (int k = 0; k < 3; k++) a[k] = noise_split_cubic(p[k], prime[k]);
  value_corners(a, seed, v);
  for (int k = 0; k < 3; k++) {
    vf g[3];
    out[k] = value_blend(a, v[k], g);
    for (int i = 0; i < 3; i++) {
      if (!along) grows[k][i] = g[i];
      if (along && i < 2) grows[k][i] = dot3(g, along[i]);
    }
  }
  for (int k = 0; k < 3; k++) {
    /* the four ends along the number's own axis, the first two of them beside each other along the
     * next */
    static const int at[3][4] = {{1, 3, 5, 7}, {2, 3, 6, 7}, {4, 5, 6, 7}};
    const noise_axis *first = &a[k == 0 ? 1 : 0], *second = &a[k == 2 ? 1 : 2];
    const vf *e = v[k];
    ends[k] = mix(mix(e[at[k][0]], e[at[k][1]], first->w), mix(e[at[k][2]], e[at[k][3]], first->w),
                  second->w);
  }
  for (int k = 0; k < 3; k++) sum = sum + (out[k] * a[k].f - ends[k] * a[k].w);
  return sum;
}

/* Gradient noise with its gradient, as core's of other corners: theirs are numbers left unscaled.
 */
INLINE vf value_gradient(const vf p[3], vu seed, vf out[3]) {
  static const uint32_t prime[3] = {HASH_X, HASH_Y, HASH_Z};
  const vf one = splat(1.0f), each = splat(1.0f / HASH_ONE);
  noise_axis a[3];
  vf v[3][8], height[8], unused[3];
  for (int k = 0; k < 3; k++) a[k] = noise_split(p[k], prime[k]);
  value_corners(a, seed, v);
  for (int c = 0; c < 8; c++) {
    const vf from[3] = {c & 1 ? a[0].f - one : a[0].f, c & 2 ? a[1].f - one : a[1].f,
                        c & 4 ? a[2].f - one : a[2].f};
    height[c] = v[0][c] * from[0] + v[1][c] * from[1] + v[2][c] * from[2];
  }
  vf n = value_blend(a, height, out);
  for (int k = 0; k < 3; k++) out[k] = (out[k] + value_blend(a, v[k], unused)) * each;
  return n * each;
}

/* How far beds rise and fall: a height over the plane that they lay in. sd 0.224 of
 * `wave`. p: bed space; slope: along its x and z, per mm; along y it is `lag` of x's. Where there
 * is a lag each bed's wave lies that much further on, over how high, than that of the bed below:
 * between two whose waves differ the beds swell and pinch. The lattice stands aslant. */
INLINE vf beds_wave(const vf p[3], float wave, float frequency, float lag, uint32_t seed,
                    vf slope[2]) {
  const float high = wave * (0.224f / VALUE_SD_FLAT / HASH_ONE);
  vf along = splat(0.8f * frequency), aside = splat(0.6f * frequency), dx, dz;
  vf on = p[0] + splat(lag) * p[1];
  noise_axis x = noise_split(on * along + p[2] * aside, HASH_X),
             z = noise_split(p[2] * along - on * aside, HASH_Z);
  vf n = noise_value2(&x, &z, splatu(seed), &dx, &dz);
  slope[0] = splat(high) * (dx * along - dz * aside);
  slope[1] = splat(high) * (dz * along + dx * aside);
  return splat(high) * n;
}

/* Value noise of one, within +-HASH_ONE. */
INLINE vf value_one(const vf p[3], vu seed) {
  static const uint32_t prime[3] = {HASH_X, HASH_Y, HASH_Z};
  noise_axis a[3];
  vf v[8], e[4], s[2];
  for (int k = 0; k < 3; k++) a[k] = noise_split(p[k], prime[k]);
#ifdef SPREADS
  vu base = value_corner(a, 0, seed);
  if (alike((vi)base)) return value_one_shared(base, a);
#endif
  for (int c = 0; c < 8; c++) v[c] = hash_signed(value_corner(a, c, seed));
  for (int i = 0; i < 4; i++) e[i] = mix(v[2 * i], v[2 * i + 1], a[0].w);
  for (int i = 0; i < 2; i++) s[i] = mix(e[2 * i], e[2 * i + 1], a[1].w);
  return mix(s[0], s[1], a[2].w);
}

#endif
