/* SPDX-License-Identifier: Apache-2.0
 *
 * Which bundle of a layer a point lies in: cells about the points of a lattice
 * of cubes and of their centres, which is the nearest to balls that two
 * look-ups give. Each has a direction on the surface, a curvature and a crimp.
 */
#ifndef SOZAI_FIBERTEX_BUNDLE_H
#define SOZAI_FIBERTEX_BUNDLE_H

#include "../../core/vectors.h"
#include "lanes.h"
#include "pile.h"

/* The axes on the surface that directions are counted from, its normal, and
 * what is seen and lit by: components along the three. */
typedef struct {
  vf e1[3], e2[3], n[3];
  vf light[3], view[3];
  vf between;
  vf step[3];  /* how far the ray has gone sideways per depth */
  vf lean2[2]; /* tangent of the view's slant along e1 and e2 */
  pile_lean pile;
} hull_frame;

/* The same turned into the lattice's space, which no face or diagonal of an object
 * lies along: a level of the lattice would be cut all at one height. */
typedef struct {
  vf at[3], step[3], e1[3], e2[3];
} lattice_frame;

/* Each layer lies in another of them than the next, lest they keep step. */
#define LATTICES 3

INLINE void into_lattice(int which, const vf v[3], vf out[3]) {
  /* rotations in whole numbers */
  static const float aslant[LATTICES][3][3] = {{{2.0f / 11.0f, 6.0f / 11.0f, 9.0f / 11.0f},
                                                {6.0f / 11.0f, 7.0f / 11.0f, -6.0f / 11.0f},
                                                {-9.0f / 11.0f, 6.0f / 11.0f, -2.0f / 11.0f}},
                                               {{-2.0f / 15.0f, 14.0f / 15.0f, 5.0f / 15.0f},
                                                {11.0f / 15.0f, -2.0f / 15.0f, 10.0f / 15.0f},
                                                {10.0f / 15.0f, 5.0f / 15.0f, -10.0f / 15.0f}},
                                               {{12.0f / 17.0f, -1.0f / 17.0f, 12.0f / 17.0f},
                                                {9.0f / 17.0f, 12.0f / 17.0f, -8.0f / 17.0f},
                                                {-8.0f / 17.0f, 12.0f / 17.0f, 9.0f / 17.0f}}};
  for (int i = 0; i < 3; i++) {
    const float *row = aslant[which][i];
    out[i] = splat(row[0]) * v[0] + splat(row[1]) * v[1] + splat(row[2]) * v[2];
  }
}

/* level: as below. */
INLINE void lattice_of(const hull_frame *f, const vf at[3], int level, lattice_frame g[LATTICES]) {
  for (int i = 0; i < LATTICES; i++) {
    into_lattice(i, at, g[i].at);
    if (!level) into_lattice(i, f->step, g[i].step);
    into_lattice(i, f->e1, g[i].e1);
    into_lattice(i, f->e2, g[i].e2);
  }
}

/* How much broader a cylinder's shadow along the view is, on a surface: `slant`
 * is the view's tangent across it. */
INLINE vf widening(vf slant, float most) {
  /* nearly sqrt(1 + x) */
  vf x = vmin(slant * slant, splat(2.6f));
  return vmin(splat(1.0f) + x * (splat(0.48f) + x * (splat(-0.086f) + x * splat(0.0085f))),
              splat(most));
}

/* Which cell a point is in, and where: from the middle, in cells. */
typedef struct {
  vf from[3], cube[3];
  vu h;
  vf chord2;
} bundle_cell;

/* Half a cell more is a whole unit more in the lowest bits of a number to which this was added. */
#define BUNDLE_HALVES 6291456.0f

/* level: the eye looks at all the points squarely. */
INLINE void bundle_cube(const fibertex_layer *c, const lattice_frame *frames, int level,
                        bundle_cell *q) {
  const lattice_frame *g = &frames[c->lattice];
  for (int k = 0; k < 3; k++) {
    vf at = g->at[k] * splat(c->inverse_size) + splat(c->offset[k]);
    if (!level) at = at - g->step[k] * splat(c->depth_cells);
    q->cube[k] = nearest_of(at);
    q->from[k] = at - q->cube[k];
  }
}

