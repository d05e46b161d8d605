/* SPDX-License-Identifier: Apache-2.0
 *
 * A hash of 64 bits: the finisher of Steele, Lea and Flood's SplitMix (2014), with
 * Stafford's constants (mix 13).
 */
#ifndef SOZAI_CORE_MIX64_H
#define SOZAI_CORE_MIX64_H

#include <stdint.h>

static inline uint64_t mix64(uint64_t x) {
  x ^= x >> 30;
  x *= 0xbf58476d1ce4e5b9ull;
  x ^= x >> 27;
  x *= 0x94d049bb133111ebull;
  return x ^ x >> 31;
}

#endif
