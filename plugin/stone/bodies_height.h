/* SPDX-License-Identifier: Apache-2.0
 *
 * Bodies as height: a bowl in every hole that is open at the face, a dome on every inclusion
 * that stands out of it or has weathered back.
 */
#ifndef SOZAI_STONE_BODIES_HEIGHT_H
#define SOZAI_STONE_BODIES_HEIGHT_H

#include "field.h"
#include "footprint.h"

#define HEIGHT_PLACES 3 /* about the point, at the corners of a triangle */
static const float height_corner[HEIGHT_PLACES][2] = {
    {1.0f, 0.0f}, {-0.5f, 0.8660254f}, {-0.5f, -0.8660254f}};

/* What bodies of a layer are as height. A bowl's is its depth, in mm to a cell, steep at the rim
 * and flat at the bottom. A dome's is a number from 0 at the rim to 1. */
typedef struct {
  const stone_cells *cells;
  int dome;
  float deep;  /* of a bowl */
  float mean;  /* of all of the bodies' area; of a bowl below 0 */
  float steep; /* sd of slope along one axis there */
} height_form;

#define DOME_RIM 0.25f   /* cells: from a dome's rim to its top */
#define DOME_EDGE 0.12f  /* cells: how far its edges are rounded */
#define DOME_SMOOTH 0.8f /* of the finish's relief that its top has lost */

/* The face to another cell, less what the body is smaller by: how far within it the point is, in
 * cells, as bodies.h has it, and how that grows. */
typedef struct {
  vf in, g[3];
} height_side;

INLINE height_side height_side_of(const cells_near *a, const cells_near *b, vf erosion) {
  height_side f;
  for (int k = 0; k < 3; k++) f.g[k] = a->x[k] - b->x[k];
  const vf inverse = splat(2.0f / CELLS_APART);
  f.in = splat(0.5f) * (b->d - a->d) * inverse - erosion;
  for (int k = 0; k < 3; k++) f.g[k] = f.g[k] * inverse;
  return f;
}

/* How far within a ball's surface; of a dome, whose top is no point, by the ball's square. */
INLINE vf height_ball(const height_form *f, vf radius, const vf x[3]) {
  if (!f->dome) return radius - cells_length(x);
  return (radius * radius - dot3(x, x)) * (splat(0.5f) / radius);
}

/* The lesser of two; of a dome without an edge where they are alike. */
INLINE vf height_lesser(const height_form *f, vf a, vf b) {
  vf least = vmin(a, b);
  if (!f->dome) return least;
  const float edge = f->cells->sorted ? CELLS_ROUNDED : DOME_EDGE; /* as the colour's are */
  vf near = vmax(splat(edge) - vabs(a - b), splat(0.0f));
  return least - near * near * splat(0.25f / edge);
}

INLINE vf height_profile(const height_form *f, vf in) {
  if (f->dome) {
    vf t = vmin(in * splat(1.0f / DOME_RIM), splat(1.0f));
    return t * (splat(2.0f) - t);
  }
  return splat(2.0f * f->deep) * in / (splat(1.0f) + splat(4.0f) * in);
}

/* Of the body of cell a at places about the point, b and c the others that tell its outline, as
 * they tell the colour's: 0 or more. by: cells, to each place. */
INLINE void height_of(const height_form *f, const cells_near *a, const cells_near *b,
                      const cells_near *c, vm there, int places, const vf by[][3], vf out[]) {
  const stone_cells *l = f->cells;
  vf zero = splat(0.0f), erosion = cells_erosion(l, a->h), radius = zero;
  int ball = l->radius < 4.0f;
  height_side side[2] = {height_side_of(a, b, erosion), height_side_of(a, c, erosion)};
  if (ball) radius = cells_radius(l, a->h);
  for (int n = 0; n < places; n++) {
    vf x[3], in = height_lesser(f, side[0].in + dot3(by[n], side[0].g),
                                side[1].in + dot3(by[n], side[1].g));
    for (int k = 0; k < 3; k++) x[k] = a->x[k] - by[n][k];
    if (ball) in = height_lesser(f, in, height_ball(f, radius, x));
    out[n] = out[n] + sel(there, height_profile(f, vmax(in, zero)), zero);
  }
}

/* Anywhere, under a footprint that leaves `fine` of the faces' finer bends. */
STAGE vf height_at(const height_form *f, vf fine, const vf p[3]) {
  const stone_cells *c = f->cells;
  const vf none[1][3] = {{splat(0.0f), splat(0.0f), splat(0.0f)}};
  vf q[3], height = splat(0.0f);
  cells_place(c, fine, p, q);
  cells_near near[3];
  cells_find(c, 1, 0, q, near);
  vm there = cells_has_body(c, near[0].at);
  if (any(there)) height_of(f, &near[0], &near[1], &near[2], there, 1, none, &height);
  return height;
}

