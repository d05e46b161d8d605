/* SPDX-License-Identifier: Apache-2.0
 *
 * The relief's shadow on itself. A point of it is lit where the light stands higher than all that
 * the relief rises to on its way there, and nothing is traced for that: each part knows its own
 * shape, and so how steeply it rises towards the light from a point within.
 *
 *   worn rings     the edge of the last ring's latewood on the one side; a tangent to the shoulder
 *                  of this one's on the other
 *   cracks         a tangent to the shoulder across
 *   tools' marks   one to the next crest
 *   vessels,       the rim of the paraboloid, from the slope and the bend at the point
 *   checks
 *   noise          Smith's expectation, by the height that the point has in it (IEEE Trans.
 * Antennas Propag. 15, 1967)
 *
 * Those that are small are cut into the slopes of those that are large, over which light stands the
 * lower.
 *
 * A footprint averages the shapes, and their shadows with them. What it has lost needs none: light
 * that does not fall on one part of a relief falls on another, and all of them together take what
 * the face would. Shadows take as much as slopes that turn to the light take more than the face.
 */
#ifndef SOZAI_WOOD_SURFACE_SHADE_H
#define SOZAI_WOOD_SURFACE_SHADE_H

#include "../../core/smith.h"

/* How steeply something rises towards the light, and over how much steeper or less its shadow's
 * edge goes. */
typedef struct {
  vf slope, soft;
} shade_rise;

typedef struct {
  vf to[3], tangent;       /* where light is within the face, log space, and of its elevation */
  shade_rise large, small; /* the steepest of each; the small over what they are cut into */
  vf fine;                 /* how the small and the noise slope towards the light at the point */
  vf variance, rank;       /* of the noise's slopes towards it; the point's height in that, in sd */
} surface_shade;

/* l: towards the light, and n, the face's normal: unit, log space. */
INLINE surface_shade shade_under(const vf l[3], const vf n[3]) {
  surface_shade s;
  vf zero = splat(0.0f), up = dot3(l, n), square = zero;
  for (int c = 0; c < 3; c++) {
    s.to[c] = l[c] - up * n[c];
    square = square + s.to[c] * s.to[c];
  }
  vf inverse = inverse_root(vmax(square, splat(1e-12f)));
  for (int c = 0; c < 3; c++) s.to[c] = s.to[c] * inverse;
  s.tangent = up * inverse;
  s.large = s.small = (shade_rise){zero, zero};
  s.fine = s.variance = s.rank = zero;
  return s;
}

/* Light twice as steep is past it, however soft. */
INLINE void shade_steeper(shade_rise *r, vf slope, vf soft) {
  vm steeper = gt(slope, r->slope);
  r->slope = sel(steeper, slope, r->slope);
  r->soft = sel(steeper, vmin(soft, slope), r->soft);
}

/* A trough's rim, from where its parabola is 0 again. depth: at the point, of `whole`; ahead: its
 * slope towards the light; fall: depth times the parabola's bend on the way there; s: the
 * footprint. Where two meet each keeps its own bend, and not the sum's: the further rim counts. */
INLINE void shade_trough(surface_shade *q, vf whole, vf depth, vf ahead, vf fall, vf s) {
  vf rise = splat(0.5f) * whole * (vsqrt(ahead * ahead + splat(4.0f) * fall) - ahead);
  shade_steeper(&q->small, rise, whole * s * fall / vmax(depth, splat(0.02f)));
  q->fine = q->fine - whole * ahead;
}

/* Noise more, whose slope towards the light at the point is `slope`. */
INLINE void shade_noise(surface_shade *q, vf variance, vf rank, vf slope) {
  q->variance = q->variance + variance;
  q->rank = q->rank + rank;
  q->fine = q->fine + slope;
}

/* What slopes that stand out take of the light, over what the face does there: half of them face it
 * and have as much more as they rise towards it. Their square is uniform, and its mean `square`;
 * ahead: a part of them, that along the light. */
INLINE vf shade_takes(const surface_shade *q, vf ahead, vf square) {
  vf one = splat(1.0f), mean = splat(0.943f) * vsqrt(square) * vabs(ahead);
  return vmax(splat(0.5f) * (one + mean / vmax(q->tangent, splat(0.01f))), one);
}

/* Share of the light that comes past. */
INLINE vf shade_past(const shade_rise *r, vf tangent) {
  vf t = vmax(tangent, splat(1e-4f)), soft = splat(0.1f) * t + r->soft;
  return clamp01(splat(0.5f) + (t - r->slope) / soft);
}

/* log2 of Smith's expectation for a point in noise: Lambda times that of the share of heights
 * below, the normal distribution's by a logistic one. */
INLINE vf shade_smith(vf variance, vf rank, vf tangent) {
  vf one = splat(1.0f), zero = splat(0.0f);
  vf lambda = smith_lambda(tangent * inverse_root(vmax(variance + variance, splat(1e-8f))));
  vf below = log2_(one + exp2_(splat(-2.4555f) * clamp(rank, splat(-6.0f), splat(6.0f))));
  return zero - lambda * below;
}

/* Share of the light that comes to the point; slope: of all of the relief. */
INLINE vf shade_lit(const surface_shade *q, const vf slope[3]) {
  vf zero = splat(0.0f), lit = shade_past(&q->large, q->tangent);
  vf over = q->tangent - (dot3(slope, q->to) - q->fine);
  if (any(gt(q->small.slope, zero))) lit = lit * shade_past(&q->small, over);
  const float much = 2.01f * SMITH_STEEPER * SMITH_STEEPER; /* a little more: rounding */
  vf least = splat(much) * vmax(q->variance, splat(5e-9f));
  if (any(or_(lt(over, zero), lt(over * over, least)))) {
    lit = lit * exp2_(shade_smith(q->variance, q->rank, over));
  }
  return sel(gt(q->tangent, zero), lit, zero);
}

#endif
