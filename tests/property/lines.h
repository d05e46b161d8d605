/* SPDX-License-Identifier: Apache-2.0
 *
 * What straight lines meet of light bodies in black stone.
 */
#ifndef SOZAI_TEST_LINES_H
#define SOZAI_TEST_LINES_H

#include "wood.h"

typedef struct {
  int count, steps;
  double step; /* mm */
} lines;

/* At random places, along x: the part that lies in bodies, of albedo above a quarter, and how
 * often one begins to a mm. */
void lines_meet(const lines *l, const sozai_texture *t, double *covered, double *begin);

#endif
