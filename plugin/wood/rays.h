/* SPDX-License-Identifier: Apache-2.0
 *
 * Rays: sheets of cells that run from the pith outwards, as high along the
 * fibre as they are, and a fraction of a millimetre thick. Cut across the
 * radius they are lenses, cut along it flakes: the silver grain of oak.
 *
 * They stand in cells of (theta', y) within shells of rho, one to a cell, at a
 * hashed place that keeps clear of the cell's edge, so that a point looks into
 * one cell. A ray begins in the inner quarter of its shell, or anywhere in the one round
 * the pith, and ends in the outer quarter. Round the pith there are sectors, each with shells of
 * its own and, where the wood that is cut mostly lies, a cell or a few to a shell: a sector of many
 * would show as a patch of rays that begin and end together. By the chance of a sector's row there
 * is one cell more or less, so that rays do not stand above one another in columns, which a cut
 * along them would show as rows of dots; where there should be less than one there is mostly none:
 * then its one cell is empty. theta' moves with the grain.
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

/* The integral from 0 of a ray's outline, held beyond +-1: 1 - x^2, of blunt ones 1 - x^4. */
INLINE vf ray_lens(const wood_constants *w, vf x) {
  x = clamp(x, splat(-1.0f), splat(1.0f));
  vf square = x * x, blunt = splat(0.2f * w->ray_blunt);
  return x - x * square * (splat((1.0f / 3.0f) * (1.0f - w->ray_blunt)) + blunt * square);
}

/* The cells at a point, and where in them it is. */
typedef struct {
  vi sector, shell, row, column;
  vf within, x;  /* of the shell, of the cell: 0..1 */
  vf y;          /* 0..1: of the row */
  vf arc, at;    /* mm: of a cell; and the point in it */
  vf reach;      /* mm: of the footprint to either side */
  vf middle;     /* mm: the radius that the shell's count is for */
  vf from, span; /* of the shell, in which its rays begin; from RAY_NONE on where it has none */
  vf chance;     /* 0..1: the row's */
  vf count;      /* of the row's cells in it, 1 or more */
  vu seed;
} ray_cells;

#define RAY_NONE 2.0f
#define RAY_ROW_STEP 0x6a09e667u /* the root of 2, less 1 */

/* In three steps, as what follows on them is, so that the kernel can take a few
 * blocks through each: the shell, */
INLINE void ray_sector_at(const wood_constants *w, const ray_place *p, vi sector, ray_cells *q) {
  const vf k24 = splat(1.0f / 16777216.0f);
  q->sector = sector;
  q->seed = wood_seed(w, p->own, SEED_RAYS) + (vu)sector * splatu(HASH_Y);
  vu hash = hash_upper(q->seed);
  vf offset = to_float((vi)(hash >> 8)) * k24;
  /* and rows at heights of its own, by steps of 0.5698 as the chance below */
  vf rows = p->y * splat(w->inverse_ray_cell) +
            to_float((vi)((vu)sector * splatu(0x91e10da5u) >> 8)) * k24;
  q->y = rows - vfloor(rows, &q->row);
  vf shells = p->rho * splat(w->inverse_ray_length) + offset;
  vf low = vfloor(shells, &q->shell), inner = low - offset, one = splat(1.0f);
  q->within = shells - low;
  /* What has the pith in it is no whole shell. Its rays begin anywhere in it, so that they are not
   * the denser the nearer to the pith. */
  vm first = lt(inner, splat(0.0f));
  vf middle = sel(first, splat(0.8f) * (inner + one), inner + splat(0.5f));
  q->middle = middle * splat(w->ray_length);
  q->from = sel(first, offset, splat(0.0f));
  q->span = sel(first, one - offset, splat(0.25f));
  /* by steps of the golden ratio round the pith, and of the root of 2 along it, which are spread
   * evenly over any few sectors and rows */
  vu chance =
      (vu)sector * splatu(0x9e3779b9u) + (vu)q->row * splatu(RAY_ROW_STEP) + ((vu)q->shell << 31);
  q->chance = to_float((vi)(chance >> 8)) * k24;
}

INLINE ray_cells ray_shell_at(const wood_constants *w, const ray_place *p) {
  ray_cells q;
  vi sector;
  vf round = p->at.turn * splat(w->ray_sectors), whole = vfloor(round, &sector);
  ray_sector_at(w, p, sector, &q);
  q.x = round - whole;
  return q;
}

