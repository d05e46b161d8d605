/* SPDX-License-Identifier: Apache-2.0
 *
 * Rays under the footprint, in steps that others stand between.
 */
#ifndef SOZAI_WOOD_STAGES_RAYS_H
#define SOZAI_WOOD_STAGES_RAYS_H

#include "../rays.h"
#include "block.h"

#define RAY_AGAIN 0x5bd1e995u /* the second layer's seeds, over the first's */

/* Put together in each stage, of which each needs another part. layer: 0, or 1 of the second. */
INLINE ray_place ray_place_here(int boards, int layer, const block *k) {
  const footprint2 *f = &grown_at(k)->f;
  return (ray_place){.rho = k->stem.rho,
                     .y = k->p[1],
                     .aa = f->aa,
                     .ab = f->ab,
                     .bb = f->bb,
                     .along = k->extent,
                     .at = k->ray_from,
                     .own = own_of(boards, k) + splatu(layer ? RAY_AGAIN : 0)};
}

INLINE void stage_ray_turn(const wood_constants *w, int boards, block *k) {
  k->ray_from = ray_turn_of(w, own_of(boards, k), k->stem.rho, k->turn, k->p[1], k->stem.c,
                            k->stem.s, k->extent, k->held->sway);
}

/* The first layer is through: the second's sectors begin where the first's have their middles. */
INLINE void stage_ray_again(const wood_constants *w, block *k) {
  vf one = splat(1.0f), turn = k->ray_from.turn + splat(w->ray_sector_turn * 0.079577472f);
  k->ray_from.turn = sel(lt(turn, one), turn, turn - one);
  if (k->rays_gone) return;
  k->ray_first = k->ray_in.a;
  k->ray_first_on = k->ray_on;
}

INLINE void stage_ray_shell(const wood_constants *w, int boards, int layer, block *k) {
  ray_place p = ray_place_here(boards, layer, k);
  k->ray_at = ray_shell_at(w, &p);
}

INLINE void stage_ray_seat(const wood_constants *w, int boards, int layer, block *k) {
  ray_place p = ray_place_here(boards, layer, k);
  ray_cell_size(w, &p, &k->ray_at);
  k->rays_gone = rays_gone(w, &p);
  if (!k->rays_gone) k->ray_on = ray_hash_of(&k->ray_at);
}

INLINE void stage_ray_body(const wood_constants *w, int boards, int layer, block *k) {
  if (k->rays_gone) return;
  ray_place p = ray_place_here(boards, layer, k);
  k->ray_in = ray_body_of(w, &p, &k->ray_at, k->ray_on);
}

/* Beside the first layer's: the two know nothing of each other. Cells are those of the ray that
 * covers more. */
INLINE vf rays_both(block *k, vf second) {
  vf first = k->ray;
  if (!k->rays_gone) {
    vm own = lt(first, second);
    k->ray_in.a = sel(own, k->ray_in.a, k->ray_first);
    k->ray_on = (vu)seli(own, (vi)k->ray_on, (vi)k->ray_first_on);
  }
  return first + second - first * second;
}

/* How its cells lie, for the light about them. Of both layers, those of the ray that covers more.
 */
INLINE void stage_ray_lean(const wood_constants *w, const ray_place *p, int layer, vm own,
                           block *k) {
  vf far, keep = splat(1.0f) - rays_fade(w, p, &far), lean = splat(0.0f);
  if (!k->rays_gone) lean = ray_lean_of(k->ray_on) * keep;
  k->ray_lean = layer ? sel(own, lean, k->ray_lean) : lean;
  k->ray_unlike = splat(RAY_LEAN * RAY_LEAN / 3.0f) * (splat(1.0f) - keep * keep);
}

INLINE void stage_rays(const wood_constants *w, int boards, int layer, const wood_io *io,
                       block *k) {
  ray_place p = ray_place_here(boards, layer, k);
  vf found = splat(0.0f);
  if (!k->rays_gone) {
    found = ray_body_cover(w, &p, &k->ray_at, &k->ray_in);
    found = rays_cover(w, &p, &k->ray_at, found);
  }
  vf ray = rays_faded(w, &p, &k->ray_at, found);
  if (k->knot) ray = ray * (splat(1.0f) - k->knot->cover);
  if (w->cone) stage_ray_lean(w, &p, layer, lt(k->ray, ray), k);
  k->ray = layer ? rays_both(k, ray) : ray;
  store_lanes(io, WOOD_RAY, k, k->ray);
}

#endif
