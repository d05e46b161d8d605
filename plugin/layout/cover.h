/* SPDX-License-Identifier: Apache-2.0
 *
 * Joints under a footprint.
 *
 * A footprint is a square of side e, which for a straight joint is a box of
 * that width across it. Between two parallel sides the joints repeat with the
 * unit's width, and their share of the box is a difference of two values of
 * their integral: exact for courses, and exact for any unit as long as the
 * footprint does not reach past its neighbours. Beyond about the unit's size
 * the share of the whole plane fades in.
 */
#ifndef SOZAI_LAYOUT_COVER_H
#define SOZAI_LAYOUT_COVER_H

#include "../core/filter.h"
#include "layout.h"

#define COVER_LEAST 0.01f /* mm: a point's own blur */

/* Integral from 0 to x of what is joint: bands of width g about the multiples
 * of w. */
INLINE vf cover_integral(vf x, vf w, vf inverse_w, vf g) {
  vi unused;
  vf turns = vfloor(x * inverse_w, &unused), rest = x - turns * w, half = splat(0.5f) * g;
  return g * turns + clamp(rest, splat(0.0f), half) + vmax(rest - (w - half), splat(0.0f));
}

/* What gathers over the sides of a unit. */
typedef struct {
  vf nearest, nx, ny; /* distance to the nearest side, and its inward normal */
  vf second, mx, my;  /* to the next nearest: for rounded corners */
  vf open;            /* share of the footprint that is no joint */
  vf own;             /* share of it within the unit's own sides */
  int upright;        /* the face is not the plane's everywhere */
  vf face[2];         /* along the plane, of the face's normal */
} cover;

/* face: along the plane, of the unit normal of the face; NULL where that is the plane. */
INLINE cover cover_begin(const vf face[2]) {
  cover c;
  c.upright = 0;
  c.face[0] = c.face[1] = splat(0.0f);
  if (face) {
    for (int k = 0; k < 2; k++) c.face[k] = face[k];
    c.upright = any(gt(face[0] * face[0] + face[1] * face[1], splat(0.0f)));
  }
  c.nearest = c.second = splat(1e9f);
  c.nx = c.ny = c.mx = c.my = splat(0.0f);
  c.open = c.own = splat(1.0f);
  return c;
}

INLINE void cover_side(cover *c, vf d, vf nx, vf ny) {
  vm nearer = lt(d, c->nearest), near = lt(d, c->second);
  c->second = sel(nearer, c->nearest, sel(near, d, c->second));
  c->mx = sel(nearer, c->nx, sel(near, nx, c->mx));
  c->my = sel(nearer, c->ny, sel(near, ny, c->my));
  c->nearest = sel(nearer, d, c->nearest);
  c->nx = sel(nearer, nx, c->nx);
  c->ny = sel(nearer, ny, c->ny);
}

/* Of the box from d - e/2 to d + e/2 the share from `low` to `high`. */
INLINE vf cover_share(vf d, vf e, vf low, vf high) {
  vf half = splat(0.5f) * e;
  return clamp01((vmin(d + half, high) - vmax(d - half, low)) / e);
}

/* How far the footprint reaches along a direction of the plane, unit: all of its side
 * e, or less where the face is not the plane. */
INLINE vf cover_extent(const cover *c, vf nx, vf ny, vf e) {
  if (!c->upright) return e;
  vf out = c->face[0] * nx + c->face[1] * ny;
  return vmax(e * vsqrt(vmax(splat(1.0f) - out * out, splat(0.0f))), splat(COVER_LEAST));
}

/* Two parallel sides, d0 and d1 away; n is the inward normal of the first. */
INLINE void cover_pair(cover *c, vf d0, vf d1, vf nx, vf ny, float joint, vf e) {
  vf zero = splat(0.0f), g = splat(joint);
  e = cover_extent(c, nx, ny, e);
  cover_side(c, d0, nx, ny);
  cover_side(c, d1, zero - nx, zero - ny);
  vf w = vmax(d0 + d1, splat(1e-3f)), half = splat(0.5f) * e;
  c->own = c->own * cover_share(d0, e, zero, w);
  if (!any(le(vmin(d0, d1) - half, splat(0.5f * joint)))) return; /* no joint within reach */
  vf inverse = splat(1.0f) / w;
  vf band = cover_integral(d0 + half, w, inverse, g) - cover_integral(d0 - half, w, inverse, g);
  vm near = le(vmin(d0, d1) - half, splat(0.5f * joint));
  c->open = c->open * sel(near, splat(1.0f) - clamp01(band / e), splat(1.0f));
}

/* One side on its own. */
INLINE void cover_one(cover *c, vf d, vf nx, vf ny, float joint, vf e) {
  vf half = splat(0.5f * joint);
  e = cover_extent(c, nx, ny, e);
  cover_side(c, d, nx, ny);
  c->own = c->own * cover_share(d, e, splat(0.0f), splat(1e9f));
  c->open = c->open * (splat(1.0f) - cover_share(d, e, splat(0.0f) - half, half));
}

/* Coverage of the joint: what the sides gave, and beyond a unit's size the
 * share of the whole plane. */
INLINE vf cover_joint(const layout *l, const cover *c, vf length, vf width, vf e) {
  vf covered = splat(1.0f) - c->open;
  vf size = vmin(length, width);
  vm wide = gt(e, size);
  if (!any(wide)) return covered;
  vf far = smooth_step(size, splat(2.0f) * size, e);
  return sel(wide, mix(covered, splat(l->share), far), covered);
}

#endif
