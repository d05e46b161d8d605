/* SPDX-License-Identifier: Apache-2.0
 *
 * Signed distances on a grid: exact at its nodes, trilinear between. Cells
 * that the surface may pass through are divided by four along each axis.
 */
#ifndef SOZAI_FIBER_GRID_H
#define SOZAI_FIBER_GRID_H

#include "hull.h"

#define GRID_FINE 4
#define GRID_BRICK 125 /* nodes of a divided cell, both ends of each axis */

typedef struct grid {
  float origin[3], spacing, inverse; /* of the undivided cells */
  float end[3];                      /* cells along each axis, less a little */
  uint32_t cells[3];
  float *nodes;          /* (cells + 1) along each axis, x first */
  int32_t *brick_of;     /* of each cell: its brick, or -1 */
  float *bricks;         /* GRID_BRICK each, x first */
  uint32_t *brick_cells; /* of each brick: its cell */
  uint32_t *candidates;  /* cells that may hold a point inside */
  uint32_t node_count, cell_count, brick_count, candidate_count, candidate_room;
  double volume; /* mm3 inside, to about a cell's corner */
} grid;

/* cells: divided ones along the hull's longest side. */
int32_t grid_make(grid *f, const sozai_host *host, const hull *h, uint32_t cells);
void grid_free(grid *f, const sozai_host *host);
uint64_t grid_bytes(const grid *f);

/* Where a point lies in the grid: eight nodes and the place between them. */
typedef struct grid_place {
  const float *at;
  uint32_t y, z;      /* from a node to the next along y and z */
  float t[3], beyond; /* distance to the grid, of points outside it */
  float spacing;
} grid_place;

static inline __attribute__((always_inline)) grid_place grid_find(const grid *f, float x, float y,
                                                                  float z) {
  float p[3] = {x, y, z}, over = 0;
  uint32_t c[3];
  grid_place r;
  for (int a = 0; a < 3; a++) {
    float u = (p[a] - f->origin[a]) * f->inverse;
    float v = u > 0.0f ? u : 0.0f;
    v = v < f->end[a] ? v : f->end[a];
    float d = u - v;
    over += d * d;
    c[a] = (uint32_t)(int32_t)v;
    r.t[a] = v - (float)(int32_t)c[a];
  }
  uint32_t cell = c[0] + f->cells[0] * (c[1] + f->cells[1] * c[2]);
  int32_t b = f->brick_of[cell];
  if (b >= 0) {
    uint32_t s[3];
    for (int a = 0; a < 3; a++) {
      float u = r.t[a] * (float)GRID_FINE;
      s[a] = (uint32_t)(int32_t)u;
      r.t[a] = u - (float)(int32_t)s[a];
    }
    r.y = 5, r.z = 25;
    r.at = f->bricks + (size_t)b * GRID_BRICK + (s[0] + 5 * s[1] + 25 * s[2]);
    r.spacing = f->spacing * (1.0f / GRID_FINE);
  } else {
    r.y = f->cells[0] + 1, r.z = r.y * (f->cells[1] + 1);
    r.at = f->nodes + (c[0] + r.y * c[1] + (size_t)r.z * c[2]);
    r.spacing = f->spacing;
  }
  r.beyond = over > 0.0f ? __builtin_sqrtf(over) * f->spacing : 0.0f;
  return r;
}

static inline __attribute__((always_inline)) float grid_at(const grid *f, float x, float y,
                                                           float z) {
  grid_place r = grid_find(f, x, y, z);
  const float *n = r.at;
  float a = n[0] + (n[1] - n[0]) * r.t[0];
  float b = n[r.y] + (n[r.y + 1] - n[r.y]) * r.t[0];
  float c = n[r.z] + (n[r.z + 1] - n[r.z]) * r.t[0];
  float d = n[r.y + r.z] + (n[r.y + r.z + 1] - n[r.y + r.z]) * r.t[0];
  float e = a + (b - a) * r.t[1], g = c + (d - c) * r.t[1];
  return e + (g - e) * r.t[2] - r.beyond;
}

/* Whether a point is inside the hull itself: by the field where that settles
 * it, else by the hull. */
int grid_inside(const grid *f, const hull *h, const float p[3]);

#endif
