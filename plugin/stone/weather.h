/* SPDX-License-Identifier: Apache-2.0
 *
 * What weather does to a paving or a block: the noise that it goes by, and how wet stone looks.
 * Moss is in moss.h.
 */
#ifndef SOZAI_STONE_WEATHER_H
#define SOZAI_STONE_WEATHER_H

#include "../core/noise.h"
#include "field.h"

/* What a square's middle tells of the mean of a gradient noise over it, as a factor, least squares.
 * wide: the square's side over the noise's wavelength. To 0.02 up to 1, and 0 from NOISE_GONE on,
 * where it should be 0.16; measured over squares along its rows and aslant of them alike. */
#define NOISE_GONE 2.0f
INLINE vf weather_keep(vf wide, float gone) {
  vf x = wide * splat(1.0f / gone), left = vmax(splat(1.0f) - x * x, splat(0.0f));
  return left * left;
}

/* Gradient noise of a size as a field, faded out by the footprint; *lost gains
 * the variance that was. */
#define NOISE_VARIANCE 0.0365f /* gradient noise's own */
STAGE field weather_noise(const vf p[3], float frequency, uint32_t seed, float weight, vf e,
                          vf *lost) {
  vf f = splat(frequency);
  field n;
  vf keep = weather_keep(e * f, NOISE_GONE);
  *lost = *lost + splat(NOISE_VARIANCE * weight * weight) * (splat(1.0f) - keep * keep);
  if (!any(gt(keep, splat(0.0f)))) return field_of(splat(0.0f));
  n.v = noise_gradient3(p[0] * f, p[1] * f, p[2] * f, splatu(seed), n.g);
  for (int k = 0; k < 3; k++) n.g[k] = n.g[k] * f;
  return field_scale(n, keep * splat(weight));
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
