/* SPDX-License-Identifier: Apache-2.0
 *
 * What weather does to a paving or a block: moss, a film of water, standing
 * water, and how wet stone looks.
 */
#ifndef SOZAI_STONE_WEATHER_H
#define SOZAI_STONE_WEATHER_H

#include "../core/noise.h"
#include "field.h"
#include "laid.h"
#include "value.h"

/* Gradient noise of a size as a field, faded out by the footprint; *lost gains
 * the variance that was (gradient noise's own is 0.05). */
STAGE field weather_noise(const vf p[3], float frequency, uint32_t seed, float weight, vf e,
                          vf *lost) {
  vf f = splat(frequency);
  field n;
  vf keep = splat(1.0f) - smooth_step(splat(0.4f), splat(1.4f), e * f);
  *lost = *lost + splat(0.05f * weight * weight) * (splat(1.0f) - keep * keep);
  if (!any(gt(keep, splat(0.0f)))) return field_of(splat(0.0f));
  n.v = noise_gradient3(p[0] * f, p[1] * f, p[2] * f, splatu(seed), n.g);
  for (int k = 0; k < 3; k++) n.g[k] = n.g[k] * f;
  return field_scale(n, keep * splat(weight));
}

/* Cushions: domes with creases between, from a noise's absolute value, a crease as wide as
 * CUSHION_CREASE of it. Mean 0, within -0.2 and some 0.5; gradient noise's own of that is
 * CUSHION_MEAN. */
