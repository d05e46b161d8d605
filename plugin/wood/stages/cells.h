/* SPDX-License-Identifier: Apache-2.0
 *
 * Single cells, where the footprint is small enough for them.
 */
#ifndef SOZAI_WOOD_STAGES_CELLS_H
#define SOZAI_WOOD_STAGES_CELLS_H

#include "../cells_ray.h"
#include "../cells_tissue.h"
#include "../cells_vessel.h"
#include "rays.h"
#include "vessels.h"

INLINE void stage_cells(const wood_constants *w, int boards, block *k) {
  vessel_place place = vessel_place_of(boards, k);
  vf out = k->nrm[0] * k->stem.c + k->nrm[2] * k->stem.s;
  vf round = k->nrm[2] * k->stem.c - k->nrm[0] * k->stem.s;
  cell_face face = {round * round, k->nrm[1] * k->nrm[1], out * out};
  k->cells = cells_tissue(w, &place, &face, k->p[1], k->extent, k->late, &k->cell_contrast);
  k->lining = splat(0.0f);
  k->ray_cells = splat(0.0f);
  if (w->has_rays && !k->rays_gone && any(gt(k->ray, splat(0.0f)))) {
    ray_place p = ray_place_here(boards, 0, k);
    vf far, fade = rays_fade(w, &p, &far); /* what is expected of rays has no cells */
    k->ray_cells = (splat(1.0f) - fade) * cells_ray(w, &p, k->ray_on, &k->ray_in, &face);
  }
  if (!any(gt(k->cover, splat(0.0f)))) return;
  vu own = own_of(boards, k);
  k->lining = k->cover * cells_rims(w, own, place.x, k->p[1], place.z, k->s, k->extent);
  if (w->rows) {
    vf within = cells_tyloses(w, own, place.x, k->p[1], place.z, k->s);
    k->lining = k->lining + k->vessels.rows * within;
  }
}

#endif
