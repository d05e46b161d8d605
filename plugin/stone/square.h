/* SPDX-License-Identifier: Apache-2.0
 *
 * A footprint in the lattice of a layer of cells: a square of two sides, sheared
 * where the layer is stretched.
 */
#ifndef SOZAI_STONE_SQUARE_H
#define SOZAI_STONE_SQUARE_H

#include "../core/lanes.h"
#include "../core/vectors.h"

/* Its two sides, in cells. */
typedef struct {
  vf u[3], v[3];
} cells_square;

INLINE vf cells_length(const vf x[3]) { return vsqrt(dot3(x, x)); }

/* The extent over the square of a number that changes by g to a cell. */
INLINE vf cells_extent2(const cells_square *s, const vf g[3], float blur) {
  vf u = dot3(g, s->u), v = dot3(g, s->v), all = dot3(g, g);
  return u * u + v * v + all * splat(blur * blur) + splat(1e-12f);
}

#endif
