/* SPDX-License-Identifier: Apache-2.0 */
#include "checksum.h"

#include <stdio.h>
#include <string.h>

/* Each step a bijection of the sum and of the word: any one changed word shows. */
static uint64_t mix(uint64_t sum, uint64_t word) {
  sum = (sum ^ word) * 0x9e3779b97f4a7c15u;
  return sum ^ sum >> 29;
}

uint64_t checksum_bytes(uint64_t sum, const void *data, size_t bytes) {
  const unsigned char *at = data;
  for (; bytes >= 8; bytes -= 8, at += 8) {
    uint64_t word;
    memcpy(&word, at, 8);
    sum = mix(sum, word);
  }
  if (bytes == 0) return sum;
  uint64_t last = bytes; /* "a" and "a\0" differ */
  last <<= 56;
  memcpy(&last, at, bytes);
  return mix(sum, last);
}

bool checksum_file(const char *path, uint64_t *sum) {
  FILE *file = fopen(path, "rb");
  if (!file) return false;
  unsigned char room[1 << 16];
  size_t count;
  *sum = 0;
  while ((count = fread(room, 1, sizeof room, file)) > 0) *sum = checksum_bytes(*sum, room, count);
  bool ok = ferror(file) == 0;
  fclose(file);
  return ok;
}
