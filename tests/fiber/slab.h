/* SPDX-License-Identifier: Apache-2.0
 * A slab of grown strands without end. */
#ifndef SOZAI_TESTS_SLAB_H
#define SOZAI_TESTS_SLAB_H

#include "traced.h"

typedef struct {
  const char *name, *preset; /* of the texture: its strand's light */
  double diameter, length;   /* um, mm */
  double side, thick;        /* mm */
  double packing;
  double squeeze;                      /* of heights: 1 every direction alike */
  float roughness, round, tilt, index; /* as the catalogue has them */
} aggregate;

extern const aggregate aggregates[];
extern const int aggregate_count;

typedef struct {
  const aggregate *of;
  traced t;
  double packing, rise;
  float *points, *radii;
  uint64_t *first;
} slab;

void grow_slab(slab *b, const aggregate *a);
void free_slab(slab *b);

#endif
