/* SPDX-License-Identifier: Apache-2.0
 *
 * Bark by its age: when each place of an axis was laid down, and what the bark
 * of such an age looks like. A shoot's skin gives way to periderm, and where the
 * species forms one, periderm to rhytidome (Trockenbrodt 1990, IAWA Bulletin 11,
 * 141-166: terms; 1991, IAWA Bulletin 12, 5-22: their order).
 */
#ifndef SOZAI_TREE_BARK_H
#define SOZAI_TREE_BARK_H

#include "tree.h"

#define BARK_TIMES 33

/* How an axis grew: a line from point to point. */
typedef struct {
  float along[BARK_TIMES]; /* mm from its base, of a grown stem its height; rising */
  float year[BARK_TIMES];  /* of the tree's age, rising */
  uint32_t count;
} bark_growth;

void bark_growth_of(bark_growth *out, const tree *t, const tree_branch *b);
/* When the place so far along it was laid down. */
float bark_year(const bark_growth *g, float along);

/* The bark's age at each node. A dead branch's grows no older. */
void bark_ages(const tree *t, const tree_branch *b, float *out);

/* How much of bark so many years old is rhytidome, 0 to 1. */
float bark_old(const tree_plan *p, float age);
/* How much of it is periderm. */
float bark_periderm(const tree_plan *p, float age);
/* Of bark so many years old: sRGB, display-referred; and apart, as it would be without rhytidome,
 * and what that adds. */
void bark_colours(const tree_plan *p, float age, float bare[3], float turned[3]);
void bark_colour(const tree_plan *p, float age, float out[3]);

#endif
