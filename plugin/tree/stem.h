/* SPDX-License-Identifier: Apache-2.0
 *
 * The stem and the first-order branches as polylines, by the paper's node
 * positions (section 4.2 (1)): x = l sin(theta) cos(phi), y = l cos(theta)
 * cos(phi), z = l sin(phi), summed from the ground; see tree.h for the axes.
 */
#ifndef SOZAI_TREE_STEM_H
#define SOZAI_TREE_STEM_H

#include "life.h"

/* The segment of length l in the direction theta, phi (degrees), from p. */
void stem_step(float p[3], double l, double theta, double phi);

/* A branch's nodes, from its base on, as its azimuth, elevation, key and length have them. */
void stem_lay(const tree_plan *p, const tree_branch *o, double length, const float base[3],
              tree_node *nodes);

/* Branches and nodes of the stem and of the buds that are still there. */
int32_t stem_grow(tree *t, const sozai_host *host, const tree_bud *buds, uint32_t count);

#endif
