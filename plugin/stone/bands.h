/* SPDX-License-Identifier: Apache-2.0
 *
 * What varies slowly in stone: beds and mottle.
 */
#ifndef SOZAI_STONE_BANDS_H
#define SOZAI_STONE_BANDS_H

#include "../core/filter.h"
#include "../core/noise.h"
#include "../core/vectors.h"
#include "stone.h"
#include "value.h"

/* How far towards the other bed at a height: 0..1, mean 1/2. e: mm, of what is wider is left out.
 */
INLINE vf bed_at(const stone_constants *w, vf y, vf e) {
  static const float weight[3] = {0.4f, 0.36f, 0.24f}, finer[3] = {0.37f, 1.0f, 2.9f};
  vf share = splat(0.5f), unused;
  for (int o = 0; o < 3; o++) {
    float f = w->bed_frequency * finer[o];
    vf keep = filter_keep(e, 1.0f / f) * splat(0.9f * weight[o] / HASH_ONE);
    noise_axis a = noise_split(y * splat(f), HASH_Y);
    share = share + keep * noise_value1(&a, splatu(w->seed_bed + (uint32_t)o), &unused);
  }
  return clamp01(share); /* an even clamp keeps the mean */
}

#define BEDS_WIDE 1.5f     /* beds: a footprint across more is seen in eight parts, */
#define BEDS_WIDER 6.0f    /* and across more in sixteen */
#define BEDS_THIN 0.085f   /* one across less in one: a quarter of the finest noise's lattice */
#define BEDS_LAG_NEAR 0.1f /* of a wave's lattice: no further up its slope tells how it lags */
#define BEDS_FINER 2.7f    /* the lesser of the two waves: its frequency over the other's, */
#define BEDS_LESSER 0.4f   /* and its height */

/* Whether a wave that lags is another so far up and down. */
INLINE vm beds_far(vf reach, float frequency, float lag) {
  return gt(reach * splat(__builtin_fabsf(lag) * frequency), splat(BEDS_LAG_NEAR));
}

/* A wave of the beds that a footprint so wide sees: its height, and what it adds to `slope`, the
 * less of it the more of the wave there is; and the square of how far up and down that lies, as
 * an even spread. reach: how far the footprint goes up and down, or NULL where the wave lags too
 * little for that to matter: what it is at those two places tells where the beds there are. */
INLINE vf beds_rise(const vf p[3], float wave, float frequency, float lag, uint32_t seed, vf s,
                    const vf *reach, vf slope[3], vf *within2) {
  vf one = splat(1.0f), d[2], keep = one / (one + splat(frequency) * s), gone = one - keep;
  vf y = beds_wave(p, wave, frequency, lag, seed, d), upward = splat(lag) * d[0];
  if (reach) {
    const vf up[3] = {p[0], p[1] + *reach, p[2]}, down[3] = {p[0], p[1] - *reach, p[2]};
    vf unused[2], half = splat(0.5f);
    vf a = beds_wave(up, wave, frequency, lag, seed, unused);
    vf b = beds_wave(down, wave, frequency, lag, seed, unused);
    vm far = beds_far(*reach, frequency, lag);
    upward = sel(far, half * (a - b) / *reach, upward);
    y = sel(far, half * (a + b), y);
  }
  for (int k = 0; k < 2; k++) slope[k] = slope[k] + keep * d[k];
  slope[2] = slope[2] + upward;
  *within2 = *within2 + splat(12.0f * 0.224f * 0.224f * wave * wave) * gone * gone;
  return y;
}

/* The same over the footprint, in four parts across the beds, or eight, sixteen or one. A layer of
 * sediment lies over the last at the same height everywhere but for slow waves: value noise across
 * the beds, at three sizes. The footprint's extent across is that of the plane that the beds are
 * about its middle. */
