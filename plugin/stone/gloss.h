/* SPDX-License-Identifier: Apache-2.0
 *
 * Light on stone: Lambert's below, and above it the surface's own reflection,
 * the microfacets of Walter et al., Microfacet models for refraction through
 * rough surfaces, EGSR 2007 (GGX), with Heitz's height-correlated masking (JCGT
 * 3.2, 2014) and Schlick's Fresnel term (CGF 13.3, 1994).
 */
#ifndef SOZAI_STONE_GLOSS_H
#define SOZAI_STONE_GLOSS_H

#include "../core/maths.h"

INLINE vf gloss_dot(const vf a[3], const vf b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

INLINE vf gloss_fresnel(vf at_normal, vf cosine) {
  vf x = splat(1.0f) - clamp01(cosine), x2 = x * x;
  return at_normal + (splat(1.0f) - at_normal) * (x2 * x2 * x);
}

/* pi f cos(l) of the surface's reflection, and what it leaves for the stone
 * below. n, l, v: unit. alpha2: GGX's alpha, squared. */
INLINE vf gloss_lobe(const vf n[3], const vf l[3], const vf v[3], vf alpha2, vf at_normal,
                     vf *below) {
  vf h[3], zero = splat(0.0f), one = splat(1.0f);
  for (int k = 0; k < 3; k++) h[k] = l[k] + v[k];
  vf k = inverse_root(vmax(gloss_dot(h, h), splat(1e-12f)));
  vf nl = clamp01(gloss_dot(n, l)), nv = vmax(gloss_dot(n, v), splat(1e-3f));
  vf nh = clamp01(gloss_dot(n, h) * k), vh = clamp01(gloss_dot(v, h) * k);
  vf d = nh * nh * (alpha2 - one) + one;
  d = alpha2 / vmax(d * d, splat(1e-12f)); /* pi D */
  vf rest = one - alpha2;
  vf mask = nl * vsqrt(nv * nv * rest + alpha2) + nv * vsqrt(nl * nl * rest + alpha2);
  *below = (one - gloss_fresnel(at_normal, nl)) * nl;
  vf lobe = splat(0.5f) * d * gloss_fresnel(at_normal, vh) * nl / vmax(mask, splat(1e-6f));
  return sel(gt(nl, zero), lobe, zero);
}

#endif
