/* SPDX-License-Identifier: Apache-2.0
 *
 * Which nodes of a grid are inside, line by line: where each line of nodes
 * crosses the hull is found once, and a node counts what is beyond it. As
 * hull_inside, to the crossing.
 */
#ifndef SOZAI_FIBER_GRID_SIGNS_H
#define SOZAI_FIBER_GRID_SIGNS_H

#include "hull.h"

typedef struct line_crossing {
  double at;
  uint32_t line;
  int32_t turn;
} line_crossing;

typedef struct signs {
  int axes, rule;
  uint32_t nodes[3];     /* of the grid */
  double origin[3], gap; /* its first node, and from node to node */
  line_crossing *list[3];
  uint32_t *first[3]; /* of each line, and one more */
  uint32_t room[3], count[3], lines[3];
} signs;

int32_t signs_make(signs *s, const sozai_host *host, const hull *h, const double origin[3],
                   double gap, const uint32_t nodes[3]);
void signs_free(signs *s, const sozai_host *host);
int signs_inside(const signs *s, const uint32_t node[3]);

static inline float signs_place(const signs *s, int axis, uint32_t i) {
  return (float)(s->origin[axis] + s->gap * (double)i);
}

#endif
