/* SPDX-License-Identifier: Apache-2.0
 *
 * Moss: where it grows, deep in joints and in patches over the stones, and how it looks there:
 * cushions with creases, of shoots. A footprint is seen in parts, each with the joints about it.
 */
#ifndef SOZAI_STONE_MOSS_H
#define SOZAI_STONE_MOSS_H

#include "footprint.h"
#include "laid.h"
#include "value.h"
#include "weather.h"

/* Cushions: domes with creases between, from a noise's absolute value, a crease as wide as
 * CUSHION_CREASE of it. Mean 0, within -0.17 and some 0.5; gradient noise's own of that is
 * CUSHION_MEAN. */
#define CUSHION_CREASE 0.05f
#define CUSHION_MEAN 0.1672f
#define CUSHION_GONE 1.4f /* as NOISE_GONE: creases are narrower than the noise */
STAGE field moss_cushions(const vf p[3], float frequency, uint32_t seed, float weight, vf e) {
  const float(*row)[3] = value_aslant; /* so that no face shows the noise's rows */
  vf f = splat(frequency), zero = splat(0.0f), at[3], g[3];
  vf keep = weather_keep(e * f, CUSHION_GONE);
  if (!any(gt(keep, zero))) return field_of(zero);
  const vf by = splat(frequency / 11.0f);
  for (int k = 0; k < 3; k++)
    at[k] = by * (splat(row[k][0]) * p[0] + splat(row[k][1]) * p[1] + splat(row[k][2]) * p[2]);
  field n = field_of(noise_gradient3(at[0], at[1], at[2], splatu(seed), g));
  for (int k = 0; k < 3; k++)
    n.g[k] = by * (splat(row[0][k]) * g[0] + splat(row[1][k]) * g[1] + splat(row[2][k]) * g[2]);
  vf square = n.v * n.v + splat(CUSHION_CREASE * CUSHION_CREASE);
  vf inverse = inverse_root(square);
  field r = field_through(n, square * inverse - splat(CUSHION_MEAN), n.v * inverse);
  return field_scale(r, keep * splat(weight));
}

/* How a moss grows where it does: how high, of moss_height; how light; lush, 0, to dry, 1. */
typedef struct {
  field rise;
  vf shade, dry;
} moss_growth;

/* Cushions of one to two centimetres and of some millimetres, on them the shoots' tips. Tips catch
 * the light, creases are in the shade of what is about them. */
INLINE moss_growth moss_growth_at(const stone_weather *v, const vf p[3], vf e) {
  vf unused = splat(0.0f);
  moss_growth m;
  field cushions = field_add(moss_cushions(p, 0.05f, v->seed + 12u, 1.1f, e),
                             moss_cushions(p, 0.13f, v->seed + 13u, 0.6f, e));
  field tips = field_add(weather_noise(p, 0.9f, v->seed + 3u, 0.55f, e, &unused),
                         weather_noise(p, 1.9f, v->seed + 14u, 0.35f, e, &unused));
  m.rise = field_add(field_scale(cushions, splat(1.6f)), field_scale(tips, splat(0.3f)));
  m.rise.v = m.rise.v + splat(0.69f);
  m.shade = splat(1.5f) * cushions.v + splat(1.1f) * tips.v;
  vf patch = weather_noise(p, 0.021f, v->seed + 4u, 0.9f, e, &unused).v +
             weather_noise(p, 0.0047f, v->seed + 15u, 1.2f, e, &unused).v;
  m.dry = clamp01(splat(0.385f) + patch + splat(0.5f) * tips.v + splat(0.4f) * cushions.v);
  return m;
}

#define GROWTH_WHOLE 1.5f /* mm: wider footprints are seen in quarters */

/* The same over a footprint. */
STAGE moss_growth moss_grown(const stone_weather *v, const vf p[3], const laid_square *square,
                             vf e) {
  vm cut = gt(e, splat(GROWTH_WHOLE));
  if (!any(cut)) return moss_growth_at(v, p, e);
  const vf each = splat(0.25f), zero = splat(0.0f);
  vf wide = sel(cut, splat(0.5f) * e, e), off = sel(cut, each * e, zero);
  moss_growth sum = {field_of(zero), zero, zero};
  for (int i = 0; i < 4; i++) {
    vf u = i & 1 ? off : zero - off, w = i & 2 ? off : zero - off, at[3];
    for (int k = 0; k < 3; k++) at[k] = p[k] + square->side[0][k] * u + square->side[1][k] * w;
    moss_growth m = moss_growth_at(v, at, wide);
    /* whole lanes have the first of them, and nothing is added to it */
    vf part = i ? sel(cut, each, zero) : sel(cut, each, splat(1.0f));
    sum.rise = field_add(sum.rise, field_scale(m.rise, part));
    sum.shade = sum.shade + part * m.shade;
    sum.dry = sum.dry + part * m.dry;
  }
  return sum;
}

