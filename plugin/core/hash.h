/* SPDX-License-Identifier: Apache-2.0
 *
 * Counter-based integer hashing: the random number of a place is a function
 * of the place, so that nothing is stored and nothing depends on order.
 */
#ifndef SOZAI_CORE_HASH_H
#define SOZAI_CORE_HASH_H

#include "hash1.h"
#include "simd.h"

/* Odd constants that spread lattice coordinates over 32 bits: the fractional
 * parts of square roots of small primes. */
#define HASH_X 0x6a09e667u
#define HASH_Y 0xbb67ae85u
#define HASH_Z 0x3c6ef373u

/* Two rounds of xor-shift and multiply: every input bit reaches every output
 * bit (tests/kernels measures the avalanche). The constants are those of
 * Wellons's lowbias32, found by search for the least bias. */
INLINE vu hash_mix(vu h) {
  h ^= h >> 16;
  h *= splatu(0x7feb352du);
  h ^= h >> 15;
  h *= splatu(0x846ca68bu);
  h ^= h >> 16;
  return h;
}

/* hash_mix without its last step, for uses that leave the lowest five bits
 * alone: those of a product depend on few bits of its factors. */
INLINE vu hash_upper(vu h) {
  h ^= h >> 16;
  h *= splatu(0x7feb352du);
  h ^= h >> 15;
  return h * splatu(0x846ca68bu);
}

/* One round, for lattice noise: a whole number within +-HASH_ONE from the upper
 * bits, where all input bits meet. Neighbouring lattice points correlate by
 * less than 0.01 (tests/kernels measures it). Left unscaled: the noise divides
 * once where its corners have come together. */
#define HASH_ONE 2147483648.0f
INLINE vf hash_signed(vu h) {
  h ^= h >> 15;
  h *= splatu(0x2c1b3c6du);
  return to_float((vi)h);
}

#ifdef WITHIN_A_POINT
INLINE f4 hash_signed4(u4 h) {
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  return to_f4((i4)h);
}
#endif

#endif
