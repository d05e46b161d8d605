/* SPDX-License-Identifier: Apache-2.0
 *
 * Spalting: thin black zone lines where colonies of fungi meet, and wood that
 * they have bleached on one side of them. Level sets of a noise drawn out along
 * the fibre; a point's distance from one is its value over its gradient.
 */
#ifndef SOZAI_WOOD_SPALT_H
#define SOZAI_WOOD_SPALT_H

#include "../core/noise.h"
#include "rays.h"

typedef struct {
  vf line, bleached; /* shares of the footprint */
} spalt_place;

#define SPALT_LONG 2.5f /* along the fibre, to a width of 1 */

/* n: the noise; inverse_steep: mm to a unit of it. */
INLINE vf spalt_line(vf n, vf inverse_steep, float level, vf half, vf e) {
  vf d = (n - splat(level)) * inverse_steep;
  return ray_overlap(d - e, d + e, half);
}

/* (x, z), y: the fibre's place in the reference section, and the height. */
INLINE spalt_place spalt_at(const wood_constants *w, vu own, vf x, vf y, vf z, vf s) {
  spalt_place p;
  vf one = splat(1.0f), f = splat(w->spalt_frequency);
  vf fade = smooth_step(splat(0.15f), splat(0.6f), s * f);
  p.line = splat(w->spalt_line_mean);
  p.bleached = splat(w->spalt_bleach_mean);
  if (!any(lt(fade, one))) return p;
  vf g[3], h[3], a = x * f, b = y * f * splat(1.0f / SPALT_LONG), c = z * f;
  vf two = splat(2.3f), weight = splat(0.4f), slope = splat(0.92f);
  vf n = noise_gradient3(a, b, c, wood_seed(w, own, SEED_SPALT), g);
  n = n + weight * noise_gradient3(a * two, b * two, c * two, wood_seed(w, own, SEED_SPALT + 1), h);
  vf steep2 = splat(1e-3f);
  for (int i = 0; i < 3; i++) {
    vf k = (g[i] + slope * h[i]) * splat(i == 1 ? 1.0f / SPALT_LONG : 1.0f);
    steep2 = steep2 + k * k;
  }
  vf inverse = inverse_root(steep2) * splat(w->spalt_size);
  /* thinner and thicker from place to place */
  vf half = splat(0.5f * w->spalt_width) * (one + splat(0.8f) * h[0] * splat(0.4f));
  half = vmax(half, splat(0.15f * w->spalt_width));
  vf e = vmax(splat(0.5f) * s, splat(0.02f));
  vf line = spalt_line(n, inverse, w->spalt_level, half, e) +
            spalt_line(n, inverse, w->spalt_other, half, e);
  vf d = (n - splat(w->spalt_level)) * inverse;
  vf pale = clamp01(d / (e + e) + splat(0.5f));
  /* most bleached by the line */
  pale = pale * (splat(0.55f) + splat(0.45f) * clamp01(one - d * f * splat(4.0f)));
  /* a mix by 1 may be a bit off: what a block skips must be what it would find */
  vm near = lt(fade, one);
  p.line = sel(near, mix(vmin(line, one), p.line, fade), p.line);
  p.bleached = sel(near, mix(pale, p.bleached, fade), p.bleached);
  return p;
}

#endif
