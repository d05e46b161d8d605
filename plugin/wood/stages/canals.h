/* SPDX-License-Identifier: Apache-2.0
 *
 * Resin canals under the footprint.
 */
#ifndef SOZAI_WOOD_STAGES_CANALS_H
#define SOZAI_WOOD_STAGES_CANALS_H

#include "../canals.h"
#include "vessels.h"

INLINE void stage_canals(const wood_constants *w, int boards, const wood_io *io, block *k) {
  vessel_place place = vessel_place_of(boards, k);
  k->canal = canals_at(w, &place);
  if (k->knot) {
    vf stem = splat(1.0f) - k->knot->cover;
    k->canal.whole = k->canal.whole * stem;
    k->canal.core = k->canal.core * stem;
  }
  store_lanes(io, WOOD_CANAL, k, k->canal.whole);
}

#endif