/* the cell in it, */
INLINE void ray_count_of(const wood_constants *w, ray_cells *q) {
  vi unused;
  vf count = vfloor(q->middle * splat(w->ray_per_radius) + q->chance, &unused);
  vm some = gt(count, splat(0.5f));
  q->count = sel(some, count, splat(1.0f));
  q->from = sel(some, q->from, splat(RAY_NONE));
}

INLINE void ray_cell_at(const wood_constants *w, ray_cells *q) {
  ray_count_of(w, q);
  vf x = q->x * q->count;
  q->x = x - vfloor(x, &q->column);
}

/* mm along the arc, of a sector. */
INLINE vf ray_sector_arc(const wood_constants *w, const ray_place *p) {
  return vmax(p->rho, splat(0.05f)) * splat(w->ray_sector_turn);
}

/* and its size beside the footprint's. */
INLINE void ray_cell_size(const wood_constants *w, const ray_place *p, ray_cells *q) {
  q->arc = ray_sector_arc(w, p) / q->count;
  q->at = q->x * q->arc;
  /* the footprint's extents along rho and y count too where sheets sway */
  vf lean = p->at.lean, across = p->at.sway * p->along;
  vf arc2 = p->aa + lean * (splat(2.0f) * p->ab + lean * p->bb) + across * across;
  q->reach = splat(0.5f) * vsqrt(vmax(arc2, splat(0.0f)) + splat(w->ray_sharp2));
}

/* A ray of its cell: where the point is from its middle, and its size there. */
typedef struct {
  vf a, thick; /* mm along the arc: of the point, and half the thickness */
  vf outer;  /* the same in the footprint's half that is farther from the pith, thick's the other */
  vf dense;  /* how much of what is under it a ray hides: thin ones less */
  vf frayed; /* squared over thick's: to either side, of edges that the footprint averages */
  vf at, inverse_tall; /* in half heights: of the point, and of a cell */
} ray_body;

#define RAY_UNEVEN_RADIAL 0.35f    /* mm: size of a broad ray's unevenness along the radius, */
#define RAY_UNEVEN_ALONG 2.5f      /* and along the fibre */
#define RAY_UNEVEN_VARIANCE 0.184f /* of value noise between -1 and 1: 1/3 (1 - 18/70)^2 */

INLINE vf ray_uneven_at(const ray_place *p, vf rho, vu root) {
  noise_axis out = noise_split_cubic(rho * splat(1.0f / RAY_UNEVEN_RADIAL), HASH_X);
  noise_axis up = noise_split_cubic(p->y * splat(1.0f / RAY_UNEVEN_ALONG), HASH_Y);
  vf across, along;
  return noise_value2(&out, &up, root, &across, &along);
}

/* Factors of a broad ray's thickness in the inner half of the footprint and in the outer; within
 * ray_uneven of 1, which is their mean, and the same under a small footprint. root: the ray's own.
 * Far from every ray it does not matter. frayed is three times the variance that a half
 * averages, which is that of edges spread evenly as far as its root. */
INLINE void ray_unevenness(const wood_constants *w, const ray_place *p, vu root, vf factor[2],
                           vf *frayed) {
  vf one = splat(1.0f), keep = splat(w->ray_uneven / HASH_ONE), reach = vsqrt(p->bb);
  vf size = vmax(reach, p->along * splat(RAY_UNEVEN_RADIAL / RAY_UNEVEN_ALONG));
  if (!filter_touches(size, RAY_UNEVEN_RADIAL)) {
    factor[0] = factor[1] = one + keep * ray_uneven_at(p, p->rho, root);
    return;
  }
  vf half = splat(0.5f) * reach;
  vf step = sel(gt(size, splat(0.5f * RAY_UNEVEN_RADIAL)), splat(0.5f) * half, splat(0.0f));
  vf left = filter_keep(vmax(half, p->along * splat(RAY_UNEVEN_RADIAL / RAY_UNEVEN_ALONG)),
                        RAY_UNEVEN_RADIAL);
  float variance = w->ray_uneven * w->ray_uneven * RAY_UNEVEN_VARIANCE;
  *frayed = splat(3.0f * variance) * (one - left * left);
  keep = keep * left;
  factor[0] = one + keep * ray_uneven_at(p, p->rho - step, root);
  factor[1] = one + keep * ray_uneven_at(p, p->rho + step, root);
}

#define RAY_ROW 0.02f /* mm: height of a row of a ray's cells, usual in wood (IAWA lists, 1989) */

/* Factor of a ray's thickness in one row of its cells, of which there are not as many as in the
 * next; its mean is 1. hash: the ray's own. Far from every ray it does not matter. */
