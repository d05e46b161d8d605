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
 *   wavy         D = A lambda / 2 pi (p (1 - cos psi) + q sin psi), psi = 2 pi y /
 *                lambda, p = 1, q = 0; irregular, psi strays and p and q are noises
 *                of (y, t): waves fork and end where both are zero
 *   interlocked  D = g sin(2 pi t / years) sin(k y) / k: the slope's sign
 *                alternates with the year of formation; the long wave in y
 *                bounds the shear between neighbouring years. Irregular, both
 *                phases and g are noises of t
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

/* The wave's phase, in turns, and its slopes in radians; its amplitude in phase and
 * out of it. */
typedef struct {
  vf psi, y, t;
  vf in, in_y, in_t, out, out_y, out_t;
} wave_phase;

/* Two value noises of one lattice, from the halves of one hash, within +-1. */
INLINE void grain_swell(const noise_axis *y, const noise_axis *t, vu seed, vf n[2], vf dy[2],
                        vf dt[2]) {
  vf k = splat(1.0f / 32768.0f), v[2][4];
  for (int c = 0; c < 4; c++) {
    vu h = hash_upper(seed + (c & 1 ? y->high : y->low) + (c & 2 ? t->high : t->low));
    v[0][c] = to_float((vi)h >> 16) * k;
    v[1][c] = to_float((vi)(h << 11) >> 16) * k;
  }
  for (int j = 0; j < 2; j++) {
    vf a = v[j][1] - v[j][0], b = v[j][3] - v[j][2];
    vf low = v[j][0] + a * y->w, high = v[j][2] + b * y->w;
    n[j] = low + (high - low) * t->w;
    dy[j] = mix(a, b, t->w) * y->dw;
    dt[j] = (high - low) * t->dw;
  }
}

/* Of an irregular wave. */
INLINE wave_phase wave_at(const wood_constants *w, vu own, vf y, vf t) {
  wave_phase q;
  const wood_irregular *r = &w->wave;
  noise_stem ay = noise_split_axial(y * splat(r->stray_frequency), HASH_Y);
  vf f = splat(w->wave_inverse_reach / CURL_STRAY_REACH), g = splat(w->wave_inverse_reach);
  noise_axis at = noise_split_cubic(t * f, HASH_X);
  vf ny, nt, n = noise_axial2(&ay, &at, wood_seed(w, own, SEED_WAVE), &ny, &nt);
  float turns = r->stray * 6.2831853f;
  q.psi = y * splat(w->wave_frequency) + splat(r->stray) * n;
  q.y = splat(w->wave_number) + splat(turns * r->stray_frequency) * ny;
  q.t = splat(turns) * f * nt;

  vf v[2], vy[2], vt[2], swell = splat(r->swell);
  noise_axis by = noise_split_cubic(y * splat(r->swell_frequency), HASH_Y);
  noise_axis bt = noise_split_cubic(t * g, HASH_X);
  grain_swell(&by, &bt, wood_seed(w, own, SEED_WAVE_SWELL), v, vy, vt);
  vf sy = splat(r->swell * r->swell_frequency), st = swell * g;
  q.in = splat(r->steady) + swell * v[0];
  q.in_y = sy * vy[0];
  q.in_t = st * vt[0];
  q.out = swell * v[1];
  q.out_y = sy * vy[1];
  q.out_t = st * vt[1];
  return q;
}

INLINE void grain_wave(const wood_constants *w, const wave_phase *q, vf extent, grain_place *p) {
  vf sine, cosine, one = splat(1.0f), a = splat(w->wave_displacement);
  sine_cosine_turns(q->psi, &sine, &cosine);
  vf lift = one - cosine, turn = q->in * sine + q->out * cosine;
  p->d = p->d + a * (q->in * lift + q->out * sine);
  /* what is left where the wave's own turns have been averaged */
  vf slow = a * q->in_y, slope = a * (turn * q->y + q->out_y * sine - q->in_y * cosine);
  vf keep = filter_wave(extent * q->y, 0.15915494f);
  vf power = q->in * q->in + q->out * q->out, wide = splat(w->wave.power);
  p->g = p->g + (slope + slow);
  p->g_filtered = p->g_filtered + (slope * keep + slow);
  p->d_t = p->d_t + a * (turn * q->t + q->in_t * lift + q->out_t * sine);
  power = mix(wide, power, keep);
  p->variance = splat(0.5f * w->wave_slope * w->wave_slope) * power * (one - keep * keep);
}

/* Of a regular wave: its amplitude is 1, in phase, everywhere. */
INLINE void grain_wave_even(const wood_constants *w, vf y, vf extent, grain_place *p) {
  vf sine, cosine, one = splat(1.0f);
  sine_cosine_turns(y * splat(w->wave_frequency), &sine, &cosine);
  vf slope = splat(w->wave_displacement) * (sine * splat(w->wave_number));
  vf keep = filter_wave(extent * splat(w->wave_number), 0.15915494f);
  p->d = p->d + splat(w->wave_displacement) * (one - cosine);
  p->g = p->g + slope;
  p->g_filtered = p->g_filtered + slope * keep;
  p->variance = splat(0.5f * w->wave_slope * w->wave_slope) * (one - keep * keep);
}

