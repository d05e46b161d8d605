/* SPDX-License-Identifier: Apache-2.0
 *
 * What lies in a cell: a crystal that fills it, or a body that is smaller; and how
 * much of a footprint shows it.
 */
#ifndef SOZAI_STONE_BODIES_H
#define SOZAI_STONE_BODIES_H

#include "../core/filter.h"
#include "cells.h"
#include "square.h"

#define CELLS_APART 1.8f /* cells: twice how far centres are apart that share a face */
#define CELLS_REACH 0.5f /* cells: the width of what shows through a border from behind it */

/* Whether a cell's mineral is of kind 1, or of kind 2. */
typedef struct {
  vm first, second;
} cells_kind;

INLINE cells_kind cells_kind_of(const stone_cells *c, const vi at[3]) {
  vf rich, u = cells_rank(c, at, &rich);
  vm first = lt(u, splat(c->chance[0]) * rich);
  return (cells_kind){first, and_(lt(u, splat(c->chance[1]) * rich), not_(first))};
}

/* How far a body's faces lie within its cell's. */
INLINE vf cells_erosion(const stone_cells *c, vu h) {
  vf u = to_float((vi)(hash_mix(h ^ splatu(0x7feb3c5du)) >> 8)) * splat(1.0f / 16777216.0f);
  return splat(c->erode) + splat(c->erode_spread) * u;
}

INLINE vf cells_radius(const stone_cells *c, vu h) {
  vf u = to_float((vi)(hash_mix(h ^ splatu(0x2545f491u)) >> 8)) * splat(1.0f / 16777216.0f);
  return splat(c->radius) * (splat(1.0f) - splat(c->radius_spread) * u);
}

/* How much of the ball about a cell's centre the square shows. */
INLINE vf cells_ball(const stone_cells *c, const cells_near *n, const cells_square *s) {
  vf radius = cells_radius(c, n->h);
  vf r2 = n->x[0] * n->x[0] + n->x[1] * n->x[1] + n->x[2] * n->x[2] + splat(1e-12f);
  vf k = inverse_root(r2);
  vf e = vsqrt(cells_extent2(s, n->x, c->blur)) * k;
  return clamp01(splat(0.5f) + (radius - r2 * k) / e);
}

/* How much of the flake about a cell's centre, which lies its own way, the square
 * shows. */
INLINE vf cells_flake(const stone_cells *c, const cells_near *n, const cells_square *s) {
  const float o = 511.5f;
  vu h = hash_mix(n->h ^ splatu(0x1b873593u));
  vf d[3] = {to_float((vi)(h >> 22)) - splat(o),
             to_float((vi)((h >> 12) & splatu(1023u))) - splat(o),
             to_float((vi)((h >> 2) & splatu(1023u))) - splat(o)};
  vf k = inverse_root(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  for (int i = 0; i < 3; i++) d[i] = d[i] * k;
  vf t = vabs(n->x[0] * d[0] + n->x[1] * d[1] + n->x[2] * d[2]);
  vf e = vsqrt(cells_extent2(s, d, c->blur)), side = splat(0.5f) * e;
  vf u = to_float((vi)(h & splatu(1023u))) * splat(1.0f / 1023.0f);
  vf half = splat(c->thick) * (splat(0.5f) + u);
  return vmax(vmin(t + side, half) - vmax(t - side, splat(0.0f) - half), splat(0.0f)) / e;
}

/* How many of the nearest cells tell what is there. A flake's outline is mostly its own. */
INLINE int cells_asked(const stone_cells *c) { return c->shaped && c->thick >= 1.0f ? 3 : 2; }

/* How much of the square lies on a's side of the face between two cells, which is `erosion`
 * nearer to its centre. Exact for a plane. Where the third nearest cell is not asked for, what
 * is taken off goes by how much further the second is and not by the distance from the
 * face: then nothing jumps where the second changes. */
INLINE vf cells_side(const stone_cells *c, const cells_near *a, const cells_near *b, vf erosion,
                     const cells_square *s) {
  vf g[3];
  for (int k = 0; k < 3; k++) g[k] = splat(2.0f) * (a->x[k] - b->x[k]);
  vf length = splat(CELLS_APART);
  if (cells_asked(c) > 2) length = vsqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2] + splat(1e-12f));
  vf e = inverse_root(cells_extent2(s, g, c->blur));
  return clamp01(splat(0.5f) + (b->d - a->d - length * erosion) * e);
}

/* Those of the cells about a point. together: see cells_find_as. */
INLINE void cells_find(const stone_cells *c, int together, const vf q[3], cells_near near[3]) {
  if (cells_asked(c) > 2)
    cells_find_as(c, 0, 3, together, q, near); /* bodies have no weights */
  else if (c->grading > 0.0f)
    cells_find_as(c, 1, 2, together, q, near);
  else
    cells_find_as(c, 0, 2, together, q, near);
}

/* How much of a square the bodies of its nearest two cells have. One ends at the faces to
 * both of the others: the nearest face need not be that to the nearest cell, and without
 * the third outlines would jump where the second changes. Of two edges through the square
 * that know nothing of each other the product is left, of two along each other the lesser;
 * faces of a crystal are between. A flake is thin: mostly it is
 * elsewhere, and then its outline is nobody's. */
INLINE void cells_bodies(const stone_cells *c, const cells_near near[3], const vm body[2],
                         const cells_square *s, vf share[2]) {
  vf zero = splat(0.0f);
  for (int n = 0; n < 2; n++) {
    const cells_near *a = &near[n];
    vf flake = splat(1.0f);
    if (c->thick < 1.0f) flake = cells_flake(c, a, s);
    share[n] = zero;
    if (!any(and_(body[n], gt(flake, zero)))) continue;
    vf erosion = cells_erosion(c, a->h);
    share[n] = cells_side(c, a, &near[1 - n], erosion, s);
    if (cells_asked(c) > 2) {
      vf third = cells_side(c, a, &near[2], erosion, s);
      share[n] = splat(0.5f) * (vmin(share[n], third) + share[n] * third);
    }
    if (c->radius < 4.0f) share[n] = vmin(share[n], cells_ball(c, a, s));
    share[n] = share[n] * flake;
  }
}

/* A square no larger than about a cell: of the nearest two cells, how much each
 * has of it; where cells have bodies, of those alone that are `body`. Exact for a plane
 * between two. */
INLINE void cells_shares(const stone_cells *c, const cells_near near[3], const vm body[2],
                         const cells_square *s, vf share[2]) {
  if (c->shaped) {
    cells_bodies(c, near, body, s, share);
    return;
  }
  const cells_near *a = &near[0], *b = &near[1];
  vf g[3];
  for (int k = 0; k < 3; k++) g[k] = splat(2.0f) * (a->x[k] - b->x[k]);
  share[0] = clamp01(splat(0.5f) + (b->d - a->d) * inverse_root(cells_extent2(s, g, c->blur)));
  if (c->depth > 0.0f) {
    /* light that has gone on behind the border */
    vf far = inverse_root(cells_extent2(s, g, CELLS_REACH));
    share[0] = mix(share[0], clamp01(splat(0.5f) + (b->d - a->d) * far), splat(c->depth));
  }
  share[1] = splat(1.0f) - share[0];
}

#endif
