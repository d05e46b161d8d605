/* SPDX-License-Identifier: Apache-2.0
 *
 * Reflection after Kawai: a lobe that dives with the fibre over a diffuse rest, and a coat over
 * both.
 */
#ifndef SOZAI_WOOD_STAGES_KAWAI_H
#define SOZAI_WOOD_STAGES_KAWAI_H

#include "light.h"

/* The exponent of a lobe that slopes of that variance widen: alpha^2 + 2 variance. It stays one of
 * n >= 1, which is 0 where light comes from below. alpha2: of that. */
INLINE vf lobe_widened(vf exponent, vf slopes, vf *alpha2) {
  *alpha2 = splat(2.0f) / (exponent + splat(2.0f)) + slopes;
  return splat(2.0f) / vmin(*alpha2, splat(2.0f / 3.0f)) - splat(2.0f);
}

/* The lobe over the relief: of its gentle part and, lower and wider, of its steep one. A lobe's
 * height goes as its exponent + 2. */
INLINE void stage_lobe_relief(block *k, vf *roughness) {
  vf one = splat(1.0f), two = splat(2.0f), gentle, steep, share = k->lost->share;
  vf n = lobe_widened(k->exponent, slopes_sum(&k->lost->gentle), &gentle);
  vf n_steep = lobe_widened(k->exponent, slopes_within(k->lost), &steep);
  vf height = k->strength / (k->exponent + two);
  k->strength = (one - share) * height * (n + two);
  k->steep_strength = share * height * (n_steep + two);
  k->steep_power = n_steep / n;
  k->exponent = n;
  *roughness = vmin(vsqrt(gentle), one);
}

/* Figure, Kawai's equation (4): the lobe's normal dives with the fibre; slopes
 * that the footprint averages widen it instead. */
INLINE void stage_lobe(const wood_constants *w, int boards, const wood_io *io, block *k) {
  vf one = splat(1.0f);
  vf roughness = splat(w->roughness);
  k->exponent = splat(w->shininess);
  k->strength = splat(w->specular);
  if (boards) k->strength = k->strength * (one - k->board.unit.joint);
  vf variance = k->grain.variance + k->stem.lost_slope;
  vm widened = gt(variance * k->exponent, splat(1e-4f));
  if (any(widened)) {
    vf wide = one / (one + k->exponent * lost_towards_normal(k));
    wide = sel(widened, wide, one);
    k->exponent = k->exponent * wide;
    k->strength = k->strength * vsqrt(wide);
    roughness = vmin(vsqrt(splat(2.0f) / (k->exponent + splat(2.0f))), one);
  }
  if (w->surface.relief) stage_lobe_relief(k, &roughness);
  store_lanes(io, WOOD_SPECULAR, k,
              w->surface.relief ? k->strength + k->steep_strength : k->strength);
  store_lanes(io, WOOD_ROUGHNESS, k, roughness);
}

INLINE void stage_tilt(block *k) {
  vf cosine = vsqrt(vmax(splat(1.0f) - k->sine * k->sine, splat(0.0f)));
  k->tilted = clamp01(k->incident * cosine + k->rise * k->sine);
}

INLINE void stage_gloss(block *k) { k->power = power01_log2(k->tilted, k->exponent); }

/* The coat over Kawai's equation: what it reflects itself, and the share of the rest that it lets
 * in and out again. What lies in the joint has none. */
INLINE vf stage_coat(const wood_constants *w, int boards, const wood_io *io, const block *k,
                     vf *through) {
  vf v[3], one = splat(1.0f);
  view_of(w, boards, io, k, v);
  vf ci = clamp01(k->incident);
  vf cr = clamp01(v[0] * k->nrm[0] + v[1] * k->nrm[1] + v[2] * k->nrm[2]);
  vf in = coat_through(w, ci, cone_refracted(w, ci));
  vf out = coat_through(w, cr, cone_refracted(w, cr));
  vf coat = coat_highlight(w, k->light, v, k->nrm, w->surface.relief ? k->lost : NULL);
  *through = in * out;
  if (boards) {
    vf joint = k->board.unit.joint;
    coat = coat * (one - joint);
    *through = mix(*through, one, joint);
  }
  return coat;
}

INLINE void stage_radiance(const wood_constants *w, int boards, const wood_io *io, block *k) {
  vf zero = splat(0.0f);
  vf gloss = k->strength * exp2_(k->power);
  vf diffuse = splat(w->diffuse) * vmax(k->incident, zero);
  if (w->surface.relief) {
    gloss = gloss + k->steep_strength * exp2_(k->power * k->steep_power);
    diffuse = diffuse * slopes_lit(k->lost);
  }
  vf coat = zero;
  if (w->coat > 0.0f) {
    vf through;
    coat = stage_coat(w, boards, io, k, &through);
    gloss = gloss * through;
    diffuse = diffuse * through;
  }
  UNROLL(3)
  for (int c = 0; c < 3; c++) {
    vf r = diffuse * k->albedo[c];
    if (w->coat > 0.0f) r = r + coat;
    r = r + gloss * splat(w->tint_colour[c]);
    store_lit(io, k, c, w->surface.relief ? r * k->past : r);
  }
}

#endif
