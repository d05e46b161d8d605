/* SPDX-License-Identifier: Apache-2.0
 *
 * What varies slowly in stone: beds, veins, mottle.
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

#define BEDS_WIDE 4.0f   /* beds: a footprint across more is seen in eight parts */
#define BEDS_THIN 0.085f /* one across less in one: a quarter of the finest noise's lattice */

/* The same over the footprint, in four parts across the beds, or eight, or one. A layer of sediment
 * lies over the last at the same height everywhere but for a slow wave: value noise across the
 * beds, at three sizes. flat2: how much of the footprint lies across. */
STAGE vf bed_share(const stone_constants *w, const vf p[3], vf s, vf flat2) {
  vf y = p[1], zero = splat(0.0f), sum = zero, e = splat(0.25f) * s * vsqrt(flat2), side = e,
     away = zero;
  if (w->bed_wave != 0.0f)
    y = y + beds_wave(p, w->bed_wave, w->bed_wave_frequency, w->seed_bed + 7u);
  vm wide = gt(e * splat(w->bed_frequency), splat(0.25f * BEDS_WIDE));
  vm thin = lt(e * splat(4.0f * w->bed_frequency), splat(BEDS_THIN));
  int eight = any(wide);
  vf whole = zero;
  if (any(thin)) {
    whole = bed_at(w, y, splat(4.0f) * e);
    if (!any(not_(thin))) return whole;
  }
  if (eight) {
    side = sel(wide, splat(0.5f) * e, e);
    away = sel(wide, splat(0.25f) * e, zero);
  }
  for (int i = 0; i < 4; i++) {
    vf at = y + (splat((float)i) - splat(1.5f)) * e;
    if (eight)
      sum = sum + splat(0.125f) * (bed_at(w, at - away, side) + bed_at(w, at + away, side));
    else
      sum = sum + splat(0.25f) * bed_at(w, at, e);
  }
  return sel(thin, whole, sum);
}

/* How folded the whole is: how far a family's veins lie from where they would,
 * in their spacing, and how that changes. Over some eight spacings the veins'
 * direction wanders by twenty degrees or so. */
#define VEIN_FOLD 0.13f
#define VEIN_FOLDED 2.6f
#define VEIN_SHAKE 0.12f /* of what bends the veins, their finest bends */
/* Of that noise's slope, 0.86 in the mean, what is made use of at least. */
#define VEIN_STEEP 2.0f

typedef struct {
  vf v, g[3];
  vf many; /* where there are veins, and where there are few: +-0.5 or so, mean 0 */
} vein_fold;

INLINE vein_fold vein_folded(const stone_constants *w, const vf p[3]) {
  vein_fold f;
  vf k = splat(w->vein_frequency * VEIN_FOLD);
  float far = VEIN_FOLDED * w->vein_warp;
  f.many = noise_gradient3(p[0] * k, p[1] * k, p[2] * k, splatu(w->seed_vein + 2u), f.g);
  f.v = splat(far) * f.many;
  for (int a = 0; a < 3; a++) f.g[a] = splat(far * VEIN_FOLD) * f.g[a];
  return f;
}

/* One family of veins: fractures in a direction, bent; each by chance thick,
 * thin or not there, and swelling and pinching out along its way. The share of
 * the footprint within half a vein's width of its middle. */
