/* SPDX-License-Identifier: Apache-2.0
 *
 * The surface that a finish leaves: a height over the sawn face, a function of
 * the place in space, with its exact gradient.
 */
#ifndef SOZAI_STONE_RELIEF_H
#define SOZAI_STONE_RELIEF_H

#include "cleft.h"
#include "stone.h"
#include "value.h"

/* Height in mm, its gradient, the variance of slope along one axis that the
 * footprint averages out, and of the height what it leaves. */
STAGE vf relief_at(const stone_constants *w, const vf p[3], vf s, vf slope[3], vf *lost,
                   vf *square) {
  vf height = splat(0.0f), one = splat(1.0f);
  *square = splat(1e-12f);
  slope[0] = slope[1] = slope[2] = *lost = height;
  for (int o = 0; o < w->relief_octaves; o++) {
    vf f = splat(w->relief_frequency[o]), g[3], at[3] = {p[0] * f, p[1] * f, p[2] * f};
    vf keep = one - smooth_step(splat(0.25f), splat(1.0f), s * f);
    *lost = *lost + (one - keep * keep) * splat(w->relief_slope2[o]);
    if (!any(gt(keep, splat(0.0f)))) continue;
    *square = *square + keep * keep * splat(0.05f * w->relief[o] * w->relief[o]);
    vf v = value_gradient(at, splatu(w->seed_relief + (uint32_t)o), g);
    vf scale = one;
    if (w->pitted && o < 2) {
      /* bumps between the pits that a hammer's points leave */
      scale = splat(-5.0f) * v;
      v = splat(0.25f) - splat(2.5f) * v * v;
    }
    vf k = keep * splat(w->relief[o]);
    height = height + k * v;
    for (int a = 0; a < 3; a++) slope[a] = slope[a] + k * f * scale * g[a];
  }
  if (w->is_cleft) height = height + cleft_at(w, p, s, slope, lost, square);
  return height;
}

#endif
