/* SPDX-License-Identifier: Apache-2.0
 *
 * Holes as depth: a bowl in every body of that layer that is open at the face.
 */
#ifndef SOZAI_STONE_HOLES_H
#define SOZAI_STONE_HOLES_H

#include "bodies.h"
#include "field.h"

/* How far within the face to another cell: cells, less what the body is smaller by. */
INLINE vf hole_within(const cells_near *a, const cells_near *b, vf erosion) {
  vf g2 = splat(1e-12f);
  for (int k = 0; k < 3; k++) {
    vf g = a->x[k] - b->x[k];
    g2 = g2 + g * g;
  }
  return splat(0.5f) * (b->d - a->d) * inverse_root(g2) - erosion;
}

/* How deep the body of cell a is below the face at a place, b and c the others that tell its
 * outline, as they tell the colour's: mm, 0 or more. */
INLINE vf hole_depth_of(const stone_constants *w, const cells_near *a, const cells_near *b,
                        const cells_near *c) {
  const stone_cells *l = &w->layer[LAYER_HOLES];
  vf zero = splat(0.0f), one = splat(1.0f), erosion = cells_erosion(l, a->h);
  vf in = hole_within(a, b, erosion), r2 = splat(1e-12f);
  if (cells_asked(l) > 2) in = vmin(in, hole_within(a, c, erosion));
  for (int k = 0; k < 3; k++) r2 = r2 + a->x[k] * a->x[k];
  if (l->radius < 4.0f) in = vmin(in, cells_radius(l, a->h) - vsqrt(r2));
  in = vmax(in, zero);
  vf rich, rank = cells_rank(l, a->at, &rich);
  vm open = lt(rank, splat(l->chance[1]) * rich);
  /* steep at the rim, flat at the bottom */
  vf depth = splat(2.0f * w->hole_depth) * in / (one + splat(4.0f) * in);
  return sel(open, depth, zero);
}

STAGE vf hole_depth_at(const stone_constants *w, const vf p[3]) {
  const stone_cells *c = &w->layer[LAYER_HOLES];
  vf q[3];
  cells_place(c, p, q);
  cells_near near[3];
  cells_find(c, 1, 0, q, near);
  return hole_depth_of(w, &near[0], &near[1], &near[2]);
}

/* The cell as it lies from a place `by` cells away. */
INLINE cells_near hole_moved(const cells_near *n, const vf by[3]) {
  cells_near m = *n;
  for (int k = 0; k < 3; k++) m.x[k] = n->x[k] - by[k];
  m.d = dot3(m.x, m.x); /* bodies have no weights */
  return m;
}

/* The same near a place whose nearest cells are known. Between them lie the walls of stone
 * that a further cell would be beyond. */
STAGE vf hole_depth_by(const stone_constants *w, const vf p[3], const vf q0[3],
                       const cells_near near[3]) {
  vf q[3];
  cells_place(&w->layer[LAYER_HOLES], p, q);
  for (int k = 0; k < 3; k++) q[k] = q[k] - q0[k];
  cells_near a = hole_moved(&near[0], q), b = hole_moved(&near[1], q), c = hole_moved(&near[2], q);
  vf own = hole_depth_of(w, &a, &b, &c), other = hole_depth_of(w, &b, &a, &c);
  return sel(le(a.d, b.d), own, other);
}

#define HOLE_PLACES 3 /* about the point, at the corners of a triangle */

/* The same as height. The field bends in a way that has no gradient of its own
 * here: slopes are differences over a step within the surface. t1, t2: bed space. */
STAGE field hole_relief(const stone_constants *w, const vf p[3], const vf t1[3], const vf t2[3],
                        vf s, vf share, vf *lost) {
  static const float corner[HOLE_PLACES][2] = {
      {1.0f, 0.0f}, {-0.5f, 0.8660254f}, {-0.5f, -0.8660254f}};
  const stone_cells *c = &w->layer[LAYER_HOLES];
  vf zero = splat(0.0f), one = splat(1.0f);
  float size = c->size;
  vf keep = one - smooth_step(splat(0.3f * size), splat(1.2f * size), s);
  float steep = w->hole_depth / size;
  *lost = *lost + splat(steep * steep) * share * (one - keep * keep);
  field f = field_of(splat(-0.1f * w->hole_depth) * share * (one - keep));
  if (!any(gt(keep, zero))) return f;
  vf step = vmax(splat(0.5f) * s, splat(0.004f * size));
  vm little = le(step, splat(0.06f * size));
  int all = !any(not_(little)), none = !any(little);
  vf q0[3];
  cells_near near[3];
  if (!none) {
    cells_place(c, p, q0);
    cells_find(c, 1, 0, q0, near);
  }
  vf sum = zero, du = zero, dv = zero, inverse = splat(2.0f / HOLE_PLACES) / step * keep;
  for (int k = 0; k < HOLE_PLACES; k++) {
    vf at[3], d = zero;
    for (int i = 0; i < 3; i++)
      at[i] = p[i] + (t1[i] * splat(corner[k][0]) + t2[i] * splat(corner[k][1])) * step;
    if (!none) d = hole_depth_by(w, at, q0, near);
    if (!all) d = sel(little, d, hole_depth_at(w, at));
    sum = sum + d;
    du = du - d * splat(corner[k][0]);
    dv = dv - d * splat(corner[k][1]);
  }
  f.v = f.v - keep * splat(1.0f / HOLE_PLACES) * sum;
  for (int i = 0; i < 3; i++) f.g[i] = (du * t1[i] + dv * t2[i]) * inverse;
  return f;
}

#endif
