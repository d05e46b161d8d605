/* SPDX-License-Identifier: Apache-2.0
 *
 * Rings under a footprint that is wide enough for them to curve in: what goes with them is averaged
 * along the line that crosses them, all of it in one pass. Where latewood strays from its ring does
 * not count: such a footprint is far wider than that.
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
  vf side; /* mm^2: what is not along the line */
} rings_line;

/* Means over the lanes' footprints that rings curve under. */
typedef struct {
  vf mean[RING_MEANS];
  vm curved;
} curved_rings;

/* In how many parts a line is seen. Rings are widest on it where it turns, next to the pith: parts
 * are short there, and grow with the root of the distance. As near as 16 equal ones
 * (`property.filter`, rings_that_curve). */
#define CURVED_PARTS 6
#define CURVED_EVEN 0.2f /* of the root of its distance and a ring's width, what is seen evenly */

/* Where a line is cut: `at` is even, mm^1/2, and is 0 where the line turns. */
INLINE vf curved_cut(vf from_turn, vf even, vf root) {
  vf at = vsqrt(vabs(from_turn) + even) - root;
  return sel(lt(from_turn, splat(0.0f)), splat(0.0f) - at, at);
}
INLINE vf curved_from_turn(vf at, vf root) { return at * (vabs(at) + root + root); }

/* Averages along it: within each part rho runs straight, and by how little it does not, the part
 * is widened. vessels: whether any but latewood's is asked for. */
static __attribute__((noinline)) void rings_along(const wood_constants *w, int vessels,
                                                  const rings_line *q, vf mean[RING_MEANS]) {
  const int asked[RING_MEANS] = {
      [MEAN_LATE] = 1,
      [MEAN_PORE] = vessels && w->has_pores && w->pore_growth != 0.0f,
      [MEAN_ROW] = vessels && w->rows,
      [MEAN_MARGIN] = vessels && w->parenchyma.margin > 0.0f,
  };
  vf zero = splat(0.0f), half = splat(0.5f), turn = q->r * q->ur;
  vf near2 = vmax(q->r * q->r - turn * turn, zero); /* of the line to the pith, squared */
  vf even = splat(CURVED_EVEN) * vsqrt(vsqrt(near2) * splat(w->ring_width)) + splat(1e-3f);
  vf root = vsqrt(even), end = half * q->s;
  vf first = curved_cut(turn - end, even, root);
  vf step = (curved_cut(turn + end, even, root) - first) * splat(1.0f / CURVED_PARTS);
  vf a0 = zero, r0 = zero, rho0 = zero;
  for (int what = 0; what < RING_MEANS; what++) mean[what] = zero;
  for (int i = 0; i <= CURVED_PARTS; i++) {
    vf from_turn = curved_from_turn(first + step * splat((float)i), root);
    vf a = from_turn - turn, r = vsqrt(vmax(near2 + from_turn * from_turn, splat(1e-6f)));
    vf rho = vmax(q->rho + (r - q->r) * q->radial + q->linear * a, zero);
    if (i) {
      vf middle = half * (rho + rho0), span = rho - rho0, part = a - a0, about = half * (r + r0);
      vf sag = part * part * near2 / (splat(8.0f) * about * about * about);
      vf wide = vsqrt(span * span + q->side + splat(2.56f) * sag * sag);
      vf reach = half * vmax(wide, splat(w->blur));
      vf low = vmax(middle - reach, zero), high = middle + reach, share = part / (high - low);
      ring_place p0 = ring_at(w, low), p1 = ring_at(w, high);
      UNROLL(4)
      for (int what = 0; what < RING_MEANS; what++) {
        if (!asked[what]) continue;
        vf within = integral_to(w, what, &p1) - integral_to(w, what, &p0);
        mean[what] = mean[what] + within * share;
      }
    }
    a0 = a;
    r0 = r;
    rho0 = rho;
  }
  vf inverse = splat(1.0f) / q->s;
  for (int what = 0; what < RING_MEANS; what++) mean[what] = clamp01(mean[what] * inverse);
}

/* Whether any lane's footprint may be wide enough for its rings to curve in. */
INLINE int rings_may_curve(const wood_constants *w, const stem_place *p, vf s) {
  /* the sag of s over a radius r is s^2 / 8 r at most */
  return any(gt(s * s, splat(0.64f * w->ring_width) * p->r));
}

/* The means of those that are, if there is one. g: row of the map from the surface to rho; n: the
 * surface's normal; s: mm. */
static __attribute__((noinline)) int curved_rings_of(const wood_constants *w, int vessels,
                                                     const stem_place *p, const vf g[3],
                                                     const vf n[3], vf s, curved_rings *out) {
  /* across: the horizontal direction in the surface */
  vf flat2 = n[0] * n[0] + n[2] * n[2];
  vm end = lt(flat2, splat(0.09f)); /* end grain: along the radius */
  vf k = inverse_root(vmax(flat2, splat(1e-6f)));
  vf ux = sel(end, p->c, n[2] * k), uz = sel(end, p->s, splat(0.0f) - n[0] * k);
  rings_line q = {.s = s, .r = p->r, .ur = ux * p->c + uz * p->s, .rho = p->rho};
  vf ut2 = vmax(splat(1.0f) - q.ur * q.ur, splat(0.0f));
  out->curved = gt(s * s * ut2, splat(0.64f * w->ring_width) * p->r);
  if (!any(out->curved)) return 0;

  vf slope = p->rho_x * ux + p->rho_z * uz; /* of rho along u */
  q.radial = p->rho_x * p->c + p->rho_z * p->s;
  q.linear = slope - q.radial * q.ur;
  /* what is not along u widens every part */
  vf gn = g[0] * n[0] + g[1] * n[1] + g[2] * n[2];
  vf all = vmax(g[0] * g[0] + g[1] * g[1] + g[2] * g[2] - gn * gn, splat(0.0f));
  q.side = vmax(all - slope * slope, splat(0.0f)) * s * s + splat(12.0f) * p->lost;
  rings_along(w, vessels, &q, out->mean);
  return 1;
}

#endif
