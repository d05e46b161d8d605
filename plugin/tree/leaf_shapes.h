/* SPDX-License-Identifier: Apache-2.0
 *
 * Shapes of needles and leaves, and the frame that they are drawn in.
 */
#ifndef SOZAI_TREE_LEAF_SHAPES_H
#define SOZAI_TREE_LEAF_SHAPES_H

#include "mesh.h"

/* needle.c's: of needles, and of shoots clothed in them */
#define SHAPE_AWL 0    /* three sides and a base, closed */
#define SHAPE_GUTTER 1 /* two of an awl's three sides */
#define SHAPE_SLIVER 2 /* one triangle */
#define SHAPE_SPRIG 3  /* a core and awls about it */
#define SHAPE_SPARSE 4 /* a sprig with half its awls, twice as wide */
#define SHAPE_CORE 5   /* its core alone */
#define NEEDLES 6
/* blade.c's */
#define SHAPE_BLADE 6
#define SHAPE_FLAT 7 /* a blade without its fold */
#define SHAPE_DIAMOND 8
#define SHAPE_ELLIPSE 9
#define SHAPE_SIX 10 /* an ellipse of six points */
#define SHAPE_LOBED 11
#define SHAPE_THREE 12 /* a hand of three lobes */
#define SHAPE_FIVE 13  /* what five points are of it */
#define SHAPE_TOOTHED 14
#define SHAPE_OBOVATE 15 /* it without teeth and fold */

#define SPRIG_AWLS 12
#define SPARSE_AWLS 6
#define ELLIPSE_POINTS 12
#define HAND_POINTS 14
#define SIX_POINTS 6
#define THREE_POINTS 8
#define FIVE_POINTS 5
#define TEETH_POINTS 5 /* to a side: three teeth */

/* A leaf's own frame: along it, to its side, out of its upper face. */
typedef struct {
  const float *base;
  float along[3], side[3], up[3];
  float length, half;
  uint32_t owner;
} leaf_frame;

/* At (x, y, z) of the frame; normal likewise. */
static inline uint32_t leaf_at(mesh_pen *pen, const leaf_frame *f, float x, float y, float z,
                               float nx, float ny, float nz) {
  float p[3], n[3];
  for (int c = 0; c < 3; c++) {
    p[c] = f->base[c] + y * f->along[c] + x * f->side[c] + z * f->up[c];
    n[c] = ny * f->along[c] + nx * f->side[c] + nz * f->up[c];
  }
  return pen_point(pen, p, n, 0.5f + 0.5f * x / (f->half > 0.0f ? f->half : 1.0f),
                   y / (f->length > 0.0f ? f->length : 1.0f), f->owner);
}

void needle_write(mesh_pen *pen, const leaf_frame *f, const leaf_shape *s);
void blade_write(mesh_pen *pen, const leaf_frame *f, int shape);

#endif
