/* SPDX-License-Identifier: Apache-2.0
 * A surface evaluated into picture files.
 *
 * Two steps: units (plan.h) are evaluated and kept as pieces (pieces.h), in
 * any order and by any number of processes; then the pieces are written, in
 * order, into the files. So a bake that was resumed, or shared out, gives the
 * same bytes as one that ran through. */
#ifndef SOZAI_BAKE_BAKE_H
#define SOZAI_BAKE_BAKE_H

#include "colour.h"
#include "ground.h"
#include "outputs.h"
#include "recipe.h"

#define BAKE_ALL 0   /* evaluate what is missing, then merge */
#define BAKE_SHARD 1 /* evaluate a share, and leave the pieces */
#define BAKE_MERGE 2 /* evaluate nothing */

typedef struct bake_job {
  const sozai_textures_1 *textures;
  const sozai_texture *texture;
  const recipe *recipe;
  const bake_ground *ground;
  const bake_outputs *outputs;
  const colour *colour;
  const char *path; /* of the files, with <UDIM> and <output> */
  int what;         /* BAKE_ALL and the like */
  bool resume;      /* BAKE_ALL: take up what is there; shards always do */
  bool mipmaps;
  uint32_t shard, shards; /* from 1 */
  uint32_t tile;          /* side; 0: scanlines */
  uint32_t threads;
} bake_job;

/* Shows progress, and can be cancelled. The pieces stay behind where it fails,
 * and --resume goes on with them. */
bool bake_run(const bake_job *job, failure *why);

#endif
