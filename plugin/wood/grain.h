/* SPDX-License-Identifier: Apache-2.0
 *
 * Grain: the slope G = r dtheta/dy of the fibres, and the phase
 * phi = D(y, t) / Rmean(t) by which they have turned since y = 0.
 *
 * Kawai's equations (1) to (3), with the ring's mean radius in the divisor:
 * along a fibre t is constant and theta is not, so that dividing by R(t,
 * theta) held fixed, as printed, would not be an integral of the field. The
 * sum of displacements D is given in closed form and G is its derivative:
 *
 *   spiral       D = g1 y
 *   wavy         D = A lambda / 2 pi (1 - cos psi), psi = 2 pi y / lambda + irregularity
 *   interlocked  D = g sin(2 pi t / years) sin(k y) / k: the slope's sign
 *                alternates with the year of formation; the long wave in y
 *                bounds the shear between neighbouring years
 *   variation    D = fractal noise in (y, t) whose slope is bounded
 *
 * D(0, t) = 0 for each.
 */
#ifndef SOZAI_WOOD_GRAIN_H
#define SOZAI_WOOD_GRAIN_H

#include "stem.h"

typedef struct {
  vf d;          /* mm: displacement along the arc */
  vf g;          /* slope, without what the footprint swallows */
  vf g_filtered; /* slope averaged over the footprint */
  vf d_t;        /* mm per year */
  vf variance;   /* of the slope, lost in the average */
} grain_place;

/* extent: mm, of the footprint along y. */
INLINE grain_place grain_at(const wood_constants *w, vu own, vf y, vf t, vf extent) {
  grain_place p;
  vf zero = splat(0.0f);
  p.d = splat(w->spiral) * y;
  p.g = p.g_filtered = splat(w->spiral);
  p.d_t = p.variance = zero;
  if (w->has_wave) {
    vf psi = y * splat(w->wave_frequency); /* in turns */
    vf psi_y = splat(w->wave_number), psi_t = zero;
    if (w->has_wave_irregularity) {
      noise_stem ay = noise_split_axial(y * splat(w->wave_irregularity_frequency), HASH_Y);
      noise_axis at = noise_split_cubic(t * splat(w->slope_noise_years), HASH_X);
      vf ny, nt, n = noise_axial2(&ay, &at, wood_seed(w, own, SEED_WAVE), &ny, &nt);
      vf k = splat(w->wave_irregularity);
      psi = psi + k * splat(0.15915494f) * n;
      psi_y = psi_y + k * splat(w->wave_irregularity_frequency) * ny;
      psi_t = k * splat(w->slope_noise_years) * nt;
    }
    vf sine, cosine, a = splat(w->wave_displacement);
    sine_cosine_turns(psi, &sine, &cosine);
    p.d = p.d + a * (splat(1.0f) - cosine);
    vf slope = a * sine * psi_y;
    vf keep = filter_wave(extent, w->wave_frequency);
    p.g = p.g + slope;
    p.g_filtered = p.g_filtered + slope * keep;
    p.d_t = p.d_t + a * sine * psi_t;
    p.variance = splat(0.5f * w->wave_slope * w->wave_slope) * (splat(1.0f) - keep * keep);
  }
  if (w->has_interlocked) {
    vf st, ct, sy, cy;
    sine_cosine_turns(t * splat(w->interlocked_frequency), &st, &ct);
    sine_cosine_turns(y * splat(1.0f / w->interlocked_length), &sy, &cy);
    vf a = splat(w->interlocked_slope);
    vf reach = a * sy * splat(w->interlocked_length * 0.15915494f);
    p.d = p.d + reach * st;
    vf slope = a * cy * st;
    p.g = p.g + slope;
    p.g_filtered = p.g_filtered + slope;
    p.d_t = p.d_t + reach * ct * splat(6.2831853f * w->interlocked_frequency);
  }
  if (w->has_slope_noise) {
    noise_axis at = noise_split_cubic(t * splat(w->slope_noise_years), HASH_X);
    for (int o = 0; o < 2; o++) {
      vf f = splat(w->slope_noise_frequency[o]), a = splat(w->slope_noise[o]);
      noise_stem ay = noise_split_axial(y * f, HASH_Y);
      vf ny, nt, n = noise_axial2(&ay, &at, wood_seed(w, own, SEED_SLOPE + (uint32_t)o), &ny, &nt);
      vf keep = filter_keep(extent, w->slope_noise_size[o]);
      vf slope = splat(w->slope_noise[o] * w->slope_noise_frequency[o]) * ny;
      p.d = p.d + a * n;
      p.g = p.g + slope;
      p.g_filtered = p.g_filtered + slope * keep;
      p.d_t = p.d_t + splat(w->slope_noise[o] * w->slope_noise_years) * nt;
      /* the slope's variance is about 0.3 of its scale's square, measured */
      float scale = w->slope_noise[o] * w->slope_noise_frequency[o];
      p.variance = p.variance + splat(0.3f * scale * scale) * (splat(1.0f) - keep * keep);
    }
  }
  return p;
}

/* 1 / Rmean(t) for the phase: bounded at the pith. */
INLINE vf grain_divisor(vf rho) { return inverse_root(rho * rho + splat(1.0f)); }

#endif
