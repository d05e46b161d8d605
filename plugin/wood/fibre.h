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
  vf lost;       /* mm^2: of the front's variance, what the footprint swallowed */
  vf trace, det; /* of the footprint in the section */
} fibre_sum;

/* The bundles' noise, unblurred, and its slopes, 1/mm. Bands of vessels and parenchyma stray by it.
 */
typedef struct {
  vf at, x, z;
} fibre_bundle;

INLINE fibre_sum fibre_start(void) {
  vf zero = splat(0.0f);
  return (fibre_sum){splat(1.0f), zero, zero, zero, zero};
}

INLINE void fibre_under(const footprint2 *f, fibre_sum *sum) {
  sum->trace = f->aa + f->bb;
  sum->det = vmax(f->aa * f->bb - f->ab * f->ab, splat(0.0f));
}

#define FIBRE_BUNDLE 1 /* the octave of bundles, */
#define FIBRE_DRIFT 2  /* and of drifts; the finest is single fibres */

/* Where octaves are looked up. */
typedef struct {
  vf x, z;
  footprint2 f;
} fibre_eye;

/* How much of an octave the mean over the footprint keeps, given its value in the
 * middle: the covariance of the two over the noise's variance. 1 / (1 + x^2 / 8) along
 * each axis, x being the extent in cells, is within 0.02 of it along a line and within
 * 0.04 over a square, measured; shifted so that it ends, at 6.7 cells along a line. */
#define FIBRE_END 0.15f

/* What an octave has of the wood: the kernel loads it before its loop, since the
 * compiler leaves in there what it cannot tell to be needed at all. */
typedef struct {
  vf blur, blur2, often, scale, front, variance;
  vu seed;
  int idle, strays;
  int bands; /* bands of vessels or parenchyma stray by this one */
} fibre_octave;

INLINE fibre_octave fibre_octave_of(const wood_constants *w, int o) {
  fibre_octave q;
  float blur = w->fibre_blur[o];
  q.blur = splat(blur);
  q.blur2 = splat(blur * blur);
  q.often = splat(w->fibre_frequency[o]);
  q.scale = splat(w->fibre_scale[o]);
  q.front = splat(w->fibre_front[o]);
  q.variance = splat(w->fibre_variance[o]);
  q.seed = splatu(w->seeds[SEED_FIBRE + o]);
  q.strays = w->fibre_front[o] > 0.0f;
  q.bands = w->has_strays && o == FIBRE_BUNDLE;
  q.idle = w->fibre_scale[o] <= 0.0f && !q.strays && !q.bands;
  return q;
}

INLINE vf fibre_keep(const fibre_octave *q, const fibre_sum *sum) {
  vf spread = splat(1.0f) + q->blur * sum->trace + q->blur2 * sum->det;
  return vmax(splat(1.0f / (1.0f - FIBRE_END)) / spread - splat(FIBRE_END / (1.0f - FIBRE_END)),
              splat(0.0f));
}

/* The bundles' noise there. */
INLINE void fibre_bundle_at(const fibre_octave *q, vu own, vf x, vf z, fibre_bundle *bundle) {
  noise_axis ax = noise_split_cubic(x * q->often, HASH_X);
  noise_axis az = noise_split_cubic(z * q->often, HASH_Z);
  bundle->at = noise_value2(&ax, &az, q->seed + own, &bundle->x, &bundle->z);
  bundle->x = bundle->x * q->often;
  bundle->z = bundle->z * q->often;
}

/* Adds an octave at (x, z) of the reference section. Kawai and Momoi repeat a small array
 * of noise; hashing the cell costs no memory and does not repeat. */
INLINE void fibre_add(const fibre_octave *q, vu own, vf x, vf z, fibre_sum *sum,
                      fibre_bundle *bundle) {
  if (q->idle) return;
  vf keep = fibre_keep(q, sum);
  /* a twentieth of it does not show, and costs a root */
  if (q->strays) {
    vf lost = vmax(splat(0.95f) - keep * keep, splat(0.0f));
    sum->lost = sum->lost + q->variance * lost;
  }
  if (!q->bands && !any(gt(keep, splat(0.0f)))) return;
  noise_axis ax = noise_split_cubic(x * q->often, HASH_X);
  noise_axis az = noise_split_cubic(z * q->often, HASH_Z);
  vf dx, dz; /* computed where they are wanted */
  vf n = noise_value2(&ax, &az, q->seed + own, &dx, &dz);
  if (q->bands) {
    bundle->at = n;
    bundle->x = dx * q->often;
    bundle->z = dz * q->often;
  }
  n = keep * n;
  sum->shift = sum->shift + q->scale * n;
  if (q->strays) sum->front = sum->front + q->front * n;
}

/* The factor of brightness, of all of them. */
INLINE vf fibre_shift(const wood_constants *w, vu own, vf x, vf z, const footprint2 *f) {
  fibre_sum sum = fibre_start();
  fibre_bundle unused;
  fibre_under(f, &sum);
  for (int o = 0; o < WOOD_FIBRE_OCTAVES; o++) {
    fibre_octave q = fibre_octave_of(w, o);
    fibre_add(&q, own, x, z, &sum, &unused);
  }
  return sum.shift;
}

#endif
