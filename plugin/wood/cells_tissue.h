/* SPDX-License-Identifier: Apache-2.0
 *
 * Tracheids or fibres: files of cells that run along the radius, and begin anew with each ring.
 */
#ifndef SOZAI_WOOD_CELLS_TISSUE_H
#define SOZAI_WOOD_CELLS_TISSUE_H

#include "../core/noise.h"
#include "cells_fine_ray.h"
#include "vessels.h"

#define CELL_TAPER 0.05f                                  /* of a cell's length, at each end */
#define CELL_TIP 0.4f                                     /* of its width, at the end */
#define CELL_MEAN (1.0f - CELL_TAPER * (1.0f - CELL_TIP)) /* of the width */
#define CELL_BEND 24.0f                                   /* files' widths over which they bend */
#define CELL_BEND_LONG 2.0f                               /* cells' lengths, along the fibre */

/* How far files are bent aside, in files, and by how much that moves with arc and rho, to the mm:
 * they go round rays, and cambial cells are lost and gained. */
INLINE vf cells_bent(const wood_constants *w, const vessel_place *p, vf y, vf *along_arc,
                     vf *along_rho) {
  vf k = splat(w->inverse_cell_width * (1.0f / CELL_BEND)), by = splat(w->cell_bend), g[3];
  vf n = noise_gradient3(p->rho * p->c * k, y * splat(w->inverse_cell_length / CELL_BEND_LONG),
                         p->rho * p->s * k, wood_seed(w, p->own, SEED_CELL_BEND), g);
  k = k * by;
  *along_arc = (g[2] * p->c - g[0] * p->s) * k;
  *along_rho = (g[0] * p->c + g[2] * p->s) * k;
  return n * by;
}

/* The files at a place. */
typedef struct {
  vi file; /* the one that it is in, */
  vf in;   /* and where in it, 0..1 */
  vf arc;  /* mm: a file's width */
  vf e;    /* files: the footprint, not sharp */
  vu seed; /* of the ring's */
} cell_files;

INLINE cell_files cell_files_of(const wood_constants *w, const vessel_place *p, vf y) {
  cell_files q;
  vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f);
  const ring_place *ring = &p->ring;
  vi n;
  vf width = one / ring->inverse_width;
  vf middle = ring->start + ring->turns * splat(w->ring_period) + half * width;
  vf count = vfloor(middle * splat(6.2831853f * w->inverse_cell_width) + half, &n);
  count = vmax(count, splat(3.0f));
  vf turn = (place_has_turn(w) ? p->turn : place_turn(p->c, p->s)) + half;
  q.arc = splat(6.2831853f) * vmax(p->rho, splat(0.05f)) / count;
  vf x = turn * count, files_arc = one / q.arc, files_rho = zero;
  if (w->cell_bend > 0.0f) {
    vf more_arc;
    x = x + cells_bent(w, p, y, &more_arc, &files_rho);
    files_arc = files_arc + more_arc;
  }
  q.in = x - vfloor(x, &q.file);
  q.seed = hash_mix((vu)ring->ring * splatu(HASH_Z) + wood_seed(w, p->own, SEED_CELLS));
  vf e2 = files_arc * (files_arc * p->f.aa + splat(2.0f) * files_rho * p->f.ab) +
          files_rho * files_rho * p->f.bb;
  q.e = vmax(vsqrt(vmax(e2, zero)), splat(CELL_SHARP));
  return q;
}

/* What cells are like at a place, and what the footprint leaves of that. */
typedef struct {
  vf count;             /* of them, from the ring's start */
  vf share;             /* of walls */
  vf across, along;     /* the lumen's part of a cell, along the arc and along the radius */
  vf e;                 /* cells: the footprint along the radius, not sharp */
  vf plain, plain_deep; /* 1: only the mean is left, along the arc and along the radius */
  vf wide;              /* 1: and of how cells taper */
} cell_shape;