INLINE vf ray_raggedness(const wood_constants *w, const ray_place *p, vu hash) {
  vi row;
  vfloor(p->y * splat(1.0f / RAY_ROW), &row);
  vu h = hash_mix(hash + (vu)row * splatu(HASH_Y));
  vf part = to_float((vi)(h >> 16)) * splat(2.0f / 65535.0f) - splat(1.0f);
  return splat(1.0f) + splat(w->ray_ragged) * filter_keep(p->along, RAY_ROW) * part;
}

/* The hash of the ray that a cell has. */
INLINE vu ray_hash_of(const ray_cells *q) {
  vu row = (vu)q->row * splatu(RAY_ROW_STEP);
  return hash_mix((vu)q->column * splatu(HASH_X) + (vu)q->shell * splatu(HASH_Z) + row + q->seed);
}

#define RAY_LEAN 0.09f /* slope of its cells' axis round the stem, at most: five degrees */

/* Rays go round vessels, and none is quite radial. By bits that ray_body_of has no use for. */
INLINE vf ray_lean_of(vu hash) {
  vu g = hash_upper(hash + splatu(HASH_Z));
  return (to_float((vi)(g & splatu(63u))) * splat(2.0f / 63.0f) - splat(1.0f)) * splat(RAY_LEAN);
}

INLINE ray_body ray_body_of(const wood_constants *w, const ray_place *p, const ray_cells *q, vu h) {
  ray_body r;
  vf one = splat(1.0f), half = splat(0.5f), k16 = splat(1.0f / 65536.0f);
  vu g = hash_upper(h + splatu(HASH_Z));

  vf u = to_float((vi)(h >> 16)) * k16, v = to_float((vi)(h & splatu(0xffffu))) * k16;
  vf tall = splat(w->ray_tall) * (half + u); /* half the height, in cells */
  vf centre = tall + v * (one - tall - tall);
  vf place = splat(0.33f) + splat(0.34f / 64.0f) * to_float((vi)(g >> 6 & splatu(63u)));
  vf starts = q->from + q->span * (to_float((vi)(g >> 12 & splatu(63u))) * splat(1.0f / 63.0f));
  vf ends = one - to_float((vi)(g >> 18 & splatu(63u))) * splat(0.25f / 63.0f);
  /* thinner rays are as many as thick ones */
  vf plump = to_float((vi)(g >> 24)) * splat(1.0f / 255.0f);
  vf thick = splat(w->ray_half) * (splat(0.7f) + splat(0.6f) * plump);
  r.dense = splat(0.6f) + splat(0.4f) * plump;
  /* they taper to their ends along the radius */
  vf taper =
      clamp01((q->within - starts) * splat(16.0f)) * clamp01((ends - q->within) * splat(16.0f));
  r.thick = thick * taper;
  r.a = q->at - place * q->arc;
  /* what neither of the two can make thick enough is not asked for them; what one of them
   * can, is asked for both, or it would depend on the lanes beside it whether it is */
  float uneven = w->ray_uneven, ragged = w->ray_ragged;
  vf most = r.thick * splat((1.0f + uneven) * (1.0f + ragged) * w->ray_softer) + q->reach;
  r.frayed = splat(0.0f);
  r.outer = r.thick;
  if (any(lt(vabs(r.a), most))) {
    if (uneven > 0.0f) {
      vf factor[2];
      ray_unevenness(w, p, h, factor, &r.frayed);
      r.outer = r.thick * factor[1];
      r.thick = r.thick * factor[0];
    }
    if (any(lt(p->along, splat(2.0f * RAY_ROW)))) {
      vf row = ray_raggedness(w, p, h);
      r.thick = r.thick * row;
      r.outer = r.outer * row;
    }
  }
  r.inverse_tall = one / tall;
  r.at = (q->y - centre) * r.inverse_tall;
  return r;
}

INLINE vf ray_half_cover(const ray_cells *q, const ray_body *r, vf thick) {
  vf reach = q->reach;
  if (any(gt(r->frayed, splat(0.0f)))) {
    vf wider = vsqrt(reach * reach + r->frayed * thick * thick);
    reach = sel(gt(r->frayed, splat(0.0f)), wider, reach);
  }
  return ray_overlap(r->a - reach, r->a + reach, thick);
}

/* How much of the footprint it covers. */
INLINE vf ray_body_cover(const wood_constants *w, const ray_place *p, const ray_cells *q,
                         const ray_body *r) {
  vf e = splat(0.5f) * p->along * splat(w->inverse_ray_cell) * r->inverse_tall;
  e = vmax(e, splat(1e-3f));
  vf lens = (ray_lens(w, r->at + e) - ray_lens(w, r->at - e)) / (e + e);
  vf inner = ray_half_cover(q, r, r->thick * lens);
  if (!any(not_(eq(r->thick, r->outer)))) return r->dense * inner;
  return r->dense * (splat(0.5f) * (inner + ray_half_cover(q, r, r->outer * lens)));
}

