/* SPDX-License-Identifier: Apache-2.0
 *
 * From the year to the reference section, by the grain: how far the fibre has gone round the stem
 * from where it stands there.
 */
#ifndef SOZAI_WOOD_STAGES_GRAIN_H
#define SOZAI_WOOD_STAGES_GRAIN_H

#include "../alone.h"
#include "../grain.h"
#include "knots.h"

INLINE void stage_years(const wood_constants *w, int boards, block *k) {
  k->grain = grain_spiral(w, k->p[1]);
  k->at = grain_years(w, k->years);
  if (w->has_wave && w->has_wave_irregularity) {
    k->wave = wave_at(w, own_of(boards, k), k->p[1], k->years);
  }
}

INLINE void stage_wave(const wood_constants *w, block *k) {
  if (w->has_wave_irregularity) {
    grain_wave(w, &k->wave, k->extent, &k->grain);
  } else {
    grain_wave_even(w, k->p[1], k->extent, &k->grain);
  }
}

INLINE void stage_interlocked(const wood_constants *w, int boards, block *k) {
  grain_interlocked(w, own_of(boards, k), k->p[1], k->years, &k->grain);
}

INLINE void stage_grain_noise(const grain_octave *q, int boards, block *k) {
  grain_noise(q, own_of(boards, k), k->p[1], &k->at, k->extent, &k->grain);
}

#if LANES == 1
INLINE void stage_grain_noises(const wood_constants *w, int boards, block *k) {
  grain_noise_alone(w, own_of(boards, k), k->p[1], &k->at, k->extent, &k->grain);
}
#endif

INLINE void stage_turn(block *k) {
  k->phase = k->grain.d * k->divisor;
  vf s, c;
  sine_cosine(k->knot ? k->phase - k->knot->turn : k->phase, &s, &c);
  k->c = k->stem.c * c + k->stem.s * s;
  k->sn = k->stem.s * c - k->stem.c * s;
}

INLINE void stage_section(const wood_constants *w, const wood_io *io, block *k) {
  vf unused;
  vf radius = k->stem.rho * (splat(1.0f) + outline_at(w, k->c, k->sn, &unused));
  k->x = radius * k->c;
  k->z = radius * k->sn;
  if (k->knot) stage_knot_section(k);
  store_lanes(io, WOOD_REFERENCE, k, k->x);
  store_lanes(io, WOOD_REFERENCE + 1, k, k->z);
}

#endif
