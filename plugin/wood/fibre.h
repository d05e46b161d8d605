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

/* The noise repeats after this many cells: a section of 90 mm at the finest. */
#define FIBRE_REPEAT 4095

/* Relative shift of brightness at (x, z) of the reference section under a
 * footprint of extent e there; within the sum of the amplitudes. */
INLINE vf fibre_shift(const wood_constants *w, vf x, vf z, vf e) {
  vf sum = splat(0.0f);
  for (int o = 0; o < WOOD_FIBRE_OCTAVES; o++) {
    if (w->fibre_amplitude[o] == 0.0f) continue;
    vf keep = filter_keep(e, w->fibre_size[o]) * splat(w->fibre_amplitude[o] / HASH_ONE);
    if (!any(gt(keep, splat(0.0f)))) continue;
    vf f = splat(w->fibre_frequency[o]);
    vi ix, iz;
    vf px = x * f, pz = z * f;
    vf fx = px - vfloor(px, &ix), fz = pz - vfloor(pz, &iz);
    vi one = splati(1), repeat = splati(FIBRE_REPEAT);
    vu seed = wood_seed(w, SEED_FIBRE + (uint32_t)o);
    vu x0 = (vu)(ix & repeat) * splatu(HASH_X), x1 = (vu)((ix + one) & repeat) * splatu(HASH_X);
    vu z0 = (vu)(iz & repeat) * splatu(HASH_Z) + seed;
    vu z1 = (vu)((iz + one) & repeat) * splatu(HASH_Z) + seed;
    vf wx = fx * fx * (splat(3.0f) - fx - fx), wz = fz * fz * (splat(3.0f) - fz - fz);
    vf a = mix(hash_signed(x0 + z0), hash_signed(x1 + z0), wx);
    vf b = mix(hash_signed(x0 + z1), hash_signed(x1 + z1), wx);
    sum = sum + keep * mix(a, b, wz);
  }
  return sum;
}

#endif
