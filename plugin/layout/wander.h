/* SPDX-License-Identifier: Apache-2.0
 *
 * Joints that wander, as between stones cut by hand: the plane is bent before
 * the layout is asked. A line is split evenly, its division points are moved,
 * at random, and between them it runs smoothly; both sides of a joint move
 * alike, so that there is neither hole nor overlap.
 */
#ifndef SOZAI_LAYOUT_WANDER_H
#define SOZAI_LAYOUT_WANDER_H

#include "../core/noise.h"
#include "layout.h"

/* Where (x, y) is moved to, and the bent place's derivatives: row k is of the
 * bent coordinate k along x and y. */
INLINE void layout_wander_at(const layout_wander *w, vf x, vf y, vf to[2], vf row[2][2]) {
  noise_axis a = noise_split_cubic(x * splat(w->frequency), HASH_X);
  noise_axis b = noise_split_cubic(y * splat(w->frequency), HASH_Y);
  vf k = splat(w->amplitude / HASH_ONE), slope = splat(w->amplitude * w->frequency / HASH_ONE);
  const vf at[2] = {x, y};
  for (int c = 0; c < 2; c++) {
    vf dx, dy;
    vf d = noise_value2(&a, &b, splatu(w->seed + (uint32_t)c * 0x9e3779b9u), &dx, &dy);
    to[c] = at[c] + k * d;
    row[c][0] = slope * dx + splat(c ? 0.0f : 1.0f);
    row[c][1] = slope * dy + splat(c ? 1.0f : 0.0f);
  }
}

#endif
