/* SPDX-License-Identifier: Apache-2.0
 *
 * What grows upon the first-order branches: shoots of the second and third
 * order, and leaves. Run twice: to count, then to write where the counts said.
 */
#ifndef SOZAI_TREE_SHOOTS_H
#define SOZAI_TREE_SHOOTS_H

#include "tree.h"

typedef struct {
  uint64_t branches, nodes, organs;
} shoot_room;

/* Where to write next. */
typedef struct {
  tree *tree;
  int writing; /* else only counting, in `used` */
  int sprigs;  /* clothe shoots as one */
  float thin;  /* 1: every leaf; 4: one of four, twice as large */
  shoot_room used;
  shoot_room at; /* of the first to write */
} shoot_pen;

/* All upon one branch. from: no shoots below that many mm from its base. */
void shoots_on(shoot_pen *pen, uint32_t branch);
/* Leaves alone, over the last `zone` mm: the stem's leader. */
void shoots_leader(shoot_pen *pen, uint32_t branch, float zone);

#endif
