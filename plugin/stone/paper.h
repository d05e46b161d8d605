/* SPDX-License-Identifier: Apache-2.0
 *
 * The colours of Yamanaka and Nagaoka's paper, literally: to every texel
 * R' = {R +- eR}, G' and B' likewise, of 8-bit display-referred RGB, rounded and
 * held within 0 to 255 (the paper prints 256); and texels of black and white.
 *
 * A code's way into the working space is a curve for each channel and a matrix
 * for all, so that a texel is the sum of three entries of a table made at
 * creation by the colour service: exactly its colour.
 */
#ifndef SOZAI_STONE_PAPER_H
#define SOZAI_STONE_PAPER_H

#include "../core/hash.h"
#include "../core/maths.h"
#include "paper_tile.h"
#include "stone.h"

#define PAPER_STEPS 4

/* -1..1 */
INLINE vf paper_number(vu h, uint32_t which) {
  vu m = hash_mix(h ^ splatu(which * 0x9e3779b9u));
  return to_float((vi)(m >> 8)) * splat(2.0f / 16777215.0f) - splat(1.0f);
}

INLINE vi paper_code(vf x) { return to_int(clamp(x, splat(0.0f), splat(255.0f)) + splat(0.5f)); }

/* A texel: adds part of its colour, and of its being black or white. */
INLINE void paper_texel(const stone_constants *w, vu h, vf part, vf sum[4]) {
  vf code[3], zero = splat(0.0f);
  if (w->mode == 1) {
    for (uint32_t c = 0; c < 3; c++) {
      code[c] = splat(w->base[c]) + splat(w->spread[c]) * paper_number(h, c + 1u);
    }
  } else {
    vf light = splat(w->luma) + splat(w->lightness) * paper_number(h, 1u);
    vf chroma = splat(1.0f) + splat(w->chroma) * paper_number(h, 2u);
    for (uint32_t c = 0; c < 3; c++) {
      code[c] = light + splat(w->base[c] - w->luma) * chroma;
    }
  }
  vf u = to_float((vi)(hash_mix(h ^ splatu(0x85ebca6bu)) >> 8)) * splat(1.0f / 16777216.0f);
  vm black = lt(u, splat(w->black)), speck = lt(u, splat(w->white));
  for (int c = 0; c < 3; c++) {
    code[c] = sel(speck, sel(black, zero, splat(255.0f)), code[c]);
  }
  for (int c = 0; c < 3; c++) {
    vi at = paper_code(code[c]) * splati(3);
    const float *table = w->decode[c][0];
    for (int k = 0; k < 3; k++) sum[k] = sum[k] + part * gather(table + k, at);
  }
  sum[3] = sum[3] + sel(speck, part, zero);
}

INLINE void paper_joint_texel(const stone_constants *w, vf part, vf sum[4]) {
  for (int k = 0; k < 3; k++) sum[k] = sum[k] + part * splat(w->tile.joint_colour[k]);
}

/* One square no wider than a texel: the two texels that it meets along each
 * axis, by their shares. */
STAGE void paper_look(const stone_constants *w, const vf q[3], const vf e[3], vf part, vf sum[4]) {
  vu at[3][2];
  vf share[3][2], index[3];
  static const uint32_t axis[3] = {HASH_X, HASH_Y, HASH_Z};
  for (int k = 0; k < 3; k++) {
    vi i;
    index[k] = vfloor(q[k] - splat(0.5f) * e[k], &i);
    vf end = index[k] + splat(1.0f);
    vf beyond = (q[k] + splat(0.5f) * e[k] - end) / vmax(e[k], splat(1e-6f));
    share[k][1] = clamp01(beyond);
    share[k][0] = splat(1.0f) - share[k][1];
    at[k][0] = (vu)i * splatu(axis[k]);
    at[k][1] = at[k][0] + splatu(axis[k]);
  }
  for (int c = 0; c < 8; c++) {
    vf of = share[0][c & 1] * share[1][c >> 1 & 1] * share[2][c >> 2];
    if (!any(gt(of, splat(0.0f)))) continue; /* it would add nothing */
    if (w->tile.on) {
      if (c >> 2) continue; /* a picture: the same at all depths */
      of = share[0][c & 1] * share[1][c >> 1];
      tile_place place =
          tile_at(&w->tile, index[0] + splat((float)(c & 1)), index[1] + splat((float)(c >> 1)));
      vf stone = sel(gt(place.depth, splat(0.0f)), of, splat(0.0f));
      paper_texel(w, hash_mix(place.h + splatu(w->seed)), stone * part, sum);
      paper_joint_texel(w, (of - stone) * part, sum);
      continue;
    }
    vu h = hash_mix(at[0][c & 1] + at[1][c >> 1 & 1] + at[2][c >> 2] + splatu(w->seed));
    paper_texel(w, h, of * part, sum);
  }
}

/* sum: the colour, and the share of black and white. */
INLINE void paper_at(const stone_constants *w, const vf p[3], const vf t1[3], const vf t2[3], vf s,
                     vf sum[4]) {
  vf zero = splat(0.0f), one = splat(1.0f);
  vf wide = s * splat(w->inverse_texel);
  vi whole;
  vf n = clamp(vfloor(wide + splat(0.999f), &whole), one, splat(PAPER_STEPS));
  vf inverse = one / n, h = s * inverse, part = inverse * inverse;
  vf keep = one - smooth_step(splat(4.0f), splat(8.0f), wide);
  vm seen = gt(keep, zero);
  vf e[3];
  for (int k = 0; k < 3; k++) {
    sum[k] = zero;
    vf u = vabs(t1[k]), v = vabs(t2[k]);
    e[k] = vmin(h * (u + v) * splat(w->inverse_texel), one);
  }
  sum[3] = zero;
  for (int j = 0; j < PAPER_STEPS; j++) {
    vm row = and_(seen, lt(splat((float)j), n));
    if (!any(row)) break;
    vf v = (splat((float)j + 0.5f) - splat(0.5f) * n) * h;
    for (int i = 0; i < PAPER_STEPS; i++) {
      vm there = and_(row, lt(splat((float)i), n));
      if (!any(there)) break;
      vf u = (splat((float)i + 0.5f) - splat(0.5f) * n) * h, q[3];
      for (int k = 0; k < 3; k++) q[k] = (p[k] + t1[k] * u + t2[k] * v) * splat(w->inverse_texel);
      paper_look(w, q, e, sel(there, part, zero), sum);
    }
  }
  vf joint = w->tile.on ? tile_joint(&w->tile, p[0] * splat(w->inverse_texel),
                                     p[1] * splat(w->inverse_texel), wide)
                        : zero;
  for (int k = 0; k < 4; k++) {
    vf mean = splat(k < 3 ? w->texel_mean[k] : w->white);
    if (w->tile.on) mean = mix(mean, splat(k < 3 ? w->tile.joint_colour[k] : 0.0f), joint);
    sum[k] = sel(seen, mix(mean, sum[k], keep), mean);
  }
}

#endif
