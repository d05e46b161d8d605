/* SPDX-License-Identifier: Apache-2.0
 *
 * Sheaths of parenchyma about the field's pores: vasicentric, aliform, confluent (IAWA list of
 * microscopic features for hardwood identification, 1989: 79, 80, 83).
 *
 * A sheath is an ellipse about its pore, wider round the stem than along the radius, and as much
 * larger or smaller than the mean as its pore is. Sheaths that meet are one. So that they have room
 * to, pores that do not stand in bands are two to every cell, and not to every other: half a cell,
 * which is what the four nearest hold, is then 0.7 of the mean distance from pore to pore. Counts
 * vary less than those of Kawai's uniform distribution do, as those of diffuse-porous woods do too.
 */
#ifndef SOZAI_WOOD_VESSELS_SHEATHS_H
#define SOZAI_WOOD_VESSELS_SHEATHS_H

#include "vessels_pores.h"

/* A pore of the mean radius with its sheath, under a footprint over (x, z). */
INLINE disc sheaths_disc(const wood_constants *w, const vessel_place *p, const matrix2 *f) {
  vf arc = splat(w->parenchyma.sheath_arc2), radial = splat(w->parenchyma.sheath_radial2);
  if (w->pore_growth != 0.0f) {
    vf size = splat(w->pore_early) + splat(w->pore_growth) * p->ring.phase;
    arc = arc * size * size;
    radial = radial * size * size;
  }
  return ellipse_blurred(to_section(arc, splat(0.0f), radial, p->c, p->s), arc * radial, *f);
}

/* Adds the cover of one pore, at (x, z) from it, and takes that of its sheath from what is left. */
INLINE void sheathed_add(const wood_constants *w, const disc *pore, const disc *sheath, vm there,
                         vu h, vf x, vf z, vf *sum, vf *left) {
  vf size = lookup8(w->pores.inverse_square, h >> 5), zero = splat(0.0f);
  vf in = clamp01(pore->top - disc_distance(pore, x, z) * size);
  vf about = sheath->height * clamp01(sheath->top - disc_distance(sheath, x, z) * size);
  *sum = *sum + sel(there, in, zero);
  *left = *left - *left * sel(there, about, zero);
}

/* Coverage by pores, and by them with their sheaths, which are many and large enough for what two
 * of them share to matter: what is left is a product, exact where nothing is blurred and where
 * all is. */
INLINE void sheathed_cover(const wood_constants *w, int banded, vu own, vf x, vf z,
                           const disc *pore, const disc *sheath, vf cover[2]) {
  pore_cells p = pores_near(w, banded, own, x, z, pore);
  disc about = disc_in_cells(w, sheath);
  vf unit = splat(PORE_UNIT), zero = splat(0.0f), one = splat(1.0f), sum = zero, left = one;
  UNROLL(4)
  for (int i = 0; i < 4; i++) {
    int a = i & 1, b = i >> 1;
    vu base = hash_upper(p.hash + splatu((uint32_t)a * HASH_X + (uint32_t)b * HASH_Z));
    vf cx = a ? p.x - unit : p.x, cz = b ? p.z - unit : p.z;
    vu h = base << 1;
    vf dx = cx - hash_place(h), dz = cz - hash_place2(h);
    if (banded) {
      vm held = bands_hold(&w->bands, &p.bands, base, dx, dz);
      sheathed_add(w, &p.d, &about, held, h, dx, dz, &sum, &left);
      continue;
    }
    vm all = le(zero, zero);
    sheathed_add(w, &p.d, &about, all, h, dx, dz, &sum, &left);
    h = base * splatu(PORE_SECOND);
    sheathed_add(w, &p.d, &about, all, h, cx - hash_place(h), cz - hash_place2(h), &sum, &left);
  }
  cover[0] = vessel_overlap(pore, w->pores.overlap, sum);
  cover[1] = one - left;
}

/* What they are expected to cover where pores cover so much of what they do at full size. */
INLINE vf sheaths_expected(const wood_constants *w, vf of_full) {
  const wood_parenchyma *m = &w->parenchyma;
  vf one = splat(1.0f);
  if (!(w->pore_growth != 0.0f)) return splat(m->sheath_cover) * of_full;
  vf sum = splat(m->sheath_area) * of_full;
  return splat(m->sheath_grown) * sum / (one + splat(m->sheath_met) * sum);
}

#endif
