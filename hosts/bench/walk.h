/* SPDX-License-Identifier: Apache-2.0
 * Going over a part of the board in raster order, batch by batch. */
#ifndef SOZAI_BENCH_WALK_H
#define SOZAI_BENCH_WALK_H

#include "board.h"
#include "plugin.h"

typedef struct walk_plan {
  const sozai_textures_1 *textures;
  const sozai_texture *texture;
  const sozai_channel *channel; /* NULL: all up to `components` */
  uint32_t components;
  const board *board;
  uint32_t batch; /* points at a time, at most LARGEST_BATCH */
  float footprint;
  bool edge;       /* the plane x, z, from -y */
  uint32_t masked; /* see entry.masked */
} walk_plan;

/* A thread's own inputs and outputs: small enough to stay in its cache, as a
 * renderer's are. */
typedef struct walk walk;

walk *walk_open(const walk_plan *plan, failure *why);
void walk_close(walk *w);

/* The batch that begins at a texel of the board. */
bool walk_batch(walk *w, uint32_t column, uint32_t row);
/* What the last batch gave for a component, or NULL where not wanted. */
const float *walk_output(const walk *w, uint32_t component);

/* Rows of the board's measured part, counted from its first. */
bool walk_rows(walk *w, uint32_t first, uint32_t end);

#endif
