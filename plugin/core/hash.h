/* SPDX-License-Identifier: Apache-2.0
 *
 * Counter-based integer hashing: the random number of a place is a function
 * of the place, so that nothing is stored and nothing depends on order.
 */
#ifndef SOZAI_CORE_HASH_H
#define SOZAI_CORE_HASH_H

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

/* As hash_mix without the last step: only the upper bits are good, which is
 * all that a signed fraction needs. */
INLINE vf hash_signed(vu h) {
  h ^= h >> 16;
  h *= splatu(0x7feb352du);
  h ^= h >> 15;
  h *= splatu(0x846ca68bu);
  return to_float((vi)h) * splat(4.6566129e-10f);
}

/* The same mixing for one number, at creation. */
static inline uint32_t hash1(uint32_t h) {
  h ^= h >> 16;
  h *= 0x7feb352du;
  h ^= h >> 15;
  h *= 0x846ca68bu;
  h ^= h >> 16;
  return h;
}

#endif
