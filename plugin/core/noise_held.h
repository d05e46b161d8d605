/* SPDX-License-Identifier: Apache-2.0
 *
 * Noises of lattices so wide that neighbours mostly stand in one cell: its corners are hashed once,
 * one to a lane, and held for as long as the next block of points lies in there as well. The bits
 * are those of noise.h.
 */
#ifndef SOZAI_CORE_NOISE_HELD_H
#define SOZAI_CORE_NOISE_HELD_H

#include "noise.h"

/* What was found of a noise's last cell. A noise of its own each: base tells cells apart, not what
 * else is hashed with it. */
typedef struct {
#ifdef HOLDS
  cell_corners at;
#endif
  uint32_t base; /* the hash term of the first corner */
  int found;     /* 0: nothing yet */
} noise_held;

INLINE void noise_held_none(noise_held *held) {
  held->base = 0;
  held->found = 0;
}

#ifdef HOLDS
/* Whether all lanes stand in the cell whose first corner has that hash term: then `held` has its
 * corners. held: NULL where nothing is. */
INLINE int noise_hold(noise_held *held, vu base, vu beside) {
  if (!held) return 0;
  if (all_are((vi)base, (int32_t)held->base) && held->found) return 1;
  if (!alike((vi)base)) return 0;
  held->at = noise_corners_at(base, beside);
  held->base = base[0];
  held->found = 1;
  return 1;
}
#endif

/* Two of noise_axial1, of seeds that are `apart`. */
INLINE void noise_axial1_twice(const noise_stem *y, vu seed, uint32_t apart, noise_held *held,
                               vf n[2], vf dy[2]) {
#ifdef HOLDS
  const vu beside = {0, HASH_Y, apart, apart + HASH_Y};
  if (noise_hold(held, y->low + seed, beside)) {
    UNROLL(2)
    for (int c = 0; c < 2; c++) {
      vf g0 = splat(held->at.value.of[2 * c]), g1 = splat(held->at.value.of[2 * c + 1]);
      dy[c] = g0 * y->d0 + g1 * y->d1;
      n[c] = g0 * y->n0 + g1 * y->n1;
    }
    return;
  }
#else
  (void)held;
#endif
  n[0] = noise_axial1(y, seed, &dy[0]);
  n[1] = noise_axial1(y, seed + splatu(apart), &dy[1]);
}

/* Three of noise_value1, of an axis split by HASH_X: of that seed, and of it with HASH_Y and with
 * HASH_Z. */
INLINE void noise_value1_thrice(const noise_axis *x, vu seed, noise_held *held, vf n[3], vf dx[3]) {
#ifdef HOLDS
  const vu beside = {0, HASH_X, HASH_Y, HASH_Y + HASH_X, HASH_Z, HASH_Z + HASH_X};
  if (noise_hold(held, x->low + seed, beside)) {
    UNROLL(3)
    for (int c = 0; c < 3; c++) {
      vf d = splat(held->at.right.of[2 * c]);
      dx[c] = d * x->dw;
      n[c] = splat(held->at.value.of[2 * c]) + d * x->w;
    }
    return;
  }
#else
  (void)held;
#endif
  n[0] = noise_value1(x, seed, &dx[0]);
  n[1] = noise_value1(x, seed + splatu(HASH_Y), &dx[1]);
  n[2] = noise_value1(x, seed + splatu(HASH_Z), &dx[2]);
}

/* noise_value2. right, up: what x and z were split by. */
INLINE vf noise_value2_held(const noise_axis *x, uint32_t right, const noise_axis *z, uint32_t up,
                            vu seed, noise_held *held, vf *dx, vf *dz) {
#ifdef HOLDS
  const vu beside = {0, right, up, right + up};
  if (noise_hold(held, x->low + z->low + seed, beside)) {
    vf low = splat(held->at.right.of[0]), high = splat(held->at.right.of[2]);
    vf p = splat(held->at.value.of[0]) + low * x->w;
    vf q = splat(held->at.value.of[2]) + high * x->w - p;
    *dx = mix(low, high, z->w) * x->dw;
    *dz = q * z->dw;
    return p + q * z->w;
  }
#else
  (void)right;
  (void)up;
  (void)held;
#endif
  return noise_value2(x, z, seed, dx, dz);
}

/* noise_axial2 of axes split by HASH_Y and, across, HASH_X. */
INLINE vf noise_axial2_held(const noise_stem *y, const noise_axis *t, vu seed, noise_held *held,
                            vf *dy, vf *dt) {
#ifdef HOLDS
  const vu beside = {0, HASH_X, HASH_Y, HASH_Y + HASH_X};
  if (noise_hold(held, t->low + y->low + seed, beside)) {
    vf d0 = splat(held->at.right.of[0]), d1 = splat(held->at.right.of[2]);
    vf g0 = splat(held->at.value.of[0]) + d0 * t->w, g1 = splat(held->at.value.of[2]) + d1 * t->w;
    *dt = d0 * t->dw * y->n0 + d1 * t->dw * y->n1;
    *dy = g0 * y->d0 + g1 * y->d1;
    return g0 * y->n0 + g1 * y->n1;
  }
#else
  (void)held;
#endif
  return noise_axial2(y, t, seed, dy, dt);
}

/* noise_axial3 of axes split by HASH_X, HASH_Y and HASH_Z. */
INLINE vf noise_axial3_held(const noise_axis *x, const noise_stem *y, const noise_axis *z, vu seed,
                            noise_held *held, vf *dx, vf *dy, vf *dz) {
#ifdef HOLDS
  if (noise_hold(held, x->low + y->low + z->low + seed, noise_beside3())) {
    return noise_axial3_in(&held->at, x, y, z, dx, dy, dz);
  }
#else
  (void)held;
#endif
  return noise_axial3(x, y, z, seed, dx, dy, dz);
}

#endif
