/* SPDX-License-Identifier: Apache-2.0
 *
 * Rings: the year at a point, and the mean of what goes with rings under its footprint.
 */
#ifndef SOZAI_WOOD_STAGES_RINGS_H
#define SOZAI_WOOD_STAGES_RINGS_H

#include "../plies/wide.h"
#include "../rings_curved.h"
#include "footprint.h"
#include "knots.h"
#include "wants.h"

INLINE void stage_ring_find(const wood_constants *w, block *k) {
  k->in_table = ring_find(w, k->stem.rho, &k->ring);
}

INLINE void stage_ring(const wood_constants *w, const wood_io *io, block *k) {
  ring_read(w, k->in_table, &k->ring);
  k->years = to_float(k->ring.ring) + k->ring.phase;
  store_lanes(io, WOOD_TIME, k, k->years);
  k->divisor = grain_divisor(k->stem.rho);
}

/* Where boards may be bent veneer. */
INLINE int has_bent_boards(const wood_constants *w, int boards) {
  return boards && (w->plies.count || w->peeled);
}

/* mm: the footprint that rings may curve under. */
INLINE vf curved_footprint(const wood_constants *w, int boards, const block *k) {
  return has_bent_boards(w, boards) ? k->board.wide : k->s;
}

/* Where a block's means over curved and over bent rings are kept. */
typedef struct {
  curved_rings curved;
  wide_rings wide;
} rings_room;

/* Where rings curve under the footprint; `room` is where their means are kept. */
INLINE void stage_curved(const wood_constants *w, int boards, const wood_io *io,
                         const wood_wants *want, block *k, curved_rings *room) {
  k->curve = NULL;
  vf s = curved_footprint(w, boards, k);
  if (!io->in->normal[0] || !rings_may_curve(w, &k->stem, s)) return;
  if (curved_rings_of(w, want->vessel, &k->stem, k->b, k->nrm, s, room)) k->curve = room;
}

/* The mean of what goes with rings under the footprint. */
INLINE vf rings_mean_at(const wood_constants *w, int boards, int what, const block *k, vf rho,
                        const ring_place *ring, vf reach) {
  vf mean = ring_average(w, what, ring, rho, reach);
  if (k->curve) mean = sel(k->curve->curved, k->curve->mean[what], mean);
  if (has_bent_boards(w, boards) && k->wide) mean = wide_rings_mean(what, k, mean);
  return mean;
}

INLINE vf rings_mean(const wood_constants *w, int boards, int what, const block *k) {
  return rings_mean_at(w, boards, what, k, k->stem.rho, &k->ring, k->reach);
}

INLINE void stage_wide(const wood_constants *w, int boards, const wood_io *io, block *k,
                       wide_rings *room) {
  k->wide = NULL;
  if (any(gt(k->board.bent, splat(WIDE_FROM)))) {
    wide_rings_of(w, own_of(boards, k), !io->in->normal[0], k, room);
  }
}

/* Where the latewood strays from its ring: it is as it would be that much nearer to the
 * pith or farther from it. */
INLINE void stage_stray(const wood_constants *w, block *k) {
  vf reach = k->reach, front = k->bundle.front, zero = splat(0.0f);
  k->front_rho = vmax(k->stem.rho - front, zero);
  k->front_reach = reach;
  if (any(gt(k->bundle.lost, zero))) {
    k->front_reach = vsqrt(reach * reach + splat(12.0f) * k->bundle.lost);
  }
  vf phase = k->ring.phase - front * k->ring.inverse_width;
  vm out = or_(lt(phase, zero), gt(phase, splat(1.0f)));
  k->crossed = any(out);
  if (k->crossed) {
    ring_place other = ring_at(w, k->front_rho), *ring = &k->front_ring;
    const ring_place *here = &k->ring;
    ring->turns = sel(out, other.turns, here->turns);
    ring->start = sel(out, other.start, here->start);
    ring->inverse_width = sel(out, other.inverse_width, here->inverse_width);
    ring->weight = sel(out, other.weight, here->weight);
    ring->last = sel(out, other.last, here->last);
  }
}

/* The mean of what goes with rings whose ends stray. */
INLINE vf rings_mean_strayed(const wood_constants *w, int boards, int what, const block *k) {
  if (!w->has_front) return rings_mean(w, boards, what, k);
  const ring_place *ring = k->crossed ? &k->front_ring : &k->ring;
  return rings_mean_at(w, boards, what, k, k->front_rho, ring, k->front_reach);
}

INLINE void stage_rings(const wood_constants *w, int boards, const wood_io *io, block *k) {
  k->late = rings_mean_strayed(w, boards, MEAN_LATE, k);
  vf late = k->late;
  if (k->knot) late = stage_knot_late(w, k);
  store_lanes(io, WOOD_LATEWOOD, k, late);
}

#endif
