/* SPDX-License-Identifier: Apache-2.0
 *
 * The surface that a finish leaves: a height over the sawn face, a function of
 * the place in space, with its exact gradient.
 */
#ifndef SOZAI_STONE_RELIEF_H
#define SOZAI_STONE_RELIEF_H

#include "cleft.h"
#include "facets.h"
#include "stone.h"
#include "value.h"

/* Where a relief is asked for, in bed space: the point, the footprint's sides, the face; and
 * whether that is a paving's, whose stones all show the face that they were split for. */
typedef struct {
  const vf *p, *t1, *t2, *face;
  vf s;
  int paved;
} relief_place;

/* How far the face lies along the cleavage. */
INLINE vf relief_along(const relief_place *o) {
  if (o->paved) return splat(1.0f);
  return smooth_step(splat(0.25f), splat(0.55f), vabs(o->face[1]));
}

/* Height in mm, its gradient, the variance of slope along one axis that the
 * footprint averages out, and of all, and of the height what it leaves. */
STAGE vf relief_at(const stone_constants *w, const relief_place *o, vf slope[3], vf *lost,
                   vf *square, vf *steep) {
  const vf *p = o->p, s = o->s;
  vf height = splat(0.0f), one = splat(1.0f);
  *square = splat(1e-12f);
  *steep = splat(w->relief_steep);
  slope[0] = slope[1] = slope[2] = *lost = height;
  for (int k = 0; k < w->relief_octaves; k++) {
    vf f = splat(w->relief_frequency[k]), g[3], at[3] = {p[0] * f, p[1] * f, p[2] * f};
    vf keep = one - smooth_step(splat(0.25f), splat(1.0f), s * f);
    *lost = *lost + (one - keep * keep) * splat(w->relief_slope2[k]);
    if (!any(gt(keep, splat(0.0f)))) continue;
    *square = *square + keep * keep * splat(NOISE_VARIANCE * w->relief[k] * w->relief[k]);
    vf v = value_gradient(at, splatu(w->seed_relief + (uint32_t)k), g);
    vf scale = one;
    if (w->pitted && k < 2) {
      /* bumps between the pits that a hammer's points leave */
      scale = splat(-5.0f) * v;
      v = splat(0.25f) - splat(2.5f) * v * v;
    }
    vf high = keep * splat(w->relief[k]);
    height = height + high * v;
    for (int a = 0; a < 3; a++) slope[a] = slope[a] + high * f * scale * g[a];
  }
  if (w->faceted) height = height + facets_at(w, p, o->t1, o->t2, s, slope, lost, square);
  if (w->is_cleft) height = height + cleft_at(w, p, relief_along(o), s, slope, lost, square, steep);
  return height;
}

#endif
