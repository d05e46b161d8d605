/* SPDX-License-Identifier: Apache-2.0
 * Curves as rays meet them: round, each point's radius its own. */
#ifndef SOZAI_RENDER_STRANDS_H
#define SOZAI_RENDER_STRANDS_H

#include "scene.h"
#include "sozai.h"

typedef struct strands {
  scene scene;       /* for the studio and the camera: no mesh in it */
  float *vertices;   /* x y z radius each */
  uint32_t *indices; /* of each segment's first point */
  uint32_t *owner;   /* of each segment: its curve */
  unsigned char *flags;
  uint64_t vertex_count, segment_count;
} strands;

typedef struct strand_hit {
  vec point, normal, tangent; /* unit; the normal square to the tangent */
  float radius;
  uint32_t curve;
  float distance;
} strand_hit;

/* smooth: how many pieces each segment is cut into, along the smooth curve
 * through the points. floor: below them, or none. */
bool strands_open(strands *s, const sozai_curves *c, uint32_t smooth, bool floor, failure *why);
void strands_close(strands *s);
bool strands_trace(const strands *s, vec origin, vec direction, strand_hit *h);
/* Out of the fibre that was hit, where a ray of that direction leaves it. */
vec strand_leave(const strand_hit *h, vec direction);

#endif
