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

#define CELLS_APART 1.8f   /* cells: twice how far centres are apart that share a face, mostly */
#define CELLS_ROUNDED 0.2f /* cells: how wide the edges of sorted bodies are rounded */
#define CELLS_REACH 0.5f   /* cells: the width of what shows through a border from behind it */

/* Whether a cell's mineral is of kind 1, or of kind 2. */
typedef struct {
  vm first, second;
} cells_kind;

INLINE cells_kind cells_kind_of(const stone_cells *c, const vi at[3]) {
  vf rich, u = cells_rank(c, at, &rich);
  vm first = lt(u, splat(c->chance[0]) * rich);
  return (cells_kind){first, and_(lt(u, splat(c->chance[1]) * rich), not_(first))};
}

/* Of a cell's share what is the third kind's, which is taken out of kind 1. */
INLINE vf cells_take_third(const stone_cells *c, const vi at[3], cells_kind *kind, vf share) {
  vf rich, u = cells_rank(c, at, &rich);
  vm third = and_(kind->first, lt(u, splat(c->third) * rich));
  kind->first = and_(kind->first, not_(third));
  return sel(third, share, splat(0.0f));
}

/* Whether it is of either. */
INLINE vm cells_has_body(const stone_cells *c, const vi at[3]) {
  vf rich, u = cells_rank(c, at, &rich);
  return lt(u, splat(c->chance[1]) * rich);
}

/* How far a body's faces lie within its cell's. */
INLINE vf cells_erosion(const stone_cells *c, vu h) {
  vf u = to_float((vi)(hash_mix(h ^ splatu(0x7feb3c5du)) >> 8)) * splat(1.0f / 16777216.0f);
  return splat(c->erode) + splat(c->erode_spread) * u;
}

/* Sorted bodies' balls are what their weights are of: then the face between two cuts neither of
 * them but where both would have the place. */
INLINE vf cells_radius(const stone_cells *c, vu h) {
  if (c->sorted) return vsqrt(splat(c->radius * c->radius) - cells_weight(c, h));
  vf u = to_float((vi)(hash_mix(h ^ splatu(0x2545f491u)) >> 8)) * splat(1.0f / 16777216.0f);
  if (c->fines > 0.0f) u = u + splat(c->fines) * u * (splat(1.0f) - u);
  return splat(c->radius) * (splat(1.0f) - splat(c->radius_spread) * u);
}

/* How thick a body's rim is: each one's by chance. */
INLINE vf cells_rim(const stone_cells *c, vu h) {
  vf u = to_float((vi)(hash_mix(h ^ splatu(0x68e31da4u)) >> 8)) * splat(1.0f / 16777216.0f);
  return splat(c->rim) * (splat(0.4f) + splat(1.2f) * u);
}

/* How far the point is within the ball about a cell's centre, and how that grows. */
INLINE vf cells_ball(const stone_cells *c, const cells_near *n, vf g[3]) {
  vf r2 = dot3(n->x, n->x) + splat(1e-12f), k = inverse_root(r2);
  for (int i = 0; i < 3; i++) g[i] = n->x[i] * k;
  return cells_radius(c, n->h) - r2 * k;
}

/* The ball, smaller by `less`. */
INLINE cells_edge edge_of_ball(const stone_cells *c, const cells_near *n, vf less,
                               const cells_square *s, const cells_parts *p) {
  vf g[3], in = cells_ball(c, n, g);
  return edge_of(s, p, in - less, g, c->blur);
}

/* The flake about a cell's centre, which lies its own way: how thick it is by half, and how far
 * over its middle the square is, as an edge; d: its normal. */
INLINE cells_edge edge_of_flake(const stone_cells *c, const cells_near *n, const cells_square *s,
                                const cells_parts *p, vf *half, vf d[3]) {
  const float o = 511.5f;
  vu h = hash_mix(n->h ^ splatu(0x1b873593u));
  d[0] = splat(o) - to_float((vi)(h >> 22));
  d[1] = splat(o) - to_float((vi)((h >> 12) & splatu(1023u)));
  d[2] = splat(o) - to_float((vi)((h >> 2) & splatu(1023u)));
  vf k = inverse_root(dot3(d, d));
  for (int i = 0; i < 3; i++) d[i] = d[i] * k;
  vf u = to_float((vi)(h & splatu(1023u))) * splat(1.0f / 1023.0f);
  *half = splat(c->thick) * (splat(0.5f) + u);
  return edge_of(s, p, splat(0.0f) - dot3(n->x, d), d, c->blur);
}

