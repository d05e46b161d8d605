/* SPDX-License-Identifier: Apache-2.0
 *
 * Directions in object space and in the log's, from which a board was cut.
 */
#ifndef SOZAI_WOOD_STAGES_AXES_H
#define SOZAI_WOOD_STAGES_AXES_H

#include "block.h"

/* From object space. */
INLINE void to_log(const wood_constants *w, int boards, const block *k, const vf p[3], vf out[3]) {
  if (boards) {
    const vf(*t)[3] = k->board.turn;
    for (int c = 0; c < 3; c++) out[c] = t[c][0] * p[0] + t[c][1] * p[1] + t[c][2] * p[2];
    return;
  }
  if (!w->turned) {
    for (int c = 0; c < 3; c++) out[c] = p[c];
    return;
  }
  for (int c = 0; c < 3; c++) {
    out[c] =
        splat(w->turn[c][0]) * p[0] + splat(w->turn[c][1]) * p[1] + splat(w->turn[c][2]) * p[2];
  }
}

/* And back. */
INLINE void from_log(const wood_constants *w, int boards, const block *k, const vf v[3],
                     vf out[3]) {
  for (int c = 0; c < 3; c++) {
    if (boards) {
      const vf(*t)[3] = k->board.turn;
      out[c] = t[0][c] * v[0] + t[1][c] * v[1] + t[2][c] * v[2];
    } else if (w->turned) {
      out[c] =
          splat(w->turn[0][c]) * v[0] + splat(w->turn[1][c]) * v[1] + splat(w->turn[2][c]) * v[2];
    } else {
      out[c] = v[c];
    }
  }
}

#endif
