/* SPDX-License-Identifier: Apache-2.0
 * What every mesh that was read keeps to. */
#ifndef SOZAI_TESTS_FUZZ_MESH_CHECK_H
#define SOZAI_TESTS_FUZZ_MESH_CHECK_H

#include <math.h>

#include "fuzz.h"
#include "mesh.h"

static inline void mesh_check(const mesh *m) {
  CHECK(m->triangle_count > 0);
  for (size_t i = 0; i < 3 * (size_t)m->triangle_count; i++) CHECK(m->indices[i] < m->point_count);
  for (size_t i = 0; i < 3 * (size_t)m->point_count; i++)
    CHECK(fabsf(m->points[i]) <= 1e6f && isfinite(m->normals[i]));
}

#endif
