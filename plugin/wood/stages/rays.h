/* SPDX-License-Identifier: Apache-2.0
 *
 * Rays under the footprint, in steps that others stand between.
 */
#ifndef SOZAI_WOOD_STAGES_RAYS_H
#define SOZAI_WOOD_STAGES_RAYS_H

#include "../rays.h"
#include "block.h"

/* Put together in each stage, of which each needs another part. */
INLINE ray_place ray_place_here(int boards, const block *k) {
  const footprint2 *f = &grown_at(k)->f;
  return (ray_place){.rho = k->stem.rho,
                     .y = k->p[1],
                     .aa = f->aa,
                     .ab = f->ab,
                     .bb = f->bb,
                     .along = k->extent,
                     .at = k->ray_from,
                     .own = own_of(boards, k)};
}

INLINE void stage_ray_turn(const wood_constants *w, int boards, block *k) {
  k->ray_from = ray_turn_of(w, own_of(boards, k), k->stem.rho, k->turn, k->p[1], k->stem.c,
                            k->stem.s, &k->held->sway);
}

INLINE void stage_ray_shell(const wood_constants *w, int boards, block *k) {
  ray_place p = ray_place_here(boards, k);
  k->ray_at = ray_shell_at(w, &p);
}

INLINE void stage_ray_seat(const wood_constants *w, int boards, block *k) {
  ray_place p = ray_place_here(boards, k);
  ray_cell_size(w, &p, &k->ray_at);
  k->rays_gone = rays_gone(w, &p);
  if (!k->rays_gone) k->ray_on = ray_hash_of(&k->ray_at);
}

INLINE void stage_ray_body(const wood_constants *w, int boards, block *k) {
  if (k->rays_gone) return;
  ray_place p = ray_place_here(boards, k);
  k->ray_in = ray_body_of(w, &p, &k->ray_at, k->ray_on);
}

INLINE void stage_rays(const wood_constants *w, int boards, const wood_io *io, block *k) {
  ray_place p = ray_place_here(boards, k);
  vf found = splat(0.0f);
  if (!k->rays_gone) {
    found = ray_body_cover(w, &p, &k->ray_at, &k->ray_in);
    found = rays_cover(w, &p, &k->ray_at, found);
  }
  k->ray = rays_faded(w, &p, &k->ray_at, found);
  if (k->knot) k->ray = k->ray * (splat(1.0f) - k->knot->cover);
  store_lanes(io, WOOD_RAY, k, k->ray);
}

#endif
