/* SPDX-License-Identifier: Apache-2.0
 *
 * From a batch to blocks: the point, its frame, what it is seen and lit from.
 */
#ifndef SOZAI_FIBERTEX_SURFACE_H
#define SOZAI_FIBERTEX_SURFACE_H

#include "../../core/directions.h"
#include "block.h"

/* e1: the axis laid down on the surface; another where it stands upright. */
INLINE void frame_axes(const fibertex_constants *w, const vf given[3], hull_frame *f) {
  vf axis[3], along = dot3(given, f->n);
  vm upright = gt(vabs(along), splat(0.995f));
  for (int c = 0; c < 3; c++) axis[c] = sel(upright, splat(w->axis[(c + 1) % 3]), given[c]);
  along = dot3(axis, f->n);
  for (int c = 0; c < 3; c++) f->e1[c] = axis[c] - along * f->n[c];
  vf k = inverse_root(vmax(dot3(f->e1, f->e1), splat(1e-6f)));
  for (int c = 0; c < 3; c++) f->e1[c] = f->e1[c] * k;
  cross3(f->n, f->e1, f->e2);
  if (w->pile || w->nap > 0.0f) pile_lean_of(w, splat(1.0f), &f->pile);
}

INLINE void into_frame(const hull_frame *f, const vf v[3], vf out[3]) {
  out[0] = dot3(v, f->e1);
  out[1] = dot3(v, f->e2);
  out[2] = dot3(v, f->n);
}

/* What is at the point: where it is, its normal, its footprint. */
INLINE void stage_point(const fibertex_constants *w, int woven, const kernel_io *io, block *k) {
  const vf zero = splat(0.0f);
  vf axis[3], other[3];
  for (int c = 0; c < 3; c++) {
    k->at[c] = finite_coordinate(load_lanes(io->in->point[c], k->i, k->n)) + splat(w->offset[c]);
    k->f.n[c] = splat(0.57735027f);
    axis[c] = splat(w->axis[c]);
  }
  k->s = zero;
  if (io->in->footprint) {
    k->s = clamp(load_lanes(io->in->footprint, k->i, k->n), zero, splat(1e4f));
  }
  if (io->in->normal[0]) {
    for (int c = 0; c < 3; c++) k->f.n[c] = load_lanes(io->in->normal[c], k->i, k->n);
    unit_direction(k->f.n);
  }
  if (woven) cloth_axes(w, k->f.n, k->at, &k->cloth, other);
  frame_axes(w, woven ? k->cloth.axis : axis, &k->f);
  /* along e2, so that a twill leans the same way from every side, as it is woven */
  if (woven) k->cloth.v = sel(lt(dot3(other, k->f.e2), zero), zero - k->cloth.v, k->cloth.v);
}

INLINE void stage_view(const kernel_io *io, block *k) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  hull_frame *f = &k->f;
  vf v[3];
  direction_of(io->in->view, k->i, k->n, f->n, 1, v);
  /* squarely it is exactly that, so that what slants need can be left out */
  vm level = and_(and_(eq(v[0], f->n[0]), eq(v[1], f->n[1])), eq(v[2], f->n[2]));
  into_frame(f, v, f->view);
  /* at the horizon nothing is seen but the hull's edge: no further than this */
  vf slant = one / vmin(vmax(f->view[2], splat(0.18f)), one);
  /* and within some 3e-4 of it, where the cosine is 1: eye_level asks for that alone */
  level = or_(level, eq(slant, one));
  slant = sel(level, one, slant);
  for (int c = 0; c < 3; c++) f->view[c] = sel(level, c == 2 ? one : zero, f->view[c]);
  for (int c = 0; c < 3; c++) f->step[c] = sel(level, zero, (v[c] - f->n[c] * f->view[2]) * slant);
  for (int c = 0; c < 2; c++) f->lean2[c] = f->view[c] * slant;
  k->inverse[1] = slant;
}

/* Whether all are looked at squarely. */
INLINE int eye_level(const block *k, uint32_t blocks) {
  vm slant = lt(splat(1.0f), splat(0.0f));
  EACH(b, blocks) slant = or_(slant, not_(eq(k[b].inverse[1], splat(1.0f))));
  return !any(slant);
}