/* A year's own part of interlocked grain: strength, phase, and where along the long wave it begins,
 * with their slopes over the year. */
typedef struct {
  vf a, a_t, psi_t, st, ct;  /* the phase by its sine and cosine, and in turns a year */
  vf begin, begin_t, sb, cb; /* turns */
  int irregular;
} interlocked_year;

INLINE interlocked_year grain_interlocked_year(const wood_constants *w, vu own, vf t,
                                               noise_held *held) {
  interlocked_year q;
  vf zero = splat(0.0f), psi = t * splat(w->interlocked_frequency);
  q.psi_t = splat(w->interlocked_frequency);
  q.a = splat(w->interlocked_slope);
  q.a_t = q.begin = q.begin_t = q.sb = zero;
  q.cb = splat(1.0f);
  q.irregular = w->interlocked_irregularity > 0.0f;
  if (q.irregular) {
    float much = w->interlocked_irregularity;
    vf n[3], slope[3], f = splat(w->interlocked_frequency * 1.13f);
    noise_axis at = noise_split_cubic(t * f, HASH_X);
    noise_value1_thrice(&at, wood_seed(w, own, SEED_RIBBON), held, n, slope);
    vf k = splat(0.45f / HASH_ONE * much);
    psi = psi + k * n[0];
    q.psi_t = q.psi_t + k * f * slope[0];
    vf fade = splat(0.35f / HASH_ONE * much) * q.a;
    q.a = q.a + fade * n[1];
    q.a_t = fade * f * slope[1];
    vf turns = splat(0.2f / HASH_ONE * much);
    q.begin = turns * n[2];
    q.begin_t = turns * f * slope[2];
    sine_cosine_turns(q.begin, &q.sb, &q.cb);
  }
  sine_cosine_turns(psi, &q.st, &q.ct);
  return q;
}

/* Its displacement at a height, over the year's sine; cy: the long wave's cosine there. */
INLINE vf interlocked_along(const wood_constants *w, const interlocked_year *q, vf y, vf *cy) {
  vf sy, turns = y * splat(1.0f / w->interlocked_length);
  sine_cosine_turns(q->irregular ? turns + q->begin : turns, &sy, cy);
  return (q->irregular ? sy - q->sb : sy) * splat(w->interlocked_length * 0.15915494f);
}

/* How that changes with the year, mm. */
INLINE vf interlocked_by_year(const wood_constants *w, const interlocked_year *q, vf along, vf cy) {
  vf length = splat(w->interlocked_length * 0.15915494f), tau = splat(6.2831853f);
  vf slope = q->a * along * q->ct * (tau * q->psi_t);
  if (!q->irregular) return slope;
  return slope + q->st * (q->a_t * along + q->a * (cy - q->cb) * length * tau * q->begin_t);
}

INLINE void grain_interlocked(const wood_constants *w, const interlocked_year *q, vf y,
                              grain_place *p) {
  vf cy, along = interlocked_along(w, q, y, &cy);
  p->d = p->d + q->a * along * q->st;
  vf slope = q->a * cy * q->st;
  p->g = p->g + slope;
  p->g_filtered = p->g_filtered + slope;
  p->d_t = p->d_t + interlocked_by_year(w, q, along, cy);
}

/* What an octave of the slope's noise has of the wood; see fibre_octave. */
typedef struct {
  vf often, far, steep, years, touches, variance;
  vu seed;
  float size;
} grain_octave;

INLINE grain_octave grain_octave_of(const wood_constants *w, int o) {
  float steep = w->slope_noise[o] * w->slope_noise_frequency[o];
  return (grain_octave){.often = splat(w->slope_noise_frequency[o]),
                        .far = splat(w->slope_noise[o]),
                        .steep = splat(steep),
                        .years = splat(w->slope_noise[o] * w->slope_noise_years),
                        .touches = splat(0.5f * w->slope_noise_size[o]),
                        .variance = splat(0.3f * steep * steep),
                        .seed = splatu(w->seeds[SEED_SLOPE + o]),
                        .size = w->slope_noise_size[o]};
}

INLINE void grain_noise(const grain_octave *q, vu own, vf y, const noise_axis *at, vf extent,
                        noise_held *held, grain_place *p) {
  noise_stem ay = noise_split_axial(y * q->often, HASH_Y);
  vf ny, nt, n = noise_axial2_held(&ay, at, q->seed + own, held, &ny, &nt);
  vf slope = q->steep * ny;
  p->d = p->d + q->far * n;
  p->g = p->g + slope;
  p->d_t = p->d_t + q->years * nt;
  if (any(gt(extent, q->touches))) {
    vf keep = filter_keep(extent, q->size);
    slope = slope * keep;
    /* the slope's variance is about 0.3 of its scale's square, measured */
    p->variance = p->variance + q->variance * (splat(1.0f) - keep * keep);
  }
  p->g_filtered = p->g_filtered + slope;
}

/* 1 / Rmean(t) for the phase: bounded at the pith. */
INLINE vf grain_divisor(vf rho) { return inverse_root(rho * rho + splat(1.0f)); }

#endif
