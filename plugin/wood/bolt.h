/* SPDX-License-Identifier: Apache-2.0
 *
 * Bolts: lengths of the stem, each with an arrangement of vessels, rays and cells of its own.
 *
 * Where neighbouring years spiral by different slopes, fibres that stand side by side at the
 * reference section have parted by y times the difference a height y above it: what is a circle
 * there is a ribbon here, and a ray a hairpin. No vessel runs that far. Vessels end, a few
 * centimetres to a few metres long by the wood (Zimmermann, Xylem Structure and the Ascent of
 * Sap, 1983), others begin beside them, and across every height they are round and rays straight.
 * So within a bolt theta' counts from the bolt's middle, turned by an angle of its own: along a
 * fibre it is constant, as it is along the whole stem in the reference section, and its shear is
 * that of half a bolt at most. A bolt is as long as keeps that to BOLT_SHEAR where the grain parts
 * most; it ends unevenly. Only what grows with y is taken back, spirals and
 * interlocks; waves and strays come back by themselves.
 *
 * What is wider than vessels (drifts of brightness, bands of pigment, streaks) stays in the
 * reference section, from end to end.
 */
#ifndef SOZAI_WOOD_BOLT_H
#define SOZAI_WOOD_BOLT_H

#include "grain.h"

#define BOLT_UNEVEN_OFTEN 1.0f /* 1/mm: how finely its ends stray, across the stem */

/* The bolt that a point is in. d: how far the grain has gone round at its middle, mm, which in the
 * reference section's own bolt is 0 to the bit; d_t: and what that changes by, mm a year. */
typedef struct {
  vf y;    /* mm: the height of its middle */
  vf turn; /* radians */
  vf d, d_t;
  int moved; /* some lane's is not the reference section's own */
} bolt_at;

INLINE bolt_at bolt_find(const wood_constants *w, vu own, const vf p[3]) {
  bolt_at b;
  vi which;
  vf zero = splat(0.0f), at = p[1] * splat(w->inverse_bolt), middle = vnearest(at, &which);
  if (any(gt(vabs(at - middle), splat(0.5f - w->bolt_uneven)))) {
    vf often = splat(BOLT_UNEVEN_OFTEN), dx, dz;
    noise_axis x = noise_split_cubic(p[0] * often, HASH_X),
               z = noise_split_cubic(p[2] * often, HASH_Z);
    vf stray = noise_value2(&x, &z, wood_seed(w, own, SEED_BOLTS), &dx, &dz);
    middle = vnearest(at + splat(w->bolt_uneven / HASH_ONE) * stray, &which);
  }
  vm other = not_(eq(middle, zero));
  b.moved = any(other);
  b.y = middle * splat(w->bolt);
  vu h = hash_mix((vu)which * splatu(HASH_Y) + wood_seed(w, own, SEED_BOLTS));
  b.turn = sel(other, to_float((vi)(h >> 8)) * splat(6.2831853f / 16777216.0f), zero);
  b.d = b.y * splat(w->spiral);
  b.d_t = zero;
  return b;
}

INLINE void bolt_interlocked(const wood_constants *w, const interlocked_year *q, bolt_at *b) {
  vf cy, along = interlocked_along(w, q, b->y, &cy);
  b->d = b->d + q->a * along * q->st;
  b->d_t = interlocked_by_year(w, q, along, cy);
}

#endif
