/* SPDX-License-Identifier: Apache-2.0
 *
 * What colours heartwood in bands and streaks.
 */
#ifndef SOZAI_WOOD_STAGES_PIGMENT_H
#define SOZAI_WOOD_STAGES_PIGMENT_H

#include "../pigment.h"
#include "../tubes.h"
#include "vessels.h"

/* Streaks of minerals along the fibre: a stain, which is no deeper where two
 * meet. */
static __attribute__((noinline)) void stage_streaks(const wood_constants *w, int boards, block *k) {
  vessel_place place = place_in(boards, &k->section, k);
  vf left;
  disc d;
  trough_sum g =
      tubes_over(&w->streaks, wood_seed(w, place.own, SEED_STREAKS), &place, k->p[1], &left, &d);
  k->streak = vmin(splat(WOOD_STREAK) * g.depth, splat(1.0f));
}

INLINE void stage_pigment(const wood_constants *w, int boards, block *k) {
  k->pigment = pigment_at(w, own_of(boards, k), k->stem.rho, vsqrt(k->section.f.bb), k->section.x,
                          k->section.z, k->section.f.aa + k->section.f.bb);
}

#endif