STAGE vf vein_sheet(const stone_constants *w, const vf p[3], const vf n[3], vf s,
                    const vein_fold *fold, int family) {
  /* one family's way is the other's mirrored; the finer one's in its own spacing */
  const float finer = family ? 2.4f : 1.0f, side = family ? -1.0f : 1.0f,
              *m = w->vein_direction[family];
  float frequency = w->vein_frequency * finer;
  uint32_t seed = w->seed_vein + 16u * (uint32_t)family;
  vf q[3], g[3], fine[3], one = splat(1.0f);
  for (int k = 0; k < 3; k++) q[k] = p[k] * splat(frequency);
  vf bend =
      noise_gradient3(q[0] * splat(0.7f), q[1] * splat(0.7f), q[2] * splat(0.7f), splatu(seed), g);
  vf f = splat(m[0]) * q[0] + splat(m[1]) * q[1] + splat(m[2]) * q[2] + splat(w->vein_warp) * bend +
         splat(side * finer) * fold->v;
  for (int k = 0; k < 3; k++) {
    g[k] = splat(m[k]) + splat(0.7f * w->vein_warp) * g[k] + splat(side) * fold->g[k];
  }
  /* whatever the shake adds, within its bounds, no vein is nearer than that */
  const float shaken = VEIN_SHAKE * w->vein_warp, widest = 0.5f * w->vein_width / finer;
  const vf soft2 = splat(w->vein_soft * w->vein_soft + 1e-12f), each = splat(1.0f / frequency);
  vf slowest = one / (vsqrt(dot3(g, g) + splat(0.09f)) + splat(3.9f * VEIN_STEEP * shaken));
  vi which;
  vf least = vabs(f - vfloor(f + splat(0.5f), &which)) - splat(shaken);
  vm near = lt(least * slowest * each - splat(0.5f) * vsqrt(s * s + soft2), splat(widest));
  if (!any(near)) return splat(0.0f);
  vf shake = noise_gradient3(q[0] * splat(3.9f), q[1] * splat(3.9f), q[2] * splat(3.9f),
                             splatu(seed + 1u), fine);
  f = f + splat(shaken) * clamp(shake, splat(-1.0f), one);
  for (int k = 0; k < 3; k++) g[k] = g[k] + splat(3.9f * shaken) * fine[k];
  vf middle = vfloor(f + splat(0.5f), &which);
  vf k = vmax(inverse_root(vmax(dot3(g, g), splat(0.09f))), slowest),
     d = vabs(f - middle) * k * each;
  vf chance = vabs(hash_signed(hash_mix((vu)which + splatu(seed)))) * splat(1.0f / HASH_ONE);
  /* along the vein, one number to each vein: neighbours do not thin out together */
  vf way = q[0] * splat(m[1] - m[2]) + q[1] * splat(m[2] - m[0]) + q[2] * splat(m[0] - m[1]);
  vf slope, own;
  noise_axis a = noise_split_cubic(way * splat(0.45f), HASH_X);
  own = noise_value1(&a, (vu)which * splatu(HASH_Y) + splatu(seed + 3u), &slope);
  vf swell = splat(family ? -0.1f : 0.2f) + splat(0.9f) * bend + splat(1.1f) * shake +
             splat(0.6f) * chance + splat(family ? -2.6f : 1.2f) * fold->many +
             splat((family ? 0.9f : 0.4f) / HASH_ONE) * own;
  vf half = clamp01(swell) * chance * chance * splat(widest);
  vf along = vmin(vabs(dot3(g, n) * k), one), e = vsqrt(s * s * (one - along * along) + soft2);
  /* by its two sides: a sharp one's width is below what d is known to */
  vf even = splat(0.5f), inverse = one / e;
  vf share = clamp01(even + (half - d) * inverse) - clamp01(even - (half + d) * inverse);
  return sel(near, share, splat(0.0f));
}

#define VEIN_STEPS 5

/* Over the footprint: veins bend, so that a wide one is looked at in parts. */
INLINE vf vein_share(const stone_constants *w, const vf p[3], const vf n[3], const vf t1[3],
                     const vf t2[3], vf s) {
  vf one = splat(1.0f), sum = splat(0.0f), wide = s * splat(w->vein_frequency);
  vi whole;
  vf parts = vmax(wide * splat(10.0f), vmin(s * splat(1.5f / w->vein_width), splat(1.3f)));
  vf steps = clamp(vfloor(parts + splat(0.85f), &whole), one, splat(VEIN_STEPS));
  vf inverse = one / steps, h = s * inverse;
  vf keep = one - smooth_step(splat(1.5f), splat(4.0f), wide);
  for (int j = 0; j < VEIN_STEPS; j++) {
    vm row = lt(splat((float)j), steps);
    if (!any(row)) break;
    vf v = (splat((float)j + 0.5f) * inverse - splat(0.5f)) * s;
    for (int i = 0; i < VEIN_STEPS; i++) {
      vm there = and_(row, lt(splat((float)i), steps));
      if (!any(there)) break;
      vf u = (splat((float)i + 0.5f) * inverse - splat(0.5f)) * s, at[3];
      for (int k = 0; k < 3; k++) at[k] = p[k] + t1[k] * u + t2[k] * v;
      vein_fold fold = vein_folded(w, at);
      vf a = vein_sheet(w, at, n, h, &fold, 0);
      vf b = vein_sheet(w, at, n, h, &fold, 1);
      sum = sel(there, sum + (one - (one - a) * (one - splat(0.8f) * b)), sum);
    }
  }
  return mix(splat(w->vein_mean), sum * (inverse * inverse), keep);
}

/* What a place's mottle is: clouds of three sizes, of which a footprint's middle knows less
 * and less as it grows to two and a half of theirs. Aslant, so that no face shows their
 * rows. */
INLINE vf mottle_at(const stone_constants *w, const vf p[3], vf s) {
  static const float row[3][3] = {{2.0f, 6.0f, 9.0f}, {6.0f, 7.0f, -6.0f}, {-9.0f, 6.0f, -2.0f}};
  vf sum = splat(0.0f);
  float f = w->mottle_frequency, weight = w->mottle * (0.224f / VALUE_SD / HASH_ONE);
  for (uint32_t o = 0; o < 3; o++) {
    vf left = clamp01(splat(2.5f / 2.4f) - splat(f / 2.4f) * s), at[3];
    if (!any(gt(left, splat(0.0f)))) break;
    for (int k = 0; k < 3; k++) {
      const float by = 1.4f / 11.0f * f;
      at[k] = splat(by * row[k][0]) * p[0] + splat(by * row[k][1]) * p[1] +
              splat(by * row[k][2]) * p[2];
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
