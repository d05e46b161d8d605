/* SPDX-License-Identifier: Apache-2.0
 *
 * Rings under a footprint that is wide enough for them to curve in: their profile is averaged
 * along the line that crosses them, whose rho is straight between nodes.
 */
#ifndef SOZAI_WOOD_RINGS_CURVED_H
#define SOZAI_WOOD_RINGS_CURVED_H

#include "rings.h"
#include "stem.h"

/* How far a footprint reaches along rho. */
INLINE vf rings_extent(const stem_place *p, const vf g[3], const vf n[3], int ball, vf s) {
  footprint2 f = footprint_through(g, g, n, ball, s);
  return vsqrt(f.aa + splat(12.0f) * p->lost);
}

/* The line through the middle of a footprint that rings curve under: level, across
 * the grain. rho along it from its two parts, of the radius and of what is straight. */
typedef struct {
  vf s, r, ur, rho, radial, linear;
  vf side, sag; /* mm^2: what is not along the line; mm: off a straight line, of rho */
} rings_line;

/* Average of a ring's profile along it: between `parts` nodes rho runs straight. */
static __attribute__((noinline)) vf rings_along(const wood_constants *w, int what,
                                                const rings_line *q, int parts) {
  float step = 1.0f / (float)parts;
  vf widen = q->side + q->sag * q->sag * splat(2.56f * step * step * step * step);
  vf sum = splat(0.0f), before = sum;
  for (int i = 0; i <= parts; i++) {
    vf a = q->s * splat(step * (float)i - 0.5f);
    vf square = q->r * q->r + splat(2.0f) * q->r * q->ur * a + a * a;
    vf r = vsqrt(vmax(square, splat(1e-12f)));
    vf rho = vmax(q->rho + (r - q->r) * q->radial + q->linear * a, splat(0.0f));
    if (i) {
      vf middle = splat(0.5f) * (rho + before), span = rho - before;
      ring_place at = ring_at(w, middle);
      sum = sum + ring_average(w, what, &at, middle, vsqrt(span * span + widen));
    }
    before = rho;
  }
  return sum * splat(step);
}

/* Average of a ring's profile over a footprint that may be wide enough for the
 * rings' curvature. rho: in place of p's; e: rings_extent. */
INLINE vf rings_across(const wood_constants *w, int what, const stem_place *p, vf rho,
                       const ring_place *ring, const vf g[3], const vf n[3], int ball, vf s, vf e) {
  vf mean = ring_average(w, what, ring, rho, e);
  /* the sag of s over a radius r is s^2 / 8 r at most */
  if (ball || !any(gt(s * s, splat(0.64f * w->ring_width) * p->r))) return mean;

  /* across: the horizontal direction in the surface */
  vf flat2 = n[0] * n[0] + n[2] * n[2];
  vm end = lt(flat2, splat(0.09f)); /* end grain: along the radius */
  vf k = inverse_root(vmax(flat2, splat(1e-6f)));
  vf ux = sel(end, p->c, n[2] * k), uz = sel(end, p->s, splat(0.0f) - n[0] * k);
  rings_line q = {.s = s, .r = p->r, .ur = ux * p->c + uz * p->s, .rho = rho};
  vf ut2 = vmax(splat(1.0f) - q.ur * q.ur, splat(0.0f));
  q.sag = s * s * ut2 / (splat(8.0f) * p->r);
  vm curved = gt(q.sag, splat(0.08f * w->ring_width));
  if (!any(curved)) return mean;

  vf slope = p->rho_x * ux + p->rho_z * uz; /* of rho along u */
  q.radial = p->rho_x * p->c + p->rho_z * p->s;
  q.linear = slope - q.radial * q.ur;
  /* what is not along u widens every part */
  vf gn = g[0] * n[0] + g[1] * n[1] + g[2] * n[2];
  vf all = vmax(g[0] * g[0] + g[1] * g[1] + g[2] * g[2] - gn * gn, splat(0.0f));
  q.side = vmax(all - slope * slope, splat(0.0f)) * s * s + splat(12.0f) * p->lost;
  /* more nodes where rho turns by more than a ring: as much lies at the turn as
   * anywhere else, and all of it in one ring */
  vm turned = and_(curved, gt(q.sag, splat(0.6f * w->ring_width)));
  if (any(and_(curved, not_(turned)))) mean = sel(curved, rings_along(w, what, &q, 4), mean);
  if (any(turned)) mean = sel(turned, rings_along(w, what, &q, 16), mean);
  return mean;
}

#endif