/* How much of a part the flake shows, edges or not. */
INLINE vf cells_flake(const cells_edge *e, vf half, const cells_parts *p, int part) {
  vf at = vabs(cells_towards(p, part, e->in, e->u, e->v)) * e->inverse, side = splat(0.5f);
  half = half * e->inverse;
  return vmax(vmin(at + side, half) - vmax(at - side, splat(0.0f) - half), splat(0.0f));
}

/* How many of the nearest cells tell what is there: a footprint at a body's corner has two of its
 * faces. A flake's outline is mostly its own, and small footprints at its corners are few: of two
 * cells larger looks ask a third. */
INLINE int cells_asked(const stone_cells *c) { return c->shaped && c->thick >= 1.0f ? 3 : 2; }

/* What two cells' power distances differ by, and by how much it grows along each axis. */
INLINE vf cells_differ(const cells_near *a, const cells_near *b, vf g[3]) {
  for (int k = 0; k < 3; k++) g[k] = splat(2.0f) * (a->x[k] - b->x[k]);
  return b->d - a->d;
}

/* The face between two cells, `erosion` nearer to a's centre. What is taken off goes by how much
 * further the second is, by the distance from the face as if all centres were as far apart: then
 * a body is what another power diagram would make of its cell, the second nearest tells at a point
 * whether it is in, and nothing jumps where cells change that are as near. */
INLINE cells_edge edge_of_face(const stone_cells *c, const cells_near *a, const cells_near *b,
                               vf erosion, const cells_square *s, const cells_parts *p) {
  vf g[3], in = cells_differ(a, b, g);
  return edge_of(s, p, in - splat(CELLS_APART) * erosion, g, c->blur);
}

/* The lesser of a and another number, rounded off where they differ by less than CELLS_ROUNDED (the
 * polynomial smooth minimum: Quilez I., Smooth minimum, 2013), and how it grows. */
INLINE vf cells_rounded(vf a, vf g[3], vf b, const vf other[3]) {
  const float k = CELLS_ROUNDED;
  vf differ = b - a, near = vmax(splat(k) - vabs(differ), splat(0.0f));
  vf own = clamp01(splat(0.5f) + differ * splat(0.5f / k));
  for (int i = 0; i < 3; i++) g[i] = mix(other[i], g[i], own);
  return vmin(a, b) - near * near * splat(0.25f / k);
}

/* How deep within a sorted body, which is its ball, as far as its neighbours leave it that, and no
 * edge where two of its sides meet; out: how that grows. */
INLINE vf depth_of_rounded(const stone_cells *c, const cells_near near[3], int n, vf erosion,
                           vf out[3]) {
  const cells_near *a = &near[n];
  vf side[3], g[3][3], per = splat(1.0f / CELLS_APART);
  side[0] = cells_differ(a, &near[1 - n], g[0]) * per - erosion;
  side[1] = cells_differ(a, &near[2], g[1]) * per - erosion;
  side[2] = cells_ball(c, a, g[2]);
  for (int i = 0; i < 3; i++) {
    g[0][i] = g[0][i] * per;
    g[1][i] = g[1][i] * per;
  }
  vf in = cells_rounded(side[0], g[0], side[1], g[1]);
  in = cells_rounded(in, g[0], side[2], g[2]);
  for (int i = 0; i < 3; i++) out[i] = g[0][i];
  return in;
}

INLINE cells_edge edge_of_rounded(const stone_cells *c, const cells_near near[3], int n, vf erosion,
                                  vf less, const cells_square *s, const cells_parts *p) {
  vf g[3], in = depth_of_rounded(c, near, n, erosion, g);
  return edge_of(s, p, in - less, g, c->blur);
}

/* How deep within a body, from its nearest side; g: how that grows. */
INLINE vf cells_depth(const stone_cells *c, const cells_near near[3], int n, vf g[3]) {
  const cells_near *a = &near[n];
  vf erosion = cells_erosion(c, a->h), other[3], per = splat(1.0f / CELLS_APART);
  if (c->sorted) return depth_of_rounded(c, near, n, erosion, g);
  vf in = cells_differ(a, &near[1 - n], g), second = cells_differ(a, &near[2], other);
  vm nearer = lt(second, in);
  for (int k = 0; k < 3; k++) g[k] = sel(nearer, other[k], g[k]) * per;
  in = vmin(in, second) * per - erosion;
  if (c->radius >= 4.0f) return in;
  vf ball = cells_ball(c, a, other);
  nearer = lt(ball, in);
  for (int k = 0; k < 3; k++) g[k] = sel(nearer, other[k], g[k]);
  return vmin(in, ball);
}

