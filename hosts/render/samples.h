/* SPDX-License-Identifier: Apache-2.0
 * Sample points that are a function of pixel, sample and dimension alone, so
 * that a picture does not depend on who drew which part of it.
 *
 * The first two dimensions of Sobol's sequence, scrambled and shuffled for each
 * pixel and pair of dimensions by a hash in the manner of Owen (after Laine and
 * Karras 2011, Burley 2020). */
#ifndef SOZAI_RENDER_SAMPLES_H
#define SOZAI_RENDER_SAMPLES_H

#include <stdint.h>

static inline uint32_t sample_hash(uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  return x ^ x >> 16;
}

static inline uint32_t sample_reverse(uint32_t x) {
  x = (x & 0x55555555u) << 1 | (x >> 1 & 0x55555555u);
  x = (x & 0x33333333u) << 2 | (x >> 2 & 0x33333333u);
  x = (x & 0x0f0f0f0fu) << 4 | (x >> 4 & 0x0f0f0f0fu);
  return __builtin_bswap32(x);
}

/* Owen's scramble of a number that is given with its bits reversed, and comes out in order: each
 * bit flips by a hash of those above it. */
static inline uint32_t sample_scramble(uint32_t reversed, uint32_t seed) {
  uint32_t x = reversed + seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return sample_reverse(x);
}

/* Sobol's dimensions, reversed: the first is the index; the second's matrix is Pascal's
 * triangle modulo 2, a product of five that add halves, quarters, and so on down to bits. */
static inline uint32_t sample_sobol_1(uint32_t index) {
  uint32_t x = index;
  x ^= x >> 16;
  x ^= (x & 0xff00ff00u) >> 8;
  x ^= (x & 0xf0f0f0f0u) >> 4;
  x ^= (x & 0xccccccccu) >> 2;
  return x ^ (x & 0xaaaaaaaau) >> 1;
}

static inline float sample_unit(uint32_t x) { return (float)(x >> 8) * 0x1p-24f; }

/* As many as are wanted, one after the other (O'Neill, PCG, 2014): paths whose length is not
 * known. state: any number to begin with. */
typedef struct sample_stream {
  uint32_t state;
} sample_stream;

static inline float sample_next(sample_stream *d) {
  d->state = d->state * 747796405u + 2891336453u;
  uint32_t x = ((d->state >> ((d->state >> 28) + 4)) ^ d->state) * 277803737u;
  return sample_unit(x >> 22 ^ x);
}

/* Two numbers in [0, 1). pixel: any number of its own; pair: which dimensions. */
static inline void sample_pair(uint32_t pixel, uint32_t index, uint32_t pair, float *u, float *v) {
  uint32_t seed = sample_hash(pixel + 0x9e3779b9u * (pair + 1));
  uint32_t shuffled = sample_scramble(sample_reverse(index), seed);
  *u = sample_unit(sample_scramble(shuffled, sample_hash(seed ^ 0x68bc21ebu)));
  *v = sample_unit(sample_scramble(sample_sobol_1(shuffled), sample_hash(seed ^ 0x02e5be93u)));
}

#endif
