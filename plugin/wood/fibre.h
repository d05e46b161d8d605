/* SPDX-License-Identifier: Apache-2.0
 *
 * Shifted brightness (Momoi, generalised by Kawai in his section 6): every
 * fibre is a little lighter or darker than its neighbours, by a noise over the
 * reference section that the grain carries along the stem. Three sizes, since
 * a board shows single fibres near, bundles at arm's length and drifts of
 * colour across the room.
 */
#ifndef SOZAI_WOOD_FIBRE_H
#define SOZAI_WOOD_FIBRE_H

#include "stem.h"

/* Relative shift of brightness at (x, z) of the reference section under a
 * footprint whose extent there has the square e2, by one octave; within its
 * amplitude. It is whole while the extent is below half its size, and gone from
 * twice its size on. Kawai and Momoi repeat a small array of noise; hashing the cell
 * costs no memory and does not repeat. */
INLINE vf fibre_octave(const wood_constants *w, vu own, int o, vf x, vf z, vf e2) {
  vf keep = splat(w->fibre_scale[o]), near = splat(w->fibre_near[o]), zero = splat(0.0f);
  if (w->fibre_scale[o] <= 0.0f) return zero;
  if (any(gt(e2, near))) {
    vf t = clamp01((e2 - near) * splat(w->fibre_fade[o]));
    keep = keep * (splat(1.0f) - t * t * (splat(3.0f) - t - t));
    if (!any(gt(keep, zero))) return zero;
  }
  vf f = splat(w->fibre_frequency[o]);
  noise_axis ax = noise_split_cubic(x * f, HASH_X), az = noise_split_cubic(z * f, HASH_Z);
  vf dx, dz; /* not wanted, and so not computed */
  return keep * noise_value2(&ax, &az, wood_seed(w, own, SEED_FIBRE + (uint32_t)o), &dx, &dz);
}

/* One and all of them. */
INLINE vf fibre_shift(const wood_constants *w, vu own, vf x, vf z, vf e2) {
  vf sum = splat(1.0f);
  for (int o = 0; o < WOOD_FIBRE_OCTAVES; o++) sum = sum + fibre_octave(w, own, o, x, z, e2);
  return sum;
}

#endif
