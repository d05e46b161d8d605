/* SPDX-License-Identifier: Apache-2.0
 *
 * A grown tree, and the way to it:
 *   parameters -> plan (plan.h) -> first-order branches with their years
 *   (life.h), or a measured table (field.h) -> axes as polylines (axis.h) ->
 *   shoots and leaves upon them (shoots.h) -> tables, mesh, curves.
 *
 * Space: mm, +y up, x east, z south, so that the stem stands as wood's log.
 * Azimuths are the paper's: degrees from north, clockwise seen from above.
 */
#ifndef SOZAI_TREE_TREE_H
#define SOZAI_TREE_TREE_H

#include <stddef.h>
#include <stdint.h>

#include "plan.h"

typedef struct {
  float p[3], r;
} tree_node;

#define TREE_NONE 0xffffffffu
#define TREE_ALIVE (-1.0f)

/* The stem (order 0) or a branch. */
typedef struct {
  uint64_t first; /* of its nodes, from base to tip */
  uint32_t nodes; /* 0: shed, no longer there */
  uint32_t parent;
  uint32_t order;
  uint32_t key;             /* what everything random on it is drawn from */
  float at;                 /* mm along the parent's axis */
  float length;             /* mm, along it */
  float radius;             /* at its base, mm */
  float azimuth;            /* degrees, at its base */
  float elevation;          /* degrees above the horizontal, at its base */
  float birth, death, shed; /* years of the tree's age, or TREE_ALIVE; of a shoot when the
                               parent bore its place */
} tree_branch;

/* A leaf, a needle, or a shoot clothed in needles drawn as one. */
typedef struct {
  float base[3];
  float axis[3]; /* from base to tip */
  float side[3]; /* blade: half its width; else its length is the radius */
  uint32_t branch;
} tree_organ;

#include "tables.h"

typedef struct {
  float *data;
  uint64_t rows, room; /* room: floats */
} tree_rows;

typedef struct {
  tree_plan plan;
  tree_branch *branches;
  tree_node *nodes;
  tree_organ *organs;
  uint64_t branch_count, node_count, organ_count;
  uint64_t branch_room, node_room, organ_room;
  uint64_t order_counts[5]; /* branches of each order; 4: leaves and needles */
  int sprigs;               /* organs are clothed shoots */
  tree_rows tables[TREE_TABLES];
  int by_years;   /* stem and first order follow the plan's curves of growth */
  int measured;   /* the highest order that a field table gave; 0: none */
  uint32_t stems; /* branches that were not grown as shoots: stem and first order,
                     or all that was measured; they come first */
  uint32_t limbs; /* they, and the arms into which branches fork, which come next */
} tree;

static inline float tree_unit(uint32_t hash) { return (float)(hash >> 8) * (1.0f / 16777216.0f); }

#endif