/* Those of the cells about a point. together: see cells_find_as. three: of crystals, too. */
INLINE void cells_find(const stone_cells *c, int together, int three, const vf q[3],
                       cells_near near[3]) {
  three |= cells_asked(c) > 2;
  if (c->sorted) {
    cells_find_as(c, CELLS_SORTED, 3, together, q, near);
  } else if (c->grading > 0.0f) { /* other bodies have no weights */
    if (three)
      cells_find_as(c, 1, 3, together, q, near);
    else
      cells_find_as(c, 1, 2, together, q, near);
  } else if (three) {
    cells_find_as(c, 0, 3, together, q, near);
  } else {
    cells_find_as(c, 0, 2, together, q, near);
  }
}

/* Brightness of a body of kind 2, which is less uneven than one of kind 1. mean: of those like it.
 */
INLINE vf cells_calm(const stone_cells *c, vf mean, vf tone) {
  return mean + (tone - mean) * splat(c->calm);
}

/* Of a body's colour what is the other kind's, more or less: of each kind there are two rocks, one
 * towards the other kind and one beyond, and the mean is as it would be without. */
INLINE vf cells_mixed(const stone_cells *c, vu h) {
  vm beyond = lt(hash_signed(h + splatu(HASH_Z)), splat(0.0f));
  return sel(beyond, splat(-c->mixing), splat(c->mixing));
}

/* Shares of the kinds, mixed. mixed: see above; third: NULL where there is none, which goes towards
 * what lies between the others. */
INLINE void cells_mix_kinds(vf mixed, vf *first, vf *second, vf *third) {
  vf moved = mixed * (*first - *second);
  *first = *first - moved;
  *second = *second + moved;
  if (!third) return;
  moved = mixed * *third;
  *third = *third - moved;
  *first = *first + splat(0.5f) * moved;
  *second = *second + splat(0.5f) * moved;
}

/* How much of each part of the square has a body, `less` smaller all round: it ends at the faces to
 * both of the others. three: a flake's third cell is known, and counts as much as `third`. */
INLINE void cells_within(const stone_cells *c, const cells_near near[3], int n, vf less,
                         const cells_square *s, const cells_parts *p, int three, vf third,
                         vf cover[4]) {
  int all = cells_asked(c) > 2, rounded = c->radius < 4.0f;
  const cells_near *a = &near[n];
  if (c->sorted) {
    cells_edge edge = edge_of_rounded(c, near, n, cells_erosion(c, a->h), less, s, p);
    for (int i = 0; i < p->count; i++) cover[i] = edge_cover(&edge, p, i);
    return;
  }
  vf erosion = cells_erosion(c, a->h) + less;
  cells_edge face = edge_of_face(c, a, &near[1 - n], erosion, s, p), other = face, ball = face;
  if (all || three) other = edge_of_face(c, a, &near[2], erosion, s, p);
  if (rounded) ball = edge_of_ball(c, a, less, s, p);
  for (int i = 0; i < p->count; i++) {
    cover[i] = edge_cover(&face, p, i);
    if (all)
      cover[i] = edges_both(cover[i], edge_cover(&other, p, i));
    else if (three)
      cover[i] = mix(cover[i], edges_both(cover[i], edge_cover(&other, p, i)), third);
    if (rounded) cover[i] = vmin(cover[i], edge_cover(&ball, p, i));
  }
}

/* How much of a square the bodies of its nearest two cells have; core: and of it what is not
 * rim. A flake is thin: mostly it is elsewhere, and then its outline is nobody's. */
