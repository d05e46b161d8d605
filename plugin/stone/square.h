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

/* A square as it is seen, whole or in quarters: how many parts, their sides, and how far along
 * each side their middles are from its own, of its sides. */
typedef struct {
  int count;
  vf side, away;
} cells_parts;

INLINE cells_parts cells_whole(void) { return (cells_parts){1, splat(1.0f), splat(0.0f)}; }
INLINE cells_parts cells_quarters(void) { return (cells_parts){4, splat(0.5f), splat(0.25f)}; }
INLINE cells_parts cells_part(vf wide, float whole) {
  vm wider = gt(wide, splat(whole));
  if (!any(wider)) return cells_whole();
  return (cells_parts){4, sel(wider, splat(0.5f), splat(1.0f)),
                       sel(wider, splat(0.25f), splat(0.0f))};
}

/* The mean over the parts; of four that are the same, to the bit that. */
INLINE vf cells_mean(const cells_parts *p, const vf x[4]) {
  return p->count > 1 ? splat(0.25f) * ((x[0] + x[1]) + (x[2] + x[3])) : x[0];
}

/* A number on its way to a part's middle, u and v what it changes by along the sides. */
INLINE vf cells_towards(const cells_parts *p, int part, vf x, vf u, vf v) {
  if (p->count == 1) return x;
  return x + (part & 1 ? u : splat(0.0f) - u) + (part & 2 ? v : splat(0.0f) - v);
}

/* An edge through the square: how far inside of it the middle lies, in units of its own; what
 * that changes by on the way to the parts' middles; and one over a part's extent. */
typedef struct {
  vf in, u, v, inverse;
} cells_edge;

INLINE cells_edge edge_of(const cells_square *s, const cells_parts *p, vf in, const vf g[3],
                          float blur) {
  vf u = dot3(g, s->u), v = dot3(g, s->v), all = dot3(g, g);
  cells_edge e = {in, u * p->away, v * p->away, in};
  u = u * p->side;
  v = v * p->side;
  e.inverse = inverse_root(u * u + v * v + all * splat(blur * blur) + splat(1e-12f));
  return e;
}

/* How much of a part lies inside. Exact for a plane. */
INLINE vf edge_cover(const cells_edge *e, const cells_parts *p, int part) {
  return clamp01(splat(0.5f) + cells_towards(p, part, e->in, e->u, e->v) * e->inverse);
}

/* Of a part, what lies inside of two edges: the product of two that know nothing of each
 * other, the lesser of two along each other; faces of a crystal are between. */
INLINE vf edges_both(vf a, vf b) { return splat(0.5f) * (vmin(a, b) + a * b); }

#endif
