/* SPDX-License-Identifier: Apache-2.0
 *
 * Heartwood and sapwood: the boundary follows the year rings, but not quite;
 * it strays by some years round the stem, and the grain carries it.
 */
#ifndef SOZAI_WOOD_HEART_H
#define SOZAI_WOOD_HEART_H

#include "stem.h"

/* The integral of a ramp from 0 to 1 over the unit about 0. */
INLINE vf heart_ramp(vf x) {
  vf half = splat(0.5f), t = clamp01(x + half);
  return half * t * t + vmax(x - half, splat(0.0f));
}

/* Share of heartwood over the footprint. (c, s): direction in the reference
 * section. span: years that the footprint spans along rho. */
INLINE vf heart_share(const wood_constants *w, vf years, vf c, vf s, vf span) {
  vf one = splat(1.0f);
  vf far = splat(w->heart_stray) + splat(0.5f) * (span + splat(w->heart_edge));
  if (!any(gt(years + far, splat(w->heart_years)))) return one; /* what the ramp would give */
  vf c2 = c * c - s * s, s2 = splat(2.0f) * s * c;
  vf c3 = c2 * c - s2 * s, s3 = s2 * c + c2 * s;
  const float *a = w->heart_cos, *b = w->heart_sin;
  vf stray = (splat(a[0]) * c + splat(b[0]) * s) + (splat(a[1]) * c2 + splat(b[1]) * s2) +
             (splat(a[2]) * c3 + splat(b[2]) * s3);
  /* the ramp's mean over the footprint */
  vf per = splat(1.0f / w->heart_edge), side = vmax(span * per, splat(0.02f)),
     out = splat(0.5f) * side;
  vf in = (splat(w->heart_years) + stray - years) * per;
  vf h = clamp01((heart_ramp(in + out) - heart_ramp(in - out)) / side);
  return sel(gt(years + far, splat(w->heart_years)), h, one);
}

#endif
