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
 * footprint whose extent there has the square e2; within the sum of the
 * amplitudes. Kawai and Momoi repeat a small array of noise; hashing the cell
 * costs no memory and does not repeat. */
INLINE vf fibre_shift(const wood_constants *w, vu own, vf x, vf z, vf e2) {
  vf sum = splat(0.0f);
  for (int o = 0; o < WOOD_FIBRE_OCTAVES; o++) {
    if (w->fibre_amplitude[o] == 0.0f) continue;
    vf keep = filter_keep_square(e2, w->fibre_size[o]) * splat(w->fibre_amplitude[o] / HASH_ONE);
    if (!any(gt(keep, splat(0.0f)))) continue;
    vf f = splat(w->fibre_frequency[o]);
    noise_axis ax = noise_split_cubic(x * f, HASH_X), az = noise_split_cubic(z * f, HASH_Z);
    vf dx, dz; /* not wanted, and so not computed */
    sum =
        sum + keep * noise_value2(&ax, &az, wood_seed(w, own, SEED_FIBRE + (uint32_t)o), &dx, &dz);
  }
  return sum;
}

#endif
