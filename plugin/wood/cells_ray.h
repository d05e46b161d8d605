/* SPDX-License-Identifier: Apache-2.0
 *
 * The cells of a ray of many: bricks along the radius.
 */
#ifndef SOZAI_WOOD_CELLS_RAY_H
#define SOZAI_WOOD_CELLS_RAY_H

#include "cells.h"
#include "rays.h"

#define RAY_CELL_WIDE 0.012f /* mm: across */
#define RAY_CELL_SHADE 0.7f  /* by which cells are brighter and darker, in the contrast of walls */

/* What its cells add to a ray's colour, relative, before the contrast. */
INLINE vf cells_ray(const wood_constants *w, const ray_place *p, vu h, const ray_body *r,
                    const cell_face *face) {
  vf zero = splat(0.0f), one = splat(1.0f), on = splat(w->fine_open);
  vf e2 = p->aa + p->bb, gone2 = splat(w->cell_gone * w->cell_gone);
  vf keep = one - smooth_step(splat(0.25f) * gone2, gone2, e2);
  if (!any(gt(keep, zero))) return zero;
  const float size[3] = {RAY_ROW, RAY_CELL_WIDE, RAY_CELL};
  vf at[3] = {p->y, r->a, p->rho};
  vf e[3] = {p->along, vsqrt(p->aa), vsqrt(p->bb)};
  vf across[3] = {face->fibre, face->arc, face->radius};
  vf lumen = one, shade = one;
  vi i[3];
  for (int k = 0; k < 3; k++) {
    /* the cells of a row, of one layer, begin where they like along the radius */
    vf x = at[k] * splat(1.0f / size[k]);
    if (k) x = x + to_float((vi)(h >> 16)) * splat(1.0f / 65536.0f);
    vf extent = vmax(e[k] * splat(1.0f / size[k]), splat(CELL_SHARP));
    vf gone = smooth_step(splat(0.7f), splat(1.3f), extent);
    lumen = lumen * mix(cell_pulse(x, extent, on), on, vmax(gone, across[k]));
    shade = shade * (one - gone);
    vfloor(x, &i[k]);
    h = hash_mix(h + (vu)i[k] * splatu(HASH_X));
  }
  vf part = to_float((vi)(h >> 16)) * splat(2.0f / 65535.0f) - one;
  return keep * (on * on * on - lumen + splat(RAY_CELL_SHADE) * shade * part);
}

#endif
