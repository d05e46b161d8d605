/* SPDX-License-Identifier: Apache-2.0
 *
 * Marks of tools. Their place is (a, b) of the face: a along the feed, b across
 * it. All heights are 0 or below, except the washboard's and the scratches'.
 *
 *   band saw      straight grooves across the feed, one to a tooth: each of its
 *                 own depth, which changes along it; the feed wanders
 *   circular saw  the same on arcs of the blade's radius, with fainter arcs the
 *                 other way, of the teeth that come up behind
 *   knives        a planer's cusps: a parabola to each cut
 *   strokes       a hand plane's: the lowest of the strokes' cambered troughs
 *   scratches     a grit's: noise far longer along the feed than across
 */
#ifndef SOZAI_WOOD_SURFACE_MARKS_H
#define SOZAI_WOOD_SURFACE_MARKS_H

#include "../stem.h"
#include "shade.h"

/* Height, mm; its slopes along a and b; and those slopes' mean products that the footprint
 * averages out. */
typedef struct {
  vf height, a, b, lost_aa, lost_ab, lost_bb;
} marks_relief;

/* Where light is, along a and b, and what it has to come past; NULL: not asked. */
typedef struct {
  vf a, b;
  surface_shade *past;
} marks_light;

#define MARK_STRAY 30.0f /* mm along a mark in which its depth changes */
#define MARK_MEAN 0.6f   /* of the deepest, the mean; and how far it strays */
#define MARK_VARIES 0.4f
#define MARK_SHAPE (8.0f / 15.0f) /* mean of a groove's q^2 */

/* What is left of a detail of that frequency: all under a quarter of it,
 * nothing from the whole of it on. */
INLINE vf marks_keep(vf e, float frequency) {
  return splat(1.0f) - smooth_step(splat(0.25f), splat(1.0f), e * splat(frequency));
}

/* One number in +-1 for each mark, changing along it, and its slope. */
INLINE vf mark_number(vi mark, vf b, vu seed, vf *slope) {
  noise_axis along = noise_split_cubic(b * splat(1.0f / MARK_STRAY), HASH_X);
  vf d, n = noise_value1(&along, (vu)mark * splatu(HASH_Y) + seed, &d);
  *slope = d * splat(1.0f / (MARK_STRAY * HASH_ONE));
  return n * splat(1.0f / HASH_ONE);
}

/* How far a groove q^2 of depth and pitch 1 rises to its crest, seen from x of its width before
 * that: a tangent's slope, to 1 %, and past the steepest place its own. */
INLINE vf marks_rise(vf x) {
  vf one = splat(1.0f), near = splat(32.0f) * x * (one - x) * (x + x - one);
  vf far = x * x * (splat(15.8f) - splat(14.0f) * x);
  return sel(lt(x, splat(0.78f)), far, near);
}

/* The shadow of a mark whose place within is f, of that slope over the phase and so much phase to a
 * mm on the way to the light. */
INLINE void marks_shade(surface_shade *s, vf rise, vf ahead, vf e) {
  vf phase = vabs(ahead);
  shade_steeper(&s->large, rise * phase, splat(3.0f) * rise * phase * phase * e);
}

/* A noise's layer at (x, y), added. */
INLINE void marks_noise(const surface_noise *q, vu seed, vf x, vf y, vf e, const marks_light *l,
                        marks_relief *r) {
  if (q->height == 0.0f) return;
  vf keep = splat(1.0f) - smooth_step(splat(0.25f * q->size), splat(q->size), e);
  vf gone = splat(1.0f) - keep * keep;
  r->lost_aa = r->lost_aa + gone * splat(q->slope2[0]);
  r->lost_bb = r->lost_bb + gone * splat(q->slope2[1]);
  if (!any(gt(keep, splat(0.0f)))) return;
  noise_axis ax = noise_split_cubic(x * splat(q->frequency[0]), HASH_X);
  noise_axis ay = noise_split_cubic(y * splat(q->frequency[1]), HASH_Y);
  vf dx, dy, k = keep * splat(q->height);
  vf n = noise_value2(&ax, &ay, seed, &dx, &dy);
  vf a = k * dx * splat(q->frequency[0]), b = k * dy * splat(q->frequency[1]);
  r->height = r->height + k * n;
  r->a = r->a + a;
  r->b = r->b + b;
  if (!l->past || q->rank == 0.0f) return;
  vf variance = splat(q->slope2[0]) * l->a * l->a + splat(q->slope2[1]) * l->b * l->b;
  shade_noise(l->past, keep * keep * variance, keep * n * splat(q->rank), a * l->a + b * l->b);
}

