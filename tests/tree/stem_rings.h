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

#endif
