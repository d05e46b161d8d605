/* SPDX-License-Identifier: Apache-2.0
 *
 * Limbs that fork: where a branch of the first order divides, an arm leaves it that is nearly as
 * long as what the branch has left, grows as a branch does and forks in turn. Crowns of broadleaves
 * are such limbs, those of most conifers are not: decurrent and excurrent (Brown, McAlpine &
 * Kormanik 1967, American Journal of Botany 54, 153-162).
 */
#ifndef SOZAI_TREE_ARMS_H
#define SOZAI_TREE_ARMS_H

#include "tree.h"

typedef struct {
  uint64_t branches, nodes;
} arms_room;

/* Added to `room`: what a branch's arms, and theirs, take. length: mm, its own. */
void arms_count(const tree_plan *p, uint32_t key, float length, arms_room *room);

/* Grows them, after all that is there; t has room. */
void arms_grow(tree *t, uint32_t branch);

#endif
