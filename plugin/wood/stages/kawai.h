/* SPDX-License-Identifier: Apache-2.0
 *
 * Reflection after Kawai: a lobe that dives with the fibre over a diffuse rest, and a coat over
 * both.
 */
#ifndef SOZAI_WOOD_STAGES_KAWAI_H
#define SOZAI_WOOD_STAGES_KAWAI_H

#include "../cone.h"
#include "light.h"

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
  if (w->surface.relief) {
    /* slopes of the surface, alike in all directions: alpha^2 + 2 variance. The
     * lobe itself stays one of n >= 1, which is 0 where light comes from below */
    vf narrow = splat(2.0f) / (k->exponent + splat(2.0f)), wide = vmin(narrow + k->lost, one);
    vf lobe = vmin(wide, splat(2.0f / 3.0f));
    k->exponent = splat(2.0f) / lobe - splat(2.0f);
    k->strength = k->strength * (narrow / lobe);
    roughness = vmin(vsqrt(wide), one);
  }
  store_lanes(io, WOOD_SPECULAR, k, k->strength);
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
  vf v[3], one = splat(1.0f), coat2 = coat_alpha2(w, k);
  view_of(w, boards, io, k, v);
  vf ci = clamp01(k->incident);
  vf cr = clamp01(v[0] * k->nrm[0] + v[1] * k->nrm[1] + v[2] * k->nrm[2]);
  vf in = coat_through(w, ci, cone_refracted(w, ci));
  vf out = coat_through(w, cr, cone_refracted(w, cr));
  vf coat = coat_highlight(w, k->light, v, k->nrm, ci, cr, coat2);
  coat = sel(gt(cr, splat(0.0f)), coat, splat(0.0f));
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
    store_lit(io, k, c, r + gloss * splat(w->tint_colour[c]));
  }
}

#endif
