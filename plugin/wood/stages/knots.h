/* SPDX-License-Identifier: Apache-2.0
 *
 * What knots do on the way: to the growth front, to the section and the fibres, to latewood and
 * colour.
 */
#ifndef SOZAI_WOOD_STAGES_KNOTS_H
#define SOZAI_WOOD_STAGES_KNOTS_H

#include "../knots.h"
#include "block.h"

/* Where on the stem a board's log lies, in turns of the period. */
INLINE vf knot_shift(const block *k) {
  vu h = hash_mix(k->board.own + splatu(HASH_Z));
  return to_float((vi)(h >> 8)) * splat(1.0f / 16777216.0f);
}

/* Once in the code: it is long, and few points are near a knot. */
static __attribute__((noinline)) void stage_knots_near(const wood_constants *w, const wood_io *io,
                                                       vf shift, block *k) {
  vf zero = splat(0.0f);
  knot_place *q = k->knot;
  knot_eye e = {.y = k->p[1], .s = k->s, .n = k->nrm, .ball = !io->in->normal[0]};
  knot_taps taps;
  if (any(gt(k->s, splat(KNOT_CLOSE)))) {
    knot_taps_of(&k->stem, k->s, k->nrm, e.ball, &taps);
    e.taps = &taps;
  }
  *q = knot_none();
  knots_add(w->knots, shift, &e, &k->stem, q);
  if (e.taps) knot_taps_late(w, k->s, &taps, q);
  store_lanes(io, WOOD_KNOT, k, q->cover);
  /* a point that no knot has to do with is as in wood without knots, to the bit */
  if (!any(gt(q->near + q->cover + q->bark + q->halo + q->nodes, zero))) k->knot = NULL;
}

INLINE void stage_knots(const wood_constants *w, const wood_io *io, vf shift, block *k) {
  if (knots_near(w->knots, shift, k->p[1], k->s, &k->stem)) {
    stage_knots_near(w, io, shift, k);
    return;
  }
  k->knot = NULL;
  store_lanes(io, WOOD_KNOT, k, splat(0.0f));
}

/* In a knot the reference is the branch's own section. */
INLINE void stage_knot_section(block *k) {
  const knot_place *q = k->knot;
  vm in = gt(q->inside, splat(0.0f));
  if (!any(in)) return;
  vf turn = inverse_root(vmax(q->a * q->a + q->h * q->h, splat(1e-6f)));
  k->section.x = sel(in, q->a, k->section.x);
  k->section.z = sel(in, q->h, k->section.z);
  k->section.c = sel(in, q->a * turn, k->section.c);
  k->section.s = sel(in, q->h * turn, k->section.s);
}

/* Near knots rho and theta' both depend on all three coordinates: slopes along
 * the radius and round from the two equations. */
INLINE void stage_knot_slopes(const block *k, vf omega, vf rho_r, vf *climb, vf *around) {
  vm near = gt(k->knot->near, splat(0.0f));
  if (!any(near)) return;
  const stem_place *stem = &k->stem;
  const knot_place *q = k->knot;
  vf zero = splat(0.0f);
  vf rho_a = stem->rho_z * stem->c - stem->rho_x * stem->s;
  vf turn_r = q->turn_x * stem->c + q->turn_z * stem->s;
  vf turn_a = stem->inverse_r + (q->turn_z * stem->c - q->turn_x * stem->s);
  vf left = omega - q->turn_y, whole = rho_r * turn_a - rho_a * turn_r;
  vf inverse = splat(1.0f) / sel(lt(vabs(whole), splat(1e-9f)), splat(1e-9f), whole);
  vf radial = (zero - stem->rho_y * turn_a - rho_a * left) * inverse;
  vf round = (rho_r * left + turn_r * stem->rho_y) * inverse;
  /* no fibre runs more than 70 degrees off the stem */
  vf slope = radial * radial + round * round, most = splat(7.5f);
  vf keep = sel(gt(slope, most), vsqrt(most / vmax(slope, most)), splat(1.0f));
  *climb = sel(near, radial * keep, *climb);
  *around = sel(near, round * keep, *around);
}

/* Where a knot's edge runs through the footprint, stem and knot have each its own;
 * of the part that the point is not in, the mean is known. */
INLINE vf stage_knot_late(const wood_constants *w, block *k) {
  knot_place *q = k->knot;
  vf zero = splat(0.0f), mean = splat(w->late_period * w->inverse_ring_period), at = k->late;
  vm in = gt(q->inside, zero), some = gt(q->nodes, zero);
  q->own = sel(in, at, mean);
  k->late = sel(and_(in, lt(q->cover, splat(1.0f))), mean, at);
  k->late = sel(some, mix(k->late, q->late, q->nodes), k->late);
  return sel(gt(q->cover, zero), mix(k->late, q->own, q->cover), k->late);
}

#define KNOT_RESIN 0.8f /* of the knot's colour in the wood beside it */
#define KNOT_HEART 0.3f /* by which it is darker at its pith than at its edge */

INLINE void stage_knot_colour(const wood_constants *w, block *k, vf late) {
  const knot_place *q = k->knot;
  vf one = splat(1.0f), least = splat(1e-6f);
  if (!any(gt(q->cover + q->bark + q->halo, splat(0.0f)))) return;
  /* of what bark leaves, the knot's share; and of the wood beside both, the resin's */
  vf rest = vmax(one - q->bark, least), cover = vmin(q->cover / rest, one);
  vf beside = vmax(rest - q->cover, least), ripe = q->heart / vmax(q->cover, least);
  vf stain = splat(w->knot_stain), full = splat(KNOT_RESIN) * stain;
  vf resin = clamp01((q->halo - q->cover - q->bark) / beside) * full;
  ripe = clamp(ripe, splat(-KNOT_TONE), splat(1.0f + KNOT_TONE));
  ripe = one - splat(KNOT_HEART) * ripe;
  for (int c = 0; c < 3; c++) {
    vf own = mix(splat(w->knot_early[c]), splat(w->knot_late[c]), late) * (k->shift * ripe);
    vf wet = splat(w->knot_early[c]) * k->shift;
    own = mix(mix(k->albedo[c], wet, full), own, stain);
    k->albedo[c] = mix(mix(k->albedo[c], wet, resin), own, cover);
    k->albedo[c] = k->albedo[c] * (splat(1.0f) - splat(0.8f) * q->check);
    k->albedo[c] = mix(k->albedo[c], splat(w->knot_bark[c]) * k->shift, q->bark);
  }
}

#endif