INLINE vf ray_of_cell(const wood_constants *w, const ray_place *p, const ray_cells *q) {
  ray_body r = ray_body_of(w, p, q, ray_hash_of(q));
  return ray_body_cover(w, p, q, &r);
}

/* To the next cell at a point's radius, on the side of larger turns or not. far: mm from the point
 * to that cell. */
INLINE void ray_next(const wood_constants *w, const ray_place *p, vm up, vf far, ray_cells *q) {
  vf zero = splat(0.0f), one = splat(1.0f);
  vf column = to_float(q->column) + sel(up, one, splat(-1.0f));
  vm past = or_(lt(column, zero), not_(lt(column, q->count)));
  vi count = splati((int32_t)w->ray_sectors), on = seli(up, splati(1), splati(-1));
  vi sector = q->sector + seli(past, on, splati(0));
  sector = seli(lti(sector, splati(0)), sector + count, sector);
  sector = seli(lti(sector, count), sector, splati(0));
  ray_sector_at(w, p, sector, q);
  ray_count_of(w, q);
  column = sel(past, sel(up, zero, q->count - one), column);
  (void)vfloor(column, &q->column);
  q->arc = ray_sector_arc(w, p) / q->count;
  q->at = sel(up, zero - far, q->arc + far);
}

/* mm: half the width of the widest ray, with the soft edge that it has under a footprint. */
INLINE vf ray_widest(const wood_constants *w, const ray_place *p) {
  if (!(w->ray_uneven > 0.0f)) return splat(w->ray_thickest);
  const float out = 0.5f * RAY_UNEVEN_RADIAL, up = 0.5f * RAY_UNEVEN_ALONG;
  vm soft = or_(gt(p->bb, splat(0.999f * out * out)), gt(p->along, splat(0.999f * up)));
  return splat(w->ray_thickest) * sel(soft, splat(w->ray_softer), splat(1.0f));
}

/* mm that rays keep from the edges of their cells at a point's radius, whichever sector's. */
INLINE vf ray_clear(const wood_constants *w, const ray_place *p) {
  vf length = splat(w->ray_length);
  vf farthest = vmax(p->rho + splat(0.5f) * length, splat(0.8f) * length);
  vf most = farthest * splat(w->ray_per_radius) + splat(1.0f); /* cells to a sector */
  return splat(w->ray_room) * ray_sector_arc(w, p) / most - ray_widest(w, p);
}

/* Whether the ray of a cell whose edge is `far` away might reach into the footprint. */
INLINE vm ray_may_reach(const wood_constants *w, const ray_place *p, const ray_cells *q, vf far) {
  vf gap = far + splat(w->ray_room) * q->arc - ray_widest(w, p);
  return and_(lt(gap, q->reach), lt(q->from, splat(RAY_NONE)));
}

/* Cover by rays, nearest: by that of the point's own cell. A ray keeps clear of
 * its cell's edge, so that most footprints meet no other cell's; others look at the next to
 * either side. How far a ray keeps clear is first bounded for whichever sector, and then
 * known of the cell: making the ray itself is the dear part. */
INLINE vf rays_cover(const wood_constants *w, const ray_place *p, const ray_cells *q, vf nearest) {
  vf sum = nearest, left = q->at, right = q->arc - q->at, zero = splat(0.0f);
  vf beyond = q->reach - ray_clear(w, p), far = vmin(left, right);
  vm up = lt(right, left);
  for (int side = 0; side < 2; side++) {
    ray_cells n = *q;
    for (int k = 0; k < w->ray_sides; k++) {
      vm meets = gt(beyond, far);
      if (!any(meets)) break;
      ray_next(w, p, up, far, &n);
      meets = and_(meets, ray_may_reach(w, p, &n, far));
      if (any(meets)) sum = sum + sel(meets, ray_of_cell(w, p, &n), zero);
      far = far + n.arc;
    }
    up = not_(up);
    far = vmax(left, right);
  }
  return sum;
}

/* Cover to be expected in a shell, over its mean: its cells widen outwards, and a
 * radius meets more rays the nearer it is to the shell's middle. fade: how far over all rows, and
 * not in the point's own. */
