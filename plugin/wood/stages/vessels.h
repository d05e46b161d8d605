/* SPDX-License-Identifier: Apache-2.0
 *
 * Vessels under the footprint: the field's pores, and the rows of the earlywood.
 */
#ifndef SOZAI_WOOD_STAGES_VESSELS_H
#define SOZAI_WOOD_STAGES_VESSELS_H

#include "../parenchyma.h"
#include "../vessels_pore_parts.h"
#include "../vessels_row_box.h"
#include "rings.h"

INLINE vessel_place place_in(int boards, const section_place *q, const block *k) {
  return (vessel_place){
      q->x, q->z, q->c, q->s, k->turn, k->stem.rho, k->ring, q->f, own_of(boards, k), &k->bands};
}
INLINE vessel_place vessel_place_of(int boards, const block *k) {
  return place_in(boards, grown_at(k), k);
}

/* The bands that the field's pores stand in, as they stray. Not kept: to store them costs more than
 * to find them again where a footprint is long. */
INLINE vessel_bands bands_of(const wood_constants *w, int boards, const block *k) {
  vessel_place place = vessel_place_of(boards, k);
  return bands_strayed(w, bands_straight(w, &place), &k->strays);
}

/* What parenchyma is told of the point. */
INLINE soft_place soft_place_of(const wood_constants *w, int boards, const block *k) {
  vf zero = splat(0.0f);
  soft_place here = {.at = vessel_place_of(boards, k), .seen = k->seen, .bundle = k->strays};
  if (!place_has_turn(w)) here.at.turn = zero;
  if (!w->has_strays) here.bundle = (fibre_bundle){zero, zero, zero};
  here.pores = k->vessels.pores;
  return here;
}

/* Where a surface's relief asks for them. */
INLINE void stage_bands(const wood_constants *w, int boards, block *k) {
  k->bands = bands_of(w, boards, k);
}

/* Long footprints here; what is within one tap goes through the stages after this one. */
INLINE void stage_vessel_parts(const wood_constants *w, int boards, block *k) {
  vf zero = splat(0.0f);
  k->vessels = (vessel_cover_t){zero, zero, zero, zero, zero};
  k->pores_parted = k->rows_parted = k->between_found = 0;
  const footprint2 *f = &grown_at(k)->f;
  vm none = lt(zero, zero), pores = w->has_pores ? pores_cut(w, f) : none;
  vm rows = w->rows ? rows_cut(w, f) : none, meet = w->rows ? rows_meet(w, f) : none;
  if (!any(or_(pores, or_(rows, meet)))) return;
  vessel_place place = vessel_place_of(boards, k);
  vessel_bands bands;
  k->pores_parted = any(pores);
  k->rows_parted = any(or_(rows, meet));
  if (w->bands.on) {
    bands = bands_of(w, boards, k);
    place.bands = &bands;
  }
  if (k->pores_parted) pores_in_parts(w, &place, pores, &k->vessels);
  if (k->rows_parted) rows_in_parts(w, &place, rows, &k->vessels);
}

INLINE void stage_turns(block *k) { k->turn = place_turn(grown_at(k)->c, grown_at(k)->s); }

INLINE void stage_disc(const wood_constants *w, int boards, block *k) {
  int single = w->has_pores && !k->pores_parted;
  if (!single && !w->parenchyma.on) return;
  vessel_place place = vessel_place_of(boards, k);
  k->seen = to_section(place.f.aa, place.f.ab, place.f.bb, place.c, place.s);
  if (!single) return;
  k->pore = pores_disc(w, &place, &k->seen);
}

INLINE void stage_pores(const wood_constants *w, int boards, block *k) {
  if (k->pores_parted || !w->has_pores) return;
  const section_place *q = grown_at(k);
  k->vessels.pores = pores_cover(w, 0, own_of(boards, k), q->x, q->z, &k->pore);
}

