/* SPDX-License-Identifier: Apache-2.0
 *
 * How the branches climb the stem (Hayashi & Takahashi 1997, section 3.3 and
 * table 1).
 */
#ifndef SOZAI_TREE_TURNING_H
#define SOZAI_TREE_TURNING_H

#include "plan.h"

#define TURNING_STEPS 512

/* One tree's way of turning. */
typedef struct {
  double turns;                       /* a year */
  double branches;                    /* a turn */
  double quantile[TURNING_STEPS + 1]; /* of its divergence, degrees */
} tree_turning;

void turning_make(tree_turning *t, const tree_plan *p);
/* The divergence at u, 0 to 1, of its distribution. */
double turning_divergence(const tree_turning *t, double u);
/* How far up the year's shoot a share u of its turning has come. */
double turning_height(const tree_plan *p, double u);

#endif
