/* SPDX-License-Identifier: Apache-2.0
 *
 * A layer of cells under a footprint of many: the cells that the face cuts, counted.
 *
 * A plane cuts a power diagram in a power diagram, whose sites are the centres laid down on
 * it and whose weights are the cells' own and the square of the centres' heights over it.
 * So a cell is seen in a patch about its centre, larger for less of both: each lattice
 * column that the footprint meets gives its two cells nearest to the face. No cell is
 * searched for, and none is missed, as between looks that stand further apart than
 * cells do.
 */
#ifndef SOZAI_STONE_SECTIONS_H
#define SOZAI_STONE_SECTIONS_H

#include "../core/vectors.h"
#include "bodies.h"

#define SECTIONS_MOST 32      /* columns along a side, of footprints of up to 17 cells */
#define SECTIONS_WIDE 0.9f    /* cells: across a patch */
#define SECTIONS_CRYSTAL 0.5f /* cells^2: power distance from the face of what it does not cut */
#define SECTIONS_BODY 0.65f   /* cells: radius of a body, before it is eroded */

/* Which way the columns stand: along the axis nearest to the normal. */
typedef struct {
  vm first, second;
} sections_axis;

/* The axis' own part of x to the front, the next two behind. */
INLINE void sections_turn(const sections_axis *a, const vf x[3], vf out[3]) {
  for (int k = 0; k < 3; k++)
    out[k] = sel(a->first, x[k], sel(a->second, x[(k + 1) % 3], x[(k + 2) % 3]));
}
INLINE void sections_turn_back(const sections_axis *a, const vi x[3], vi out[3]) {
  for (int k = 0; k < 3; k++)
    out[k] = seli(a->first, x[k], seli(a->second, x[(k + 2) % 3], x[(k + 1) % 3]));
}

/* A footprint, as columns see it. Lengths in cells. */
typedef struct {
  vf q[3];                 /* its middle */
  vf up[3];                /* unit normal */
  vf along[2][3], wide[2]; /* to places in it, -1/2 to 1/2; across it */
} sections_face;

/* How much of a cell's patch lies within, along one side. */
INLINE vf sections_within(vf at, vf wide) {
  return clamp01(splat(0.5f) + (splat(0.5f) - vabs(at)) * wide * splat(1.0f / SECTIONS_WIDE));
}

/* The cell at a place of the lattice: how much of the footprint its patch takes, in no
 * unit; its hash. */
INLINE vf sections_patch(const stone_cells *c, const sections_face *f, const vi at[3], vu *hash) {
  vf x[3], mid[3];
  for (int k = 0; k < 3; k++) mid[k] = to_float(at[k]) + splat(0.5f) - f->q[k];
  vu h = hash_upper((vu)at[0] * splatu(HASH_X) + (vu)at[1] * splatu(HASH_Y) +
                    (vu)at[2] * splatu(HASH_Z) + splatu(c->seed));
  cells_centre(c, h, mid[0], mid[1], mid[2], x);
  vf height = dot3(x, f->up), reach = splat(SECTIONS_CRYSTAL + 0.5f * c->grading);
  if (c->grading > 0.0f) reach = reach - cells_weight(c, h);
  if (c->shaped) {
    vf r = splat(SECTIONS_BODY) - cells_erosion(c, h);
    if (c->radius < 4.0f) r = vmin(r, cells_radius(c, h));
    r = vmax(r, splat(0.0f));
    reach = r * r;
  }
  vf patch = vmax(reach - height * height, splat(0.0f));
  for (int k = 0; k < 2; k++) patch = patch * sections_within(dot3(x, f->along[k]), f->wide[k]);
  *hash = h;
  return patch;
}

typedef struct {
  vi at[3];
  vu h;
  vf patch;
  cells_kind kind;
} sections_cell;

/* Of patches: all of them; as of cells_cover; of bodies those of kinds 1 and 2; and a third kind's.
 */
typedef struct {
  vf of[3], count[2], all, third;
} sections_sum;

INLINE void sections_add(const stone_cells *c, const sections_cell *o, sections_sum *sum) {
  const vf zero = splat(0.0f);
  const cells_kind *kind = &o->kind;
  cells_kind own = *kind;
  vf patch = o->patch, third = zero;
  sum->all = sum->all + patch;
  vf tone = patch + patch * splat(c->variation / HASH_ONE) * hash_signed(o->h + splatu(HASH_Y));
  vf calm = c->shaped ? cells_calm(c, patch, tone) : tone;
  vm other = not_(or_(kind->first, kind->second));
  if (c->shaped) {
    sum->count[0] = sum->count[0] + sel(kind->first, patch, zero);
    sum->count[1] = sum->count[1] + sel(kind->second, patch, zero);
  }
  if (c->third > 0.0f) third = cells_take_third(c, o->at, &own, tone);
  vf first = sel(own.first, tone, zero), second = sel(kind->second, calm, zero);
  if (c->shaped && c->mixing > 0.0f)
    cells_mix_kinds(cells_mixed(c, o->h), &first, &second, c->third > 0.0f ? &third : NULL);
  sum->of[0] = sum->of[0] + sel(other, tone, zero);
  sum->of[1] = sum->of[1] + first;
  sum->of[2] = sum->of[2] + second;
  sum->third = sum->third + third;
}

