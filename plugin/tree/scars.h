/* SPDX-License-Identifier: Apache-2.0
 *
 * Scars of branches on a grown stem's smooth bark: the brow that droops to both sides of where a
 * branch stands or stood, and under it the closed wound. A brow is the ridge of bark from the
 * crotch above the branch: its middle was folded last, its ends when the branch was young (Shigo
 * 1989, A New Tree Biology; Mattheck and Breloer 1994, The Body Language of Trees). The stem draws
 * it apart as it thickens, and makes it no higher: old brows are flat.
 */
#ifndef SOZAI_TREE_SCARS_H
#define SOZAI_TREE_SCARS_H

#include "tree.h"

#define SCARS_MOST 32 /* beside one another, at one height */

/* One, as it meets a height of the stem. Lengths in mm. */
typedef struct {
  float x, z;           /* unit: its way from the axis */
  float up;             /* the height, over the branch's middle */
  float half[2];        /* from there to the brow's ends, to either side, round the stem */
  float top, drop;      /* the brow's middle, over the branch's; its ends below that */
  float thick;          /* half of the brow's height in the middle */
  float wound[2], size; /* semi-axes, round the stem and along it; of the branch, its radius */
  uint32_t hash;
} scar;

typedef struct {
  uint32_t count;
  float dark; /* of scars_dark */
  float mean; /* of the marks, about there */
  scar at[SCARS_MOST];
} scars_here;

/* Whether a branch, a grown tree's stem, may have any. */
int scars_on(const tree *t, const tree_branch *b);

#define SCARS_BELOW 2u /* levels of detail: from then on they are not told from the bark */

/* How much darker they are than the bark about them, as a share: where the stem's radius is r at
 * height y, and its bark so many years old. */
float scars_dark(const tree *t, float age, float r, float y);

/* Those there. */
void scars_at(const tree *t, float age, float r, float y, scars_here *out);

/* At a place: x, z: its way from the axis, unit; r: mm. */
typedef struct {
  float mark; /* 1 on a scar, 0 beside it */
  float rise; /* mm, over the bark about it */
} scar_point;

scar_point scars_mark(const scars_here *s, float x, float z, float r);

/* mm: how far points may stand apart that show those between two heights, round the stem and along
 * it; 0: at will. r: its radius at the lower one. */
void scars_steps(const tree *t, float r, float from, float to, float out[2]);

#endif
