/* SPDX-License-Identifier: Apache-2.0
 *
 * Reflection as a cone about the fibre, and what a host needs to build that itself.
 */
#ifndef SOZAI_WOOD_STAGES_CONE_H
#define SOZAI_WOOD_STAGES_CONE_H

#include "../cone.h"
#include "light.h"

/* What a host needs to build the cone itself. */
INLINE void stage_cone(const wood_constants *w, const wood_io *io, block *k) {
  for (int c = 0; c < 3; c++) store_lanes(io, WOOD_CONE_COLOUR + c, k, splat(w->fibre_colour[c]));
  store_lanes(io, WOOD_RAY_LUSTRE, k, splat(w->ray_lustre));
  vf width2 = splat(w->cone_width * w->cone_width) + splat(4.0f) * lost_towards_normal(k);
  store_lanes(io, WOOD_CONE_WIDTH, k, vsqrt(width2));
  vf coat = splat(w->coat), alpha2 = coat_alpha2(w, k);
  if (w->surface.relief) {
    /* one lobe is all that a host has: what is steep lies lower by as much as it is wider */
    vf steep = vmin(alpha2 + slopes_within(k->lost), splat(1.0f));
    coat = coat * mix(splat(1.0f), alpha2 / steep, k->lost->share);
  }
  store_lanes(io, WOOD_COAT, k, coat);
  store_lanes(io, WOOD_COAT_ROUGHNESS, k, vsqrt(vsqrt(alpha2)));
}

/* The cells of a ray lie along the radius, each ray's a little askew; and the sine of their dive.
 */
INLINE vf ray_axis(const block *k, vf axis[3]) {
  vf zero = splat(0.0f), one = splat(1.0f), c = k->stem.c, s = k->stem.s;
  vf whole = inverse_root(one + k->ray_lean * k->ray_lean);
  axis[0] = (c - k->ray_lean * s) * whole;
  axis[1] = zero;
  axis[2] = (s + k->ray_lean * c) * whole;
  return zero - (axis[0] * k->nrm[0] + axis[2] * k->nrm[2]);
}

INLINE void ray_shine(const wood_constants *w, const vf v[3], const block *k, vf out[3]) {
  vf zero = splat(0.0f), one = splat(1.0f), axis[3], dive = ray_axis(k, axis);
  const cone_lost lost = {k->stem.c, k->stem.s, zero, k->ray_unlike};
  const cone_cells cells = {axis, dive, one, w->cone_ray,
                            any(gt(k->ray_unlike, zero)) ? &lost : NULL};
  cone_radiance(w, k->light, v, k->nrm, &cells, k->albedo, out);
}

/* Whether fibres shine over vessels, too: a picture's are not known, and those that the relief has
 * opened, it shades. */
INLINE int fibres_are_whole(const wood_constants *w) {
  return w->picture || w->surface.pores.depth > 0.0f || w->surface.rows.depth > 0.0f;
}

INLINE int rays_shine(const wood_constants *w) { return w->cone && w->has_rays && !w->picture; }

/* Both lobes' axes, as long as the share of the footprint that they have, and less where they would
 * reflect more than they receive: so that a host may average them as it likes. */
INLINE void stage_lobes(const wood_constants *w, int boards, const wood_io *io, block *k) {
  vf one = splat(1.0f), fibres = one, rays = splat(0.0f), back[3];
  vf axis[3] = {rays, rays, rays};
  if (w->cone) {
    cone_dive dive = cone_dive_of(k->sine);
    fibres = cone_along(w->cone_scale, &dive);
    if (!fibres_are_whole(w)) fibres = fibres * (one - k->cover);
  }
  if (rays_shine(w)) {
    vf sine = ray_axis(k, axis);
    cone_dive dive = cone_dive_of(sine);
    fibres = fibres * (one - k->ray);
    rays = k->ray * cone_along(w->cone_scale, &dive) * cone_along(w->cone_ray, &dive) *
           splat(w->inverse_ray_lustre);
  }
  if (boards) {
    vf wood = one - k->board.unit.joint; /* the joint has neither */
    fibres = fibres * wood;
    rays = rays * wood;
  }
  from_log(w, boards, k, k->fibre, back);
  for (int c = 0; c < 3; c++) store_lanes(io, WOOD_FIBER_LOBE + c, k, back[c] * fibres);
  from_log(w, boards, k, axis, back);
  for (int c = 0; c < 3; c++) store_lanes(io, WOOD_RAY_LOBE + c, k, back[c] * rays);
}

INLINE void stage_cone_radiance(const wood_constants *w, int boards, const wood_io *io, block *k) {
  vf r[3], v[3], one = splat(1.0f);
  view_of(w, boards, io, k, v);
  const cone_lost lost = {k->stem.c, k->stem.s, k->stem.lost_slope, k->grain.variance};
  vm some = gt(lost.out + lost.around, splat(0.0f));
  const cone_cells fibres = {k->fibre, k->sine, fibres_are_whole(w) ? one : one - k->cover, NULL,
                             any(some) ? &lost : NULL};
  cone_radiance(w, k->light, v, k->nrm, &fibres, k->albedo, r);
  if (rays_shine(w)) {
    vf shine[3];
    ray_shine(w, v, k, shine);
    for (int c = 0; c < 3; c++) r[c] = mix(r[c], shine[c], k->ray);
  }
  if (w->surface.relief) {
    vf lit = slopes_lit(k->lost);
    for (int c = 0; c < 3; c++) r[c] = r[c] * lit;
  }
  if (w->coat > 0.0f) {
    vf coat = coat_highlight(w, k->light, v, k->nrm, w->surface.relief ? k->lost : NULL);
    for (int c = 0; c < 3; c++) r[c] = r[c] + coat;
  }
  if (w->surface.relief) {
    for (int c = 0; c < 3; c++) r[c] = r[c] * k->past;
  }
  if (boards) {
    /* what lies in the joint has no fibres */
    vf lit = splat(w->diffuse) * vmax(k->incident, splat(0.0f));
    for (int c = 0; c < 3; c++) {
      r[c] = mix(r[c], lit * board_filler(w, &k->board, c), k->board.unit.joint);
    }
  }
  for (int c = 0; c < 3; c++) store_lit(io, k, c, r[c]);
}

#endif
