/* SPDX-License-Identifier: Apache-2.0
 *
 * A footprint in the lattice of a layer of cells: a square of two sides, sheared
 * where the layer is stretched.
 */
#ifndef SOZAI_STONE_SQUARE_H
#define SOZAI_STONE_SQUARE_H

#include "../core/lanes.h"

/* Its two sides, in cells. */
typedef struct {
  vf u[3], v[3];
} cells_square;

INLINE vf cells_length(const vf x[3]) { return vsqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]); }

/* The extent over the square of a number that changes by g to a cell. */
INLINE vf cells_extent2(const cells_square *s, const vf g[3], float blur) {
  vf u = g[0] * s->u[0] + g[1] * s->u[1] + g[2] * s->u[2];
  vf v = g[0] * s->v[0] + g[1] * s->v[1] + g[2] * s->v[2];
  vf all = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
  return u * u + v * v + all * splat(blur * blur) + splat(1e-12f);
}

#endif