INLINE cell_shape cell_shape_of(const wood_constants *w, const vessel_place *p,
                                const cell_face *face, const cell_files *files, vf late) {
  cell_shape q;
  vf one = splat(1.0f), arc = files->arc;
  const ring_place *ring = &p->ring;
  vf early = splat(w->inverse_cell_early);
  vf more = splat(w->inverse_cell_late - w->inverse_cell_early);
  vf width = one / ring->inverse_width;
  q.count = width * (ring->phase * early + late_integral(w, ring->phase) * more);
  vf deep = one / (early + late * more);

  /* walls of the thickness that leaves the lumina their share */
  q.share = mix(splat(w->wall_early), splat(w->wall_late), late);
  vf open = (one - q.share) * splat(1.0f / CELL_MEAN);
  vf sum = arc + deep, four = splat(4.0f) * arc * deep * (one - open);
  vf wall = (sum - vsqrt(vmax(sum * sum - four, splat(0.0f)))) * splat(0.25f);
  q.across = one - (wall + wall) / arc;
  q.along = one - (wall + wall) / deep;

  q.e = vmax(vsqrt(p->f.bb) / deep, splat(CELL_SHARP));
  q.plain = cell_plain(files->e, face->arc);
  q.plain_deep = cell_plain(q.e, face->radius);
  q.wide = vmax(clamp01(q.e - splat(0.5f)), face->arc);
  return q;
}

/* How much of a file's stretch is lumina. h: the file's hash. */
INLINE vf cell_lumina(const wood_constants *w, const cell_shape *o, const cell_stretch *q, vf y,
                      vi file, vu h) {
  vf one = splat(1.0f);
  /* files are offset by golden parts of a cell, so that few of them are alike;
   * and a little at random */
  vf golden = to_float((vi)((vu)file * splatu(0x9e3779b9u) >> 8)) * splat(1.0f / 16777216.0f);
  vf c = o->count + golden + to_float((vi)(h >> 16)) * splat(0.2f / 65536.0f);
  vi cell, unused;
  vfloor(c, &cell);
  /* ends taper; neighbours' do not lie side by side */
  vf offset = to_float((vi)(hash_upper(h + (vu)cell * splatu(HASH_Y)) >> 8));
  vf rows = y * splat(w->inverse_cell_length) + offset * splat(1.0f / 16777216.0f);
  vf at = rows - vfloor(rows, &unused);
  vf taper = clamp01(vmin(at, one - at) * splat(1.0f / CELL_TAPER));
  taper = splat(CELL_TIP) + splat(1.0f - CELL_TIP) * taper;
  vf on = o->across * mix(taper, splat(CELL_MEAN), o->wide);
  vf edge = splat(0.5f) * (one - on) * (q->right - q->left);
  vf x = mix(cell_within(q, q->left + edge, q->right - edge), q->whole * on, o->plain);
  return x * mix(cell_pulse(c, o->e, o->along), o->along, o->plain_deep);
}

/* What cells add to a tissue's colour, relative, before the contrast. late: how far
 * towards latewood; extent: mm, of the footprint along y. */
INLINE vf cells_tissue(const wood_constants *w, const vessel_place *p, const cell_face *face, vf y,
                       vf extent, vf late, vf *contrast) {
  *contrast = splat(0.0f);
  vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f);
  vf e2 = p->f.aa + p->f.bb, gone2 = splat(w->cell_gone * w->cell_gone);
  if (!any(lt(e2, gone2))) return zero;
  cell_files files = cell_files_of(w, p, y);
  cell_shape shape = cell_shape_of(w, p, face, &files, late);
  int fine = w->fine_tall > 0.0f;
  fine_rows rows = {zero, zero, zero, zero, zero};
  if (fine) rows = fine_rows_of(p, y, extent);
  cell_sums sum = {zero, zero};
  cell_stretch q = {.low = files.in - half * files.e, .high = files.in + half * files.e};
  for (int d = -2; d <= 2; d++) {
    q.left = splat((float)d);
    q.right = splat((float)d + 1.0f);
    q.whole = cell_within(&q, q.left, q.right);
    if (d && !any(gt(q.whole, zero))) continue;
    vi file = files.file + splati(d);
    vu h = hash_mix((vu)file * splatu(HASH_X) + files.seed);
    if (fine) {
      fine_ray ray = fine_ray_of(w, y, extent, h);
      fine_ray_add(w, &rows, face, &ray, shape.share, shape.plain, &q, &sum);
    }
    sum.lumen = sum.lumen + cell_lumina(w, &shape, &q, y, file, h);
  }
  vf lumen = sum.lumen / files.e, rays = zero;
  if (fine) {
    float mean = FINE_RAY_SHADE * FINE_RAY_PART * FINE_RAY_FILLED;
    rays = sum.ray / files.e - splat(mean) * splat(w->fine_tall);
  }
  vf keep = one - smooth_step(splat(0.25f) * gone2, gone2, e2);
  *contrast = mix(splat(w->cell_side), splat(w->cell_end), face->fibre);
  return keep * (one - shape.share - lumen + rays);
}

#endif