/* The same where they are in bands. */
INLINE void stage_banded_pores(const wood_constants *w, int boards, block *k) {
  if (k->pores_parted) return;
  const section_place *q = grown_at(k);
  vessel_bands bands = bands_of(w, boards, k);
  disc d = k->pore;
  d.bands = &bands;
  k->vessels.pores = pores_cover(w, 1, own_of(boards, k), q->x, q->z, &d);
  if (!(w->parenchyma.between > 0.0f)) return;
  /* here, where the bands are at hand */
  soft_place here = soft_place_of(w, boards, k);
  k->between = soft_between(w, &here, &bands, NULL);
  k->between_found = 1;
}

/* The same, and their sheaths. */
INLINE void stage_sheathed_pores(const wood_constants *w, int boards, int banded, block *k) {
  if (k->pores_parted) return;
  vessel_place place = vessel_place_of(boards, k);
  vessel_bands bands;
  disc d = k->pore, sheath = sheaths_disc(w, &place, &k->seen);
  if (banded) {
    bands = bands_of(w, boards, k);
    d.bands = &bands;
  }
  vf cover[2];
  sheathed_cover(w, banded, place.own, place.x, place.z, &d, &sheath, cover);
  k->vessels.pores = cover[0];
  k->vessels.sheaths = cover[1];
}

INLINE void stage_rows(const wood_constants *w, int boards, block *k) {
  if (k->rows_parted || !w->rows) return;
  vessel_place place = vessel_place_of(boards, k);
  row_place row = row_of(w, &place);
  if (!any(row.near)) return;
  disc d = rows_disc(w, place.f.aa, place.f.ab, place.f.bb);
  vf zero = splat(0.0f);
  k->vessels.rows = rows_cover(w, &row, k->stem.rho, zero, zero, &d);
}

/* Where the vessels could not be looked up, what is to be expected. */
INLINE void stage_cover(const wood_constants *w, int boards, const wood_io *io, block *k) {
  const vessel_cover_t *v = &k->vessels;
  vf one = splat(1.0f), zero = splat(0.0f);
  const section_place *q = grown_at(k);
  vf pores = v->pores, rows = v->rows, sheaths = v->sheaths;
  k->over_late = v->pores;
  if (w->has_pores && any(gt(v->pores_faded, zero))) {
    vf expected = one;
    if (w->pore_growth != 0.0f) {
      expected = rings_mean(w, boards, MEAN_PORE, k);
    }
    if (w->bands.on) {
      vessel_bands bands = bands_of(w, boards, k);
      expected = expected * bands_mean(w, &bands, q->c, q->s, &q->f);
    }
    pores = mix(pores, splat(w->pores.coverage) * expected, v->pores_faded);
    if (w->parenchyma.sheaths) {
      sheaths = mix(sheaths, sheaths_expected(w, expected), v->pores_faded);
    }
    k->over_late = mix(k->over_late, splat(w->late_vessel), v->pores_faded);
  }
  if (w->rows && any(gt(v->rows_faded, zero))) {
    vf expected = rings_mean(w, boards, MEAN_ROW, k);
    rows = mix(rows, splat(w->row.coverage) * expected, v->rows_faded);
  }
  if (w->rows) {
    vf late = rows * splat(w->late_row);
    k->over_late = k->over_late + late - k->over_late * late;
  }
  if (k->knot) rows = rows * (one - k->knot->cover); /* branches have no wide earlywood vessels */
  k->cover = vmin(pores + rows - pores * rows, one); /* they stand where they like */
  if (w->parenchyma.on) {
    k->vessels.pores = pores;
    k->vessels.sheaths = vmin(vmax(sheaths, pores), one);
    k->rest = w->parenchyma.sheaths ? (one - k->vessels.sheaths) * (one - rows) : one - k->cover;
  }
  k->ray = zero;
  if (!w->has_rays) store_lanes(io, WOOD_RAY, k, zero);
  store_lanes(io, WOOD_VESSEL, k, k->cover);
}

#endif
