/* SPDX-License-Identifier: Apache-2.0
 *
 * The wood's colour from a picture of the section, in place of all that is grown.
 */
#ifndef SOZAI_WOOD_STAGES_PICTURE_H
#define SOZAI_WOOD_STAGES_PICTURE_H

#include "../picture.h"
#include "colour.h"
#include "footprint.h"
#include "knots.h"

/* It shows rings, vessels and fibres down to its pixels, and the fibres' noise goes on below them.
 */
INLINE void stage_picture(const wood_constants *w, int boards, const wood_io *io, block *k) {
  const stem_place *stem = &k->stem;
  stem_row(k);
  footprint2 f = footprint_in_section(w, boards, io, k);
  vf unused, widen = splat(1.0f) + outline_at(w, k->section.c, k->section.s, &unused);
  picture_place p =
      picture_fold(w, k->section.x, k->section.z, k->section.c, k->section.s, stem->rho);
  picture_albedo(w, &p, k->section.c, k->section.s, widen, &f, k->n, k->albedo);
  store_lanes(io, WOOD_LATEWOOD, k, picture_late(w, k->albedo));
  store_lanes(io, WOOD_VESSEL, k, splat(0.0f));
  k->ray = splat(0.0f);
  store_lanes(io, WOOD_RAY, k, k->ray);
  store_lanes(io, WOOD_CANAL, k, k->ray);
  store_lanes(io, WOOD_PARENCHYMA, k, k->ray);
  vf shift = fibre_shift(w, own_of(boards, k), p.x, p.z, &f);
  for (int c = 0; c < 3; c++) k->albedo[c] = k->albedo[c] * shift;
  k->shift = shift;
  if (k->knot) stage_knot_colour(w, k, picture_late(w, k->albedo));
  store_albedo(w, boards, io, k);
}

#endif
