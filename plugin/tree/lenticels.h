/* SPDX-License-Identifier: Apache-2.0
 *
 * Lenticels: the pores of periderm, which widen across the stem as it thickens, into the bars of
 * birch and cherry bark (Trockenbrodt 1990, IAWA Bulletin 11, 141-166). One to a cell of space,
 * a disc that the stem's surface cuts along a bar; gone where bark is rhytidome.
 */
#ifndef SOZAI_TREE_LENTICELS_H
#define SOZAI_TREE_LENTICELS_H

#include "plan.h"

typedef struct {
  float length, height; /* mm: across the stem, the longest, and along it */
  float layer;          /* mm, from one layer of cells to the next */
  float shade;          /* how much darker they are; 0: none */
  float mean;           /* of the marks, all over */
  float reach;          /* mm: the height up to which they are drawn */
  uint32_t seed;
} lenticels;

/* Refuses more than there is room for. */
int32_t lenticels_check(const tree_plan *p);

lenticels lenticels_of(const tree_plan *p);

/* 1 in one's middle, 0 beside it, at a place in mm, the second along the stem. */
float lenticels_mark(const lenticels *l, const float p[3]);

/* How much of its shade they have on bark so old at that height, 0 to 1. */
float lenticels_seen(const lenticels *l, const tree_plan *p, float age, float y);

/* mm: how far points stand from each other that show them, round the stem and along it. */
void lenticels_steps(const lenticels *l, float out[2]);

#endif
