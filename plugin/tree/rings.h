/* SPDX-License-Identifier: Apache-2.0
 *
 * A branch's axis as a mesh's level of detail has it: stations from base to tip, at each of which a
 * tube has a ring.
 */
#ifndef SOZAI_TREE_RINGS_H
#define SOZAI_TREE_RINGS_H

#include "tree.h"

#define RINGS_MOST 512u

typedef struct {
  float p[3], r, age; /* age: of its bark */
  float way;          /* on a collar, collar.h: how far along it; below 0: beyond */
  float next;         /* on a collar: mm, the longest way to the next ring */
} ring;

/* Those of an axis at a level of detail: at its nodes, or every stride-th of them; of limbs also
 * between them where they bend, on a curve through them. */
uint32_t rings_stride(const tree_branch *b, uint32_t level);
uint32_t rings_lay(const tree *t, const tree_branch *b, uint32_t level, ring *out);

float rings_apart(const ring *a, const ring *b);

/* What lies at a share of the way from one to the next. */
void rings_between(const ring *a, const ring *b, float share, ring *out);

/* The axis's direction at the i-th, and from there a share of the way to the next one's. */
void rings_direction(const ring *rings, uint32_t count, uint32_t i, float share, float out[3]);

/* Which of the axis's pieces is nearest to a place, and which share of it. */
uint32_t rings_nearest(const ring *rings, uint32_t count, const float p[3], float *share);

/* What lies s mm along the axis, of which along is the direction. */
void rings_along(const ring *rings, uint32_t count, float s, ring *out, float along[3]);

#endif
