/* SPDX-License-Identifier: Apache-2.0
 *
 * From object space to bed space, in which +y lies across the beds, and back.
 */
#ifndef SOZAI_STONE_BED_H
#define SOZAI_STONE_BED_H

#include "block.h"

INLINE void copy3(const vf from[3], vf to[3]) {
  for (int c = 0; c < 3; c++) to[c] = from[c];
}

/* Object space to bed space, which is its own way back. */
INLINE void exchange(const stone_constants *w, vf v[3]) {
  vf y = v[1];
  v[1] = v[w->swap];
  v[w->swap] = y;
}

/* Bed space to object space, a direction. */
INLINE void from_bed(const stone_constants *w, int paved, const block *k, vf v[3]) {
  exchange(w, v);
  if (paved) laid_turn_back(&k->laid, v);
}

/* The footprint, object space. */
INLINE void stage_square(const stone_constants *w, int paved, const block *k, laid_square *out) {
  copy3(k->t1, out->side[0]);
  copy3(k->t2, out->side[1]);
  for (int i = 0; i < 2; i++) from_bed(w, paved, k, out->side[i]);
  out->n = k->square ? k->face : NULL;
}

#endif
