/* SPDX-License-Identifier: Apache-2.0
 *
 * Holes as depth: a bowl in every body of that layer that is open at the face.
 */
#ifndef SOZAI_STONE_HOLES_H
#define SOZAI_STONE_HOLES_H

#include "field.h"
#include "footprint.h"

#define HOLE_PLACES 3 /* about the point, at the corners of a triangle */
static const float hole_corner[HOLE_PLACES][2] = {
    {1.0f, 0.0f}, {-0.5f, 0.8660254f}, {-0.5f, -0.8660254f}};

/* The face to another cell, less what the body is smaller by: how far within it the point is, in
 * cells, and how that grows. */
typedef struct {
  vf in, g[3];
} hole_side;

INLINE hole_side hole_side_of(const cells_near *a, const cells_near *b, vf erosion) {
  hole_side f;
  for (int k = 0; k < 3; k++) f.g[k] = a->x[k] - b->x[k];
  vf inverse = inverse_root(dot3(f.g, f.g) + splat(1e-12f));
  f.in = splat(0.5f) * (b->d - a->d) * inverse - erosion;
  for (int k = 0; k < 3; k++) f.g[k] = f.g[k] * inverse;
  return f;
}

/* How deep the body of cell a is below the face at places about the point, b and c the others that
 * tell its outline, as they tell the colour's: mm, 0 or more. by: cells, to each place. */
INLINE void hole_depth_of(const stone_constants *w, const cells_near *a, const cells_near *b,
                          const cells_near *c, vm open, int places, const vf by[][3], vf depth[]) {
  const stone_cells *l = &w->layer[LAYER_HOLES];
  vf zero = splat(0.0f), one = splat(1.0f), erosion = cells_erosion(l, a->h), radius = zero;
  int ball = l->radius < 4.0f;
  hole_side side[2] = {hole_side_of(a, b, erosion), hole_side_of(a, c, erosion)};
  if (ball) radius = cells_radius(l, a->h);
  for (int n = 0; n < places; n++) {
    vf x[3], in = vmin(side[0].in + dot3(by[n], side[0].g), side[1].in + dot3(by[n], side[1].g));
    for (int k = 0; k < 3; k++) x[k] = a->x[k] - by[n][k];
    if (ball) in = vmin(in, radius - cells_length(x));
    in = vmax(in, zero);
    /* steep at the rim, flat at the bottom */
    vf d = splat(2.0f * w->hole_depth) * in / (one + splat(4.0f) * in);
    depth[n] = depth[n] + sel(open, d, zero);
  }
}

INLINE vm hole_is_open(const stone_cells *c, const vi at[3]) {
  vf rich, rank = cells_rank(c, at, &rich);
  return lt(rank, splat(c->chance[1]) * rich);
}

/* Anywhere, under a footprint that leaves `fine` of the faces' finer bends. */
STAGE vf hole_depth_at(const stone_constants *w, vf fine, const vf p[3]) {
  const stone_cells *c = &w->layer[LAYER_HOLES];
  const vf none[1][3] = {{splat(0.0f), splat(0.0f), splat(0.0f)}};
  vf q[3], depth = splat(0.0f);
  cells_place(c, fine, p, q);
  cells_near near[3];
  cells_find(c, 1, 0, q, near);
  vm open = hole_is_open(c, near[0].at);
  if (any(open)) hole_depth_of(w, &near[0], &near[1], &near[2], open, 1, none, &depth);
  return depth;
}

/* The cells at the point, and of the nearer two whether they are holes: what the colour's look
 * has found where it has had but one. */
STAGE void hole_find(const stone_cells *c, const vf p[3], cells_found *f) {
  vf q[3];
  cells_place(c, f->fine, p, q);
  cells_find(c, 1, 0, q, f->near);
  for (int n = 0; n < 2; n++) f->body[n] = hole_is_open(c, f->near[n].at);
}

/* The depths at the places about a point whose nearest cells are known. One is within the nearest
 * or the next: between them lie the walls of stone that a further cell would be beyond. The
 * bends are taken as even so near by. */
STAGE void hole_depths_by(const stone_constants *w, const vf p[3], const vf t1[3], const vf t2[3],
                          vf step, const cells_found *f, vf depth[HOLE_PLACES]) {
  const stone_cells *c = &w->layer[LAYER_HOLES];
  vf along[2][3], by[HOLE_PLACES][3];
  cells_slopes(c, f->fine, p, t1, t2, along);
  for (int n = 0; n < HOLE_PLACES; n++) {
    for (int k = 0; k < 3; k++) {
      by[n][k] =
          (along[0][k] * splat(hole_corner[n][0]) + along[1][k] * splat(hole_corner[n][1])) * step;
    }
  }
  for (int n = 0; n < 2; n++) {
    if (!any(f->body[n])) continue;
    vm open = f->body[n];
    if (c->radius < 4.0f) {
      /* nor deeper than the look might have seen it: bodies_absent.h */
      vf reach = cells_radius(c, f->near[n].h) + f->wide + splat(0.5f * c->blur);
      open = and_(open, lt(dot3(f->near[n].x, f->near[n].x), reach * reach));
      if (!any(open)) continue;
    }
    hole_depth_of(w, &f->near[n], &f->near[1 - n], &f->near[2], open, HOLE_PLACES, by, depth);
  }
}

/* The same as height; slopes are differences over a step within the surface, which see a rim as
 * wide as the footprint. t1, t2: bed space. */
STAGE field hole_relief(const stone_constants *w, const vf p[3], const vf t1[3], const vf t2[3],
                        vf s, vf share, cells_found *found, vf *lost) {
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
  vf depth[HOLE_PLACES] = {zero, zero, zero};
  if (!found->bent) {
    cells_view view;
    view_open(c, t1, t2, s, &view);
    found->fine = view.fine;
    found->wide = view.most;
  }
  if (any(little)) {
    if (!found->met) hole_find(c, p, found);
    if (any(and_(little, or_(found->body[0], found->body[1]))))
      hole_depths_by(w, p, t1, t2, step, found, depth);
  }
  int wide = any(not_(little));
  vf sum = zero, du = zero, dv = zero, inverse = splat(2.0f / HOLE_PLACES) / step * keep;
  for (int n = 0; n < HOLE_PLACES; n++) {
    if (wide) {
      vf at[3];
      for (int k = 0; k < 3; k++)
        at[k] = p[k] + (t1[k] * splat(hole_corner[n][0]) + t2[k] * splat(hole_corner[n][1])) * step;
      depth[n] = sel(little, depth[n], hole_depth_at(w, found->fine, at));
    }
    sum = sum + depth[n];
    du = du - depth[n] * splat(hole_corner[n][0]);
    dv = dv - depth[n] * splat(hole_corner[n][1]);
  }
  f.v = f.v - keep * splat(1.0f / HOLE_PLACES) * sum;
  for (int k = 0; k < 3; k++) f.g[k] = (du * t1[k] + dv * t2[k]) * inverse;
  return f;
}

#endif
