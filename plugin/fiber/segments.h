/* SPDX-License-Identifier: Apache-2.0
 *
 * Segments of all strands by the cell their middle lies in, to find those that
 * may touch one.
 */
#ifndef SOZAI_FIBER_SEGMENTS_H
#define SOZAI_FIBER_SEGMENTS_H

#include "fiber.h"

typedef struct segment_entry {
  uint32_t id;  /* strand * (vertices - 1) + segment */
  uint32_t key; /* its cell, each coordinate modulo 1024: of the 27 about one no two are alike */
} segment_entry;

typedef struct segments {
  float gap;        /* side of a cell: no segment reaches past the next one */
  uint32_t buckets; /* a power of two */
  uint64_t count;
  uint32_t *first;     /* of each bucket, and one more */
  segment_entry *list; /* sorted within a bucket */
} segments;

/* Room for all of a fibre's; RANGE beyond 2^32. */
int32_t segments_make(segments *s, const sozai_host *host, const fiber *f, double reach);
/* Bytes of segments_make. */
uint64_t segments_bytes(const fiber *f);
void segments_free(segments *s, const sozai_host *host);
/* Sorts them by where they are now. */
void segments_sort(segments *s, const fiber *f);

static inline void segment_cell(const segments *s, const float *a, int32_t cell[3]) {
  for (int k = 0; k < 3; k++) {
    float x = 0.5f * (a[k] + a[3 + k]) / s->gap;
    int32_t i = (int32_t)x;
    cell[k] = (float)i > x ? i - 1 : i;
  }
}

static inline uint32_t segment_key(const int32_t c[3]) {
  return ((uint32_t)c[0] & 1023u) | ((uint32_t)c[1] & 1023u) << 10 | ((uint32_t)c[2] & 1023u) << 20;
}

static inline uint32_t segment_bucket(const segments *s, const int32_t c[3]) {
  uint32_t h =
      (uint32_t)c[0] * 0x9e3779b1u ^ (uint32_t)c[1] * 0x85ebca77u ^ (uint32_t)c[2] * 0xc2b2ae3du;
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  return (h ^ h >> 16) & (s->buckets - 1);
}

/* The nearest points of two segments, p + s (q - p) and so on: their squared
 * distance. */
double segments_nearest(const float p[6], const float r[6], double *s, double *t);

#endif
