/* SPDX-License-Identifier: Apache-2.0
 *
 * Bands of the field's pores: along the rings (elm), along the rays or across both (hornbeam,
 * eucalypts), in flames that fork (oak).
 *
 * A band is where the phase is near a whole number. Bands along the rings take the phase from the
 * ring's: a whole number of them to a ring, with none at its ends. Those that go round the stem are
 * a whole number to a ring's circumference, another in each ring, and leave no pores at its ends.
 * The phase strays by the noise of the bundles of fibres. Its slopes are exact at the point and
 * taken as they are there for the pores about it, which lie nearer than it bends.
 */
#ifndef SOZAI_WOOD_VESSELS_BANDS_H
#define SOZAI_WOOD_VESSELS_BANDS_H

#include "fibre.h"
#include "vessels.h"

#define BANDS_LEAST 3.0f /* round the pith */

/* The nearest whole number, of less than 2^22: in two operations. */
INLINE vf whole_nearest(vf x) {
  vf large = splat(12582912.0f); /* 1.5 * 2^23: a float of this size has no fraction */
  return (x + large) - large;
}

/* How many bands a ring has, of so many to a mm: a whole number, near what its width asks for. */
INLINE vf bands_to_ring(float often, vf inverse_width) {
  return vmax(whole_nearest(splat(often) / inverse_width), splat(1.0f));
}

/* Bands that follow one another along the radius. */
INLINE void bands_out(const wood_constants *w, const vessel_place *p, vessel_bands *b) {
  vf inverse = p->ring.inverse_width, count = bands_to_ring(w->bands.often, inverse);
  vf rate = count * inverse;
  b->phase = p->ring.phase * count - splat(0.5f);
  b->x = rate * p->c;
  b->z = rate * p->s;
}

/* Bands that follow one another round the stem; p->turn is wanted. */
INLINE void bands_round(const wood_constants *w, const vessel_place *p, vessel_bands *b) {
  const wood_bands *m = &w->bands;
  vf half = splat(0.5f), inverse = p->ring.inverse_width;
  vf start = p->ring.start + p->ring.turns * splat(w->ring_period);
  vf count = vmax(whole_nearest(start * splat(m->often)), splat(BANDS_LEAST));
  vu h = hash_upper((vu)p->ring.ring * splatu(HASH_Z) + wood_seed(w, p->own, SEED_BANDS));
  vf first = to_float((vi)(h >> 8)) * splat(1.0f / 16777216.0f);
  vf round = count * splat(0.15915494f) / vmax(p->rho, splat(1e-3f)), out = splat(m->slant);
  b->phase = p->turn * count + first + out * (p->rho - start);
  b->x = out * p->c - round * p->s;
  b->z = out * p->s + round * p->c;
  b->fork = splat(m->fork) * p->ring.phase;
  b->half = vmin(b->fork, splat(m->fork_most));
  b->ring = p->ring.phase - half;
  b->ring_x = inverse * p->c;
  b->ring_z = inverse * p->s;
  b->ring_end = half - splat(m->margin) * inverse;
}

INLINE vessel_bands bands_straight(const wood_constants *w, const vessel_place *p) {
  vessel_bands b;
  if (w->bands.along_arc) {
    bands_round(w, p, &b);
  } else {
    bands_out(w, p, &b);
  }
  return b;
}

/* The same as they stray. */
INLINE vessel_bands bands_strayed(const wood_constants *w, vessel_bands b,
                                  const fibre_bundle *bundle) {
  if (w->bands.stray > 0.0f && !w->picture) { /* under a picture no fibre's noise is found */
    vf stray = splat(w->bands.stray);
    b.phase = b.phase + stray * bundle->at;
    b.x = b.x + stray * bundle->x;
    b.z = b.z + stray * bundle->z;
  }
  return b;
}

/* The same with slopes per another unit, of so many mm. */
INLINE vessel_bands bands_per(const wood_bands *m, const vessel_bands *from, float mm) {
  vessel_bands b = *from;
  vf k = splat(mm);
  b.x = b.x * k;
  b.z = b.z * k;
  if (m->along_arc) {
    b.ring_x = b.ring_x * k;
    b.ring_z = b.ring_z * k;
  }
  return b;
}

/* Those about a place (dx, dz) from theirs. */
INLINE vessel_bands bands_beside(const wood_bands *m, const vessel_bands *from, vf dx, vf dz) {
  vessel_bands b = *from;
  b.phase = b.phase + (b.x * dx + b.z * dz);
  if (m->along_arc) b.ring = b.ring + (b.ring_x * dx + b.ring_z * dz);
  return b;
}

/* Whether the cell of a hash holds its pore, which the point is (dx, dz) from. */
INLINE vm bands_hold(const wood_bands *m, const vessel_bands *b, vu hash, vf dx, vf dz) {
  vf t = b->phase - (b->x * dx + b->z * dz);
  t = vabs(t - whole_nearest(t));
  if (m->fork > 0.0f) t = vabs(t - b->fork) + b->half;
  vm held = lt(t, lookup8(m->within, hash >> 7));
  if (m->along_arc) {
    vf ring = b->ring - (b->ring_x * dx + b->ring_z * dz);
    held = and_(held, lt(vabs(ring), b->ring_end));
  }
  return held;
}

/* Square of turns: how far a footprint over (arc, rho) reaches along a phase of slopes (x, z). By
 * rounding, it may be a little below 0. */
INLINE vf phase_extent2(vf x, vf z, vf c, vf s, const footprint2 *f) {
  vf arc = z * c - x * s, rho = x * c + z * s;
  return (f->aa * arc + splat(2.0f) * f->ab * rho) * arc + f->bb * rho * rho;
}

/* The same of a footprint over (x, z). */
INLINE vf phase_across2(vf x, vf z, const matrix2 *f) {
  return (f->xx * x + (f->xz + f->xz) * z) * x + f->zz * z * z;
}

/* The density's mean over a footprint wider than single pores, over its mean: its first harmonic,
 * as much as the footprint leaves of it. */
INLINE vf bands_mean(const wood_constants *w, const vessel_bands *b, vf c, vf s,
                     const footprint2 *f) {
  const wood_bands *m = &w->bands;
  vf e2 = phase_extent2(b->x, b->z, c, s, f);
  vf keep = filter_wave(vsqrt(vmax(e2, splat(0.0f))), 1.0f);
  vf across = vsqrt(f->aa + f->bb);
  if (m->stray > 0.0f) keep = keep * filter_keep(across, m->stray_size);
  vf sine, cosine;
  sine_cosine_turns(b->phase, &sine, &cosine);
  if (m->fork > 0.0f) {
    vf parted;
    sine_cosine_turns(b->fork, &sine, &parted);
    cosine = cosine * parted;
  }
  /* never below none */
  return splat(1.0f) + vmin(splat(m->swing) * keep, splat(1.0f)) * cosine;
}

#endif
