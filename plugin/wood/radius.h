/* SPDX-License-Identifier: Apache-2.0
 *
 * What is asked of a kernel beside points' wood: the radius that a year has, and where the pith is.
 */
#ifndef SOZAI_WOOD_RADIUS_H
#define SOZAI_WOOD_RADIUS_H

#include "../core/lanes.h"
#include "figure.h"
#include "rings.h"

/* R(t, theta, y): rho of the year from the table, then the radius whose rho it
 * is, by Newton's method from above, where the field is all but linear. */
static void ring_radius(const wood_constants *w, uint32_t count, const float *t, const float *theta,
                        const float *y, float *out) {
  for (uint32_t i = 0; i < count; i += LANES) {
    uint32_t n = count - i < LANES ? count - i : LANES;
    vf years = clamp(finite_coordinate(load_lanes(t, i, n)), splat(0.0f), splat(1e5f));
    vf height = finite_coordinate(load_lanes(y, i, n));
    vf angle = load_lanes(theta, i, n);
    angle = sel(lt(vabs(angle), splat(1e4f)), angle, splat(0.0f));
    vf s, c, unused;
    sine_cosine(angle, &s, &c);
    vi whole;
    vf phase = years - vfloor(years, &whole);
    vi turns;
    vfloor(to_float(whole) * splat(1.0f / WOOD_RINGS), &turns);
    vi j = whole - turns * splati(WOOD_RINGS);
    vf rho = to_float(turns) * splat(w->ring_period) + gather(w->start, j) +
             phase / gather(w->inverse_width, j);
    stem_pith pith = pith_at(w, splatu(0), height, NULL);
    vf r = rho * (splat(1.0f) + outline_at(w, c, s, &unused));
    for (int k = 0; k < 8; k++) {
      stem_place p = stem_with_figure(w, r * c + pith.x, height, r * s + pith.z);
      vf slope = vmax(p.rho_x * p.c + p.rho_z * p.s, splat(0.2f));
      r = vmax(r + (rho - p.rho) / slope, splat(0.0f));
    }
    for (uint32_t k = 0; k < n; k++) out[i + k] = lane(r, k);
  }
}

static void pith(const wood_constants *w, uint32_t count, const float *y, float *out_x,
                 float *out_z) {
  for (uint32_t i = 0; i < count; i += LANES) {
    uint32_t n = count - i < LANES ? count - i : LANES;
    stem_pith p = pith_at(w, splatu(0), finite_coordinate(load_lanes(y, i, n)), NULL);
    for (uint32_t k = 0; k < n; k++) {
      out_x[i + k] = lane(p.x, k);
      out_z[i + k] = lane(p.z, k);
    }
  }
}

#endif
