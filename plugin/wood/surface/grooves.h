/* SPDX-License-Identifier: Apache-2.0
 *
 * Vessels that the cut has opened, at the places of vessels_pores.h and vessels_rows.h: each
 * a trough as tubes.h has them, whole along its length. Where troughs meet they add up.
 */
#ifndef SOZAI_WOOD_SURFACE_GROOVES_H
#define SOZAI_WOOD_SURFACE_GROOVES_H

#include "../tubes.h"
#include "../vessels_pores.h"
#include "../vessels_rows.h"

/* The field's pores, over their depth; slopes are per mm of (x, z). */
INLINE trough_sum grooves_pores(const wood_constants *w, vu own, vf x, vf z, const disc *d) {
  pore_cells p = pores_near(w, w->bands.on, own, x, z, d);
  vf zero = splat(0.0f), unit = splat(PORE_UNIT), one = splat(1.0f), unused;
  trough_sum g = {zero, zero, zero, zero, zero};
  for (int i = 0; i < 4; i++) {
    int a = i & 1, b = i >> 1;
    vu base = hash_upper(p.hash + splatu((uint32_t)a * HASH_X + (uint32_t)b * HASH_Z));
    vf cx = a ? p.x - unit : p.x, cz = b ? p.z - unit : p.z;
    vu h = base << 1;
    if (w->bands.on) {
      vm held = bands_hold(&w->bands, &p.bands, base, cx - hash_place(h), cz - hash_place2(h));
      cx = sel(held, cx, splat(PORE_NOWHERE));
    } else {
      cx = sel_top(base | splatu(w->pores_each), cx, splat(PORE_NOWHERE));
    }
    for (int k = 0; k < (w->bands.on ? 1 : 2); k++) {
      trough_add(&p.d, one, lookup8(w->pores.inverse_square, h >> 5), cx - hash_place(h),
                 cz - hash_place2(h), &g, &unused);
      h = base * splatu(PORE_SECOND);
    }
  }
  vf per_mm = splat(1.0f / w->pore_step);
  g.x = g.x * per_mm;
  g.z = g.z * per_mm;
  return g;
}

/* The earlywood's rows; x is along the arc and z along rho. */
INLINE trough_sum grooves_rows(const wood_constants *w, const row_place *p, vf rho, vf da, vf dr,
                               const disc *d) {
  vf zero = splat(0.0f), one = splat(1.0f), unused;
  trough_sum g = {zero, zero, zero, zero, zero};
  for (int m = 0; m < w->rows; m++) {
    row_spot q = row_spot_of(w, p, m, rho, da, dr);
    for (int a = 0; a < 2; a++) {
      vf x, z;
      vu h = row_vessel(w, p, &q, a, &x, &z);
      trough_add(d, one, lookup8(w->row.inverse_square, h >> 5), x, z, &g, &unused);
    }
  }
  g.depth = sel(p->near, g.depth, zero);
  g.x = sel(p->near, g.x, zero);
  g.z = sel(p->near, g.z, zero);
  g.fall = sel(p->near, g.fall, zero);
  return g;
}

#endif
