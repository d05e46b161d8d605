/* SPDX-License-Identifier: Apache-2.0
 * The rings of a straight stem's mesh. */
#ifndef SOZAI_TESTS_STEM_RINGS_H
#define SOZAI_TESTS_STEM_RINGS_H

#include <math.h>

#include "tree.h"

/* mm: a stem stands on roots, which are gone there */
#define ROOTS 800

/* Each of `sides` points and one that repeats the first. */
typedef struct {
  const sozai_mesh *mesh;
  uint64_t first, sides, count;
} rings;

static inline rings rings_from(const sozai_mesh *m, uint64_t first) {
  rings r = {.mesh = m, .first = first + 1};
  while (m->uv[2 * (r.first + r.sides)] < 1.0f) r.sides++;
  while (r.first + (r.count + 1) * (r.sides + 1) < m->point_count &&
         m->owner[r.first + (r.count + 1) * (r.sides + 1)] == m->owner[first])
    r.count++;
  return r;
}

static inline rings rings_of(const sozai_mesh *m) { return rings_from(m, 0); }

static inline uint64_t index_of(const rings *r, uint64_t i, uint64_t k) {
  return r->first + i * (r->sides + 1) + k;
}

/* mm, of a point from the axis, which a straight stem has where x = z = 0. */
static inline double out_of(const rings *r, uint64_t i, uint64_t k) {
  const float *p = r->mesh->points + 3 * index_of(r, i, k);
  return hypot((double)p[0], (double)p[2]);
}

static inline double height_of(const rings *r, uint64_t i) {
  return (double)r->mesh->points[3 * index_of(r, i, 0) + 1];
}

/* Of bark whose green is 0.6, with marks darker by SHADE: how dark a point is, of what it is at
 * most. */
#define SHADE 0.5
static inline double mark(const rings *r, uint64_t i, uint64_t k) {
  double tone = (double)r->mesh->colours[3 * index_of(r, i, k) + 1] / 0.6;
  return (1 - tone) / SHADE;
}

/* The range of marks from one height up to another, and their mean, or NULL. */
static inline double range_of(const rings *r, double from, double to, double *mean) {
  double least = 9, most = -9, sum = 0, count = 0;
  for (uint64_t i = 0; i < r->count; i++)
    for (uint64_t k = 0; k < r->sides && height_of(r, i) >= from && height_of(r, i) < to; k++) {
      double m = mark(r, i, k), high = height_of(r, i + (i + 1 < r->count)) - height_of(r, i);
      least = fmin(least, m), most = fmax(most, m);
      sum += m * high, count += high;
    }
  if (mean) *mean = sum / count;
  return most - least;
}

#endif
