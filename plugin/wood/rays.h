/* SPDX-License-Identifier: Apache-2.0
 *
 * Rays: sheets of cells that run from the pith outwards, as high along the
 * fibre as they are, and a fraction of a millimetre thick. Cut across the
 * radius they are lenses, cut along it flakes: the silver grain of oak.
 *
 * They stand in cells of (theta', y) within shells of rho, one to a cell, at a
 * hashed place that keeps clear of the cell's edge, so that a point looks into
 * one cell. Two such sets, with shells that overlap by half, hold half of the
 * rays each: one begins within the inner half of its shell and ends within the
 * outer, evenly, so that the two sets together are as dense at every radius.
 * theta' moves with the grain.
 */
#ifndef SOZAI_WOOD_RAYS_H
#define SOZAI_WOOD_RAYS_H

#include "../core/noise.h"
#include "stem.h"

/* Where a point is, and the footprint there: mm along the arc and along y. */
typedef struct {
  vf rho, turn, y;      /* turn: theta' / 2 pi, 0..1 */
  vf aa, ab, bb, along; /* products along arc and rho; extent along y */
} ray_place;

/* Share of lo..hi that -w..w covers; hi > lo. */
INLINE vf ray_overlap(vf lo, vf hi, vf w) {
  vf in = vmin(hi, w) - vmax(lo, splat(0.0f) - w);
  return vmax(in, splat(0.0f)) / (hi - lo);
}

/* The integral of 1 - x^2 from 0, held beyond +-1. */
INLINE vf ray_lens(vf x) {
  x = clamp(x, splat(-1.0f), splat(1.0f));
  return x - x * x * x * splat(1.0f / 3.0f);
}

/* A set's cells round the pith at a point: how many, and where in them it is. */
typedef struct {
  vi shell, column, count;
  vf within, x; /* of the shell, of the cell: 0..1 */
  vf arc;       /* mm: of a cell */
} ray_cells;

INLINE ray_cells ray_cells_at(const wood_constants *w, const ray_place *p, int set) {
  ray_cells q;
  vf shells = p->rho * splat(w->inverse_ray_length) + splat(0.5f * (float)set);
  vf low = vfloor(shells, &q.shell);
  q.within = shells - low;
  vf middle = vmax(low + splat(0.5f - 0.5f * (float)set), splat(0.25f)) * splat(w->ray_length);
  vf count = vmax(vfloor(middle * splat(w->ray_per_radius), &q.count), splat(3.0f));
  q.count = to_int(count);
  vf x = p->turn * count;
  q.x = x - vfloor(x, &q.column);
  q.arc = vmax(p->rho, splat(0.05f)) * splat(6.2831853f) / count;
  return q;
}

