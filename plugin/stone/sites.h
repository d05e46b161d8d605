/* SPDX-License-Identifier: Apache-2.0
 *
 * Four looks side by side, of one search: the cells nearest to their middle are kept, and
 * each look asks those alone.
 *
 * By how much two cells' power distances from a point differ is linear in the point. So a
 * number for the middle and how it changes is all that a look needs of a cell, and a quarter
 * of a look one addition; and what a cell is, its mineral and its tone, is asked once.
 */
#ifndef SOZAI_STONE_SITES_H
#define SOZAI_STONE_SITES_H

#include "bodies.h"
#include "crystals.h"

#define SITES 7        /* cells that are kept: a wide four's last has some of it */
#define SITES_BODIES 4 /* the same of bodies, which end before their cells do */
#define SITES_LOOKS 4  /* 2 x 2 */

/* Cells, from the nearest. aslant, lean: what a number changes by from a look's middle to
 * two of its quarters'; to the other two's the reverse. */
typedef struct {
  vu h[SITES];
  vi at[SITES][3];
  vf far[SITES];  /* power distance from the middle of all, */
  vf x[SITES][3]; /* and what it changes by */
  vf aslant[SITES][2];
  /* of bodies: whether any lane has one that reaches into a look; the flake's normal, how far
   * the middle is over its own, one over a quarter's extent, half its thickness times that;
   * what is taken off at the face; and the ball's square, and what makes a
   * distance of its differences */
  int some[SITES_BODIES];
  cells_kind kind[SITES_BODIES];
  vf flake[SITES_BODIES][3], slab[SITES_BODIES], lean[SITES_BODIES][2], per[SITES_BODIES];
  vf thick[SITES_BODIES], gap[SITES_BODIES], ball[SITES_BODIES], per_ball[SITES_BODIES];
} cells_sites;

INLINE int sites_count(int shaped) { return shaped ? SITES_BODIES : SITES; }

/* All 27 are tried: among a few lanes' sixth nearest there is one of the further. */
INLINE void sites_nearest(const stone_cells *c, int graded, int most, const cells_about *a,
                          vf key[]) {
  for (int k = 0; k < most; k++) key[k] = splat(1e30f);
  CELLS_TRY_ALL(1)
}

/* The flake of a cell, as bodies.h has it. */
INLINE void sites_flake(const stone_cells *c, const cells_near *n, const cells_square *s,
                        cells_sites *o, int k) {
  const cells_parts quarter = cells_quarters();
  vf half;
  cells_edge e = edge_of_flake(c, n, s, &quarter, &half, o->flake[k]);
  o->slab[k] = e.in;
  o->lean[k][0] = e.u + e.v;
  o->lean[k][1] = e.u - e.v;
  o->per[k] = e.inverse;
  o->thick[k] = half * e.inverse;
  o->gap[k] = splat(CELLS_APART) * cells_erosion(c, n->h);
  if (c->radius < 4.0f) {
    vf r = cells_radius(c, n->h);
    o->ball[k] = r * r;
    o->per_ball[k] = splat(0.5f) / r;
  }
}

/* q: the middle, in cells, bent. s: a look. reach: how far from the middle a body is still seen. */
INLINE void sites_find(const stone_cells *c, int shaped, const vf q[3], const cells_square *s,
                       vf reach, cells_sites *o) {
  const int count = sites_count(shaped), graded = !shaped; /* bodies have no weights */
  cells_own own;
  cells_about about;
  vf key[SITES];
  cells_look_own(c, q, &own);
  cells_look_about(&own, &about);
  sites_nearest(c, graded, count, &about, key);
  const vf back = splat(-2.0f), quarter = splat(0.25f);
  for (int k = 0; k < count; k++) {
    cells_near n = cells_of_key(c, graded, &own, key[k]);
    o->h[k] = n.h;
    o->far[k] = n.d;
    memcpy(o->at[k], n.at, sizeof n.at);
    for (int i = 0; i < 3; i++) o->x[k][i] = back * n.x[i];
    vf u = dot3(o->x[k], s->u) * quarter, v = dot3(o->x[k], s->v) * quarter;
    o->aslant[k][0] = u + v;
    o->aslant[k][1] = u - v;
    if (!shaped) continue;
    vf within = splat(c->radius) + reach;
    vm near = lt(o->far[k], within * within);
    o->some[k] = any(near);
    if (!o->some[k]) continue;
    o->kind[k] = cells_kind_of(c, n.at);
    o->some[k] = any(and_(near, or_(o->kind[k].first, o->kind[k].second)));
    if (o->some[k]) sites_flake(c, &n, s, o, k);
  }
}

/* One over how wide a face is to a square: of two thirds of its extent, as a face stands to it in
 * the mean. */
INLINE vf sites_inverse(vf wide, float blur) {
  vf w = wide * wide * splat(0.67f) + splat(blur * blur);
  return inverse_root(w + splat(1e-12f));
}

/* From a look, which is o away from the middle, to the power distances. */
INLINE void sites_from(const cells_sites *s, int count, const vf o[3], vf d[SITES]) {
  for (int k = 0; k < count; k++) d[k] = s->far[k] + dot3(s->x[k], o);
}

INLINE vf sites_towards(vf x, const vf aslant[2], int part) {
  return part & 1 ? x - aslant[part >> 1] : x + aslant[part >> 1];
}

