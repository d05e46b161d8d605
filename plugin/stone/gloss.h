/* SPDX-License-Identifier: Apache-2.0
 *
 * Light on stone: Lambert's below, and above it the surface's own reflection,
 * the microfacets of Walter et al., Microfacet models for refraction through
 * rough surfaces, EGSR 2007 (GGX), with Heitz's height-correlated masking (JCGT
 * 3.2, 2014) and Schlick's Fresnel term (CGF 13.3, 1994).
 */
#ifndef SOZAI_STONE_GLOSS_H
#define SOZAI_STONE_GLOSS_H

#include "../core/vectors.h"

INLINE vf gloss_fresnel(vf at_normal, vf cosine) {
  vf x = splat(1.0f) - clamp01(cosine), x2 = x * x;
  return at_normal + (splat(1.0f) - at_normal) * (x2 * x2 * x);
}

/* What of the light is reflected, of slopes that the footprint averages out: those that lean to the
 * light have most of it, and it glances less than off what is level. */
INLINE vf gloss_fresnel_mean(vf at_normal, vf cosine, vf leans) {
  vf square = cosine * cosine;
  square = square + leans * (splat(1.0f) - square);
  return gloss_fresnel(at_normal, vsqrt(square));
}

/* pi f cos(l) of the surface's reflection, and what it leaves for the stone
 * below. n, l, v: unit. alpha2: GGX's alpha, squared. leans: variance of slopes that the
 * footprint averages out and that lean so. */
INLINE vf gloss_lobe(const vf n[3], const vf l[3], const vf v[3], vf alpha2, vf at_normal, vf leans,
                     vf *below) {
  vf h[3], zero = splat(0.0f), one = splat(1.0f);
  for (int k = 0; k < 3; k++) h[k] = l[k] + v[k];
  vf k = inverse_root(vmax(dot3(h, h), splat(1e-12f)));
  vf nl = clamp01(dot3(n, l)), nv = vmax(dot3(n, v), splat(1e-3f));
  vf nh = clamp01(dot3(n, h) * k), vh = clamp01(dot3(v, h) * k);
  vf d = nh * nh * (alpha2 - one) + one;
  d = alpha2 / vmax(d * d, splat(1e-12f)); /* pi D */
  vf rest = one - alpha2;
  vf mask = nl * vsqrt(nv * nv * rest + alpha2) + nv * vsqrt(nl * nl * rest + alpha2);
  *below = (one - gloss_fresnel_mean(at_normal, nl, leans)) * nl;
  vf lobe = splat(0.5f) * d * gloss_fresnel(at_normal, vh) * nl / vmax(mask, splat(1e-6f));
  return sel(gt(nl, zero), lobe, zero);
}

#endif
