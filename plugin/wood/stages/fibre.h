/* SPDX-License-Identifier: Apache-2.0
 *
 * The fibres' own brightness.
 */
#ifndef SOZAI_WOOD_STAGES_FIBRE_H
#define SOZAI_WOOD_STAGES_FIBRE_H

#include "../alone.h"
#include "../fibre.h"
#include "block.h"

/* One octave of the fibres' noise. */
INLINE void stage_bundle(const fibre_octave *q, int boards, int o, block *k) {
  /* drifts of a hand's breadth go on from bolt to bolt */
  const section_place *at = o < FIBRE_DRIFT ? grown_at(k) : &k->section;
  if (o == 0) k->bundle = fibre_start();
  if (o == 0 || (o == FIBRE_DRIFT && k->in.moved)) fibre_under(&at->f, &k->bundle);
  fibre_add(q, own_of(boards, k), at->x, at->z, &k->bundle, &k->strays);
  k->shift = k->bundle.shift;
}

#define DRIFT_ROUND 0.2f /* cells: how far it differs round the stem */

/* Drift along the stem: slow, of the whole wood. It differs from one side to the other, or the two
 * halves of a board would mirror each other. */
INLINE void stage_drift(const wood_constants *w, int boards, block *k) {
  noise_axis up = noise_split_cubic(
      k->p[1] * splat(w->drift_frequency) + splat(DRIFT_ROUND) * k->stem.s, HASH_Y);
  noise_axis out = noise_split_cubic(
      k->stem.rho * splat(w->drift_frequency_radial) + splat(DRIFT_ROUND) * k->stem.c, HASH_X);
  vf across, along, keep = splat(w->drift), one = splat(1.0f);
  vf extent = vmax(k->extent, k->s * splat(w->drift_frequency_radial * w->drift_length));
  if (filter_touches(extent, w->drift_length)) keep = keep * filter_keep(extent, w->drift_length);
  vf n = noise_value2_held(&up, HASH_Y, &out, HASH_X, wood_seed(w, own_of(boards, k), SEED_DRIFT),
                           &k->held->drift, &along, &across);
  /* each board's is its own, and counts as much as the footprint lies on it */
  if (boards && w->boards.layout.kind != LAYOUT_NONE) keep = keep * k->board.unit.own;
  k->shift = k->shift * (one + keep * n);
}

#if LANES == 1
INLINE void stage_bundles(const wood_constants *w, int boards, block *k) {
  const section_place *near = grown_at(k), *far = &k->section;
  const fibre_eye eyes[2] = {{near->x, near->z, near->f}, {far->x, far->z, far->f}};
  k->bundle = fibre_alone(w, own_of(boards, k), &eyes[0], &eyes[1], &k->strays);
  k->shift = k->bundle.shift;
}
#endif

#endif
