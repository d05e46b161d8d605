/* SPDX-License-Identifier: Apache-2.0
 *
 * Pigment figure: heartwood substances lie in bands that go with groups of rings,
 * and not quite with them; each is deepest at its outer edge, where it ends at once
 * (Beals and Davis 1977: walnut, rosewood, olive, zebrano).
 *
 * A table of the bands' depth over the section's radius, straight between its samples,
 * with its integral: the mean over a stretch is a difference of two look-ups. The
 * radius is that of the place and a stray, a slow noise over the reference section,
 * whose other half makes bands stronger and weaker round the stem.
 */
#ifndef SOZAI_WOOD_PIGMENT_H
#define SOZAI_WOOD_PIGMENT_H

#include "grain.h"

/* The integral of the depth, mm, from the beginning of the table's turn. */
INLINE vf pigment_integral(const wood_constants *w, vf rho) {
  vf row[4], at = rho * splat(w->pigment_per_mm);
  vi i = to_int(clamp(at, splat(0.0f), splat((float)(PIGMENT_SAMPLES - 1))));
  gather4(w->pigment_row, i, row);
  vf x = at - to_float(i);
  return row[0] + x * (row[1] + x * row[2]);
}

/* Depth of the bands, 0..1, averaged over e mm about rho; e2: squared extent of the
 * footprint in the reference section, where the fibre stands at (x, z). */
INLINE vf pigment_at(const wood_constants *w, vu own, vf rho, vf e, vf x, vf z, vf e2) {
  vf f = splat(w->pigment_frequency), n[2], dx[2], dz[2]; /* slopes are not wanted */
  noise_axis ax = noise_split_cubic(x * f, HASH_X), az = noise_split_cubic(z * f, HASH_Y);
  grain_swell(&ax, &az, wood_seed(w, own, SEED_PIGMENT), n, dx, dz);
  vf near = splat(w->pigment_near), keep = splat(1.0f);
  if (any(gt(e2, near))) keep = keep - smooth_step(near, splat(16.0f) * near, e2);

  vi turns0, turns1;
  vf period = splat(w->ring_period), inverse = splat(w->inverse_ring_period);
  /* each board's log has its bands elsewhere */
  vf middle = rho + n[0] * keep * splat(w->pigment_stray) + to_float((vi)(own >> 22)) * splat(0.5f);
  e = vmax(e, splat(0.1f)); /* the difference of integrals, to 1e-3 */
  vf low = middle - splat(0.5f) * e, high = low + e;
  vf low0 = low - vfloor(low * inverse, &turns0) * period;
  vf high0 = high - vfloor(high * inverse, &turns1) * period;
  vf sum = to_float(turns1 - turns0) * splat(w->pigment_period) + pigment_integral(w, high0) -
           pigment_integral(w, low0);
  vf strength = splat(1.0f - 0.5f * PIGMENT_FADE) - splat(0.5f * PIGMENT_FADE) * keep * n[1];
  return clamp01(sum / e) * strength;
}

#endif
