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

#define EYE_STAIN 0.23f /* of what latewood reflects, what the outline of a bird's eye does not */

INLINE void stage_colour(const wood_constants *w, int boards, const wood_io *io, block *k) {
  vf one = splat(1.0f), zero = splat(0.0f);
  /* pores stand everywhere; earlywood rows where there is no latewood, or in its stead */
  vf season = k->late;
  if (w->has_eyes) season = season + (one - season) * vmin(k->stem.eye, one);
  vf late = season * (one - vmin(k->over_late, one));
  if (w->has_canals) late = canals_leave(w, &k->canal, k->f.bb, k->ring.inverse_width, late);
  late = clamp(late, zero, vmax(one - k->cover, zero));
  vf shift = w->has_eyes ? k->shift * (one - splat(EYE_STAIN) * vmin(k->stem.eye, one)) : k->shift;
  vf early = vmax(one - k->cover - late, zero) * shift, dark = late * shift;
  vf open = w->has_cells ? k->cover + k->lining : k->cover;
  vf heart = heart_share(w, k->years, k->c, k->sn, vsqrt(k->f.bb) * k->ring.inverse_width);
  vm pale = lt(heart, one);
  vf light[3], deep[3], tissue[3];
  UNROLL(3)
  for (int c = 0; c < 3; c++) {
    light[c] = splat(w->early[c]);
    deep[c] = splat(w->late[c]);
  }
  if (w->has_pigment) {
    UNROLL(3)
    for (int c = 0; c < 3; c++) {
      light[c] = mix(light[c], splat(w->pigment[c]), k->pigment);
      deep[c] = mix(deep[c], splat(PIGMENT_LATE * w->pigment[c]), k->pigment);
    }
  }
  if (any(pale)) {
    UNROLL(3)
    for (int c = 0; c < 3; c++) {
      light[c] = sel(pale, mix(splat(w->sap_early[c]), light[c], heart), light[c]);
      deep[c] = sel(pale, mix(splat(w->sap_late[c]), deep[c], heart), deep[c]);
    }
  }
  UNROLL(3)
  for (int c = 0; c < 3; c++) tissue[c] = light[c] * early + deep[c] * dark;
  if (w->has_cells && any(lt(zero, k->cell_contrast))) {
    UNROLL(3)
    for (int c = 0; c < 3; c++) {
      vf contrast = vmin(k->cell_contrast, cells_room(w, light[c]));
      tissue[c] = tissue[c] + tissue[c] * k->cells * contrast;
    }
  }
  UNROLL(3)
  for (int c = 0; c < 3; c++) tissue[c] = tissue[c] + splat(w->vessel[c]) * open;
  if (w->streaks.share > 0.0f) {
    UNROLL(3)
    for (int c = 0; c < 3; c++) {
      tissue[c] = mix(tissue[c], splat(w->streak[c]) * k->shift, k->streak);
    }
  }
  int ends = w->has_ends && io->in->normal[0];
  if (ends) {
    vf seen = ends_seen(one - k->up2);
    if (any(gt(seen, zero))) {
      vf left = one - seen * splat(w->shade);
      UNROLL(3)
      for (int c = 0; c < 3; c++) tissue[c] = tissue[c] * left;
    }
  }
  if (w->has_rays) {
    vf lit = k->shift;
    if (ends) {
      vf out = k->nrm[0] * k->stem.c + k->nrm[2] * k->stem.s;
      lit = lit * (one - ends_seen(out * out) * splat(w->ray_shade));
    }
    UNROLL(3)
    for (int c = 0; c < 3; c++) {
      vf ray = splat(w->ray[c]) * lit;
      if (w->has_cells) {
        vf contrast = vmin(k->cell_contrast, cells_room(w, splat(w->ray[c])));
        ray = ray + ray * k->ray_cells * contrast;
      }
      tissue[c] = mix(tissue[c], ray, k->ray);
    }
  }
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
  if (w->has_spalt) stage_spalt_colour(k);
  for (int c = 0; c < 3; c++) {
    if (boards) k->albedo[c] = board_albedo(w, &k->board, c, k->albedo[c]);
    store_lanes(io, WOOD_ALBEDO + c, k, k->albedo[c]);
  }
}

#endif
