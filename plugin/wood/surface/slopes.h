/* SPDX-License-Identifier: Apache-2.0
 *
 * Slopes that a footprint averages out. Fibres, scratches and tools' marks slope a little
 * everywhere, more one way than the other; vessels, checks and cracks not at all over most of the
 * face and by 45 degrees and more in what is left. One distribution for both would be as wide as
 * the steep part and as high as neither, so each has its own: a highlight is that of the gentle
 * part over what it covers, and that of the steep one over the rest.
 */
#ifndef SOZAI_WOOD_SURFACE_SLOPES_H
#define SOZAI_WOOD_SURFACE_SLOPES_H

#include "../../core/vectors.h"

/* Mean products of slopes along two directions of the face. */
typedef struct {
  vf uu, uv, vv;
} slope_matrix;

typedef struct {
  vf u[3], v[3];       /* those directions, log space: up the stem, and across */
  slope_matrix gentle; /* over all of the face */
  vf share;            /* of the face, what is steep, */
  vf steep;            /* and over the face, the mean square of its slopes, of each at most 1 */
  vf upright;          /* mean cosine between the face and all that is on it */
} lost_slopes;

/* Two directions of a face whose normal is n: what of the axis lies within it, and across that. */
INLINE void slopes_frame(const vf axis[3], const vf n[3], vf u[3], vf v[3]) {
  vf along = dot3(axis, n);
  for (int c = 0; c < 3; c++) u[c] = axis[c] - along * n[c];
  vf k = inverse_root(vmax(dot3(u, u), splat(1e-12f)));
  for (int c = 0; c < 3; c++) u[c] = u[c] * k;
  cross3(n, u, v);
}

/* up2: squared length of +y within the face, on which n is normal. On end grain any direction
 * does for up. */
INLINE lost_slopes slopes_none(const vf n[3], vf up2) {
  vf zero = splat(0.0f), one = splat(1.0f);
  vm end = lt(up2, splat(0.04f));
  const vf axis[3] = {sel(end, one, zero), sel(end, zero, one), zero};
  lost_slopes l;
  slopes_frame(axis, n, l.u, l.v);
  l.gentle = (slope_matrix){zero, zero, zero};
  l.share = l.steep = zero;
  l.upright = one;
  return l;
}

/* A variance along g, log space, which is scaled by its length. */
INLINE void slopes_along(const lost_slopes *l, slope_matrix *m, const vf g[3], vf variance) {
  vf u = dot3(g, l->u), v = dot3(g, l->v);
  m->uu = m->uu + variance * u * u;
  m->uv = m->uv + variance * u * v;
  m->vv = m->vv + variance * v * v;
}

/* What slopes along g and h have in common, likewise. */
INLINE void slopes_between(const lost_slopes *l, slope_matrix *m, const vf g[3], const vf h[3],
                           vf product) {
  vf gu = dot3(g, l->u), gv = dot3(g, l->v), hu = dot3(h, l->u), hv = dot3(h, l->v);
  m->uu = m->uu + splat(2.0f) * product * gu * hu;
  m->uv = m->uv + product * (gu * hv + gv * hu);
  m->vv = m->vv + splat(2.0f) * product * gv * hv;
}

/* Of what is alike all round in the section: `sum` is over both directions. */
INLINE void slopes_section(slope_matrix *m, vf up2, vf sum) {
  vf one = splat(1.0f), v = sum / (one + (one - up2));
  m->uu = m->uu + v * (one - up2);
  m->vv = m->vv + v;
}

INLINE vf slopes_sum(const slope_matrix *m) { return m->uu + m->vv; }

/* Mean of 1 / sqrt(1 + g^2) where g^2 is uniform, as in a paraboloid, with a mean of v. */
INLINE vf slopes_upright(vf v) {
  vf one = splat(1.0f);
  return splat(2.0f) / (one + vsqrt(one + v + v));
}

/* Some of the face more that is steep: `share` of it, of which the footprint has lost `lost`,
 * within which slopes have a mean square of `square`. Where they do not overlap. taken: of the
 * face's light, what falls there. */
INLINE void slopes_steep_taking(lost_slopes *l, vf share, vf taken, vf lost, vf square) {
  vf one = splat(1.0f);
  lost = clamp01(lost);
  share = vmin(share, one) * lost * lost;
  l->steep = l->steep + share * vmin(square, one);
  l->share = l->share + share * (one - l->share);
  l->upright = l->upright * mix(one, slopes_upright(square), vmin(taken, one) * lost * lost);
}

/* The same of what is cut into the face, so that no more falls on it. */
INLINE void slopes_steep(lost_slopes *l, vf share, vf lost, vf square) {
  slopes_steep_taking(l, share, share, lost, square);
}

/* Mean square slope within the steep part. */
INLINE vf slopes_within(const lost_slopes *l) {
  return vmin(l->steep / vmax(l->share, splat(1e-6f)), splat(1.0f));
}

/* What of the light on the face falls on the slopes: as much, over a larger area. Some are turned
 * away from it or lie in shadow, and others get that light (shade.h). */
INLINE vf slopes_lit(const lost_slopes *l) {
  return l->upright * slopes_upright(slopes_sum(&l->gentle));
}

#endif
