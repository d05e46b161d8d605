/* SPDX-License-Identifier: Apache-2.0
 *
 * Clouds: how bright strands are from one part of a felt, a lock or a cloth to the next, where
 * they were laid thicker, rubbed or soiled: far wider than bundles, so that it is what is left of
 * them from afar. Of light and albedo, not of coverage: how strands lie is as it was.
 */
#ifndef SOZAI_FIBERTEX_CLOUD_H
#define SOZAI_FIBERTEX_CLOUD_H

#include "../../core/noise.h"
#include "block.h"
#include "nap.h"

#define CLOUD_OCTAVES 2
#define CLOUD_FINER 2.17f
#define CLOUD_WEAKER 0.6f
#define CLOUD_SIGMA 4.490f /* 1 over the sd of the octaves' sum, 0.191 sqrt(1 + 0.36) */
#define CLOUD_MOST 0.95f   /* either way, so that the mean stays 1 and nothing is black */

/* A footprint is looked at in 2 x 2 parts where it is wider than this, of the noise's lattice. */
#define CLOUD_PARTS 0.2f

/* What is left of the noise at the middle, and of the mean of four parts, under a square that is
 * e lattices wide: by the least squares of 20,000 squares of 64 points, within 0.03. */
INLINE vf cloud_keep(vf e) {
  const vf one = splat(1.0f);
  vf wide = (one - splat(0.08f) * e) * (one - smooth_step(splat(1.1f), splat(3.9f), e));
  return sel(gt(e, splat(CLOUD_PARTS)), wide, one - splat(0.55f) * e * e);
}

INLINE vf cloud_noise(const vf at[3], float frequency, uint32_t seed) {
  vf g[3], f = splat(frequency);
  return noise_gradient3(at[0] * f, at[1] * f, at[2] * f, splatu(seed), g);
}

/* Over the square's parts; a lane that is narrow has four times its middle, to the bit. */
INLINE vf cloud_parts(const block *k, const vf at[3], vf e, float frequency, uint32_t seed) {
  const vf zero = splat(0.0f);
  vf off = sel(gt(e, splat(CLOUD_PARTS)), splat(0.25f) * k->s, zero), side[2][3], sum = zero;
  nap_place(k->f.e1, side[0]);
  nap_place(k->f.e2, side[1]);
  for (int i = 0; i < 4; i++) {
    vf part[3];
    for (int c = 0; c < 3; c++) {
      vf x = off * side[0][c], y = off * side[1][c];
      part[c] = at[c] + (i & 1 ? x : zero - x) + (i & 2 ? y : zero - y);
    }
    sum = sum + cloud_noise(part, frequency, seed);
  }
  return splat(0.25f) * sum;
}

/* 1 in the mean. */
STAGE void stage_cloud(const fibertex_constants *w, block *k) {
  const vf zero = splat(0.0f), most = splat(CLOUD_MOST);
  float finer = w->cloud_frequency, weight = w->cloud;
  vf at[3], sum = zero;
  nap_place(k->at, at);
  for (uint32_t o = 0; o < CLOUD_OCTAVES; o++) {
    vf e = k->s * splat(finer), keep = cloud_keep(e);
    if (any(gt(keep, zero))) {
      vf n = any(gt(e, splat(CLOUD_PARTS))) ? cloud_parts(k, at, e, finer, w->cloud_seed + o)
                                            : cloud_noise(at, finer, w->cloud_seed + o);
      sum = sum + splat(weight) * keep * n;
    }
    finer *= CLOUD_FINER;
    weight *= CLOUD_WEAKER;
  }
  k->cloud = splat(1.0f) + clamp(sum * splat(CLOUD_SIGMA), zero - most, most);
}

#endif
