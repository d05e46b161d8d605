/* SPDX-License-Identifier: Apache-2.0
 *
 * Holes as depth: a bowl in every body of that layer that is open at the face.
 */
#ifndef SOZAI_STONE_HOLES_H
#define SOZAI_STONE_HOLES_H

#include "cells.h"
#include "field.h"

/* mm below the face, 0 or more. p: bed space. */
STAGE vf hole_depth_at(const stone_constants *w, const vf p[3]) {
  const stone_cells *c = &w->layer[LAYER_HOLES];
  vf q[3], zero = splat(0.0f), one = splat(1.0f);
  (void)cells_place(c, p, q);
  cells_near a, b;
  cells_find(c, q, &a, &b);
  vf g2 = zero, r2 = splat(1e-12f);
  for (int k = 0; k < 3; k++) {
    vf g = a.x[k] - b.x[k];
    g2 = g2 + g * g;
    r2 = r2 + a.x[k] * a.x[k];
  }
  vf in = splat(0.5f) * (b.d - a.d) * inverse_root(g2 + splat(1e-12f)) - cells_erosion(c, a.h);
  if (c->radius < 4.0f) in = vmin(in, cells_radius(c, a.h) - vsqrt(r2));
  in = vmax(in, zero);
  vm open = lt(cells_rank(c, a.at), splat(c->chance[1]));
  /* steep at the rim, flat at the bottom */
  vf depth = splat(2.0f * w->hole_depth) * in / (one + splat(4.0f) * in);
  return sel(open, depth, zero);
}

/* The same as height. The field bends in a way that has no gradient of its own
 * here: slopes are differences over a step within the surface. t1, t2: bed space. */
STAGE field hole_relief(const stone_constants *w, const vf p[3], const vf t1[3], const vf t2[3],
                        vf s, vf share, vf *lost) {
  const stone_cells *c = &w->layer[LAYER_HOLES];
  vf zero = splat(0.0f), one = splat(1.0f);
  float size = c->size;
  vf keep = one - smooth_step(splat(0.3f * size), splat(1.2f * size), s);
  float steep = w->hole_depth / size;
  *lost = *lost + splat(steep * steep) * share * (one - keep * keep);
  field f = field_of(splat(-0.1f * w->hole_depth) * share * (one - keep));
  if (!any(gt(keep, zero))) return f;
  vf step = vmax(splat(0.5f) * s, splat(0.004f * size));
  vf d[4], sum = zero, inverse = splat(0.5f) / step;
  for (int k = 0; k < 4; k++) {
    const vf *t = k < 2 ? t1 : t2;
    vf along = k & 1 ? step : zero - step, at[3];
    for (int a = 0; a < 3; a++) at[a] = p[a] + t[a] * along;
    d[k] = hole_depth_at(w, at);
    sum = sum + d[k];
  }
  f.v = f.v - keep * splat(0.25f) * sum;
  vf du = (d[0] - d[1]) * inverse * keep, dv = (d[2] - d[3]) * inverse * keep;
  for (int a = 0; a < 3; a++) f.g[a] = du * t1[a] + dv * t2[a];
  return f;
}

#endif