INLINE void stage_bundles(const fibertex_constants *w, int level, block *k) {
  lattice_of(&k->f, k->at, level, k->g);
  k->filter = lane_filter_of(w->layer[0].radius, k->s);
}

/* What of a pile light meets on its way, over what it meets squarely: to strands that lie every way
 * as to all the amounts are fitted for, inverse (1 over the cosine), as the widths go. */
INLINE vf met_of_pile(const fibertex_constants *w, const hull_frame *f, vf inverse) {
  const vf lean2[2] = {f->light[0] * inverse, f->light[1] * inverse};
  vf flat = splat(0.5f) * (lean2[0] * lean2[0] + lean2[1] * lean2[1]) + splat(1.0f);
  return inverse * inverse_root(flat) * pile_widening_mean(w, &f->pile, lean2, 30.0f);
}

/* The eye sees what is lit, where it looks along the light: the way in is the way out. */
INLINE void stage_met(const fibertex_constants *w, block *k) {
  const vf one = splat(1.0f);
  vf apart = one + (one - k->f.between) * splat(w->opposition_sharp);
  vf met = k->inverse[0];
  if (w->pile) met = met_of_pile(w, &k->f, met);
  k->inverse_up = (one - splat(w->opposition) / (apart * apart)) * met;
}

INLINE void stage_light(const fibertex_constants *w, const kernel_io *io, block *k) {
  const vf one = splat(1.0f);
  vf v[3];
  direction_of(io->in->light, k->i, k->n, k->f.n, 0, v);
  into_frame(&k->f, v, k->f.light);
  k->f.between = dot3(k->f.light, k->f.view);
  k->front = smooth_step(splat(-0.02f), splat(0.22f), k->f.light[2]);
  k->inverse[0] = one / vmax(k->f.light[2], splat(0.1f));
  stage_met(w, k);
}

/* No light is asked for, and none that is given looked at. */
INLINE void stage_dark(block *k) {
  const vf zero = splat(0.0f);
  for (int c = 0; c < 3; c++) k->f.light[c] = zero;
  k->f.between = k->front = k->reach = k->lit = k->deep_lit = zero;
  k->inverse[0] = k->inverse_up = k->step[0] = k->step[1] = zero;
}

/* The light that reaches the next layer straight. */
INLINE void stage_reach(const fibertex_constants *w, block *k) {
  k->step[0] = exp2_(splat(-1.442695f * w->step) * k->inverse_up);
  k->step[1] = exp2_(splat(-1.442695f * w->step_more) * k->inverse_up);
  k->deep_lit = exp2_(splat(-1.442695f * w->deep_above) * k->inverse_up) * k->front;
  k->reach = k->lit = k->front;
}

/* Of a cloth what of the light all of them get is the yarn's business: here only which of them
 * more, which less. */
INLINE void stage_reach_of_cloth(const fibertex_constants *w, block *k) {
  vf all = splat(0.0f);
  for (int l = w->layers - 1; l >= w->yarns_from; l--) {
    all = all * k->step[0] + splat(w->part[l]);
  }
  all = k->front * all + splat(w->part_deep) * k->deep_lit;
  vf inverse = k->front * splat(1.0f - w->flown) / vmax(all, splat(1e-6f));
  k->reach = k->front * inverse;
  k->deep_lit = k->deep_lit * inverse;
}

INLINE void stage_empty(const fibertex_constants *w, block *k) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  k->far = smooth_step(splat(w->far[0]), splat(w->far[1]), k->s);
  k->sum.left = k->shade = one;
  k->hole = zero;
  for (int c = 0; c < 2; c++) {
    k->sum.albedo[c] = k->sum.direct[c] = zero;
    k->best.direction[c] = splat(w->below[c]);
  }
  k->sum.bare = k->sum.depth = k->most = k->next = zero;
  k->best.slope = k->best.bend = k->best.across = k->best.strand = k->best.lit = zero;
  k->best.flown = zero;
  k->best.id = splatu(0);
}

#endif