/* How well moss does at a place, joints aside; *lost: its variance that the footprint hides. */
INLINE field moss_thrives(const stone_weather *v, const vf p[3], vf e, vf *lost) {
  vf unused = splat(0.0f);
  float size = v->moss_spread > 8.0f ? v->moss_spread : 8.0f;
  *lost = unused;
  field n = weather_noise(p, 0.06f / size, v->seed, 1.9f, e, lost);
  n = field_add(n, weather_noise(p, 0.31f / size, v->seed + 1u, 1.0f, e, lost));
  n = field_add(n, weather_noise(p, 0.085f, v->seed + 7u, 0.85f, e, lost));
  n = field_add(n, weather_noise(p, 0.33f, v->seed + 2u, 0.55f, e, lost));
  return field_add(n, weather_noise(p, 0.9f, v->seed + 3u, 0.2f, e, &unused));
}

/* Share of moss where it thrives so well. `near`: 1 in the joint, 0 at moss_spread from it. */
INLINE field moss_at(const stone_constants *w, field n, vf lost, field near, vf e) {
  const stone_weather *v = &w->weather;
  /* where it begins: deep and wide joints shelter it */
  const stone_paving *l = &w->paving;
  float deep = l->depth / (l->depth + 4.0f), wide = l->half / (l->half + 3.0f);
  const float shelter = 0.75f + 0.5f * deep + 0.4f * wide;
  n = field_add(n, field_scale(near, splat(shelter)));
  /* how near a joint is differs within the footprint, too */
  vf within = e / (e + splat(2.0f * v->moss_spread));
  lost = lost + splat(0.3f * shelter * shelter) * within * near.v * (splat(1.0f) - near.v);
  /* a step so soft has a fifth of that squared as its slope's variance */
  vf soft = vsqrt(splat(0.0144f) + splat(5.0f) * lost);
  n.v = n.v - splat(1.35f - 1.5f * v->moss);
  return field_step(n, splat(0.0f) - soft, soft);
}

/* mm: footprints of which each side is one part, two, four and six, up to, and of wider ones
 * eight; from where on parts look up joints of their own; and in how many strips they are cut
 * along the nearest of those. */
#define MOSS_ONE 0.3f
#define MOSS_TWO 0.8f
#define MOSS_FOUR 2.5f
#define MOSS_SIX 60.0f
#define MOSS_LAID 6.0f
#define MOSS_STRIPS 4

/* How near that joint each strip of a part is, and how much of it is told by that and not by the
 * mean of all stones. */
STAGE void moss_near(const stone_constants *w, const vf p[3], const vf *n, vf e,
                     vf near[MOSS_STRIPS], vf *told) {
  const stone_paving *v = &w->paving;
  laid q;
  vf nx, ny;
  laid_find(w, p, n, e, &q, &nx, &ny);
  vf size = vmin(q.unit.length, q.unit.width);
  *told = splat(1.0f) - smooth_step(splat(0.7f) * size, splat(1.6f) * size, e);
  q.e = vmax(e * splat(1.0f / MOSS_STRIPS), splat(LAID_LEAST));
  vf middle = vmax(q.edge + splat(v->half), splat(0.0f));
  for (int i = 0; i < MOSS_STRIPS; i++) {
    const float at = ((float)i + 0.5f) / MOSS_STRIPS - 0.5f;
    q.m = field_of(vabs(middle + splat(at) * e)); /* past the joint's middle it is further again */
    near[i] = laid_fall(&q, v->half, w->weather.moss_spread).v;
  }
}

/* Shares of moss: of the footprint, and of what of it is joint; and how near a joint is what the
 * moss leaves bare, times that. */
typedef struct {
  field all;
  vf joint, near;
} moss_shares;

