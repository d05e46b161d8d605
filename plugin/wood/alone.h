/* SPDX-License-Identifier: Apache-2.0
 *
 * All octaves of a noise for a point alone. Where the processor has vectors for it they lie
 * in the lanes of one: each lane does what stem.h, grain.h and fibre.h do one after another,
 * and the sums are taken in their order, so that the bits are the same. Octaves of no height
 * and such as the footprint leaves nothing of add zeros here.
 */
#ifndef SOZAI_WOOD_ALONE_H
#define SOZAI_WOOD_ALONE_H

#include "fibre.h"
#include "grain.h"

#ifdef WITHIN_A_POINT

INLINE stem_pith pith_alone(const wood_constants *w, vu own, vf y) {
  noise_stems a = noise_split_axial2(all_f4(y * w->pith_frequency), HASH_Y);
  f4 p = noise_axial1_two(&a, load_u4(w->fours.pith_seed) + own) * load_f4(w->fours.pith);
  return (stem_pith){p[0], p[1], p[2], p[3]};
}

/* undulation_add of both octaves. */
INLINE undulation_sum undulation_alone(const wood_constants *w, vu own, vf y, vf footprint,
                                       stem_place *p) {
  const wood_fours *q = &w->fours;
  vf x1 = 0.8f * p->x - 0.6f * p->z, z1 = 0.6f * p->x + 0.8f * p->z;
  f4 often = load_f4(q->section);
  noise_axes ax = noise_split_cubic4((f4){p->x, p->x, x1, x1} * often, HASH_X);
  noise_axes az = noise_split_cubic4((f4){p->z, p->z, z1, z1} * often, HASH_Z);
  noise_stems ay = noise_split_axial2(y * load_f4(q->axis), HASH_Y);
  f4 height = load_f4(q->height);
  if (footprint > 0.5f * vmin(w->undulation_size[0], w->undulation_size[1])) {
    vf keep[2];
    for (int o = 0; o < 2; o++) {
      keep[o] = filter_keep(footprint, w->undulation_size[o]);
      vf variance = 0.025f * w->undulation[o] * w->undulation[o];
      p->lost = p->lost + variance * (1.0f - keep[o] * keep[o]);
    }
    height *= (f4){keep[0], keep[1], keep[0], keep[1]};
  }
  f4 across, n = noise_axial3_two(&ax, &ay, &az, load_u4(q->undulation_seed) + own, &across);
  n = 0.0f + n * (height * load_f4(q->slope_y));
  across = across * (height * load_f4(q->slope));
  vf gx = across[1], gz = across[3];
  return (undulation_sum){n[0] + n[1], 0.0f + across[0] + (0.8f * gx + 0.6f * gz), n[2] + n[3],
                          0.0f + across[2] + (0.8f * gz - 0.6f * gx)};
}

/* grain_noise of both octaves. */
INLINE void grain_noise_alone(const wood_constants *w, vu own, vf y, const noise_axis *at,
                              vf extent, grain_place *p) {
  const wood_fours *q = &w->fours;
  noise_stems ay = noise_split_axial2(y * load_f4(q->often), HASH_Y);
  f4 by_years, n = noise_axial2_two(&ay, at, load_u4(q->slope_seed) + own, &by_years);
  n *= load_f4(q->far);
  by_years *= load_f4(q->by_years);
  vf slope[2] = {n[2], n[3]};
  p->d = p->d + n[0] + n[1];
  p->g = p->g + slope[0] + slope[1];
  p->d_t = p->d_t + by_years[0] + by_years[1];
  if (extent > 0.5f * vmin(w->slope_noise_size[0], w->slope_noise_size[1])) {
    for (int o = 0; o < 2; o++) {
      vf keep = filter_keep(extent, w->slope_noise_size[o]);
      float steep = w->slope_noise[o] * w->slope_noise_frequency[o];
      slope[o] = slope[o] * keep;
      p->variance = p->variance + 0.3f * steep * steep * (1.0f - keep * keep);
    }
  }
  p->g_filtered = p->g_filtered + slope[0] + slope[1];
}

/* fibre_add of all octaves. */
INLINE fibre_sum fibre_alone(const wood_constants *w, vu own, const fibre_eye *near,
                             const fibre_eye *far, fibre_bundle *bundle) {
  const wood_fours *q = &w->fours;
  fibre_sum sum = fibre_start(), by[2] = {sum, sum};
  fibre_under(&near->f, &by[0]);
  fibre_under(&far->f, &by[1]);
  f4 none = {0.0f, 0.0f, 0.0f, 0.0f};
  f4 trace = {by[0].trace, by[0].trace, by[1].trace, by[1].trace};
  f4 det = {by[0].det, by[0].det, by[1].det, by[1].det};
  f4 x = {near->x, near->x, far->x, far->x}, z = {near->z, near->z, far->z, far->z};
  f4 spread = 1.0f + load_f4(q->blur) * trace + load_f4(q->blur2) * det;
  f4 keep = max_f4(1.0f / (1.0f - FIBRE_END) / spread - FIBRE_END / (1.0f - FIBRE_END), none);
  noise_axes ax = noise_split_cubic4(x * load_f4(q->frequency), HASH_X);
  noise_axes az = noise_split_cubic4(z * load_f4(q->frequency), HASH_Z);
  f4 n = keep * noise_value2_four(&ax, &az, load_u4(q->fibre_seed) + own);
  f4 shift = load_f4(q->scale) * n;
  sum.shift = sum.shift + shift[0] + shift[1] + shift[2];
  if (w->has_front) {
    f4 lost = load_f4(q->variance) * max_f4(0.95f - keep * keep, none);
    f4 front = load_f4(q->front) * n;
    sum.lost = sum.lost + lost[0] + lost[1] + lost[2];
    sum.front = sum.front + front[0] + front[1] + front[2];
  }
  if (w->has_strays) {
    fibre_octave octave = fibre_octave_of(w, FIBRE_BUNDLE);
    fibre_bundle_at(&octave, own, near->x, near->z, bundle);
  }
  return sum;
}

#else

INLINE stem_pith pith_alone(const wood_constants *w, vu own, vf y) {
  return pith_at(w, own, y, NULL);
}

INLINE undulation_sum undulation_alone(const wood_constants *w, vu own, vf y, vf footprint,
                                       stem_place *p) {
  undulation_sum sum = undulation_none();
  for (int o = 0; o < 2; o++) {
    undulation_octave octave = undulation_octave_of(w, o);
    undulation_add(&octave, own, y, footprint, NULL, p, &sum);
  }
  return sum;
}

INLINE void grain_noise_alone(const wood_constants *w, vu own, vf y, const noise_axis *at,
                              vf extent, grain_place *p) {
  for (int o = 0; o < 2; o++) {
    grain_octave octave = grain_octave_of(w, o);
    grain_noise(&octave, own, y, at, extent, NULL, p);
  }
}

INLINE fibre_sum fibre_alone(const wood_constants *w, vu own, const fibre_eye *near,
                             const fibre_eye *far, fibre_bundle *bundle) {
  fibre_sum sum = fibre_start();
  for (int o = 0; o < WOOD_FIBRE_OCTAVES; o++) {
    const fibre_eye *at = o < FIBRE_DRIFT ? near : far;
    fibre_octave octave = fibre_octave_of(w, o);
    fibre_under(&at->f, &sum);
    fibre_add(&octave, own, at->x, at->z, &sum, bundle);
  }
  return sum;
}

#endif
#endif
