/* SPDX-License-Identifier: Apache-2.0
 *
 * Fine rays, of one cell's width: each takes a part of the file beside it.
 */
#ifndef SOZAI_WOOD_CELLS_FINE_RAY_H
#define SOZAI_WOOD_CELLS_FINE_RAY_H

#include "cells.h"
#include "rays.h"
#include "vessels.h"

#define FINE_RAY_PART 0.47f  /* of a file's width, that a ray takes from the file beside it, */
#define FINE_RAY_RAGGED 0.3f /* of that: by which its rows begin later, and end sooner or later */
#define FINE_RAY_FILLED (1.0f - 0.5f * FINE_RAY_RAGGED)
#define FINE_RAY_SHADE 0.5f /* by which it is brighter, in the contrast of walls */

/* The stretch of a footprint that lies within a file; in files. */
typedef struct {
  vf low, high;   /* the footprint's ends, */
  vf left, right; /* and the file's, less what its fine ray takes */
  vf whole;       /* how much of one lies in the other */
} cell_stretch;

INLINE vf cell_within(const cell_stretch *q, vf left, vf right) {
  return vmax(vmin(q->high, right) - vmax(q->low, left), splat(0.0f));
}

/* What a footprint sees, over its files. */
typedef struct {
  vf lumen; /* how much of it is lumina, */
  vf ray;   /* and how much brighter rays are than walls */
} cell_sums;

/* A fine ray at a file's side: how much of the footprint's height it covers. h: the file's. */
typedef struct {
  vf cover;
  vu hash;
} fine_ray;

INLINE fine_ray fine_ray_of(const wood_constants *w, vf y, vf extent, vu h) {
  fine_ray r;
  vi row;
  vf pitch = splat(w->inverse_fine_pitch), one = splat(1.0f), half = splat(0.5f);
  vf start = to_float((vi)(hash_upper(h) >> 8)) * splat(1.0f / 16777216.0f);
  vf rows = y * pitch + start, at = rows - vfloor(rows, &row) - half;
  r.hash = hash_mix(h + (vu)row * splatu(HASH_Y));
  vf tall = to_float((vi)(r.hash >> 16)) * splat(1.0f / 65536.0f) + half;
  vf reach = half * tall * splat(w->fine_tall);
  vf e = half * vmax(extent * pitch, splat(1e-3f));
  vf in = vmin(at + e, reach) - vmax(at - e, splat(0.0f) - reach);
  r.cover = vmin(vmax(in, splat(0.0f)) / (e + e), one);
  return r;
}

/* Rays' cells along y and rho: the same for all files but for where they begin. */
typedef struct {
  vf y, r;   /* cells: the place */
  vf ey, er; /* the footprint, not sharp */
  vf keep;   /* of what differs from row to row */
} fine_rows;

INLINE fine_rows fine_rows_of(const vessel_place *p, vf y, vf extent) {
  fine_rows q;
  q.y = y * splat(1.0f / RAY_ROW);
  q.r = p->rho * splat(1.0f / RAY_CELL);
  q.ey = vmax(extent * splat(1.0f / RAY_ROW), splat(CELL_SHARP));
  q.keep = filter_keep(extent, RAY_ROW);
  q.er = vmax(vsqrt(p->f.bb) * splat(1.0f / RAY_CELL), splat(CELL_SHARP));
  return q;
}

/* Adds the ray at a file's left, and takes its place from the file. h: the file's hash; share: of
 * walls in it; plain: 1 where along the arc only the mean is left. */
INLINE void fine_ray_add(const wood_constants *w, const fine_rows *at, const cell_face *face,
                         const fine_ray *ray, vf share, vf plain, cell_stretch *q, cell_sums *sum) {
  vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f);
  vi row;
  vfloor(at->y, &row);
  vu r = hash_mix(ray->hash + (vu)row * splatu(HASH_Z));
  vf uneven = to_float((vi)(r >> 16)) * splat(2.0f / 65535.0f) - one;
  vf part = splat(FINE_RAY_PART) * ray->cover;
  vf ragged = splat(FINE_RAY_RAGGED) * part;
  vf begins = to_float((vi)(r & splatu(0xffu))) * splat(1.0f / 255.0f);
  vf from = q->left + ragged * mix(half, begins, at->keep);
  vf to = q->left + part + ragged * uneven * at->keep;
  vf covers = cell_within(q, q->left, to);
  if (any(gt(covers, zero))) {
    vf in_ray = cell_within(q, from, to);
    vf on = splat(w->fine_open), edge = half * (one - on) * (to - from);
    vf x = cell_within(q, from + edge, to - edge);
    vf shift = to_float((vi)(r >> 8 & splatu(0xffu))) * splat(1.0f / 256.0f);
    vf rows = mix(cell_pulse(at->y, at->ey, on), on, cell_plain(at->ey, face->fibre));
    vf columns = mix(cell_pulse(at->r + shift, at->er, on), on, cell_plain(at->er, face->radius));
    /* its cells' lumina against their mean, and how bright it is */
    sum->ray = sum->ray + in_ray * (on * on * on + splat(FINE_RAY_SHADE)) -
               mix(x, in_ray * on, plain) * rows * columns;
    sum->lumen = sum->lumen + covers * (one - share);
  }
  q->left = to;
  q->whole = q->whole - covers;
}

#endif
