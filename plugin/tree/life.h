/* SPDX-License-Identifier: Apache-2.0
 *
 * The years of the first-order branches: where the stem bore them and when,
 * how they grew, when they died and fell.
 */
#ifndef SOZAI_TREE_LIFE_H
#define SOZAI_TREE_LIFE_H

#include "tree.h"

typedef struct {
  double z;                  /* height on the stem, mm */
  double turning;            /* degrees, summed from the first branch */
  double azimuth;            /* degrees */
  double elevation;          /* degrees above the horizontal, as it leaves the stem */
  double divergence;         /* from the one before; 0 of the first */
  double birth, death, shed; /* years; TREE_ALIVE */
  double scatter;            /* of its length */
  int year;                  /* the shoot it stands on, from 1 */
  int down;                  /* on the downslope side */
  uint32_t key;
} tree_bud;

/* All that were ever born, from the ground up. To be freed: room * sizeof. */
int32_t life_make(const tree_plan *p, const sozai_host *host, tree_bud **out, uint32_t *count,
                  uint32_t *room);

/* In year t, up to its death: length, and radius at the base. */
double life_length(const tree_plan *p, const tree_bud *b, double t);
double life_radius(const tree_plan *p, const tree_bud *b, double t);

/* What share of that length is there still: dead branches break off from their tips. */
double life_left(const tree_plan *p, const tree_bud *b);

#endif