/* Those of a quarter, and the least two. */
INLINE void sites_quarter(const cells_sites *s, int count, int part, const vf from[SITES],
                          vf d[SITES], vf least[2]) {
  least[0] = least[1] = splat(1e30f);
  for (int k = 0; k < count; k++) {
    d[k] = sites_towards(from[k], s->aslant[k], part);
    cells_least(d[k], 2, least);
  }
}

/* One over how wide the border is, in what two cells' power distances differ by, between the
 * two nearest to a look's middle: as its quarters see it, and as what lies behind it shows. */
INLINE void sites_border(const stone_cells *c, const cells_sites *s, const cells_square *part,
                         const vf from[SITES], vf inverse[2]) {
  vf least[2] = {splat(1e30f), splat(1e30f)}, a[3], b[3], half = splat(0.5f);
  for (int k = 0; k < SITES; k++) cells_least(from[k], 2, least);
  for (int i = 0; i < 3; i++) a[i] = b[i] = s->x[0][i];
  for (int k = 0; k < SITES; k++) {
    vm first = le(from[k], least[0]), second = le(from[k], least[1]);
    for (int i = 0; i < 3; i++) {
      b[i] = sel(second, sel(first, b[i], s->x[k][i]), b[i]);
      a[i] = sel(first, s->x[k][i], a[i]);
    }
  }
  for (int i = 0; i < 3; i++) a[i] = a[i] - b[i];
  vf u = dot3(a, part->u) * half, v = dot3(a, part->v) * half, square = u * u + v * v;
  vf all = dot3(a, a) + splat(1e-6f);
  inverse[0] = inverse_root(square + all * splat(c->blur * c->blur));
  inverse[1] = inverse_root(square + all * splat(CELLS_REACH * CELLS_REACH));
}

/* How much of a look each of the crystals has. */
INLINE void sites_crystals(const stone_cells *c, const cells_sites *s, const cells_square *part,
                           const vf o[3], vf share[SITES]) {
  vf from[SITES], inverse[2], zero = splat(0.0f), half = splat(0.5f), each = splat(0.25f);
  vf depth = splat(c->depth), sharp = splat(1.0f - c->depth);
  sites_from(s, SITES, o, from);
  sites_border(c, s, part, from, inverse);
  for (int k = 0; k < SITES; k++) share[k] = zero;
  UNROLL(4)
  for (int i = 0; i < 4; i++) {
    vf d[SITES], least[2];
    sites_quarter(s, SITES, i, from, d, least);
    vf beyond = least[1] - least[0];
    vf other = vmax(half - beyond * inverse[0], zero);
    if (c->depth > 0.0f) other = sharp * other + depth * vmax(half - beyond * inverse[1], zero);
    other = other * each;
    vf most = each - other;
    for (int k = 0; k < SITES; k++) {
      vf own = sel(le(d[k], least[0]), most, sel(le(d[k], least[1]), other, zero));
      share[k] = share[k] + own;
    }
  }
}

/* The same of flakes. Where a ball is near its surface its square tells how far. Of faces that
 * between the two cells nearest to all looks says how far apart centres are: some are close. */
INLINE void sites_flakes(const stone_cells *c, const cells_sites *s, const cells_square *part,
                         const vf o[3], vf inverse, vf share[SITES]) {
  vf from[SITES], d[4][SITES], least[4][2], square[4], zero = splat(0.0f), half = splat(0.5f);
  const int rounded = c->radius < 4.0f;
  vf apart[3];
  for (int i = 0; i < 3; i++) apart[i] = s->x[0][i] - s->x[1][i];
  vf u = dot3(apart, part->u) * half, v = dot3(apart, part->v) * half;
  vf face =
      inverse_root(u * u + v * v + dot3(apart, apart) * splat(c->blur * c->blur) + splat(1e-6f));
  sites_from(s, SITES_BODIES, o, from);
  UNROLL(4)
  for (int i = 0; i < 4; i++) {
    vf at[3], a = splat(i & 1 ? -0.25f : 0.25f), b = splat(i == 0 || i == 3 ? 0.25f : -0.25f);
    sites_quarter(s, SITES_BODIES, i, from, d[i], least[i]);
    for (int k = 0; k < 3; k++) at[k] = o[k] + part->u[k] * a + part->v[k] * b;
    square[i] = dot3(at, at);
  }
  for (int k = 0; k < SITES_BODIES; k++) {
    share[k] = zero;
    if (!s->some[k]) continue;
    vf slab = s->slab[k] + dot3(s->flake[k], o), thick = s->thick[k];
    UNROLL(4)
    for (int i = 0; i < 4; i++) {
      vf in = sel(le(d[i][k], least[i][0]), least[i][1], least[i][0]) - d[i][k] - s->gap[k];
      in = in * face;
      if (rounded) in = vmin(in, (s->ball[k] - d[i][k] - square[i]) * s->per_ball[k] * inverse);
      vf cover = clamp01(half + in);
      vf at = vabs(sites_towards(slab, s->lean[k], i)) * s->per[k];
      vf flake = vmax(vmin(at + half, thick) - vmax(at - half, zero - thick), zero);
      share[k] = share[k] + cover * flake;
    }
    share[k] = share[k] * splat(0.25f);
  }
}

#endif
