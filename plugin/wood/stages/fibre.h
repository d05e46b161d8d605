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
  fibre_add(q, own_of(boards, k), at->x, at->z, &k->bundle);
  k->shift = k->bundle.shift;
}

#if LANES == 1
INLINE void stage_bundles(const wood_constants *w, int boards, block *k) {
  const section_place *near = grown_at(k), *far = &k->section;
  const fibre_eye eyes[2] = {{near->x, near->z, near->f}, {far->x, far->z, far->f}};
  k->bundle = fibre_alone(w, own_of(boards, k), &eyes[0], &eyes[1]);
  k->shift = k->bundle.shift;
}
#endif

#endif
