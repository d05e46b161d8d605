/* SPDX-License-Identifier: Apache-2.0
 *
 * What stone's stages hand on.
 */
#ifndef SOZAI_STONE_BLOCK_H
#define SOZAI_STONE_BLOCK_H

#include "footprint.h"
#include "surface.h"

/* Blocks that go through each stage before the next begins. */
#define STONE_BLOCKS CELLS_LOOKS

/* A block of LANES points on its way through the stages. */
typedef struct {
  uint32_t i, n;
  vf at[3], face[3]; /* object space: the point and its normal */
  vf p[3], nrm[3];   /* bed space, likewise */
  vf s;
  vf t1[3], t2[3]; /* the footprint's sides */
  int alike;       /* of the blocks on their way the first whose footprints lie as these do */
  vf albedo[3], speck, hole, inclusion; /* the last three: shares of the footprint */
  int crystal_known;                    /* the colour has met it */
  vu crystal;                           /* that the point is in */
  int hidden; /* how many of the layers, from below, no lane sees anything of */
  cells_cover cover[STONE_LAYERS];
  int mixed[STONE_LAYERS]; /* a bit to each layer below that it covers unevenly */
  /* covariances of what the first layer covers with the second's shares */
  vf with[STONE_LAYERS][STONE_LAYERS][CELLS_PARTS];
  laid laid; /* where there is a paving */
  surface surface;
  cells_found holes, inclusions; /* that are asked how high they are */
  cells_bends bends;             /* of layers that share them, at the point */
} block;

#endif
