/* SPDX-License-Identifier: Apache-2.0
 *
 * A number for a list of words, by their bits: lists that differ have others.
 */
#ifndef SOZAI_TESTS_HASHING_H
#define SOZAI_TESTS_HASHING_H

#include <stdint.h>
#include <string.h>

static inline uint64_t hash_word(uint64_t h, uint32_t bits) {
  h = (h ^ bits) * 0xd6e8feb86659fd93u;
  return h ^ h >> 32;
}

static inline uint64_t hash_words(uint64_t h, const void *list, uint64_t count) {
  const char *at = list;
  for (uint64_t i = 0; i < count; i++) {
    uint32_t bits;
    memcpy(&bits, at + 4 * i, sizeof bits);
    h = hash_word(h, bits);
  }
  return hash_word(h, (uint32_t)count);
}

#endif