/* The cells at the point, and of the nearer two whether they are bodies: what the colour's look
 * has found where it has had but one. */
STAGE void height_find(const stone_cells *c, const vf p[3], cells_found *f) {
  vf q[3];
  cells_place(c, f->fine, p, q);
  cells_find(c, 1, 0, q, f->near);
  for (int n = 0; n < 2; n++) f->body[n] = cells_has_body(c, f->near[n].at);
}

/* At the places about a point whose nearest cells are known. One is within the nearest or the
 * next: between them lie the walls of stone that a further cell would be beyond. The bends are
 * taken as even so near by. */
STAGE void heights_by(const height_form *form, const vf p[3], const vf t1[3], const vf t2[3],
                      vf step, const cells_found *f, vf out[HEIGHT_PLACES]) {
  const stone_cells *c = form->cells;
  vf along[2][3], by[HEIGHT_PLACES][3];
  cells_slopes(c, f->fine, p, t1, t2, along);
  for (int n = 0; n < HEIGHT_PLACES; n++) {
    for (int k = 0; k < 3; k++) {
      by[n][k] =
          (along[0][k] * splat(height_corner[n][0]) + along[1][k] * splat(height_corner[n][1])) *
          step;
    }
  }
  for (int n = 0; n < 2; n++) {
    if (!any(f->body[n])) continue;
    vm there = f->body[n];
    if (c->radius < 4.0f) {
      /* nor further than the look might have seen it: bodies_absent.h */
      vf reach = cells_radius(c, f->near[n].h) + f->wide + splat(0.5f * c->blur);
      there = and_(there, lt(dot3(f->near[n].x, f->near[n].x), reach * reach));
      if (!any(there)) continue;
    }
    height_of(form, &f->near[n], &f->near[1 - n], &f->near[2], there, HEIGHT_PLACES, by, out);
  }
}

/* What of the bodies' slopes a footprint sees. */
INLINE vf bodies_kept(float size, vf s) {
  return splat(1.0f) - smooth_step(splat(0.3f * size), splat(1.2f * size), s);
}

/* The variance along one axis of those that it averages out. share: of the footprint that is body.
 */
INLINE vf bodies_lost(float steep, vf keep, vf share) {
  return splat(steep * steep) * share * (splat(1.0f) - keep * keep);
}

/* Height, a dome's from 0 to 1; slopes are differences over a step within the surface, which see a
 * rim as wide as the footprint. t1, t2: bed space. share: of the footprint that is body. lost: is
 * added the variance of slope along one axis that the footprint averages out. */
STAGE field bodies_height(const height_form *form, const vf p[3], const vf t1[3], const vf t2[3],
                          vf s, vf share, cells_found *found, vf *lost) {
  const stone_cells *c = form->cells;
  vf zero = splat(0.0f), one = splat(1.0f);
  float size = c->size, way = form->dome ? 1.0f : -1.0f;
  vf keep = bodies_kept(size, s);
  *lost = *lost + bodies_lost(form->steep, keep, share);
  field f = field_of(splat(form->mean) * share * (one - keep));
  if (!any(gt(keep, zero))) return f;
  vf step = vmax(splat(0.5f) * s, splat(0.003f * size));
  vm little = le(step, splat(0.06f * size));
  vf height[HEIGHT_PLACES] = {zero, zero, zero};
  if (!found->bent) {
    cells_view view;
    view_open(c, t1, t2, s, &view);
    found->fine = view.fine;
    found->wide = view.most;
  }
  if (any(little)) {
    if (!found->met) height_find(c, p, found);
    if (any(and_(little, or_(found->body[0], found->body[1]))))
      heights_by(form, p, t1, t2, step, found, height);
  }
  int wide = any(not_(little));
  vf sum = zero, du = zero, dv = zero, inverse = splat(2.0f * way / HEIGHT_PLACES) / step * keep;
  for (int n = 0; n < HEIGHT_PLACES; n++) {
    if (wide) {
      vf at[3];
      for (int k = 0; k < 3; k++)
        at[k] =
            p[k] + (t1[k] * splat(height_corner[n][0]) + t2[k] * splat(height_corner[n][1])) * step;
      height[n] = sel(little, height[n], height_at(form, found->fine, at));
    }
    sum = sum + height[n];
    du = du + height[n] * splat(height_corner[n][0]);
    dv = dv + height[n] * splat(height_corner[n][1]);
  }
  f.v = f.v + keep * splat(way / HEIGHT_PLACES) * sum;
  for (int k = 0; k < 3; k++) f.g[k] = (du * t1[k] + dv * t2[k]) * inverse;
  return f;
}

#endif
