/* SPDX-License-Identifier: Apache-2.0
 *
 * Within vessels: tyloses, which fill those of the earlywood, and the rims of the elements that all
 * are put together from.
 */
#ifndef SOZAI_WOOD_CELLS_VESSEL_H
#define SOZAI_WOOD_CELLS_VESSEL_H

#include "../core/noise.h"
#include "cells.h"

#define TYLOSE_EDGE 0.05f   /* of a tylose's size, half a membrane's width */
#define TYLOSE_STRAY 0.5f   /* of its cell, within which a tylose's middle lies */
#define TYLOSE_MEAN 0.1339f /* of the membranes' cover, measured */
#define RIM_WIDTH 0.12f     /* of an element's length */
#define RIM_SLOPE 1.2f      /* at most, across the fibre, each way */

/* What is seen within the earlywood's vessels, and within all: relative to
 * their colour, mean zero. (x, z), y: the fibre's place and height. s: footprint. */
INLINE vf cells_tyloses(const wood_constants *w, vu own, vf x, vf y, vf z, vf s) {
  vf one = splat(1.0f), zero = splat(0.0f), half = splat(0.5f), k = splat(w->inverse_tylose);
  vf keep = one - smooth_step(splat(0.5f), splat(1.6f), s * k);
  if (w->tyloses <= 0.0f || !any(gt(keep, zero))) return zero;
  /* Bubbles that have met: a membrane is where two middles are as far. Those of the eight cells
   * about a point's nearest corner hold the two nearest but for some far from every membrane. */
  vf at[3] = {x * k, y * splat(0.6f) * k, z * k};
  vi i[3];
  for (int c = 0; c < 3; c++) at[c] = at[c] - vfloor(at[c] - half, &i[c]) - half;
  vu base = (vu)i[0] * splatu(HASH_X) + (vu)i[1] * splatu(HASH_Y) + (vu)i[2] * splatu(HASH_Z) +
            wood_seed(w, own, SEED_TYLOSES);
  vf near2 = splat(1e9f), near[3] = {zero, zero, zero}, other[8][3], other2[8];
  for (int c = 0; c < 8; c++) {
    vu h = hash_mix(base +
                    splatu((c & 1 ? HASH_X : 0u) + (c & 2 ? HASH_Y : 0u) + (c & 4 ? HASH_Z : 0u)));
    vf d2 = zero;
    for (int a = 0; a < 3; a++) {
      vf stray = to_float((vi)(h >> (22 - 10 * a) & splatu(1023u))) * splat(1.0f / 1023.0f) - half;
      vf centre = splat((float)(c >> a & 1)) + splat(TYLOSE_STRAY) * stray;
      other[c][a] = centre - at[a];
      d2 = d2 + other[c][a] * other[c][a];
    }
    other2[c] = d2;
    vm nearer = lt(d2, near2);
    near2 = vmin(d2, near2);
    for (int a = 0; a < 3; a++) near[a] = sel(nearer, other[c][a], near[a]);
  }
  vf gap = splat(1e9f);
  for (int c = 0; c < 8; c++) {
    vf across2 = zero;
    for (int a = 0; a < 3; a++) {
      vf across = other[c][a] - near[a];
      across2 = across2 + across * across;
    }
    /* to the plane between the two */
    vf to = half * (other2[c] - near2) * inverse_root(vmax(across2, splat(1e-6f)));
    gap = vmin(gap, sel(lt(across2, splat(1e-6f)), splat(1e9f), to));
  }
  /* blurred: wider, and lower by as much */
  vf blur = half * s * k;
  vf thin = splat(TYLOSE_EDGE) * inverse_root(splat(TYLOSE_EDGE * TYLOSE_EDGE) + blur * blur);
  vf cover = clamp01(one - gap * thin * splat(1.0f / TYLOSE_EDGE)) * thin;
  return splat(w->tyloses) * keep * (cover - splat(TYLOSE_MEAN));
}

INLINE vf cells_rims(const wood_constants *w, vu own, vf x, vf y, vf z, vf s, vf extent) {
  vf one = splat(1.0f), zero = splat(0.0f), k = splat(w->inverse_element);
  vf e = vmax(vmax(extent, splat(0.5f * RIM_SLOPE) * s) * k, splat(0.03f));
  vf keep = (one - smooth_step(splat(0.7f), splat(1.4f), e)) *
            (one - smooth_step(splat(0.1f), splat(0.3f), s));
  if (!any(gt(keep, zero))) return zero;
  /* each vessel's begin elsewhere, by where it is in squares that hold about one, and its rims lie
   * oblique */
  vi iz, ix;
  vfloor(z * splat(w->rim_squares), &iz);
  vu h = hash_mix((vu)iz * splatu(HASH_Z) + wood_seed(w, own, SEED_RIMS));
  vfloor(x * splat(w->rim_squares) + to_float((vi)(h >> 16)) * splat(1.0f / 65536.0f), &ix);
  h = hash_mix(h + (vu)ix * splatu(HASH_X));
  const vf k16 = splat(1.0f / 65536.0f), slope = splat(RIM_SLOPE / 32768.0f);
  vf rise = x * (to_float((vi)(h >> 16)) - splat(32768.0f)) +
            z * (to_float((vi)(h & splatu(0xffffu))) - splat(32768.0f));
  vf shift = to_float((vi)(hash_upper(h) >> 16)) * k16;
  vf rim = cell_pulse((y + rise * slope) * k + shift, e, splat(RIM_WIDTH));
  return splat(w->cell_side) * keep * (rim - splat(RIM_WIDTH));
}

#endif
