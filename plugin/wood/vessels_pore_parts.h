/* SPDX-License-Identifier: Apache-2.0
 *
 * Pores of the field, and their sheaths, under footprints that one look-up does not answer.
 */
#ifndef SOZAI_WOOD_VESSELS_PORE_PARTS_H
#define SOZAI_WOOD_VESSELS_PORE_PARTS_H

#include "vessels_sheaths.h"

/* Pores under footprints longer than what one tap answers are answered by up to 4, or 8 with their
 * sheaths; past the part of those the expected coverage fades in. The lanes that are not cut are
 * whole, in one tap, as they would be alone. */
INLINE vm pores_cut(const wood_constants *w, const footprint2 *f) {
  return gt(f->aa + f->bb, splat(w->pores.part * w->pores.part));
}

INLINE void pores_in_parts(const wood_constants *w, const vessel_place *p, vm cut,
                           vessel_cover_t *v) {
  vf zero = splat(0.0f);
  int sheaths = w->parenchyma.sheaths;
  footprint_axes l = footprint_split(&p->f);
  footprint_parts part =
      footprint_cut(&p->f, &l, cut, w->pores.part, w->pores.third, sheaths ? 8 : 4);
  v->pores_faded = sel(part.most, fade_beyond(part.aa + part.bb, w->pores.part), zero);
  vm left = lt(v->pores_faded, splat(1.0f));
  if (!any(left)) return;
  matrix2 f = to_section(part.aa, part.ab, part.bb, p->c, p->s);
  disc d = pores_disc(w, p, &f), sheath;
  if (sheaths) sheath = sheaths_disc(w, p, &f);
  vessel_bands bands;
  int taps = part.taps;
  while (taps > 1 && !any(and_(left, footprint_has_part(&part, taps - 1)))) taps--;
  for (int i = 0; i < taps; i++) {
    footprint_part q = footprint_part_of(&l, &part, cut, i);
    vf x = p->x + (q.rho * p->c - q.arc * p->s), z = p->z + (q.rho * p->s + q.arc * p->c);
    if (w->bands.on) {
      bands = bands_beside(&w->bands, p->bands, x - p->x, z - p->z);
      d.bands = &bands;
    }
    if (sheaths) {
      vf cover[2];
      if (w->bands.on) {
        sheathed_cover(w, 1, p->own, x, z, &d, &sheath, cover);
      } else {
        sheathed_cover(w, 0, p->own, x, z, &d, &sheath, cover);
      }
      v->pores = v->pores + cover[0] * q.weight;
      v->sheaths = v->sheaths + cover[1] * q.weight;
    } else {
      v->pores = v->pores + pores_cover(w, w->bands.on, p->own, x, z, &d) * q.weight;
    }
  }
  v->pores = sel(left, v->pores, zero);
  v->sheaths = sel(left, v->sheaths, zero);
}

#endif