/* How teeth are set and fed unevenly: a shift of the travel t, and one
 * more than its slope. */
INLINE vf marks_uneven(const wood_surface *m, vu seed, vf t, vf *ta) {
  float size = 2.3f * m->pitch;
  noise_axis along = noise_split_cubic(t * splat(1.0f / size), HASH_Y);
  vf d, k = splat(0.4f * m->pitch / HASH_ONE), n = noise_value1(&along, seed, &d);
  *ta = splat(1.0f) + k * splat(1.0f / size) * d;
  return k * n;
}

/* Grooves at every pitch of the travel, whose gradient is (1, tb): teeth are
 * set and fed unevenly, which shifts them along it. */
INLINE void marks_grooves(const wood_surface *m, vu seed, float depth, vf travel, vf tb, vf b, vf e,
                          const marks_light *l, marks_relief *r) {
  vf one = splat(1.0f), zero = splat(0.0f), ta, t = travel + marks_uneven(m, seed, travel, &ta);
  vf u = t * splat(m->inverse_pitch), keep = marks_keep(e * vsqrt(one + tb * tb), m->inverse_pitch);
  tb = tb * ta;
  vf k = splat(depth), change, gone = (one - keep * keep) * (k * k * splat(m->slope2));
  r->lost_aa = r->lost_aa + gone * ta * ta;
  r->lost_ab = r->lost_ab + gone * ta * tb;
  r->lost_bb = r->lost_bb + gone * tb * tb;
  r->height = r->height - k * splat(MARK_MEAN * MARK_SHAPE);
  if (!any(gt(keep, zero))) return;
  vi mark;
  vf f = u - vfloor(u, &mark), q = splat(4.0f) * f * (one - f), g = q * q;
  vf d = splat(MARK_MEAN) + splat(MARK_VARIES) * mark_number(mark, b, seed, &change);
  k = k * keep;
  r->height = r->height - k * (d * g - splat(MARK_MEAN * MARK_SHAPE));
  vf slope = k * d * splat(8.0f * m->inverse_pitch) * q * (one - f - f);
  r->a = r->a - slope * ta;
  r->b = r->b - slope * tb - k * g * splat(MARK_VARIES) * change;
  if (!l->past) return;
  vf ahead = (ta * l->a + tb * l->b) * splat(m->inverse_pitch);
  vf rise = k * d * marks_rise(sel(lt(ahead, zero), one - f, f));
  marks_shade(l->past, rise, ahead, e);
}

/* A planer's cuts. */
INLINE void marks_knives(const wood_surface *m, vu seed, vf a, vf b, vf e, const marks_light *l,
                         marks_relief *r) {
  vf one = splat(1.0f), u = a * splat(m->inverse_pitch), k = splat(m->depth), change;
  vf keep = marks_keep(e, m->inverse_pitch);
  r->lost_aa = r->lost_aa + (one - keep * keep) * (k * k * splat(m->slope2));
  r->height = r->height - k * splat(2.0f / 3.0f);
  if (!any(gt(keep, splat(0.0f)))) return;
  vi mark;
  vf f = u - vfloor(u, &mark), q = splat(4.0f) * f * (one - f), g = q * q;
  /* no two knives stand out alike */
  vf d = splat(0.35f) * mark_number(mark, b, seed, &change);
  k = k * keep;
  r->height = r->height - k * (q + d * g - splat(2.0f / 3.0f));
  r->a = r->a - k * splat(m->inverse_pitch) * (one - f - f) * (splat(4.0f) + splat(8.0f) * d * q);
  r->b = r->b - k * splat(0.35f) * change * g;
  if (!l->past) return;
  vf ahead = l->a * splat(m->inverse_pitch);
  vf past = sel(lt(ahead, splat(0.0f)), one - f, f);
  marks_shade(l->past, splat(4.0f) * k * past, ahead, e);
}

/* A hand plane's strokes: troughs along a, at irregular distances in b; what
 * is left is the lowest. x from a trough's middle in half pitches, its floor
 * rises by 0.3 (x^2 + x^4) of the depth: steeper towards the iron's rounded corners. */
