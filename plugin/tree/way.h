/* SPDX-License-Identifier: Apache-2.0
 *
 * The way of a first-order branch: it bends by its length, and turns aside.
 */
#ifndef SOZAI_TREE_WAY_H
#define SOZAI_TREE_WAY_H

#include <stdint.h>

#include "plan.h"

/* How far it is turned aside, degrees, from one turn to the next. All zero at the
 * base: it leaves the stem as its knot does. */
typedef struct {
  double azimuth[2], elevation[2];
} way;

/* Segments of a branch of that length. */
uint32_t way_segments(const tree_plan *p, double length);
/* Where its i-th segment leads, in turn from 0, given how it leaves the stem:
 * degrees. */
void way_step(way *w, const tree_plan *p, uint32_t key, double length, uint32_t i, double *azimuth,
              double *elevation);
/* The elevation at its base of which the straight line from base to tip has
 * that elevation. */
double way_base(const tree_plan *p, uint32_t key, double length, double elevation);

#endif
