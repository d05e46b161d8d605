/* SPDX-License-Identifier: Apache-2.0
 *
 * An axis is a polyline. This walks along one, from base to tip.
 */
#ifndef SOZAI_TREE_AXIS_H
#define SOZAI_TREE_AXIS_H

#include "tree.h"
#include "turn.h"

typedef struct {
  const tree_node *nodes;
  uint32_t last, at;   /* segments; the present one */
  float begin, length; /* of the present segment along the axis, mm */
  float along[3];      /* unit */
  float level[3];      /* unit, square to it, level */
} axis_walk;

static inline void axis_segment(axis_walk *w) {
  const float *a = w->nodes[w->at].p, *b = w->nodes[w->at + 1].p;
  float x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
  float length = __builtin_sqrtf(x * x + y * y + z * z);
  w->length = length;
  float s = length > 0.0f ? 1.0f / length : 0.0f;
  w->along[0] = x * s, w->along[1] = length > 0.0f ? y * s : 1.0f, w->along[2] = z * s;
  turn_level(w->along, w->level);
}

static inline void axis_begin(axis_walk *w, const tree_node *nodes, uint32_t count) {
  w->nodes = nodes;
  w->last = count - 1;
  w->at = 0;
  w->begin = 0.0f;
  axis_segment(w);
}

/* To s mm from the base; s may only grow. Gives the point and its radius. */
static inline float axis_to(axis_walk *w, float s, float p[3]) {
  while (s > w->begin + w->length && w->at + 1 < w->last) {
    w->begin += w->length;
    w->at++;
    axis_segment(w);
  }
  float t = s - w->begin;
  const tree_node *a = &w->nodes[w->at];
  for (int c = 0; c < 3; c++) p[c] = a->p[c] + t * w->along[c];
  float share = w->length > 0.0f ? t / w->length : 0.0f;
  if (share > 1.0f) share = 1.0f;
  return a->r + share * (w->nodes[w->at + 1].r - a->r);
}

#endif