/* One part, so wide. near, told: as its own middle has them where `laid` has no joints of its own
 * looked up. */
INLINE moss_shares moss_part(const stone_constants *w, int paved, vm laid, const vf p[3],
                             const vf *n, field near, vf told, vf wide) {
  const vf one = splat(1.0f), zero = splat(0.0f), strip = splat(1.0f / MOSS_STRIPS);
  vf lost, strips[MOSS_STRIPS], found;
  field thrives = moss_thrives(&w->weather, p, wide, &lost);
  moss_shares m = {moss_at(w, thrives, lost, near, wide), zero, zero};
  if (!paved) return m;
  m.near = (one - m.all.v) * near.v;
  if (any(laid)) {
    field cut = field_of(zero);
    vf bare = zero;
    moss_near(w, p, n, wide, strips, &found);
    for (int k = 0; k < MOSS_STRIPS; k++) {
      near.v = strips[k];
      field one_strip = moss_at(w, thrives, lost, near, wide * strip);
      cut = field_add(cut, one_strip);
      bare = bare + (one - one_strip.v) * near.v;
    }
    m.near = sel(laid, bare * strip, m.near);
    m.all.v = sel(laid, cut.v * strip, m.all.v);
    for (int k = 0; k < 3; k++) m.all.g[k] = sel(laid, cut.g[k] * strip, m.all.g[k]);
    told = sel(laid, found, told);
  }
  m.all = field_through(m.all, mix(splat(w->weather.moss_mean), m.all.v, told), told);
  if (w->paving.half > 0.0f) m.joint = moss_at(w, thrives, lost, field_of(one), wide).v;
  return m;
}

/* told: of the middle, where there is a paving. seen: where the parts' shares are kept, or NULL. */
STAGE moss_shares moss_over(const stone_constants *w, int paved, const vf p[3],
                            const laid_square *square, field near, vf told, vf e,
                            cells_covered *seen) {
  const vf one = splat(1.0f), half = splat(0.5f), zero = splat(0.0f);
  static const float from[] = {MOSS_ONE, MOSS_TWO, MOSS_FOUR, MOSS_SIX};
  /* of parts that tell nothing of joints nor of patches one does for all */
  vm some = lt(e, splat(w->weather.moss_told)), laid = gt(e, splat(MOSS_LAID));
  vf side = one, each = zero;
  int parts = 1;
  for (int k = 0; k < 4; k++) {
    vm more = and_(some, gt(e, splat(from[k])));
    if (!any(more)) break;
    parts = 2 * (k + 1);
    side = sel(more, splat((float)parts), side);
  }
  vf share = one / side;
  moss_shares sum = {field_of(zero), zero, zero};
  for (int i = 0; i < parts * parts; i++) {
    /* lanes of fewer parts have theirs in the first of these */
    vf along[2] = {splat((float)(i % parts)), splat((float)(i / parts))};
    vm there = and_(lt(along[0], side), lt(along[1], side));
    vf at[3];
    field by = near;
    for (int k = 0; k < 2; k++) along[k] = ((along[k] + half) * share - half) * e;
    for (int k = 0; k < 3; k++) {
      vf off = square->side[0][k] * along[0] + square->side[1][k] * along[1];
      at[k] = p[k] + off;
      by.v = by.v + near.g[k] * off;
    }
    by.v = clamp01(by.v);
    moss_shares part = moss_part(w, paved, laid, at, square->n, by, told, e * share);
    sum.all.v = sel(there, sum.all.v + part.all.v, sum.all.v);
    for (int k = 0; k < 3; k++)
      sum.all.g[k] = sel(there, sum.all.g[k] + part.all.g[k], sum.all.g[k]);
    sum.joint = sel(there, sum.joint + part.joint, sum.joint);
    sum.near = sel(there, sum.near + part.near, sum.near);
    each = sel(there, each + one, each);
    if (seen) seen->of[i / parts * CELLS_STEPS + i % parts] = part.all.v;
  }
  if (seen) {
    seen->grid.n[0] = seen->grid.n[1] = side;
    seen->grid.weight = sel(gt(side, one), one, zero);
  }
  vf inverse = one / each;
  sum.all = field_scale(sum.all, inverse);
  sum.joint = vmax(sum.joint * inverse, sum.all.v); /* there is more of it in joints */
  sum.near = sum.near * inverse;
  return sum;
}

#endif
