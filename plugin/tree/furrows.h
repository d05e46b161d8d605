/* SPDX-License-Identifier: Apache-2.0
 *
 * Relief of old bark: rhytidome tears as the wood within it thickens, into plates or strips with
 * furrows between (Vaucher 2003, Tree Bark: A Color Guide; Whitmore 1962, New Phytologist 61,
 * 191-207). A cellular pattern in space, stretched along the stem, so that it has neither a seam
 * nor a place where its count changes as the stem tapers. It stands on the stem's radius, which is
 * that under bark.
 */
#ifndef SOZAI_TREE_FURROWS_H
#define SOZAI_TREE_FURROWS_H

#include "plan.h"

typedef struct {
  float across, along; /* 1 / mm: inverse sizes of a cell */
  float edge;          /* cells: from a furrow's bottom to the plate beside it */
  float depth;         /* mm, of whole rhytidome; 0: smooth */
  float joined;        /* how many cells are one plate with a neighbour, as a share */
  float ridges;        /* how much shallower cracks across the stem are */
  float scales;        /* how uneven plates are: in steps, of what has flaked off */
  float shade;         /* how much darker furrows are, as a share */
  float reach;         /* mm: the height up to which they are cut */
  float mean;          /* of the height, all over */
  uint32_t seed;
} furrows;

furrows furrows_of(const tree_plan *p);

typedef struct {
  float height; /* 0 in a furrow, up to 1 on plates */
  float kind;   /* -1 to 1: of a plate and the scales on it, 0 in the mean */
} furrow_place;

/* At a place in mm, the second along the stem. */
furrow_place furrows_at(const furrows *f, const float p[3]);

/* mm: how high plates stand over furrows on a stem of radius r. old: how much is rhytidome. */
float furrows_depth(const furrows *f, float old, float r);

/* How much of them is cut at a height in mm, 0 to 1. */
float furrows_cut(const furrows *f, float y);

/* mm: how far points stand from each other that show it, round the stem and along it. */
void furrows_steps(const furrows *f, float out[2]);

#endif
