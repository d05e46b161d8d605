/* SPDX-License-Identifier: Apache-2.0
 *
 * The wood's colour: of each tissue its share, and what lies over them.
 */
#ifndef SOZAI_WOOD_STAGES_COLOUR_H
#define SOZAI_WOOD_STAGES_COLOUR_H

#include "../cells.h"
#include "../ends.h"
#include "../heart.h"
#include "canals.h"
#include "knots.h"
#include "pigment.h"
#include "spalt.h"

#define EYE_STAIN 0.3f /* of what latewood reflects, what the outline of a bird's eye does not */

/* Shares of early- and latewood, times how bright their fibres are. */
typedef struct {
  vf early, late;
} season_shares;

INLINE season_shares season_shares_of(const wood_constants *w, const block *k) {
  vf one = splat(1.0f), zero = splat(0.0f);
  /* pores stand everywhere; earlywood rows where there is no latewood, or in its stead */
  vf season = k->late;
  if (w->has_eyes) season = season + (one - season) * vmin(k->stem.eye, one);
  vf late = season * (one - vmin(k->over_late, one));
  if (w->has_canals)
    late = canals_leave(w, &k->canal, k->section.f.bb, k->ring.inverse_width, late);
  vf room = one - k->cover;
  if (w->parenchyma.on) {
    /* a ring's last cells are its latest */
    if (w->parenchyma.margin > 0.0f) late = late - k->margin * k->ring.weight;
    late = late * k->tough;
    room = k->rest;
  }
  late = clamp(late, zero, vmax(room, zero));
  vf shift = w->has_eyes ? k->shift * (one - splat(EYE_STAIN) * vmin(k->stem.eye, one)) : k->shift;
  return (season_shares){vmax(room - late, zero) * shift, late * shift};
}

INLINE vf heart_at(const wood_constants *w, const block *k) {
  return heart_share(w, k->years, k->section.c, k->section.s,
                     vsqrt(k->section.f.bb) * k->ring.inverse_width);
}

/* A tissue's colour in both, which is `own` in heartwood. pale: where there is sapwood; sap:
 * whether any lane has some. */
INLINE vf or_sapwood(vm pale, int sap, vf heart, float beyond, vf own) {
  return sap ? sel(pale, mix(splat(beyond), own, heart), own) : own;
}

/* The colours of both, of heartwood with its pigment or of sapwood. */
INLINE void season_colours(const wood_constants *w, const block *k, vf heart, vf early[3],
                           vf late[3]) {
  vm pale = lt(heart, splat(1.0f));
  UNROLL(3)
  for (int c = 0; c < 3; c++) {
    early[c] = splat(w->early[c]);
    late[c] = splat(w->late[c]);
  }
  if (w->has_pigment) {
    UNROLL(3)
    for (int c = 0; c < 3; c++) {
      early[c] = mix(early[c], splat(w->pigment[c]), k->pigment);
      late[c] = mix(late[c], splat(PIGMENT_LATE * w->pigment[c]), k->pigment);
    }
  }
  if (!any(pale)) return;
  UNROLL(3)
  for (int c = 0; c < 3; c++) {
    early[c] = sel(pale, mix(splat(w->sap_early[c]), early[c], heart), early[c]);
    late[c] = sel(pale, mix(splat(w->sap_late[c]), late[c], heart), late[c]);
  }
}

#define PIGMENT_SOFT 0.8f /* how much of the tissue's pigment lies in its parenchyma */

/* Parenchyma's, likewise. */
INLINE void tissue_soft(const wood_constants *w, const block *k, vf heart, vf tissue[3]) {
  const wood_parenchyma *m = &w->parenchyma;
  vf soft = k->soft * k->shift;
  vm pale = lt(heart, splat(1.0f));
  int sap = any(pale);
  UNROLL(3)
  for (int c = 0; c < 3; c++) {
    vf own = splat(m->colour[c]);
    if (w->has_pigment) own = mix(own, splat(w->pigment[c]), splat(PIGMENT_SOFT) * k->pigment);
    tissue[c] = tissue[c] + soft * or_sapwood(pale, sap, heart, m->sap[c], own);
  }
}

