/* SPDX-License-Identifier: Apache-2.0
 *
 * What fungi have left: zone lines, bleached wood, stains.
 */
#ifndef SOZAI_WOOD_STAGES_SPALT_H
#define SOZAI_WOOD_STAGES_SPALT_H

#include "../spalt.h"
#include "footprint.h"

INLINE void stage_spalt(const wood_constants *w, int boards, const wood_io *io, block *k) {
  vf a[3], b[3];
  spalt_eye q = {.at = {k->section.x, k->p[1], k->section.z},
                 .n = k->nrm,
                 .ball = !io->in->normal[0],
                 .s = k->s};
  section_rows(k, a, b);
  for (int c = 0; c < 3; c++) {
    q.row[0][c] = k->section.c * b[c] - k->section.s * a[c];
    q.row[1][c] = splat(c == 1 ? 1.0f : 0.0f);
    q.row[2][c] = k->section.s * b[c] + k->section.c * a[c];
  }
  if (boards && w->plies.count) {
    for (int c = 0; c < 3; c++) ply_squeeze(&k->board, q.row[c]);
  }
  k->spalt = spalt_at(w, own_of(boards, k), &q);
}

/* Bleached wood is nearer to white, which is white in every working space; what
 * the zone lines are made of is melanin. */
INLINE void stage_spalt_colour(const wood_constants *w, block *k) {
  vf one = splat(1.0f), *a = k->albedo;
  for (int c = 0; c < 3; c++) {
    vf pale = a[c] + (splat(w->spalt_pale[c]) - a[c]) * splat(0.4f);
    a[c] = mix(a[c], pale, k->spalt.bleached);
    a[c] = a[c] * (one - splat(0.2f) * k->spalt.stained) * (one - splat(0.86f) * k->spalt.line);
  }
}

#endif