INLINE void marks_strokes(const wood_surface *m, vu seed, vf a, vf b, vf e, marks_relief *r) {
  vf one = splat(1.0f), zero = splat(0.0f), k = splat(m->depth);
  vf keep = marks_keep(e, m->inverse_pitch);
  r->lost_bb = r->lost_bb + (one - keep * keep) * (k * k * splat(m->slope2));
  if (!any(gt(keep, zero))) return;
  /* the hand does not go straight */
  noise_axis far = noise_split_cubic(a * splat(1.0f / 260.0f), HASH_X);
  vf da, sway = splat(0.12f / HASH_ONE) * noise_value1(&far, seed, &da);
  vf sway_a = da * splat(0.12f / (260.0f * HASH_ONE));
  vf u = b * splat(m->inverse_pitch) + sway;
  vi first;
  vf f = u - vfloor(u, &first);
  vf best = splat(1e30f), best_x = zero, best_a = zero;
  for (int i = -1; i <= 1; i++) {
    vi stroke = first + splati(i);
    vu h = hash_mix((vu)stroke * splatu(HASH_Z) + seed);
    vf middle = splat((float)i + 0.5f) + to_float((vi)h) * splat(0.12f / HASH_ONE);
    noise_axis along = noise_split_cubic(a * splat(1.0f / 400.0f), HASH_X);
    vf dn, n = noise_value1(&along, h, &dn);
    vf x = splat(2.0f) * (f - middle), x2 = x * x, x4 = x2 * x2;
    vf level = splat(0.3f) * (x2 + x4) + splat(0.1f / HASH_ONE) * n;
    vm lower = lt(level, best);
    best = sel(lower, level, best);
    best_x = sel(lower, splat(0.6f) * x + splat(1.2f) * x2 * x, best_x);
    best_a = sel(lower, dn * splat(0.1f / (400.0f * HASH_ONE)), best_a);
  }
  k = k * keep;
  r->height = r->height + k * (best - one);
  vf slope = splat(2.0f) * best_x;
  r->b = r->b + k * slope * splat(m->inverse_pitch);
  r->a = r->a + k * (best_a + slope * sway_a);
}

/* to: where light is, along a0 and b0. */
INLINE marks_relief marks_at(const wood_surface *m, vu seed, vf a0, vf b0, vf e, const vf to[2],
                             surface_shade *past) {
  vf zero = splat(0.0f);
  marks_relief r = {zero, zero, zero, zero, zero, zero};
  vf c = splat(m->turn_c), s = splat(m->turn_s);
  /* no two boards begin at the same tooth, nor below the same part of the blade */
  vu h = hash_mix(seed);
  vf shift = to_float((vi)(h >> 8)) * splat(977.0f / 16777216.0f);
  vf a = c * a0 + s * b0 + shift, b = c * b0 - s * a0;
  const marks_light l = {c * to[0] + s * to[1], c * to[1] - s * to[0], past};
  if (m->marks == MARKS_BAND) {
    noise_axis ab = noise_split_cubic(b * splat(1.0f / 70.0f), HASH_Z);
    vf n, wander = splat(0.9f / HASH_ONE) * noise_value1(&ab, seed, &n);
    vf tb = n * splat(0.9f / (70.0f * HASH_ONE));
    marks_grooves(m, seed, m->depth, a + wander, tb, b, e, &l, &r);
  } else if (m->marks == MARKS_CIRCULAR) {
    vf middle = splat(m->radius) *
                (splat(0.2f) + to_float((vi)(h & splatu(1023u))) * splat(0.35f / 1023.0f));
    vf most = splat(0.95f * m->radius), x = b + middle, q = clamp(x, zero - most, most);
    vf root = vsqrt(splat(m->radius * m->radius) - q * q);
    vf tilt = sel(eq(x, q), q / root, zero), arc = splat(m->radius) - root;
    marks_grooves(m, seed, m->depth, a - arc, zero - tilt, b, e, &l, &r);
    marks_grooves(m, seed + splatu(HASH_X), m->depth * m->second, a + arc, tilt, b, e, &l, &r);
  } else if (m->marks == MARKS_KNIVES) {
    marks_knives(m, seed, a, b, e, &l, &r);
  } else if (m->marks == MARKS_STROKES) {
    marks_strokes(m, seed, a, b, e, &r);
  }
  marks_noise(&m->washboard, seed + splatu(HASH_Y), a, b, e, &l, &r);
  for (int o = 0; o < SURFACE_OCTAVES; o++) {
    marks_noise(&m->scratch[o], seed + splatu(HASH_Z + (uint32_t)o), a, b, e, &l, &r);
  }
  vf ga = r.a, aa = r.lost_aa, ab = r.lost_ab, bb = r.lost_bb, two = splat(2.0f);
  r.a = c * ga - s * r.b;
  r.b = s * ga + c * r.b;
  r.lost_aa = c * c * aa - two * c * s * ab + s * s * bb;
  r.lost_bb = s * s * aa + two * c * s * ab + c * c * bb;
  r.lost_ab = c * s * (aa - bb) + (c * c - s * s) * ab;
  return r;
}

#endif
