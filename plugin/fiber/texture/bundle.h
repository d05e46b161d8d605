/* SPDX-License-Identifier: Apache-2.0
 *
 * Which bundle of a layer a point lies in: cells about the points of a lattice
 * of cubes and of their centres, which is the nearest to balls that two
 * look-ups give. Each has a direction on the surface, a curvature and a crimp.
 */
#ifndef SOZAI_FIBERTEX_BUNDLE_H
#define SOZAI_FIBERTEX_BUNDLE_H

#include "lanes.h"

/* The axes on the surface that directions are counted from, its normal, and
 * what is seen and lit by: components along the three. */
typedef struct {
  vf e1[3], e2[3], n[3];
  vf light[3], view[3];
  vf between;
  vf step[3];  /* how far the ray has gone sideways per depth */
  vf lean2[2]; /* tangent of the view's slant along e1 and e2 */
} hull_frame;

/* The same turned into the lattice's space, which no face or diagonal of an object
 * lies along: a level of the lattice would be cut all at one height. */
typedef struct {
  vf at[3], step[3], e1[3], e2[3], n[3];
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

INLINE void lattice_of(const hull_frame *f, const vf at[3], lattice_frame g[LATTICES]) {
  for (int i = 0; i < LATTICES; i++) {
    into_lattice(i, at, g[i].at);
    into_lattice(i, f->step, g[i].step);
    into_lattice(i, f->e1, g[i].e1);
    into_lattice(i, f->e2, g[i].e2);
    into_lattice(i, f->n, g[i].n);
  }
}

INLINE vf dot3(const vf a[3], const vf b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* How much broader a cylinder's shadow along the view is, on a surface: `slant`
 * is the view's tangent across it. */
INLINE vf widening(vf slant, float most) {
  /* nearly sqrt(1 + x) */
  vf x = vmin(slant * slant, splat(2.6f));
  return vmin(splat(1.0f) + x * (splat(0.48f) + x * (splat(-0.086f) + x * splat(0.0085f))),
              splat(most));
}

INLINE void bundle_at(const fibertex_constants *w, const fibertex_layer *c, const hull_frame *hull,
                      const lattice_frame *frames, lane_place *p, vf direction[2]) {
  const vf half = splat(0.5f);
  const lattice_frame *g = &frames[c->lattice];
  vf a[3], b[3];
  vu ha = splatu(c->seed), hb;
  static const uint32_t odd[3] = {HASH_X, HASH_Y, HASH_Z};
  for (int k = 0; k < 3; k++) {
    vf q = (g->at[k] - g->step[k] * splat(c->depth)) * splat(c->inverse_size) + splat(c->offset[k]);
    vi i;
    vf low = vfloor(q, &i), part = q - low;
    /* the cube's centre; and the nearest of its corners */
    b[k] = part - half;
    vm upper = gt(b[k], splat(0.0f));
    a[k] = part - sel(upper, splat(1.0f), splat(0.0f));
    ha += (vu)(i + i + seli(upper, splati(2), splati(0))) * splatu(odd[k]);
    if (k == 0)
      hb = (vu)(i + i + splati(1)) * splatu(odd[0]);
    else
      hb += (vu)(i + i + splati(1)) * splatu(odd[k]);
  }
  hb += splatu(c->seed);
  vm centre = lt(dot3(b, b), dot3(a, a));
  for (int k = 0; k < 3; k++) a[k] = sel(centre, b[k], a[k]) * splat(c->size);
  vu h = hash_mix((vu)seli(centre, (vi)hb, (vi)ha));
  p->h = h;

  vf x1 = dot3(a, g->e1), x2 = dot3(a, g->e2), above = dot3(a, g->n);
  /* a bundle stands off its cell's middle, so that no rows are seen, and is more or
   * less full */
  vu more = h * splatu(HASH_Z);
  vf off = splat(0.16f / 128.0f * c->size);
  x1 = x1 + off * byte_of(more, 1);
  x2 = x2 + off * byte_of(more, 2);
  above = above + off * byte_of(more, 3);
  p->full = splat(1.0f) + splat(0.25f / 128.0f) * byte_of(more, 0);
  vf co = lookup16(w->turn[0], h & splatu(15)), si = lookup16(w->turn[1], h & splatu(15));
  direction[0] = co;
  direction[1] = si;
  p->x = x1 * co + x2 * si;
  vf y = x2 * co - x1 * si;
  p->rest2 = splat(c->reach2) - above * above;
  vf curl = splat(w->curl) * byte_of(h, 0), slope;
  vf f = splat(w->crimp_frequency) * (splat(1.0f) + splat(0.25f / 128.0f) * byte_of(h, 1));
  vf swing = wave(p->x * f + splat(1.0f / 256.0f) * byte_of(h, 2), &slope) * splat(w->crimp);
  p->bend = curl * p->x + slope * f * splat(w->crimp);
  p->y = y - half * curl * p->x * p->x - swing;
  vf chord2 = p->rest2 - p->y * p->y;
  p->chord = vsqrt(vmax(chord2, splat(0.0f)));
  p->inverse_length = splat(1.0f / LANE_ENDS) / vmax(p->chord, splat(1e-3f * c->size));
  p->widen = widening(hull->lean2[1] * co - hull->lean2[0] * si, c->widen_most);
}

#endif
