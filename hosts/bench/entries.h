/* SPDX-License-Identifier: Apache-2.0
 * What there is to measure. The names stay as they are: results of one version
 * are compared with those of another. */
#ifndef SOZAI_BENCH_ENTRIES_H
#define SOZAI_BENCH_ENTRIES_H

#include <stddef.h>
#include <stdint.h>
#include "tile.h"
#include "wood.h"

#define ENTRY_POINTS 0  /* evaluating the board's part */
#define ENTRY_THREADS 1 /* the same on two threads */
#define ENTRY_CREATE 2
#define ENTRY_LOAD 3
#define ENTRY_LOAD_ALONE 4     /* without the services that stand beside the plugin */
#define ENTRY_TILE 5           /* through OpenImageIO, beside the baked tile */
#define ENTRY_TREE 6           /* growing one: beside 50 ms */
#define ENTRY_TREE_MESH 7      /* growing it and making its mesh: beside 50 ms */
#define ENTRY_TREE_BRANCHES 8  /* growing one, a branch: beside 34 thousand a second */
#define ENTRY_FIBER_PLACE 9    /* a hull measured and filled: beside 0.3 s of one core */
#define ENTRY_FIBER_FIT 10     /* and every strand fitted: beside 0.3 s of one core */
#define ENTRY_FIBER_THREADS 11 /* the same on two cores: beside 0.15 s */

typedef struct entry {
  const char *name;
  int kind; /* ENTRY_* */
  uint32_t batch;
  float footprint;     /* mm; 0: a texel */
  const char *channel; /* NULL: all */
  uint32_t masked;     /* 0: none is; of a hundred points the inactive, scattered, and one more */
  wood wood;
  tile_kind tile;
  const char *tree; /* the preset, 7 years old, all four orders */
} entry;

extern const entry entries[];
extern const size_t entry_count;

#endif
