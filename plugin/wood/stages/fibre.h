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
  if (o == 0) k->bundle = fibre_start(&k->f);
  fibre_add(q, own_of(boards, k), k->x, k->z, &k->bundle);
  k->shift = k->bundle.shift;
}

#if LANES == 1
INLINE void stage_bundles(const wood_constants *w, int boards, block *k) {
  k->bundle = fibre_alone(w, own_of(boards, k), k->x, k->z, &k->f);
  k->shift = k->bundle.shift;
}
#endif

#endif