INLINE sections_axis sections_open(const stone_cells *c, const vf p[3], const cells_square *s,
                                   sections_face *f) {
  vf n[3], dual[3];
  cells_turn(c, p, f->q);
  cross3(s->u, s->v, n);
  vf k = inverse_root(dot3(n, n) + splat(1e-20f));
  for (int i = 0; i < 3; i++) f->up[i] = n[i] * k;
  for (int side = 0; side < 2; side++) {
    cross3(side ? f->up : s->v, side ? s->u : f->up, dual);
    vf own = splat(1.0f) / dot3(dual, side ? s->v : s->u);
    for (int i = 0; i < 3; i++) f->along[side][i] = dual[i] * own;
    f->wide[side] = inverse_root(dot3(f->along[side], f->along[side]));
  }
  vf x = vabs(n[0]), y = vabs(n[1]), z = vabs(n[2]);
  sections_axis a;
  a.first = and_(le(y, x), le(z, x));
  a.second = and_(not_(a.first), le(z, y));
  return a;
}

/* What is cut, as of cells_cover, and of a third kind. there: lanes that ask. */
STAGE void sections_count(const stone_cells *c, const vf p[3], const cells_square *s, vm there,
                          vf out[3], vf *third) {
  sections_face f;
  vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f);
  sections_axis axis = sections_open(c, p, s, &f);
  vf q[3], up[3], u[3], v[3];
  sections_sum sum = {{zero, zero, zero}, {zero, zero}, zero, zero};
  sections_turn(&axis, f.q, q);
  sections_turn(&axis, f.up, up);
  sections_turn(&axis, s->u, u);
  sections_turn(&axis, s->v, v);
  vi from[3], at[3];
  vf many[3], lean[3], reach[3];
  for (int k = 1; k < 3; k++) {
    reach[k] = half * (vabs(u[k]) + vabs(v[k])) + half;
    lean[k] = up[k] / up[0];
  }
  (void)vfloor(q[2] - reach[2], &from[2]);
  many[2] = reach[2] + reach[2] + one;
  /* a row's way through the footprint: between the sides */
  vf cross = u[1] * v[2] - u[2] * v[1], steep[2], far[2];
  for (int k = 0; k < 2; k++) {
    const vf *side = k ? u : v;
    vf over = sel(lt(vabs(side[2]), splat(1e-3f)), splat(1e-3f), side[2]);
    steep[k] = side[1] / over;
    far[k] = half * vabs(cross / over) + one + vabs(steep[k]);
  }
  for (int j = 0; j < SECTIONS_MOST; j++) {
    vm row = and_(there, lt(splat((float)j), many[2]));
    if (!any(row)) break;
    at[2] = from[2] + splati(j);
    vf y = to_float(at[2]) + half - q[2];
    vf low = zero - reach[1], high = reach[1];
    for (int k = 0; k < 2; k++) {
      low = vmax(low, steep[k] * y - far[k]);
      high = vmin(high, steep[k] * y + far[k]);
    }
    (void)vfloor(q[1] + low, &from[1]);
    many[1] = high - low + one;
    for (int i = 0; i < SECTIONS_MOST; i++) {
      vm column = and_(row, lt(splat((float)i), many[1]));
      if (!any(column)) break;
      at[1] = from[1] + splati(i);
      vf x = to_float(at[1]) + half - q[1];
      (void)vfloor(q[0] - x * lean[1] - y * lean[2] - half, &at[0]);
      /* both side by side, step by step: each is one long wait */
      sections_cell cell[2];
      for (int n = 0; n < 2; n++) {
        sections_turn_back(&axis, at, cell[n].at);
        at[0] = at[0] + splati(1);
        cell[n].patch = sel(column, sections_patch(c, &f, cell[n].at, &cell[n].h), zero);
      }
      for (int n = 0; n < 2; n++) {
        cells_first(c, cell[n].at);
        cell[n].h = cells_crystal(c, cell[n].at, cell[n].h);
        cell[n].kind = cells_kind_of(c, cell[n].at);
      }
      for (int n = 0; n < 2; n++) sections_add(c, &cell[n], &sum);
    }
  }
  vf each = one / vmax(sum.all, splat(1e-6f));
  if (c->shaped) {
    /* of the cells that have a body, all the same part is body */
    float bodies = c->mean[0] + c->mean[1] + c->third_mean;
    each = each * splat(c->chance[1] > 0.0f ? bodies / c->chance[1] : 0.0f);
    sum.of[0] = sum.count[0] + sum.count[1];
    if (c->rim > 0.0f) {
      vf rim = sum.of[1] * splat(1.0f - c->core);
      sum.of[1] = sum.of[1] - rim;
      sum.of[2] = sum.of[2] + rim;
    }
  }
  for (int k = 0; k < 3; k++) out[k] = sum.of[k] * each;
  *third = sum.third * each;
}

#endif
