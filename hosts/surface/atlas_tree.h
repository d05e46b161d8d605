/* SPDX-License-Identifier: Apache-2.0
 * A tree of boxes over triangles in the UV plane. */
#ifndef SOZAI_SURFACE_ATLAS_TREE_H
#define SOZAI_SURFACE_ATLAS_TREE_H

#include <stdbool.h>
#include <stdint.h>
#include "mesh.h"

#define ATLAS_LEAF 4 /* triangles */

typedef struct atlas_node {
  float low[2], high[2]; /* UV */
  uint32_t first;        /* the lowest index of a triangle below */
} atlas_node;

/* Leaf l holds triangles order[4l] to order[4l+3], neighbours along a Z curve.
 * Nodes stand in preorder: a node over m leaves, m > 1, is followed by its left
 * child over m/2 of them, and 2(m/2)-1 nodes later by its right one over the rest. */
typedef struct atlas_tree {
  uint32_t *order;
  atlas_node *nodes;
  uint32_t count; /* triangles */
  uint32_t leaves;
} atlas_tree;

/* Of the triangles that keep[] names, count of them. false: out of memory. */
bool atlas_tree_build(atlas_tree *t, const mesh *m, const uint32_t *keep, uint32_t count);
void atlas_tree_free(atlas_tree *t);

/* ---- looking at it as a picture of one tile -------------------------------- */

/* From UV to texels: x = (u - left) width, y = (top - v) height. */
typedef struct atlas_view {
  double left, top, width, height;
} atlas_view;

typedef struct atlas_box {
  double low[2], high[2]; /* texels */
} atlas_box;

/* A triangle in a view's texels. */
typedef struct atlas_face {
  uint32_t index;
  double x[3], y[3];
  double area; /* twice it, negative when clockwise; never 0 */
  atlas_box box;
} atlas_face;

typedef struct atlas_found {
  uint32_t index;   /* of the triangle */
  double distance2; /* texels squared; 0: inside */
  double at[2];     /* the triangle's point nearest to the one asked for */
} atlas_found;

/* false: no area. */
bool atlas_face_of(atlas_face *f, const mesh *m, const atlas_view *v, uint32_t triangle);
/* Whether it lies in the triangle, borders included. */
bool atlas_face_contains(const atlas_face *f, double x, double y);

/* The triangle of the view's tile that is nearest to (x, y), and of several the
 * one of the lowest index. found->distance2: how far to look, at the start.
 * false: none is nearer. */
bool atlas_tree_nearest(const atlas_tree *t, const mesh *m, const atlas_view *v, double x, double y,
                        atlas_found *found);
/* The triangles whose boxes meet `box`, in ascending order; how many, or
 * most + 1 where there are more. */
uint32_t atlas_tree_gather(const atlas_tree *t, const mesh *m, const atlas_view *v,
                           const atlas_box *box, uint32_t *triangles, uint32_t most);

#endif
