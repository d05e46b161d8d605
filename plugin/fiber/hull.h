/* SPDX-License-Identifier: Apache-2.0
 *
 * The surface that strands are packed into: what is inside, and how far off the
 * surface is. In coordinates of its own, about its box's centre, so that a hull
 * far from the origin is as exact as one at it.
 *
 * Inside is
 *   closed, and all faces turned one way (outward or inward): where the surface
 *     winds round a point other than 0 times, so that hulls that cross
 *     themselves or one another are one body, and a cavity is a cavity;
 *   closed, faces turned either way: where a ray meets the surface an odd
 *     number of times;
 *   open: where of the six rays along the axes four or more do.
 * Literally as the paper: behind the nearest vertex's normal.
 */
#ifndef SOZAI_FIBER_HULL_H
#define SOZAI_FIBER_HULL_H

#include "../../api/sozai.h"

#define HULL_WINDING 0
#define HULL_PARITY 1
#define HULL_VOTE 2
#define HULL_VERTICES 3 /* the literal one */

typedef float f4 __attribute__((vector_size(16)));
typedef int32_t i4 __attribute__((vector_size(16)));

#define HULL_LEAF 4u /* triangles, or vertices, of a leaf */
#define HULL_WIDE 8u /* children of a node */
#define HULL_LEVELS 12

/* Leaves of four, in the order of Hilbert's curve; a triangle's corners, or a vertex and its
 * normal. */
typedef struct hull_leaf {
  f4 corner[3][3]; /* [corner][axis] */
} hull_leaf;

/* Boxes of eight children: along the axes, for rays; and for the nearest along
 * the patch's own normal, since a patch that lies across the axes fills its box
 * badly. [..][child] */
typedef struct hull_node {
  float low[3][HULL_WIDE], high[3][HULL_WIDE];
  float axis[3][3][HULL_WIDE]; /* [axis][component] */
  float from[3][HULL_WIDE], to[3][HULL_WIDE];
} hull_node;

typedef struct hull {
  double centre[3];
  float low[3], high[3]; /* about the centre */
  float side;            /* the longest of the box */
  int rule;
  uint32_t given;    /* triangles, or points, as handed in */
  uint32_t items;    /* of them with any area; in the literal mode dense vertices */
  double area;       /* mm2 */
  hull_leaf *leaves; /* of level 0 */
  hull_node *nodes;  /* level 1 first, the root last */
  uint32_t leaf_count, node_count;
  uint32_t level_first[HULL_LEVELS], level_count[HULL_LEVELS]; /* of nodes; level 1 is [0] */
  int levels;
} hull;

/* From a mesh. spacing > 0: as dense vertices, none further apart than that,
 * for the literal mode. Errors: RANGE, MEMORY. */
int32_t hull_from_mesh(hull *h, const sozai_host *host, const sozai_buffer *mesh, double spacing);
/* From points with normals: the literal mode's alone. */
int32_t hull_from_points(hull *h, const sozai_host *host, const sozai_buffer *points);
void hull_free(hull *h, const sozai_host *host);
uint64_t hull_bytes(const hull *h);

/* Distance to the surface, never negative; at most `bound`. */
float hull_distance(const hull *h, const float p[3], float bound);
/* Likewise, without a bound. *hint: a place in the tree to look at first, such
 * as the last point's nearest, which is left there; 0 at first. Not of
 * HULL_VERTICES. */
float hull_distance_near(const hull *h, const float p[3], uint32_t *hint);
/* Whether a point is inside. Not of HULL_VERTICES. */
int hull_inside(const hull *h, const float p[3]);
/* The paper's, equation (2). Of HULL_VERTICES. */
float hull_literal(const hull *h, const float p[3]);

/* Builds leaves and nodes over `items` items; item(context, i, out) gives the
 * nine numbers of one. */
int32_t hull_tree(hull *h, const sozai_host *host,
                  void (*item)(const void *context, uint32_t i, float out[9]), const void *context);

/* Where a line along `axis` through the point q of the other two axes (in the
 * cyclic order after it) crosses a triangle: +1 where it leaves a body whose
 * faces look outward, -1 where it enters, 0 nowhere; *at: where. Edges and
 * corners are met by exactly one of the triangles that share them. */
int hull_crossing(const float corner[3][3], int axis, const float q[2], double *at);

#endif
