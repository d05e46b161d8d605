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

/* Share of moss. `near`: 1 in the joint, 0 at moss_spread from it. *tuft: its
 * light and dark; *hue: from lush, 0, to dry, 1. */
INLINE field weather_moss(const stone_constants *w, const vf p[3], field near, vf e, vf *tuft,
                          vf *hue) {
  const stone_weather *v = &w->weather;
  vf lost = splat(0.0f);
  float size = v->moss_spread > 8.0f ? v->moss_spread : 8.0f;
  field n = weather_noise(p, 0.06f / size, v->seed, 1.9f, e, &lost);
  n = field_add(n, weather_noise(p, 0.31f / size, v->seed + 1u, 1.0f, e, &lost));
  n = field_add(n, weather_noise(p, 0.085f, v->seed + 7u, 0.85f, e, &lost));
  n = field_add(n, weather_noise(p, 0.33f, v->seed + 2u, 0.55f, e, &lost));
  vf unused = splat(0.0f);
  field fine = weather_noise(p, 0.9f, v->seed + 3u, 1.0f, e, &unused);
  *tuft = fine.v;
  vf patch = weather_noise(p, 0.021f, v->seed + 4u, 1.2f, e, &unused).v;
  *hue = clamp01(splat(0.35f) + patch + splat(0.5f) * fine.v);
  n = field_add(n, field_scale(fine, splat(0.2f)));
  /* where it begins: deep and wide joints shelter it */
  const stone_paving *l = &w->paving;
  float deep = l->depth / (l->depth + 4.0f), wide = l->half / (l->half + 3.0f);
  n = field_add(n, field_scale(near, splat(0.75f + 0.5f * deep + 0.4f * wide)));
  vf soft = vsqrt(splat(0.0144f) + splat(3.0f) * lost);
  n.v = n.v - splat(1.35f - 1.5f * v->moss);
  return field_step(n, splat(0.0f) - soft, soft);
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
