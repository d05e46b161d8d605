/* SPDX-License-Identifier: Apache-2.0
 *
 * From the log to the stem: the pith, the growth front and its figure, rho.
 */
#ifndef SOZAI_WOOD_STAGES_STEM_H
#define SOZAI_WOOD_STAGES_STEM_H

#include "../alone.h"
#include "../figure.h"
#include "block.h"

INLINE void stage_pith(const wood_constants *w, int boards, block *k) {
#if LANES == 1
  k->stem.pith = pith_alone(w, own_of(boards, k), k->p[1]);
#else
  k->stem.pith = pith_at(w, own_of(boards, k), k->p[1], &k->held->pith);
#endif
  k->stem.lost = k->stem.lost_slope = k->stem.eye = splat(0.0f);
  k->undulation = undulation_none();
}

INLINE void stage_about(block *k) { stem_about(k->p[0], k->p[2], &k->stem); }

INLINE void stage_undulation(const undulation_octave *q, int boards, block *k) {
  undulation_add(q, own_of(boards, k), k->p[1], k->s, &k->held->undulation[q->o], &k->stem,
                 &k->undulation);
}

INLINE void stage_figure(const wood_constants *w, int boards, block *k) {
  figure_add(w, own_of(boards, k), k->p[1], k->s, k->extent, &k->stem, &k->undulation);
}

INLINE void stage_rho(const wood_constants *w, block *k) {
  stem_rho(w, k->p[1], &k->undulation, &k->stem);
}

#if LANES == 1
/* All octaves at once. */
INLINE void stage_undulations(const wood_constants *w, int boards, block *k) {
  k->undulation = undulation_alone(w, own_of(boards, k), k->p[1], k->s, &k->stem);
}
#endif

#endif
