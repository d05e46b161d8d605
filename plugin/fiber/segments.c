/* SPDX-License-Identifier: Apache-2.0 */
#include "segments.h"

#include <string.h>

#include "../core/status.h"

static uint32_t buckets_for(uint64_t count) {
  uint32_t n = 1024;
  while (n < count && n < 1u << 30) n *= 2;
  return n;
}

uint64_t segments_bytes(const fiber *f) {
  uint64_t count = (uint64_t)f->strands * (f->vertices - 1);
  return (buckets_for(count) + 2ull) * sizeof(uint32_t) + (count + 1) * sizeof(segment_entry);
}

int32_t segments_make(segments *s, const sozai_host *host, const fiber *f, double reach) {
  memset(s, 0, sizeof *s);
  s->count = (uint64_t)f->strands * (f->vertices - 1);
  s->gap = (float)reach;
  s->buckets = buckets_for(s->count);
  s->first = host_alloc(host, (s->buckets + 2ull) * sizeof *s->first, 64);
  s->list = host_alloc(host, (size_t)(s->count + 1) * sizeof *s->list, 64);
  return s->first && s->list ? SOZAI_OK : SOZAI_ERROR_MEMORY;
}

void segments_free(segments *s, const sozai_host *host) {
  host_free(host, s->first, (s->buckets + 2ull) * sizeof *s->first, 64);
  host_free(host, s->list, (size_t)(s->count + 1) * sizeof *s->list, 64);
}

static uint32_t bucket_of(const segments *s, const fiber *f, uint64_t strand, uint64_t i,
                          uint32_t *key) {
  int32_t c[3];
  segment_cell(s, f->points + 3 * (strand * f->vertices + i), c);
  *key = segment_key(c);
  return segment_bucket(s, c);
}

void segments_sort(segments *s, const fiber *f) {
  uint32_t each = f->vertices - 1, key;
  memset(s->first, 0, (s->buckets + 2ull) * sizeof *s->first);
  for (uint64_t k = 0; k < f->strands; k++)
    for (uint64_t i = 0; i < each; i++) s->first[bucket_of(s, f, k, i, &key) + 2]++;
  for (uint64_t b = 2; b < s->buckets + 2ull; b++) s->first[b] += s->first[b - 1];
  for (uint64_t k = 0; k < f->strands; k++) {
    for (uint64_t i = 0; i < each; i++) {
      uint32_t at = s->first[bucket_of(s, f, k, i, &key) + 1]++;
      s->list[at] = (segment_entry){(uint32_t)(k * each + i), key};
    }
  }
}

static double clamp01(double x) { return x < 0 ? 0 : x > 1 ? 1 : x; }

double segments_nearest(const float p[6], const float r[6], double *s, double *t) {
  double u[3], v[3], w[3], a = 0, b = 0, c = 0, d = 0, e = 0, sum = 0;
  for (int k = 0; k < 3; k++) {
    u[k] = (double)p[3 + k] - (double)p[k];
    v[k] = (double)r[3 + k] - (double)r[k];
    w[k] = (double)p[k] - (double)r[k];
    a += u[k] * u[k], b += u[k] * v[k], c += v[k] * v[k], d += u[k] * w[k], e += v[k] * w[k];
  }
  double det = a * c - b * b;
  *s = det > 1e-12 * a * c ? clamp01((b * e - c * d) / det) : 0.5;
  *t = c > 0 ? (b * *s + e) / c : 0;
  if (*t < 0 || *t > 1) {
    *t = clamp01(*t);
    *s = a > 0 ? clamp01((b * *t - d) / a) : 0;
  }
  for (int k = 0; k < 3; k++) {
    double x = w[k] + *s * u[k] - *t * v[k];
    sum += x * x;
  }
  return sum;
}
