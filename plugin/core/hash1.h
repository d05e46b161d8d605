/* SPDX-License-Identifier: Apache-2.0
 *
 * The hash of hash.h for one number, where there are no lanes: at creation,
 * and for seeds.
 */
#ifndef SOZAI_CORE_HASH1_H
#define SOZAI_CORE_HASH1_H

#include <stdint.h>

static inline uint32_t hash1(uint32_t h) {
  h ^= h >> 16;
  h *= 0x7feb352du;
  h ^= h >> 15;
  h *= 0x846ca68bu;
  h ^= h >> 16;
  return h;
}

/* A seed of a number and a name; NULL: no name. */
static inline uint32_t hash1_named(uint32_t seed, const char *name) {
  uint32_t h = hash1(seed);
  for (const char *t = name; t && *t; t++) h = hash1(h ^ (uint32_t)(unsigned char)*t);
  return h;
}

#endif