INLINE void cells_bodies(const stone_cells *c, const cells_near near[3], const vm body[2],
                         const cells_square *s, const cells_parts *p, int three, vf third,
                         vf share[2], vf core[2]) {
  vf zero = splat(0.0f), one = splat(1.0f);
  int flat = c->thick < 1.0f;
  for (int n = 0; n < 2; n++) {
    const cells_near *a = &near[n];
    vf flake[4] = {one, one, one, one}, cover[4], half, some = one, normal[3];
    share[n] = core[n] = zero;
    if (!any(body[n])) continue;
    if (flat) {
      cells_edge slab = edge_of_flake(c, a, s, p, &half, normal);
      some = zero;
      for (int i = 0; i < p->count; i++) {
        flake[i] = cells_flake(&slab, half, p, i);
        some = vmax(some, flake[i]);
      }
    }
    if (!any(and_(body[n], gt(some, zero)))) continue;
    cells_within(c, near, n, zero, s, p, three, third, cover);
    for (int i = 0; i < p->count; i++) cover[i] = cover[i] * flake[i];
    share[n] = core[n] = cells_mean(p, cover);
    if (c->rim <= 0.0f) continue;
    cells_within(c, near, n, cells_rim(c, a->h), s, p, three, third, cover);
    core[n] = vmin(cells_mean(p, cover), share[n]);
  }
}

/* Of a crystal, at its border to another, how much shows of what lies behind: the first's share. */
INLINE vf cells_behind(const cells_square *s, const cells_near *a, const cells_near *b) {
  const cells_parts whole = cells_whole();
  vf g[3], in = cells_differ(a, b, g);
  cells_edge far = edge_of(s, &whole, in, g, CELLS_REACH);
  return edge_cover(&far, &whole, 0);
}

/* Of crystals, three of which may meet in the square. */
INLINE void cells_crystals(const stone_cells *c, const cells_near near[3], const cells_square *s,
                           const cells_parts *p, int three, vf third, vf share[3]) {
  const cells_near *a = &near[0], *b = &near[1];
  vf one = splat(1.0f), none = splat(0.0f), cover[3][4];
  cells_edge side[3];
  side[0] = edge_of_face(c, a, b, none, s, p);
  for (int i = 0; i < p->count; i++) cover[0][i] = edge_cover(&side[0], p, i);
  share[0] = cells_mean(p, cover[0]);
  share[1] = one - share[0];
  share[2] = none;
  if (three) {
    side[1] = edge_of_face(c, b, &near[2], none, s, p);
    side[2] = edge_of_face(c, &near[2], a, none, s, p);
    for (int i = 0; i < p->count; i++) {
      vf in[3], own[3], sum = splat(1e-6f);
      for (int n = 0; n < 3; n++) in[n] = edge_cover(&side[n], p, i);
      for (int n = 0; n < 3; n++) {
        own[n] = edges_both(in[n], one - in[(n + 2) % 3]);
        sum = sum + own[n];
      }
      vf each = one / sum;
      for (int n = 0; n < 3; n++) cover[n][i] = own[n] * each;
    }
    for (int n = 0; n < 3; n++) share[n] = mix(share[n], cells_mean(p, cover[n]), third);
  }
  if (c->depth > 0.0f) {
    /* light that has gone on behind the border to the second nearest, which of a square's parts
     * are one and the other */
    vf back = cells_behind(s, a, b), depth = splat(c->depth), behind[3] = {back, one - back, none};
    if (three) {
      vf nearer = clamp01(splat(0.5f) + side[1].in * side[1].inverse * p->side);
      vf beyond = third * (one - nearer), other = cells_behind(s, a, &near[2]);
      behind[0] = mix(back, other, beyond); /* to the bit what it is of two where there is none */
      behind[1] = (one - beyond) * (one - back);
      behind[2] = vmax(one - behind[0] - behind[1], none);
    }
    for (int n = 0; n < 3; n++) share[n] = mix(share[n], behind[n], depth);
  }
}

/* A square no larger than about a cell: of the nearest cells, how much each has of it;
 * where cells have bodies, of those alone that are `body`, and what is not rim. third: how
 * much the third cell counts, of crystals and flakes, three: whether it does to any. */
INLINE void cells_shares(const stone_cells *c, const cells_near near[3], const vm body[2],
                         const cells_square *s, const cells_parts *p, int three, vf third,
                         vf share[3], vf core[3]) {
  share[2] = core[2] = splat(0.0f);
  if (c->shaped) {
    cells_bodies(c, near, body, s, p, three, third, share, core);
    return;
  }
  cells_crystals(c, near, s, p, three, third, share);
  for (int n = 0; n < 3; n++) core[n] = share[n];
}

#endif
