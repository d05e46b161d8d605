/* SPDX-License-Identifier: Apache-2.0
 *
 * A stem's foot: stems of some size stand on roots, lobes that are gone a diameter or two up, and
 * lie flat on the ground, however they lean.
 */
#ifndef SOZAI_TREE_FOOT_H
#define SOZAI_TREE_FOOT_H

#include "tree.h"

/* How many sides roots take at a level of detail; 0: as many as any tube. */
uint32_t foot_sides(const tree_branch *b, uint32_t level);

/* Of a ring at that height the share of the radius at the k-th of its sides, and out its normal,
 * in the ring's plane. */
float foot_radius(const tree *t, const tree_branch *b, float height, uint32_t k, uint32_t sides,
                  float out[2]);

/* Turns a ring's direction, along, towards upright: rings come round to it by and by. */
void foot_stand(const tree_branch *b, float height, float along[3]);

#endif