/* Vessels', of which there is so much open. */
INLINE void tissue_open(const wood_constants *w, vf open, vf heart, vf tissue[3]) {
  vm pale = lt(heart, splat(1.0f));
  int sap = any(pale);
  UNROLL(3)
  for (int c = 0; c < 3; c++) {
    vf own = or_sapwood(pale, sap, heart, w->vessel_sap[c], splat(w->vessel[c]));
    tissue[c] = tissue[c] + own * open;
  }
}

/* All but rays and canals. heart: heart_at. */
INLINE void tissue_colour(const wood_constants *w, const block *k, vf heart, vf tissue[3]) {
  vf early[3], late[3], open = w->has_cells ? k->cover + k->lining : k->cover;
  season_shares share = season_shares_of(w, k);
  season_colours(w, k, heart, early, late);
  UNROLL(3)
  for (int c = 0; c < 3; c++) tissue[c] = early[c] * share.early + late[c] * share.late;
  if (w->parenchyma.on) tissue_soft(w, k, heart, tissue);
  if (w->has_cells && any(lt(splat(0.0f), k->cell_contrast))) {
    UNROLL(3)
    for (int c = 0; c < 3; c++) {
      vf contrast = vmin(k->cell_contrast, cells_room(w, early[c]));
      tissue[c] = tissue[c] + tissue[c] * k->cells * contrast;
    }
  }
  tissue_open(w, open, heart, tissue);
  if (w->streaks.share > 0.0f) {
    UNROLL(3)
    for (int c = 0; c < 3; c++) {
      tissue[c] = mix(tissue[c], splat(w->streak[c]) * k->shift, k->streak);
    }
  }
}

/* Shaded where the face looks into the open ends of the cells. */
INLINE void tissue_ends(const wood_constants *w, const block *k, vf tissue[3]) {
  vf one = splat(1.0f), seen = ends_seen(one - k->up2);
  if (!any(gt(seen, splat(0.0f)))) return;
  vf left = one - seen * splat(w->shade);
  UNROLL(3)
  for (int c = 0; c < 3; c++) tissue[c] = tissue[c] * left;
}

/* Rays over it, whose cells' ends are open along the radius. */
INLINE void tissue_rays(const wood_constants *w, int ends, const block *k, vf heart, vf tissue[3]) {
  vf lit = k->shift;
  vm pale = lt(heart, splat(1.0f));
  int sap = any(pale);
  if (ends) {
    vf out = k->nrm[0] * k->stem.c + k->nrm[2] * k->stem.s;
    lit = lit * (splat(1.0f) - ends_seen(out * out) * splat(w->ray_shade));
  }
  UNROLL(3)
  for (int c = 0; c < 3; c++) {
    vf own = or_sapwood(pale, sap, heart, w->ray_sap[c], splat(w->ray[c]));
    vf ray = own * lit;
    if (w->has_cells) {
      vf contrast = vmin(k->cell_contrast, cells_room(w, own));
      ray = ray + ray * k->ray_cells * contrast;
    }
    tissue[c] = mix(tissue[c], ray, k->ray);
  }
}

/* The board's shade and the joint's colour over what there is. */
INLINE void store_albedo(const wood_constants *w, int boards, const wood_io *io, block *k) {
  for (int c = 0; c < 3; c++) {
    if (boards) k->albedo[c] = board_albedo(w, &k->board, c, k->albedo[c]);
    store_lanes(io, WOOD_ALBEDO + c, k, k->albedo[c]);
  }
}

INLINE void stage_colour(const wood_constants *w, int boards, const wood_io *io, block *k) {
  vf tissue[3];
  int ends = w->has_ends && io->in->normal[0];
  vf heart = heart_at(w, k);
  tissue_colour(w, k, heart, tissue);
  if (ends) tissue_ends(w, k, tissue);
  if (w->has_rays) tissue_rays(w, ends, k, heart, tissue);
  if (w->has_canals) {
    UNROLL(3)
    for (int c = 0; c < 3; c++) {
      tissue[c] = mix(tissue[c], splat(w->canal_colour[c]), k->canal.whole - k->canal.core);
      tissue[c] = mix(tissue[c], splat(w->canal_lumen[c]), k->canal.core);
    }
  }
  UNROLL(3)
  for (int c = 0; c < 3; c++) k->albedo[c] = tissue[c];
  if (k->knot) stage_knot_colour(w, k, k->knot->own);
  if (w->has_spalt) stage_spalt_colour(w, k);
  store_albedo(w, boards, io, k);
}

#endif
