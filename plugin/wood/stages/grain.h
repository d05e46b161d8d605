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
  k->in.moved = 0;
  if (w->bolt > 0.0f) k->in = bolt_find(w, own_of(boards, k), k->p);
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
  interlocked_year q =
      grain_interlocked_year(w, own_of(boards, k), k->years, &k->held->interlocked);
  grain_interlocked(w, &q, k->p[1], &k->grain);
  if (k->in.moved) bolt_interlocked(w, &q, &k->in);
}

INLINE void stage_grain_noise(const grain_octave *q, int boards, int o, block *k) {
  grain_noise(q, own_of(boards, k), k->p[1], &k->at, k->extent, &k->held->slope[o], &k->grain);
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
  k->section.c = k->stem.c * c + k->stem.s * s;
  k->section.s = k->stem.s * c - k->stem.c * s;
}

INLINE void stage_section(const wood_constants *w, const wood_io *io, block *k) {
  vf unused;
  k->radius = k->stem.rho * (splat(1.0f) + outline_at(w, k->section.c, k->section.s, &unused));
  k->section.x = k->radius * k->section.c;
  k->section.z = k->radius * k->section.s;
  if (k->knot) stage_knot_section(k);
  store_lanes(io, WOOD_REFERENCE, k, k->section.x);
  store_lanes(io, WOOD_REFERENCE + 1, k, k->section.z);
}

/* The same in the point's bolt. In a knot there is but the branch's own. */
INLINE void stage_bolt(block *k) {
  if (!k->in.moved) return;
  vf s, c, turn = (k->grain.d - k->in.d) * k->divisor + k->in.turn;
  sine_cosine(k->knot ? turn - k->knot->turn : turn, &s, &c);
  section_place *q = &k->bolt;
  q->c = k->stem.c * c + k->stem.s * s;
  q->s = k->stem.s * c - k->stem.c * s;
  q->x = k->radius * q->c;
  q->z = k->radius * q->s;
  if (!k->knot) return;
  vm in = gt(k->knot->inside, splat(0.0f));
  q->c = sel(in, k->section.c, q->c);
  q->s = sel(in, k->section.s, q->s);
  q->x = sel(in, k->section.x, q->x);
  q->z = sel(in, k->section.z, q->z);
}

#endif