/* Cover by the ray of the cell `side` columns on. */
INLINE vf ray_of_cell(const wood_constants *w, const ray_place *p, const ray_cells *q, int set,
                      int side) {
  vf one = splat(1.0f), half = splat(0.5f), k16 = splat(1.0f / 65536.0f);
  vi column = q->column + splati(side), iy;
  column = seli(lti(column, splati(0)), column + q->count, column);
  column = seli(lti(column, q->count), column, column - q->count);
  vu seed = wood_seed(w, SEED_RAYS) + splatu((uint32_t)set);
  vu root = hash_mix((vu)column * splatu(HASH_X) + (vu)q->shell * splatu(HASH_Z) + seed);
  /* columns of cells stand at heights of their own */
  vf rows = p->y * splat(w->inverse_ray_cell) + to_float((vi)(root >> 16)) * k16;
  vf y = rows - vfloor(rows, &iy);
  vu h = hash_mix((vu)iy * splatu(HASH_Y) + root), g = hash_mix(h + splatu(HASH_Z));

  vf u = to_float((vi)(h >> 16)) * k16, v = to_float((vi)(h & splatu(0xffffu))) * k16;
  vf tall = splat(w->ray_tall) * (half + u); /* half the height, in cells */
  vf centre = tall + v * (one - tall - tall);
  vf place = splat(0.33f) + splat(0.34f / 256.0f) * to_float((vi)(g & splatu(255u)));
  vf starts = to_float((vi)(g >> 8 & splatu(255u))) * splat(0.5f / 256.0f);
  vf ends = one - to_float((vi)(g >> 16 & splatu(255u))) * splat(0.5f / 256.0f);
  /* thinner rays are as many as thick ones */
  vf thick = splat(w->ray_half) * (splat(0.6f) + splat(0.8f / 256.0f) * to_float((vi)(g >> 24)));
  /* they taper to their ends along the radius */
  vf taper =
      clamp01((q->within - starts) * splat(16.0f)) * clamp01((ends - q->within) * splat(16.0f));

  /* the sheets are not flat: a cut along one leaves it and meets it again */
  noise_axis out = noise_split(p->rho * splat(w->ray_wave_radial), HASH_X);
  noise_axis up = noise_split(p->y * splat(w->ray_wave_along), HASH_Y);
  vf lean, sway, stray = noise_value2(&out, &up, h, &lean, &sway);
  vf a = (q->x - splat((float)side) - place) * q->arc + stray * splat(w->ray_stray);
  /* so that the footprint's extents along rho and y count too */
  lean = lean * splat(w->ray_stray * w->ray_wave_radial);
  sway = sway * splat(w->ray_stray * w->ray_wave_along) * p->along;
  vf arc2 = p->aa + lean * (splat(2.0f) * p->ab + lean * p->bb) + sway * sway;
  /* no edge is sharper than a hundredth of a millimetre */
  vf reach = half * vsqrt(vmax(arc2, splat(0.0f)) + splat(1e-4f));
  vf e = half * p->along * splat(w->inverse_ray_cell) / tall, at = (y - centre) / tall;
  e = vmax(e, splat(1e-3f));
  vf lens = (ray_lens(at + e) - ray_lens(at - e)) / (e + e);
  return ray_overlap(a - reach, a + reach, thick * taper * lens);
}

/* Cover by the rays of one set. A ray keeps 0.03 of its cell's arc clear on
 * either side, and no footprint of half a cell reaches past the next. */
INLINE vf ray_set(const wood_constants *w, const ray_place *p, int set, vf *share) {
  ray_cells q = ray_cells_at(w, p, set);
  vf sum = ray_of_cell(w, p, &q, set, 0);
  vf most = p->aa + splat(w->ray_lean2) * (p->bb + p->along * p->along) + splat(1e-4f);
  if (any(gt(most, splat(0.0009f) * q.arc * q.arc))) {
    sum = sum + (ray_of_cell(w, p, &q, set, -1) + ray_of_cell(w, p, &q, set, 1));
  }
  /* of the rays that are expected: a shell's cells widen outwards, and a radius
   * meets more of them the nearer it is to the shell's middle */
  vf inside = vmin(q.within, splat(1.0f) - q.within);
  *share = (inside + inside) / (q.arc * splat(w->inverse_ray_arc));
  return sum;
}

INLINE vf rays_at(const wood_constants *w, vf rho, vf c, vf s, vf y, const footprint2 *f,
                  vf along) {
  ray_place p;
  vi unused;
  vf turn = arctan2(s, c) * splat(0.15915494f), one = splat(1.0f);
  p.rho = rho;
  p.turn = turn - vfloor(turn, &unused);
  p.y = y;
  p.aa = f->aa;
  p.ab = f->ab;
  p.bb = f->bb;
  p.along = along;
  /* past the cells looked at the expected cover takes over */
  vf far =
      vmax(vsqrt(p.aa) * splat(0.5f * w->inverse_ray_arc), p.along * splat(w->inverse_ray_cell));
  vf fade = smooth_step(splat(0.45f), splat(1.0f), far);
  vf s0, s1, found = ray_set(w, &p, 0, &s0) + ray_set(w, &p, 1, &s1);
  return vmin(mix(found, splat(w->ray_cover) * (s0 + s1), fade), one);
}

#endif
