/* SPDX-License-Identifier: Apache-2.0
 *
 * Rays: sheets of cells that run from the pith outwards, as high along the
 * fibre as they are, and a fraction of a millimetre thick. Cut across the
 * radius they are lenses, cut along it flakes: the silver grain of oak.
 *
 * They stand in cells of (theta', y) within shells of rho, one to a cell, at a
 * hashed place that keeps clear of the cell's edge, so that a point looks into
 * one cell. A ray begins in the inner quarter of its shell and ends in the outer.
 * Round the pith there are sectors, and each has shells of its own, so that no
 * radius is one at which all rays end. theta' moves with the grain.
 */
#ifndef SOZAI_WOOD_RAYS_H
#define SOZAI_WOOD_RAYS_H

#include "../core/noise.h"
#include "stem.h"

/* Where a point is among sheets that sway. */
typedef struct {
  vf turn;       /* theta' / 2 pi, 0..1 */
  vf lean, sway; /* slopes of the sheets' waves along rho and along y */
} ray_turn;

/* The same, and the footprint there. */
typedef struct {
  vf rho, y;
  vf aa, ab, bb, along; /* products along arc and rho; extent along y */
  ray_turn at;
  vu own; /* the seeds' offset */
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

/* The cells at a point, and where in them it is. */
typedef struct {
  vi shell, column;
  vf within, x; /* of the shell, of the cell: 0..1 */
  vf arc;       /* mm: of a cell */
  vf reach;     /* mm: of the footprint to either side */
  vf middle;    /* mm: of the shell, at its sector's beginning */
  vf count;     /* of the sector's cells in it */
  vu seed;
} ray_cells;

/* In three steps, as what follows on them is, so that the kernel can take a few
 * blocks through each: the shell, */
INLINE ray_cells ray_shell_at(const wood_constants *w, const ray_place *p) {
  ray_cells q;
  vi sector;
  vf round = p->at.turn * splat((float)WOOD_RAY_SECTORS), whole = vfloor(round, &sector);
  q.x = round - whole;
  q.seed = wood_seed(w, p->own, SEED_RAYS) + (vu)sector * splatu(HASH_Y);
  vf offset = to_float((vi)(hash_upper(q.seed) >> 8)) * splat(1.0f / 16777216.0f);
  vf shells = p->rho * splat(w->inverse_ray_length) + offset;
  vf low = vfloor(shells, &q.shell);
  q.within = shells - low;
  q.middle = vmax(low + (splat(0.5f) - offset), splat(0.25f)) * splat(w->ray_length);
  return q;
}

/* the cell in it, */
INLINE void ray_cell_at(const wood_constants *w, ray_cells *q) {
  vi unused;
  vf count = vnearest(q->middle * splat(w->ray_per_radius), &unused);
  q->count = vmax(count, splat(1.0f));
  vf x = q->x * q->count;
  q->x = x - vfloor(x, &q->column);
}

/* and its size beside the footprint's. */
INLINE void ray_cell_size(const wood_constants *w, const ray_place *p, ray_cells *q) {
  q->arc = vmax(p->rho, splat(0.05f)) * splat(6.2831853f / WOOD_RAY_SECTORS) / q->count;
  /* the footprint's extents along rho and y count too where sheets sway */
  vf lean = p->at.lean, across = p->at.sway * p->along;
  vf arc2 = p->aa + lean * (splat(2.0f) * p->ab + lean * p->bb) + across * across;
  q->reach = splat(0.5f) * vsqrt(vmax(arc2, splat(0.0f)) + splat(w->ray_sharp2));
}

/* A ray of its cell: where the point is from its middle, and its size there. */
typedef struct {
  vf a, thick;         /* mm along the arc: of the point, and half the thickness */
  vf dense;            /* how much of what is under it a ray hides: thin ones less */
  vf at, inverse_tall; /* in half heights: of the point, and of a cell */
} ray_body;

#define RAY_UNEVEN_RADIAL 0.35f /* mm: size of a broad ray's unevenness along the radius, */
#define RAY_UNEVEN_ALONG 2.5f   /* and along the fibre */

/* Factor of a broad ray's thickness; within ray_uneven of 1, which is its mean. root:
 * the ray's own. Far from every ray it does not matter. */
INLINE vf ray_unevenness(const wood_constants *w, const ray_place *p, vu root) {
  noise_axis out = noise_split_cubic(p->rho * splat(1.0f / RAY_UNEVEN_RADIAL), HASH_X);
  noise_axis up = noise_split_cubic(p->y * splat(1.0f / RAY_UNEVEN_ALONG), HASH_Y);
  vf across, along, n = noise_value2(&out, &up, root, &across, &along);
  vf keep = splat(w->ray_uneven / HASH_ONE);
  vf size = vmax(vsqrt(p->bb), p->along * splat(RAY_UNEVEN_RADIAL / RAY_UNEVEN_ALONG));
  if (filter_touches(size, RAY_UNEVEN_RADIAL)) {
    keep = keep * filter_keep(size, RAY_UNEVEN_RADIAL);
  }
  return splat(1.0f) + keep * n;
}

/* Which ray a cell has, and where along the fibre the point is in it. */
typedef struct {
  vu root, hash; /* of the column, and of the ray */
  vf y;          /* 0..1 */
} ray_seat;

/* That of the cell `side` columns on. Past the sector's edge it is one that
 * might be there: only footprints that blur it away look so far. */
INLINE ray_seat ray_seat_of(const wood_constants *w, const ray_place *p, const ray_cells *q,
                            vi side) {
  ray_seat seat;
  vf k16 = splat(1.0f / 65536.0f);
  vi column = q->column + side, iy;
  vu root = hash_mix((vu)column * splatu(HASH_X) + (vu)q->shell * splatu(HASH_Z) + q->seed);
  /* columns of cells stand at heights of their own */
  vf rows = p->y * splat(w->inverse_ray_cell) + to_float((vi)(root >> 16)) * k16;
  seat.root = root;
  seat.y = rows - vfloor(rows, &iy);
  seat.hash = hash_mix((vu)iy * splatu(HASH_Y) + root);
  return seat;
}

INLINE ray_body ray_body_of(const wood_constants *w, const ray_place *p, const ray_cells *q,
                            const ray_seat *seat, vi side) {
  ray_body r;
  vf one = splat(1.0f), half = splat(0.5f), k16 = splat(1.0f / 65536.0f), y = seat->y;
  vu h = seat->hash, g = hash_upper(h + splatu(HASH_Z));

  vf u = to_float((vi)(h >> 16)) * k16, v = to_float((vi)(h & splatu(0xffffu))) * k16;
  vf tall = splat(w->ray_tall) * (half + u); /* half the height, in cells */
  vf centre = tall + v * (one - tall - tall);
  vf place = splat(0.33f) + splat(0.34f / 64.0f) * to_float((vi)(g >> 6 & splatu(63u)));
  vf starts = to_float((vi)(g >> 12 & splatu(63u))) * splat(0.25f / 63.0f);
  vf ends = one - to_float((vi)(g >> 18 & splatu(63u))) * splat(0.25f / 63.0f);
  /* thinner rays are as many as thick ones */
  vf plump = to_float((vi)(g >> 24)) * splat(1.0f / 255.0f);
  vf thick = splat(w->ray_half) * (splat(0.7f) + splat(0.6f) * plump);
  r.dense = splat(0.6f) + splat(0.4f) * plump;
  /* they taper to their ends along the radius */
  vf taper =
      clamp01((q->within - starts) * splat(16.0f)) * clamp01((ends - q->within) * splat(16.0f));
  r.thick = thick * taper;
  r.a = (q->x - to_float(side) - place) * q->arc;
  if (w->ray_uneven > 0.0f) {
    vf most = r.thick * splat(1.0f + w->ray_uneven) + q->reach;
    if (any(lt(vabs(r.a), most))) r.thick = r.thick * ray_unevenness(w, p, seat->root);
  }
  r.inverse_tall = one / tall;
  r.at = (y - centre) * r.inverse_tall;
  return r;
}

/* How much of the footprint it covers. */
INLINE vf ray_body_cover(const wood_constants *w, const ray_place *p, const ray_cells *q,
                         const ray_body *r) {
  vf e = splat(0.5f) * p->along * splat(w->inverse_ray_cell) * r->inverse_tall;
  e = vmax(e, splat(1e-3f));
  vf lens = (ray_lens(r->at + e) - ray_lens(r->at - e)) / (e + e);
  return r->dense * ray_overlap(r->a - q->reach, r->a + q->reach, r->thick * lens);
}

INLINE vf ray_of_cell(const wood_constants *w, const ray_place *p, const ray_cells *q, vi side) {
  ray_seat seat = ray_seat_of(w, p, q, side);
  ray_body r = ray_body_of(w, p, q, &seat, side);
  return ray_body_cover(w, p, q, &r);
}

/* Cover by rays, nearest: by that of the point's own cell. A ray keeps clear of
 * its cell's edge, so that most footprints meet no other cell's. */
INLINE vf rays_cover(const wood_constants *w, const ray_place *p, const ray_cells *q, vf nearest) {
  vf zero = splat(0.0f), one = splat(1.0f), sum = nearest;
  vf edge = vmin(q->x, one - q->x), clear = splat(w->ray_clear);
  vm meets = gt(q->reach, (edge + clear) * q->arc);
  if (!any(meets)) return sum;
  vi nearer = seli(lt(q->x, splat(0.5f)), splati(-1), splati(1));
  for (int k = 1; k <= w->ray_sides; k++) {
    vf past = splat((float)(k - 1)) + clear;
    vi side = nearer * splati(k);
    meets = gt(q->reach, (edge + past) * q->arc);
    if (!any(meets)) break;
    sum = sum + sel(meets, ray_of_cell(w, p, q, side), zero);
    meets = gt(q->reach, (one - edge + past) * q->arc);
    if (any(meets)) sum = sum + sel(meets, ray_of_cell(w, p, q, splati(0) - side), zero);
  }
  return sum;
}

/* Cover to be expected in a shell, over its mean: its cells widen outwards, and a
 * radius meets more rays the nearer it is to the shell's middle. */
INLINE vf rays_share(const wood_constants *w, const ray_cells *q) {
  vf one = splat(1.0f), inside = vmin(vmin(q->within, one - q->within) * splat(4.0f), one);
  return inside * splat(4.0f / 3.0f) / (q->arc * splat(w->inverse_ray_arc));
}

#define RAY_SWAY_FROM 20.0f /* mm */

/* turn: theta' / 2 pi. */
INLINE ray_turn ray_turn_of(const wood_constants *w, vu own, vf rho, vf turn, vf y) {
  ray_turn p;
  vi unused;
  noise_axis out = noise_split_cubic(rho * splat(w->ray_wave_radial), HASH_X);
  noise_axis up = noise_split_cubic(y * splat(w->ray_wave_along), HASH_Y);
  /* The sheets are not flat: they sway with the bundles of fibres that go round them,
   * together all round the stem, so that a cut along them leaves them and meets them
   * again. Nearer to the pith than RAY_SWAY_FROM they sway by an angle. */
  vf lean, sway, stray = noise_value2(&out, &up, wood_seed(w, own, SEED_RAYS), &lean, &sway);
  vf from = splat(RAY_SWAY_FROM), per = splat(w->ray_stray) * vmin(rho / from, splat(1.0f));
  p.lean = lean * per * splat(w->ray_wave_radial);
  p.sway = sway * per * splat(w->ray_wave_along);
  turn = turn + stray * splat(0.15915494f * w->ray_stray) / vmax(rho, from);
  p.turn = turn - vfloor(turn, &unused);
  return p;
}

INLINE vf rays_faded(const wood_constants *w, const ray_place *p, const ray_cells *q, vf found) {
  /* past the cells looked at the expected cover takes over */
  float arc = 0.5f * w->inverse_ray_arc, most = (float)w->ray_sides, from = most - 0.55f;
  vm wide = or_(gt(p->aa * splat(arc * arc), splat(0.98f * from * from)),
                gt(p->along * splat(w->inverse_ray_cell), splat(0.44f)));
  if (!any(wide)) return vmin(found, splat(1.0f));
  vf far = smooth_step(splat(from), splat(most), vsqrt(p->aa) * splat(arc));
  vf fade =
      vmax(smooth_step(splat(0.45f), splat(1.0f), p->along * splat(w->inverse_ray_cell)), far);
  return vmin(mix(found, splat(w->ray_cover) * rays_share(w, q), fade), splat(1.0f));
}

#endif