STAGE vf bed_share(const stone_constants *w, const vf p[3], const vf nrm[3], vf s) {
  vf y = p[1], zero = splat(0.0f), one = splat(1.0f), sum = zero, extent2 = zero, side;
  vf away[2] = {zero, zero};
  vf slope[3] = {zero, zero, one}; /* along x, z and y */
  if (w->bed_wave != 0.0f) {
    const float f = w->bed_wave_frequency, finer = BEDS_FINER * f, lag = w->bed_lag;
    const vf turned[3] = {p[2], p[1], p[0]}, *reach = NULL;
    vf lesser[3] = {zero, zero, zero}, half;
    if (lag > 0.0f) {
      half = splat(0.5f) * s * vsqrt(vmax(one - nrm[1] * nrm[1], splat(0.01f)));
      if (any(beds_far(half, finer, lag))) reach = &half;
    }
    y = y + beds_rise(p, w->bed_wave, f, lag, w->seed_bed + 7u, s, reach, slope, &extent2);
    y = y + beds_rise(turned, BEDS_LESSER * w->bed_wave, finer, -lag, w->seed_bed + 8u, s, reach,
                      lesser, &extent2);
    for (int k = 0; k < 2; k++) slope[k] = slope[k] + lesser[1 - k];
    slope[2] = slope[2] + lesser[2];
  }
  vf into = slope[2] * nrm[1] + slope[0] * nrm[0] + slope[1] * nrm[2];
  vf lean2 = slope[2] * slope[2] + slope[0] * slope[0] + slope[1] * slope[1] - into * into;
  vf e = splat(0.25f) * vsqrt(vmax(s * s * lean2, zero) + extent2);
  side = e;
  vm wide = gt(e * splat(w->bed_frequency), splat(0.25f * BEDS_WIDE));
  vm wider = gt(e * splat(w->bed_frequency), splat(0.25f * BEDS_WIDER));
  vm thin = lt(e * splat(4.0f * w->bed_frequency), splat(BEDS_THIN));
  const int parts = any(wider) ? 4 : any(wide) ? 2 : 1;
  vf whole = zero;
  if (any(thin)) {
    whole = bed_at(w, y, splat(4.0f) * e);
    if (!any(not_(thin))) return whole;
  }
  if (parts > 1) {
    side = sel(wider, splat(0.25f) * e, sel(wide, splat(0.5f) * e, e));
    away[0] = sel(wide, splat(0.25f) * e, zero);
    away[1] = sel(wider, splat(0.125f) * e, zero);
  }
  for (int i = 0; i < 4; i++) {
    vf at = y + (splat((float)i) - splat(1.5f)) * e, part[4] = {zero, zero, zero, zero};
    for (int k = 0; k < parts; k++) {
      vf on = k & 1 ? at + away[0] : at - away[0];
      if (parts > 2) on = k & 2 ? on + away[1] : on - away[1];
      part[k] = bed_at(w, parts > 1 ? on : at, side);
    }
    if (parts == 2) part[0] = splat(0.5f) * (part[0] + part[1]);
    if (parts > 2) part[0] = splat(0.25f) * ((part[0] + part[1]) + (part[2] + part[3]));
    sum = sum + splat(0.25f) * part[0];
  }
  return sel(thin, whole, sum);
}

/* What a place's mottle is: clouds of three sizes, of which a footprint's middle knows less
 * and less as it grows to two and a half of theirs. Aslant, so that no face shows their
 * rows. */
INLINE vf mottle_at(const stone_constants *w, const vf p[3], vf s) {
  vf sum = splat(0.0f);
  float f = w->mottle_frequency, weight = w->mottle * (0.224f / VALUE_SD / HASH_ONE);
  for (uint32_t o = 0; o < 3; o++) {
    vf left = clamp01(splat(2.5f / 2.4f) - splat(f / 2.4f) * s), at[3];
    if (!any(gt(left, splat(0.0f)))) break;
    for (int k = 0; k < 3; k++) {
      const float by = 1.4f / 11.0f * f, *row = value_aslant[k];
      at[k] = splat(by * row[0]) * p[0] + splat(by * row[1]) * p[1] + splat(by * row[2]) * p[2];
    }
    left = left * left * (splat(3.0f) - left - left);
    sum = sum + splat(weight) * left * value_one(at, splatu(w->seed_mottle + o));
    f *= 2.3f;
    weight *= 0.6f;
  }
  return sum;
}

/* Errors go as the clouds: of weaker ones a footprint's middle tells enough. */
#define MOTTLE_STRONG 0.15f
#define MOTTLE_WIDE 0.4f /* of the largest clouds: a wider footprint is seen in four parts */

/* Relative shift of brightness, mean 0. t1, t2: the footprint's sides. */
INLINE vf mottle_shift(const stone_constants *w, const vf p[3], const vf t1[3], const vf t2[3],
                       vf s) {
  vf zero = splat(0.0f), quarter = splat(0.25f) * s, side = s, sum = zero, first = zero;
  vm parts = gt(s * splat(w->mottle_frequency), splat(MOTTLE_WIDE));
  int four = w->mottle > MOTTLE_STRONG && any(parts);
  if (four) {
    quarter = sel(parts, quarter, zero);
    side = sel(parts, splat(0.5f) * s, s);
  }
  for (int i = 0; i < (four ? 4 : 1); i++) {
    vf at[3] = {p[0], p[1], p[2]};
    if (four) {
      vf u = i & 1 ? quarter : zero - quarter, v = i & 2 ? quarter : zero - quarter;
      for (int k = 0; k < 3; k++) at[k] = p[k] + t1[k] * u + t2[k] * v;
    }
    vf here = mottle_at(w, at, side);
    if (i == 0) first = here;
    sum = sum + here;
  }
  return four ? sel(parts, splat(0.25f) * sum, first) : first;
}

#endif
