/* SPDX-License-Identifier: Apache-2.0
 *
 * Shifted brightness (Momoi, generalised by Kawai in his section 6): every
 * fibre is a little lighter or darker than its neighbours, by a noise over the
 * reference section that the grain carries along the stem. Three sizes, since
 * a board shows single fibres near, bundles at arm's length and drifts of
 * colour across the room. By the same noise latewood strays: the growth front is no
 * smooth surface, which a cut along it shows as a ragged edge.
 */
#ifndef SOZAI_WOOD_FIBRE_H
#define SOZAI_WOOD_FIBRE_H

#include "stem.h"

/* The sum of the octaves: of brightness, relative; and of how far the growth front of
 * the bundle that a fibre belongs to strays from its ring's, mm. */
typedef struct {
  vf shift, front;
  vf lost; /* mm^2: of the front's variance, what the footprint swallowed */
} fibre_sum;

/* How much of the octave the mean over the footprint keeps, given its value in the
 * middle: the covariance of the two over the noise's variance. 1 / (1 + x^2 / 8) along
 * each axis, x being the extent in cells, is within 0.02 of it along a line and within
 * 0.04 over a square, measured; shifted so that it ends, at 6.7 cells along a line. */
#define FIBRE_END 0.15f

INLINE vf fibre_keep(const wood_constants *w, int o, const footprint2 *f) {
  vf one = splat(1.0f), k = splat(w->fibre_blur[o]);
  vf det = vmax(f->aa * f->bb - f->ab * f->ab, splat(0.0f));
  vf keep = one / (one + k * (f->aa + f->bb + k * det));
  return vmax(keep - splat(FIBRE_END), splat(0.0f)) * splat(1.0f / (1.0f - FIBRE_END));
}

/* Adds an octave at (x, z) of the reference section under a footprint there. Kawai and
 * Momoi repeat a small array of noise; hashing the cell costs no memory and does not
 * repeat. */
INLINE void fibre_add(const wood_constants *w, vu own, int o, vf x, vf z, const footprint2 *f,
                      fibre_sum *sum) {
  if (w->fibre_scale[o] <= 0.0f && w->fibre_front[o] <= 0.0f) return;
  vf keep = fibre_keep(w, o, f);
  sum->lost = sum->lost + splat(w->fibre_variance[o]) * (splat(1.0f) - keep * keep);
  if (!any(gt(keep, splat(0.0f)))) return;
  vf often = splat(w->fibre_frequency[o]);
  noise_axis ax = noise_split_cubic(x * often, HASH_X), az = noise_split_cubic(z * often, HASH_Z);
  vf dx, dz; /* not wanted, and so not computed */
  vf n = keep * noise_value2(&ax, &az, wood_seed(w, own, SEED_FIBRE + (uint32_t)o), &dx, &dz);
  sum->shift = sum->shift + splat(w->fibre_scale[o]) * n;
  sum->front = sum->front + splat(w->fibre_front[o]) * n;
}

INLINE fibre_sum fibre_start(void) { return (fibre_sum){splat(1.0f), splat(0.0f), splat(0.0f)}; }

/* The factor of brightness, of all of them. */
INLINE vf fibre_shift(const wood_constants *w, vu own, vf x, vf z, const footprint2 *f) {
  fibre_sum sum = fibre_start();
  for (int o = 0; o < WOOD_FIBRE_OCTAVES; o++) fibre_add(w, own, o, x, z, f, &sum);
  return sum.shift;
}

#endif
