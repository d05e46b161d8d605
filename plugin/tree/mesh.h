/* SPDX-License-Identifier: Apache-2.0
 *
 * A tree as one mesh, or as curves: stem and branches as closed tubes that
 * begin within their parent, so that no joint gapes; leaves as sheets.
 */
#ifndef SOZAI_TREE_MESH_H
#define SOZAI_TREE_MESH_H

#include "../generator.h"
#include "bark_surface.h"
#include "skin.h"
#include "tree.h"

/* Numbers of parts, in this order. */
#define PART_BARK 0
#define PART_SHOOT 1
#define PART_LEAF 2

int32_t tree_mesh(const tree *t, const sozai_host *host, uint32_t level, mesh_block **out);
int32_t tree_curves(const tree *t, const sozai_host *host, uint32_t level, curves_block **out);

/* Where to write next. */
typedef struct {
  mesh_block *mesh;
  uint64_t point, triangle;
  float colour[3]; /* of the points to come */
  bark_surface bark;
  const stem_skin *stem; /* NULL: it shows no bark */
} mesh_pen;

uint32_t pen_point(mesh_pen *pen, const float p[3], const float n[3], float u, float v,
                   uint32_t owner);
void pen_triangle(mesh_pen *pen, uint32_t a, uint32_t b, uint32_t c);

/* ---- tube.c ------------------------------------------------------------ */

typedef struct {
  uint32_t sides, rings, stride; /* of nodes */
  uint32_t level;                /* of detail */
  int fine;                      /* more sides and rings, where there is bark to be seen */
  int smooth;                    /* its normals are those of its triangles: with a collar */
} tube_shape;

/* Whether a branch is drawn at that level, and how. bark: NULL for its axis alone. */
int tube_shape_of(const tree *t, const bark_surface *bark, uint32_t branch, uint32_t level,
                  tube_shape *out);
/* How many sides it has, were there no bark to be seen. */
uint32_t tube_sides(const tree_branch *b, uint32_t level);
void tube_size(const tube_shape *s, uint64_t *points, uint64_t *triangles);
void tube_write(mesh_pen *pen, const tree *t, uint32_t branch, const tube_shape *s);

/* ---- leaf.c, needle.c, blade.c ------------------------------------------- */

typedef struct {
  uint32_t points, triangles, stride; /* of one; every stride-th leaf is drawn */
  float longer, wider;
  int closed, shape;
} leaf_shape;

void leaf_shape_of(const tree *t, uint32_t level, leaf_shape *out);
void leaf_write(mesh_pen *pen, const tree_organ *o, const leaf_shape *s);

#endif
