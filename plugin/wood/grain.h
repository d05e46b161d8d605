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

/* The kinds one after another, so that the kernel can take a few blocks
 * through each. extent: mm, of the footprint along y. */
INLINE grain_place grain_spiral(const wood_constants *w, vf y) {
  grain_place p;
  p.d = splat(w->spiral) * y;
  p.g = p.g_filtered = splat(w->spiral);
  p.d_t = p.variance = splat(0.0f);
  return p;
}

/* at: the year among those that slopes vary over */
INLINE noise_axis grain_years(const wood_constants *w, vf t) {
  return noise_split_cubic(t * splat(w->slope_noise_years), HASH_X);
}

/* The wave's phase, in turns, and its slopes. */
typedef struct {
  vf psi, y, t;
} wave_phase;

INLINE wave_phase wave_at(const wood_constants *w, vu own, vf y, const noise_axis *at) {
  wave_phase q = {y * splat(w->wave_frequency), splat(w->wave_number), splat(0.0f)};
  if (w->has_wave_irregularity) {
    noise_stem ay = noise_split_axial(y * splat(w->wave_irregularity_frequency), HASH_Y);
    vf ny, nt, n = noise_axial2(&ay, at, wood_seed(w, own, SEED_WAVE), &ny, &nt);
    q.psi = q.psi + splat(w->wave_irregularity * 0.15915494f) * n;
    q.y = q.y + splat(w->wave_irregularity * w->wave_irregularity_frequency) * ny;
    q.t = splat(w->wave_irregularity * w->slope_noise_years) * nt;
  }
  return q;
}

INLINE void grain_wave(const wood_constants *w, const wave_phase *q, vf extent, grain_place *p) {
  vf sine, cosine, a = splat(w->wave_displacement);
  sine_cosine_turns(q->psi, &sine, &cosine);
  p->d = p->d + a * (splat(1.0f) - cosine);
  vf slope = a * sine * q->y;
  vf keep = filter_wave(extent, w->wave_frequency);
  p->g = p->g + slope;
  p->g_filtered = p->g_filtered + slope * keep;
  p->d_t = p->d_t + a * sine * q->t;
  p->variance = splat(0.5f * w->wave_slope * w->wave_slope) * (splat(1.0f) - keep * keep);
}

INLINE void grain_interlocked(const wood_constants *w, vf y, vf t, grain_place *p) {
  vf st, ct, sy, cy;
  sine_cosine_turns(t * splat(w->interlocked_frequency), &st, &ct);
  sine_cosine_turns(y * splat(1.0f / w->interlocked_length), &sy, &cy);
  vf a = splat(w->interlocked_slope);
  vf reach = a * sy * splat(w->interlocked_length * 0.15915494f);
  p->d = p->d + reach * st;
  vf slope = a * cy * st;
  p->g = p->g + slope;
  p->g_filtered = p->g_filtered + slope;
  p->d_t = p->d_t + reach * ct * splat(6.2831853f * w->interlocked_frequency);
}

INLINE void grain_noise(const wood_constants *w, vu own, int o, vf y, const noise_axis *at,
                        vf extent, grain_place *p) {
  noise_stem ay = noise_split_axial(y * splat(w->slope_noise_frequency[o]), HASH_Y);
  vf ny, nt, n = noise_axial2(&ay, at, wood_seed(w, own, SEED_SLOPE + (uint32_t)o), &ny, &nt);
  float scale = w->slope_noise[o] * w->slope_noise_frequency[o];
  vf slope = splat(scale) * ny;
  p->d = p->d + splat(w->slope_noise[o]) * n;
  p->g = p->g + slope;
  p->d_t = p->d_t + splat(w->slope_noise[o] * w->slope_noise_years) * nt;
  if (filter_touches(extent, w->slope_noise_size[o])) {
    vf keep = filter_keep(extent, w->slope_noise_size[o]);
    slope = slope * keep;
    /* the slope's variance is about 0.3 of its scale's square, measured */
    p->variance = p->variance + splat(0.3f * scale * scale) * (splat(1.0f) - keep * keep);
  }
  p->g_filtered = p->g_filtered + slope;
}

/* 1 / Rmean(t) for the phase: bounded at the pith. */
INLINE vf grain_divisor(vf rho) { return inverse_root(rho * rho + splat(1.0f)); }

#endif