INLINE vf rays_share(const wood_constants *w, const ray_place *p, const ray_cells *q, vf fade) {
  vf one = splat(1.0f), zero = splat(0.0f), all = q->middle * splat(w->ray_per_radius);
  vf inside = clamp(vmin(q->within, one - q->within) * splat(4.0f), zero, one);
  vf own = sel(lt(q->from, splat(RAY_NONE)), q->count, zero);
  return inside * splat(4.0f / 3.0f) * mix(own, all, fade) /
         (ray_sector_arc(w, p) * splat(w->inverse_ray_arc));
}

#define RAY_SWAY_FROM 20.0f /* mm */
#define RAY_RIPPLE 0x2545f491u

/* turn: theta' / 2 pi. c, s: the direction from the pith. along: mm, of the footprint along y.
 * held: of both waves. */
INLINE ray_turn ray_turn_of(const wood_constants *w, vu own, vf rho, vf turn, vf y, vf c, vf s,
                            vf along, noise_held *held) {
  ray_turn p;
  vi unused;
  /* by c and s, or the two sides of a board with the pith in it would mirror each other */
  noise_axis out = noise_split_cubic(rho * splat(w->ray_wave_radial) + c, HASH_X);
  noise_axis up = noise_split_cubic(y * splat(w->ray_wave_along) + s, HASH_Y);
  /* The sheets are not flat: they sway with the bundles of fibres that go round them,
   * together all round the stem, so that a cut along them leaves them and meets them
   * again. Nearer to the pith than RAY_SWAY_FROM they sway by an angle. */
  vu seed = wood_seed(w, own, SEED_RAYS);
  vf lean, sway, stray = noise_value2_held(&out, HASH_X, &up, HASH_Y, seed, held, &lean, &sway);
  vf from = splat(RAY_SWAY_FROM), per = splat(w->ray_stray) * vmin(rho / from, splat(1.0f));
  p.lean = lean * per * splat(w->ray_wave_radial);
  p.sway = sway * per * splat(w->ray_wave_along);
  stray = stray * splat(w->ray_stray);
  if (w->ray_ripple > 0.0f) {
    /* and with single bundles, which part a flake that lies flat in the cut into ribbons */
    vf quick, rise, fall;
    out = noise_split_cubic(rho * splat(w->ray_ripple_radial) + c, HASH_X);
    up = noise_split_cubic(y * splat(w->ray_ripple_along) + s, HASH_Y);
    quick = noise_value2_held(&out, HASH_X, &up, HASH_Y, seed + splatu(RAY_RIPPLE), &held[1], &rise,
                              &fall);
    vf keep = splat(w->ray_ripple) * filter_keep(along, 1.0f / w->ray_ripple_along);
    vf of = keep * vmin(rho / from, splat(1.0f));
    p.lean = p.lean + rise * of * splat(w->ray_ripple_radial);
    p.sway = p.sway + fall * of * splat(w->ray_ripple_along);
    stray = stray + quick * keep;
  }
  turn = turn + stray * splat(0.15915494f) / vmax(rho, from);
  p.turn = turn - vfloor(turn, &unused);
  return p;
}

/* How far the expected cover stands in for the rays of the cells looked at; far: for the arc's
 * sake. */
INLINE vf rays_fade(const wood_constants *w, const ray_place *p, vf *far) {
  float arc = 0.5f * w->inverse_ray_arc, most = (float)w->ray_sides, from = most - 0.55f;
  vm wide = or_(gt(p->aa * splat(arc * arc), splat(0.98f * from * from)),
                gt(p->along * splat(w->inverse_ray_cell), splat(0.44f)));
  *far = splat(0.0f);
  if (!any(wide)) return *far;
  *far = smooth_step(splat(from), splat(most), vsqrt(p->aa) * splat(arc));
  return vmax(smooth_step(splat(0.45f), splat(1.0f), p->along * splat(w->inverse_ray_cell)), *far);
}

/* Whether no lane asks which rays there are. */
INLINE int rays_gone(const wood_constants *w, const ray_place *p) {
  vf far;
  return !any(lt(rays_fade(w, p, &far), splat(1.0f)));
}

/* found: of no matter where the expected cover has taken over. */
INLINE vf rays_faded(const wood_constants *w, const ray_place *p, const ray_cells *q, vf found) {
  vf one = splat(1.0f), far, fade = rays_fade(w, p, &far);
  if (!any(gt(fade, splat(0.0f)))) return vmin(found, one);
  /* across several sectors their shells' shares are of all kinds */
  vf expected = splat(w->ray_cover) * mix(rays_share(w, p, q, fade), one, far);
  return vmin(sel(lt(fade, one), mix(found, expected, fade), expected), one);
}

#endif