/* The cube's centre is nearest, or the nearest of its corners: cells have the shape of an
 * octahedron whose corners are cut off. */
INLINE void bundle_find(const fibertex_layer *c, bundle_cell *q) {
  static const uint32_t odd[3] = {HASH_X, HASH_Y, HASH_Z};
  vf *b = q->from;
  vm centre = lt(vabs(b[0]) + vabs(b[1]) + vabs(b[2]), splat(0.75f));
  vu h = splatu(c->seed);
  vi half = seli(centre, splati(0), bits_of(splat(0.5f))); /* of b's sign */
  vi sign = seli(centre, splati(0), splati(INT32_MIN));
  for (int k = 0; k < 3; k++) {
    vf aside = float_of((bits_of(b[k]) & sign) | half);
    h += (vu)bits_of(q->cube[k] + aside + splat(BUNDLE_HALVES)) * splatu(odd[k]);
    b[k] = b[k] - aside;
  }
  q->h = hash_mix(h);
}

/* How far it lies from the nearest face of the cell, mm: of six squares and eight hexagons. */
INLINE vf bundle_edge(const fibertex_layer *c, const bundle_cell *q) {
  vf x = vabs(q->from[0]), y = vabs(q->from[1]), z = vabs(q->from[2]);
  vf square = splat(0.5f) - vmax(vmax(x, y), z);
  vf hexagon = (splat(0.75f) - (x + y + z)) * splat(0.57735027f);
  return vmin(square, hexagon) * splat(c->size);
}

/* Where it lies about its bundle's middle, on the surface and above. */
INLINE void bundle_middle(const fibertex_constants *w, const fibertex_layer *c,
                          const hull_frame *hull, const lattice_frame *frames, int level,
                          bundle_cell *q, lane_place *p, vf direction[2]) {
  const lattice_frame *g = &frames[c->lattice];
  vu h = p->h = q->h;
  /* a bundle stands off its cell's middle, so that no rows are seen, and is more or
   * less full */
  vu more = h * splatu(HASH_Z);
  const vf size = splat(c->size), off = splat(FIELD(0.16f));
  vf v[3];
  for (int k = 0; k < 3; k++) v[k] = q->from[k] + off * field_of(more, k + 1);
  vf x1 = dot3(v, g->e1) * size, x2 = dot3(v, g->e2) * size;
  p->many = field_of(more, 0);
  p->full = to_int(splat(c->presence - HASH_ONE) + splat(c->presence * FIELD(LANE_MANY)) * p->many);
  vf co = lookup16(w->turn[0], h), si = lookup16(w->turn[1], h);
  direction[0] = co;
  direction[1] = si;
  p->widen = splat(1.0f);
  if (!level) {
    p->widen = w->pile ? pile_widening(&hull->pile, hull->lean2, co, si, c->widen_most)
                       : widening(hull->lean2[1] * co - hull->lean2[0] * si, c->widen_most);
  }
  p->x = x1 * co + x2 * si;
  p->y = x2 * co - x1 * si;
  /* half of the bundle's extent along x, squared: what lies off x counts, not what for */
  q->chord2 = p->x * p->x + (splat(c->reach2) - dot3(v, v) * splat(c->size * c->size));
}

/* Its course there. */
INLINE void bundle_course(const fibertex_constants *w, const fibertex_layer *c,
                          const bundle_cell *q, lane_place *p) {
  vu h = q->h;
  vf x = p->x;
  vf arc = splat(w->curl) * field_of(h, 0) * x, slope;
  vf f = splat(w->crimp_frequency) + splat(w->crimp_vary) * field_of(h, 1);
  vf swing = wave(x * f + phase_of(h), w->crimp, &slope);
  p->bend = arc + slope * f;
  p->y = p->y - splat(0.5f) * arc * x - swing;
  p->chord = vsqrt(vmax(q->chord2, splat(c->chord_least * c->chord_least)));
  p->part = p->x / p->chord;
}

#endif