#define CUSHION_CREASE 0.05f
#define CUSHION_MEAN 0.190f
STAGE field weather_cushions(const vf p[3], float frequency, uint32_t seed, float weight, vf e) {
  const float(*row)[3] = value_aslant; /* so that no face shows the noise's rows */
  vf f = splat(frequency), one = splat(1.0f), zero = splat(0.0f), at[3], g[3];
  vf keep = one - smooth_step(splat(0.25f), splat(0.9f), e * f);
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
INLINE moss_growth weather_growth(const stone_weather *v, const vf p[3], vf e) {
  vf unused = splat(0.0f);
  moss_growth m;
  field cushions = field_add(weather_cushions(p, 0.05f, v->seed + 12u, 1.1f, e),
                             weather_cushions(p, 0.13f, v->seed + 13u, 0.6f, e));
  field tips = field_add(weather_noise(p, 0.9f, v->seed + 3u, 0.55f, e, &unused),
                         weather_noise(p, 1.9f, v->seed + 14u, 0.35f, e, &unused));
  m.rise = field_add(field_scale(cushions, splat(1.6f)), field_scale(tips, splat(0.3f)));
  m.rise.v = m.rise.v + splat(0.75f);
  m.shade = splat(1.5f) * cushions.v + splat(1.1f) * tips.v;
  vf patch = weather_noise(p, 0.021f, v->seed + 4u, 0.9f, e, &unused).v +
             weather_noise(p, 0.0047f, v->seed + 15u, 1.2f, e, &unused).v;
  m.dry = clamp01(splat(0.4f) + patch + splat(0.5f) * tips.v + splat(0.4f) * cushions.v);
  return m;
}

/* Share of moss at a place. `near`: 1 in the joint, 0 at moss_spread from it. */
INLINE field weather_moss_at(const stone_constants *w, const vf p[3], field near, vf e) {
  const stone_weather *v = &w->weather;
  vf lost = splat(0.0f), unused = lost;
  float size = v->moss_spread > 8.0f ? v->moss_spread : 8.0f;
  field n = weather_noise(p, 0.06f / size, v->seed, 1.9f, e, &lost);
  n = field_add(n, weather_noise(p, 0.31f / size, v->seed + 1u, 1.0f, e, &lost));
  n = field_add(n, weather_noise(p, 0.085f, v->seed + 7u, 0.85f, e, &lost));
  n = field_add(n, weather_noise(p, 0.33f, v->seed + 2u, 0.55f, e, &lost));
  n = field_add(n, weather_noise(p, 0.9f, v->seed + 3u, 0.2f, e, &unused));
  /* where it begins: deep and wide joints shelter it */
  const stone_paving *l = &w->paving;
  float deep = l->depth / (l->depth + 4.0f), wide = l->half / (l->half + 3.0f);
  const float shelter = 0.75f + 0.5f * deep + 0.4f * wide;
  n = field_add(n, field_scale(near, splat(shelter)));
  /* how near a joint is differs within the footprint, too */
  vf within = e / (e + splat(2.0f * v->moss_spread));
  lost = lost + splat(0.5f * shelter * shelter) * within * near.v * (splat(1.0f) - near.v);
  vf soft = vsqrt(splat(0.0144f) + splat(3.0f) * lost);
  n.v = n.v - splat(1.35f - 1.5f * v->moss);
  return field_step(n, splat(0.0f) - soft, soft);
}

#define MOSS_ONE 0.3f  /* mm: a footprint that is wider is seen in two parts along a side, */
#define MOSS_TWO 0.8f  /* and a wider one in four; */
#define MOSS_LAID 6.0f /* from which on each of these parts has joints of its own */

/* How near a joint a part of a footprint is, and how much of it is told by that and not by the
 * mean of all stones. */
STAGE vf weather_near(const stone_constants *w, const vf p[3], const vf *n, vf e, vf *told) {
  const stone_paving *v = &w->paving;
  laid q;
  vf nx, ny;
  laid_find(w, p, n, e, &q, &nx, &ny);
  q.e = vmax(e, splat(LAID_LEAST));
  q.m = field_of(vmax(q.edge + splat(v->half), splat(0.0f)));
  vf size = vmin(q.unit.length, q.unit.width);
  *told = splat(1.0f) - smooth_step(splat(0.7f) * size, splat(1.6f) * size, q.e);
  return laid_fall(&q, v->half, w->weather.moss_spread).v;
}

/* Share of moss over a footprint. told: of the middle, where there is a paving. */
STAGE field weather_moss(const stone_constants *w, int paved, const vf p[3],
                         const laid_square *square, field near, vf told, vf e) {
  const vf one = splat(1.0f), half = splat(0.5f), zero = splat(0.0f);
  const vf mean = splat(w->weather.moss_mean);
  vm two = gt(e, splat(MOSS_ONE)), four = gt(e, splat(MOSS_TWO)), laid = gt(e, splat(MOSS_LAID));
  const int parts = any(four) ? 4 : any(two) ? 2 : 1, finds = paved && any(laid);
  vf share = sel(four, splat(0.25f), sel(two, half, one)), each = zero;
  field sum = field_of(zero);
  for (int i = 0; i < parts * parts; i++) {
    /* lanes of fewer parts have theirs in the first of these */
    vf along[2] = {splat((float)(i % parts)), splat((float)(i / parts))};
    vm there = and_(lt(along[0] * share, one), lt(along[1] * share, one));
    vf at[3], known = told;
    field by = near;
    for (int k = 0; k < 2; k++) along[k] = ((along[k] + half) * share - half) * e;
    for (int k = 0; k < 3; k++) {
      vf off = square->side[0][k] * along[0] + square->side[1][k] * along[1];
      at[k] = p[k] + off;
      by.v = by.v + near.g[k] * off;
    }
    by.v = clamp01(by.v);
    if (finds) {
      vf told_there, found = weather_near(w, at, square->n, e * share, &told_there);
      by.v = sel(laid, found, by.v);
      known = sel(laid, told_there, known);
    }
    field part = weather_moss_at(w, at, by, e * share);
    if (paved) {
      part.v = mix(mean, part.v, known);
      part = field_through(part, part.v, known);
    }
    sum.v = sel(there, sum.v + part.v, sum.v);
    for (int k = 0; k < 3; k++) sum.g[k] = sel(there, sum.g[k] + part.g[k], sum.g[k]);
    each = sel(there, each + one, each);
  }
  return field_scale(sum, one / each);
}

/* The same of what of the footprint is joint: there is more of it than between them. moss: of all.
 */
INLINE vf weather_moss_joint(const stone_constants *w, const vf p[3], vf moss, vf e) {
  vf one = splat(1.0f);
  vm wide = gt(e, splat(MOSS_ONE));
  if (!any(wide)) return moss;
  return sel(wide, vmax(weather_moss_at(w, p, field_of(one), e).v, moss), moss);
}

/* Light that water holds within a surface goes through it more than once:
 * Lekner and Dorf, Why some things are darker when wet, Appl. Opt. 27 (1988),
 * with the share that turns back at the film as 0.45. */
INLINE vf weather_wet_albedo(vf a, vf wet) {
  const vf back = splat(0.45f), one = splat(1.0f);
  vf dark = (one - back) * a / (one - back * vmin(a, one)); /* a stone's shade may lift it over 1 */
  return mix(a, dark, wet);
}

#endif
