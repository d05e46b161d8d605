/* SPDX-License-Identifier: Apache-2.0
 *
 * Vessels, looked up where they are and never listed.
 *
 * Pores of the field (diffuse-porous wood, and the latewood of the others)
 * stand in square cells of the reference section, two in every other cell at
 * uniform places: mean, variance and pair density are those of Kawai's uniform
 * distribution. Earlywood vessels stand along the ring boundary, 2 pi R P to a
 * ring, evenly spaced with jitter. Radii are normally distributed, truncated
 * above zero.
 *
 * Filtering. A vessel is a ramp in q = (distance / radius)^2, from 1.25 where
 * it is 0 to 0.75 where it is 1: its area and its half level are the disc's.
 * Under a footprint of covariance C the disc's matrix R^2 I grows to
 * M = R^2 I + C / 0.2552 (0.2552 R^2 is the ramped disc's own variance). While
 * x = R^2 / sqrt(det M) is above 0.74 the vessel stays full in its middle, its
 * area is kept by moving the half level to q = x, and the ramp widens; below,
 * it is a cone in q whose height falls with x. The area is exact throughout,
 * the shape approximate. Of pores a footprint longer than the cells looked at is cut into
 * up to 4 parts along its longest direction and, where it is broad, once across that. A row
 * answers a long footprint in one pass, each vessel by its share of a box. Beyond, the
 * expected coverage takes over. tests/property prints the errors.
 */
#ifndef SOZAI_WOOD_VESSELS_H
#define SOZAI_WOOD_VESSELS_H

#include "rings.h"
#include "stem.h"

/* A symmetric 2 x 2 matrix over (x, z) of the reference section, or over
 * (arc, rho). */
typedef struct {
  vf xx, xz, zz;
} matrix2;

/* What a blurred disc comes to: height * clamp(top - q), with q = d^T Q d in
 * units of the mean radius. */
typedef struct {
  vf xx, xz, zz; /* of Q; xz doubled */
  vf top, height;
  vf apart; /* 1: a sum of covers that is cut off at 1 is their union; 0: it counts twice */
} disc;

#define DISC_FULL 0.74f  /* x from which on a disc is full in its middle */
#define DISC_APART 1.25f /* of x^2: what two discs share is smaller than either */

INLINE disc disc_blurred(vf radius2, matrix2 c) {
  vf k = splat(1.0f / 0.2552f), one = splat(1.0f);
  vf xx = radius2 + k * c.xx, zz = radius2 + k * c.zz, xz = k * c.xz;
  vf det = vmax(xx * zz - xz * xz, radius2 * radius2);
  vf root = inverse_root(det), x = radius2 * root;
  vf middle = vmax(x, splat(DISC_FULL));
  /* one over the ramp's width: 2 of a point, no less than what keeps the cone's tip at 1, and
   * between them what errs least against discs averaged over squares and lines */
  vf slope = vmax(vmax(splat(20.0f) * x - splat(18.0f), splat(3.4f) * x - splat(2.1f)),
                  splat(0.5f / DISC_FULL));
  vf inverse = root * root * slope;
  disc d;
  d.height = vmin(x * splat(1.0f / DISC_FULL), one);
  d.apart = vmin(splat(DISC_APART) * x * x, one);
  d.top = splat(0.5f) + middle * slope;
  d.xx = zz * inverse;
  d.zz = xx * inverse;
  d.xz = splat(-2.0f) * xz * inverse;
  return d;
}

INLINE vf disc_distance(const disc *d, vf x, vf z) {
  return (d->xx * x + d->xz * z) * x + d->zz * z * z;
}

/* Cover by one vessel at distance q, its radius drawn from the hash; over the
 * disc's height. */
INLINE vf vessel_cover(const wood_vessels *v, const disc *d, vu h, vf q) {
  return clamp01(d->top - q * lookup8(v->inverse_square, h >> 5));
}

/* From the sum of covers to the share covered: discs overlap, and where they
 * are blurred the sum counts that twice, by `overlap` on average. */
INLINE vf vessel_overlap(const wood_vessels *v, const disc *d, vf sum) {
  sum = sum * d->height;
  return vmin(sum - sum * (splat(1.0f) - d->apart) * splat(v->overlap), splat(1.0f));
}

/* A hash as a whole number within +-HASH_ONE: a place within half a cell of the
 * cell's middle. The second, from the bits below the first's ten, leaves those
 * below 10 to the radius. */
INLINE vf hash_place(vu h) { return to_float((vi)h); }
INLINE vf hash_place2(vu h) { return to_float((vi)(h << 11)); }

/* The four cells nearest to a point of the reference section, which hold
 * everything within half a cell. Places are kept in units of 2^-32 of a cell,
 * which are the hash's own. */
typedef struct {
  vf x, z; /* from the first cell's middle, 0..2^32 */
  vu hash; /* of the first cell */
  disc d;  /* in those units */
} pore_cells;

#define PORE_UNIT 4294967296.0f
#define PORE_NOWHERE 1e13f      /* far from everything */
#define PORE_SECOND 0x2c1b3c6du /* makes another hash of a cell's */

INLINE pore_cells pores_near(const wood_constants *w, vu own, vf x, vf z, const disc *d) {
  pore_cells p;
  vf inverse_cell = splat(w->inverse_pore_cell), unit = splat(PORE_UNIT), half = splat(0.5f);
  vf square = splat(w->pore_step * w->pore_step);
  vi ix, iz;
  x = x * inverse_cell - half;
  z = z * inverse_cell - half;
  p.x = (x - vfloor(x, &ix)) * unit;
  p.z = (z - vfloor(z, &iz)) * unit;
  p.hash = (vu)ix * splatu(HASH_X) + (vu)iz * splatu(HASH_Z) + wood_seed(w, own, SEED_PORES);
  p.d = (disc){d->xx * square, d->xz * square, d->zz * square, d->top, d->height, d->apart};
  return p;
}

/* The sum of the covers by their pores: two in every other cell, by its hash's
 * top bit; the rest gives their places and radii. */
#ifndef WITHIN_A_POINT
INLINE vf pores_sum(const wood_vessels *v, const pore_cells *p) {
  vf sum = splat(0.0f), unit = splat(PORE_UNIT);
  UNROLL(4)
  for (int i = 0; i < 4; i++) {
    int a = i & 1, b = i >> 1;
    vu base = hash_upper(p->hash + splatu((uint32_t)a * HASH_X + (uint32_t)b * HASH_Z));
    if (idle(lti((vi)base, splati(0)))) continue;
    vf x = sel_top(base, a ? p->x - unit : p->x, splat(PORE_NOWHERE)), z = b ? p->z - unit : p->z;
    vu h = base << 1;
    vf two = splat(0.0f); /* apart from the sum, which would have each cell wait for the last */
    UNROLL(2)
    for (int k = 0; k < 2; k++) {
      vf q = disc_distance(&p->d, x - hash_place(h), z - hash_place2(h));
      /* past `farthest` the cover is exactly 0: passing over it changes nothing */
      if (!idle(lt(q, splat(v->farthest)))) two = two + vessel_cover(v, &p->d, h, q);
      h = base * splatu(PORE_SECOND);
    }
    sum = sum + two;
  }
  return sum;
}
#else
/* One point alone: the eight places are eight lanes, and the sum is taken in
 * the same order. */
INLINE vf pores_sum(const wood_vessels *v, const pore_cells *p) {
  const u4 cell = {0, HASH_X, HASH_Z, HASH_X + HASH_Z};
  u4 base = cell + p->hash;
  base ^= base >> 16;
  base *= 0x7feb352du;
  base ^= base >> 15;
  base *= 0x846ca68bu;
  vf x1 = p->x - PORE_UNIT, z1 = p->z - PORE_UNIT;
  f4 x = {p->x, x1, p->x, x1}, z = {p->z, p->z, z1, z1};
  i4 there = (i4)base < 0;
  x = (f4)(((i4)x & there) |
           ((i4)(f4){PORE_NOWHERE, PORE_NOWHERE, PORE_NOWHERE, PORE_NOWHERE} & ~there));
  u8 h = join_u4(base << 1, base * PORE_SECOND);
  f8 dx = join_f4(x, x) - to_f8((i8)h), dz = join_f4(z, z) - to_f8((i8)(h << 11));
  f8 q = (p->d.xx * dx + p->d.xz * dz) * dx + p->d.zz * dz * dz;
  f8 cover = clamp01_f8(p->d.top - q * lookup8_f8(v->inverse_square, h >> 5));
  f4 two = half_f8(cover, 0) + half_f8(cover, 1);
  return two[0] + two[1] + two[2] + two[3];
}
#endif

/* Coverage by the field's pores. */
INLINE vf pores_cover(const wood_constants *w, vu own, vf x, vf z, const disc *d) {
  pore_cells p = pores_near(w, own, x, z, d);
  return vessel_overlap(&w->pores, d, pores_sum(&w->pores, &p));
}

/* The earlywood band nearest to a point, and the point's place along it. */
typedef struct {
  vm near;    /* close enough to matter */
  vf count;   /* vessels to the ring */
  vi n;       /* the same */
  vf start;   /* mm: rho of the ring's start */
  vf turn;    /* theta' / 2 pi, 0..1 */
  vf per_arc; /* vessels to a mm of arc at the point */
  vf arc;     /* its inverse */
  vu seed;
} row_place;

/* turn: theta' / 2 pi. extent: mm, how far along rho the footprint and its taps reach. */
INLINE row_place row_at(const wood_constants *w, vu own, const ring_place *ring, vf rho, vf turn,
                        vf extent) {
  row_place p;
  vf reach = (extent + splat(w->row.radius)) * ring->inverse_width;
  vf band = splat(w->band) * ring->inverse_width;
  /* the band just ahead, where that is nearer than the one behind */
  vm ahead = lt(splat(1.0f) - ring->phase, vmin(ring->phase - band, reach));
  p.near = or_(ahead, lt(ring->phase, band + reach));
  p.turn = p.per_arc = p.arc = p.count = p.start = splat(0.0f);
  p.n = splati(0);
  p.seed = splatu(0);
  if (!any(p.near)) return p;
  vf width = splat(1.0f) / ring->inverse_width;
  p.start = ring->start + ring->turns * splat(w->ring_period) + sel(ahead, width, splat(0.0f));
  vi which = seli(ahead, ring->ring + splati(1), ring->ring);
  p.count = vnearest(p.start * splat(6.2831853f * w->row_density), &p.n);
  p.near = and_(p.near, le(splat(3.0f), p.count));
  p.turn = turn + splat(0.5f);
  p.arc = splat(6.2831853f) * rho / vmax(p.count, splat(1.0f));
  p.per_arc = splat(1.0f) / vmax(p.arc, splat(1e-3f));
  p.seed = (vu)which * splatu(HASH_Z) + wood_seed(w, own, SEED_ROWS);
  return p;
}

/* Where a place stands in row m: da along the arc and dr along rho from the
 * point. */
typedef struct {
  vu seed;
  vi first; /* of the two nearest vessels: they hold all within a spacing less half the jitter */
  vf within, radial;
} row_spot;

INLINE row_spot row_spot_of(const wood_constants *w, const row_place *p, int m, vf rho, vf da,
                            vf dr) {
  row_spot q;
  vi unused;
  q.seed = hash_upper(p->seed + splatu((uint32_t)m * HASH_X));
  /* each row begins at an azimuth of its own */
  vf u = p->turn + to_float((vi)(q.seed >> 8)) * splat(1.0f / 16777216.0f);
  vf place = (u - vfloor(u, &unused)) * p->count - splat(0.5f) + da * p->per_arc;
  q.within = place - vfloor(place, &q.first);
  q.radial = rho + dr - p->start - splat(w->row_start + w->row_spacing * (float)m);
  return q;
}

/* The hash of vessel first + a, and the place relative to its centre, mm. */
INLINE vu row_vessel(const wood_constants *w, const row_place *p, const row_spot *q, int a, vf *x,
                     vf *z) {
  vi k = q->first + splati(a);
  k = seli(lti(k, splati(0)), k + p->n, k);
  k = seli(lti(k, p->n), k, k - p->n);
  vu h = hash_upper((vu)k * splatu(HASH_Y) + q->seed);
  *x = (q->within - splat((float)a) - hash_place(h) * splat(w->row_step_arc)) * p->arc;
  *z = q->radial - hash_place2(h) * splat(w->row_step_radial);
  return h;
}

/* Coverage by the rows, da along the arc and dr along rho from the point. */
INLINE vf rows_cover(const wood_constants *w, const row_place *p, vf rho, vf da, vf dr,
                     const disc *d) {
  vf sum = splat(0.0f);
  for (int m = 0; m < w->rows; m++) {
    row_spot q = row_spot_of(w, p, m, rho, da, dr);
    UNROLL(2)
    for (int a = 0; a < 2; a++) {
      vf x, z;
      vu h = row_vessel(w, p, &q, a, &x, &z);
      sum = sum + vessel_cover(&w->row, d, h, disc_distance(d, x, z));
    }
  }
  return sel(p->near, vessel_overlap(&w->row, d, sum), splat(0.0f));
}

/* Where a point's vessels are looked up. */
typedef struct {
  vf x, z; /* mm: in the reference section */
  vf c, s; /* direction of (x, z) */
  vf turn; /* the same over 2 pi, where place_has_turn */
  vf rho;  /* mm: of the point's year */
  ring_place ring;
  footprint2 f; /* over (arc, rho) */
  vu own;       /* the seeds' offset */
} vessel_place;

/* Where it is worth an arc tangent for all. */
INLINE int place_has_turn(const wood_constants *w) {
  return w->has_rays || w->rows || w->has_canals;
}
INLINE vf place_turn(vf c, vf s) { return arctan2(s, c) * splat(0.15915494f); }

/* A footprint over (arc, rho) as two vectors, mm: its longest direction, and
 * what is left, which lies along arc or rho alone. */
typedef struct {
  vf arc, rho;
  vf rest_arc, rest_rho;
} footprint_axes;

INLINE footprint_axes footprint_split(const footprint2 *f) {
  footprint_axes l;
  vf zero = splat(0.0f);
  vm across = le(f->bb, f->aa);
  vf square = vmax(sel(across, f->aa, f->bb), splat(1e-12f));
  vf inverse = inverse_root(square), major = square * inverse, other = f->ab * inverse;
  l.arc = sel(across, major, other);
  l.rho = sel(across, other, major);
  vf rest = vsqrt(vmax(sel(across, f->bb, f->aa) - other * other, zero));
  l.rest_arc = sel(across, zero, rest);
  l.rest_rho = sel(across, rest, zero);
  return l;
}

/* How a footprint is cut into parts, lane by lane: `along` of its longest
 * direction (1, 2, 3 or 4, or 1, 2, 4 or 8), `beside` of what is left (1 or 2). */
typedef struct {
  vm most;          /* into as many as there are */
  vf along, beside; /* inverses of the numbers */
  vf aa, ab, bb;    /* of one part */
  int taps;         /* of the lane that has the most */
} footprint_parts;

INLINE vf square_of(vf x) { return x * x; }

/* most: how many parts there may be, 4 or 8; third: of 4, how long three may be. */
INLINE footprint_parts footprint_cut(const footprint2 *f, const footprint_axes *l, vm cut,
                                     float reach, float third, int most) {
  footprint_parts p;
  vf one = splat(1.0f), half = splat(0.5f), reach2 = splat(reach * reach);
  vf long2 = square_of(l->arc) + square_of(l->rho);
  vf rest2 = square_of(l->rest_arc) + square_of(l->rest_rho);
  vm wide = and_(cut, gt(rest2, splat(0.36f) * reach2)), narrow = not_(wide);
  p.beside = sel(wide, half, one);
  rest2 = rest2 * square_of(p.beside);
  vm two = gt(long2 + rest2, reach2), four = gt(long2 * splat(0.25f) + rest2, reach2);
  vm all = and_(wide, two); /* as many as there may be */
  p.along = sel(two, half, one);
  if (most == 8) {
    all = or_(and_(wide, four), and_(narrow, gt(long2 * splat(0.0625f) + rest2, reach2)));
    p.along = sel(four, splat(0.25f), p.along);
    p.along = sel(and_(narrow, all), splat(0.125f), p.along);
  } else {
    vm three = four; /* or four, where thirds would have their cones cut off */
    four = gt(long2 * splat(1.0f / 9.0f) + rest2, splat(third * third));
    all = or_(all, and_(narrow, four));
    p.along = sel(and_(narrow, three), splat(1.0f / 3.0f), p.along);
    p.along = sel(and_(narrow, four), splat(0.25f), p.along);
    four = three;
  }
  p.most = and_(cut, all);
  p.along = sel(cut, p.along, one);
  vf k = square_of(p.along), r = square_of(p.beside);
  p.aa = sel(cut, square_of(l->arc) * k + square_of(l->rest_arc) * r, f->aa);
  p.bb = sel(cut, square_of(l->rho) * k + square_of(l->rest_rho) * r, f->bb);
  p.ab = sel(cut, l->arc * l->rho * k, f->ab);
  p.taps = any(p.most) ? most : any(and_(cut, or_(four, wide))) ? 4 : any(cut) ? 2 : 1;
  return p;
}

/* From (arc, rho) at direction (c, s) to (x, z). */
INLINE matrix2 to_section(vf aa, vf ab, vf bb, vf c, vf s) {
  matrix2 m;
  vf cs = c * s, cc = c * c, ss = s * s;
  m.xx = aa * ss - (ab + ab) * cs + bb * cc;
  m.zz = aa * cc + (ab + ab) * cs + bb * ss;
  m.xz = (bb - aa) * cs + ab * (cc - ss);
  return m;
}

#define ROW_MOST 8     /* vessels of a row under a footprint */
#define ROW_FADES 2.5f /* of half of those: from here on the mean fades in */
#define ROW_SHARP 0.3f /* of a radius: no box is narrower, as no vessel's edge is sharper */
#define ROW_LENS 0.5f  /* of a radius: what two vessels share is smaller than either */

typedef struct {
  vf pores, rows;             /* coverage, where it could be looked up */
  vf pores_faded, rows_faded; /* 1: the expected coverage is to be used */
} vessel_cover_t;

/* 0 while sqrt(e2) is below 0.6 of the reach, 1 from the whole of it on. */
INLINE vf fade_beyond(vf e2, float reach) {
  return smooth_step(splat(0.6f * reach), splat(reach), vsqrt(e2));
}

/* A pore at its mean radius under a footprint of (aa, ab, bb). */
INLINE disc pores_disc(const wood_constants *w, const vessel_place *p, vf aa, vf ab, vf bb) {
  vf twelfth = splat(1.0f / 12.0f);
  matrix2 m = to_section(aa * twelfth, ab * twelfth, bb * twelfth, p->c, p->s);
  vf radius2 = splat(w->pores.radius * w->pores.radius);
  if (w->pore_growth != 0.0f) {
    vf size = splat(w->pore_early) + splat(w->pore_growth) * p->ring.phase;
    radius2 = radius2 * size * size;
  }
  return disc_blurred(radius2, m);
}

/* An earlywood vessel at its mean radius under such a footprint. */
INLINE disc rows_disc(const wood_constants *w, vf aa, vf ab, vf bb) {
  vf twelfth = splat(1.0f / 12.0f);
  matrix2 m = {aa * twelfth, ab * twelfth, bb * twelfth};
  return disc_blurred(splat(w->row.radius * w->row.radius), m);
}

INLINE row_place row_of(const wood_constants *w, const vessel_place *p) {
  return row_at(w, p->own, &p->ring, p->rho, p->turn, vsqrt(p->f.bb));
}

/* Of a footprint in parts: where the i-th is, and its share of the whole. */
typedef struct {
  vf arc, rho, weight;
} footprint_part;

INLINE vm footprint_has_part(const footprint_parts *part, int i) {
  return lt(splat((float)i + 0.5f) * part->along * part->beside, splat(1.0f));
}

/* `along` runs first, then the other side. */
INLINE footprint_part footprint_part_of(const footprint_axes *l, const footprint_parts *part,
                                        vm cut, int i) {
  footprint_part q;
  vf zero = splat(0.0f), one = splat(1.0f);
  vf at = splat((float)i + 0.5f) * part->along;
  vm second = gt(at, one);
  vf a = at - splat(0.5f) - sel(second, one, zero);
  vf side = sel(lt(part->beside, one), sel(second, splat(0.25f), splat(-0.25f)), zero);
  q.weight = sel(footprint_has_part(part, i), part->along * part->beside, zero);
  q.arc = sel(cut, l->arc * a + l->rest_arc * side, zero);
  q.rho = sel(cut, l->rho * a + l->rest_rho * side, zero);
  return q;
}

/* Pores under footprints longer than what one tap answers are answered by up to 4; past the
 * part of those the expected coverage fades in. The lanes that are not cut are whole, in
 * one tap, as they would be alone. */
INLINE vm pores_cut(const wood_constants *w, const footprint2 *f) {
  return gt(f->aa + f->bb, splat(w->pores.part * w->pores.part));
}

INLINE void pores_in_parts(const wood_constants *w, const vessel_place *p, vm cut,
                           vessel_cover_t *v) {
  vf zero = splat(0.0f);
  footprint_axes l = footprint_split(&p->f);
  footprint_parts part = footprint_cut(&p->f, &l, cut, w->pores.part, w->pores.third, 4);
  v->pores_faded = sel(part.most, fade_beyond(part.aa + part.bb, w->pores.part), zero);
  vm left = lt(v->pores_faded, splat(1.0f));
  if (!any(left)) return;
  disc d = pores_disc(w, p, part.aa, part.ab, part.bb);
  int taps = part.taps;
  while (taps > 1 && !any(and_(left, footprint_has_part(&part, taps - 1)))) taps--;
  for (int i = 0; i < taps; i++) {
    footprint_part q = footprint_part_of(&l, &part, cut, i);
    vf x = p->x + (q.rho * p->c - q.arc * p->s), z = p->z + (q.rho * p->s + q.arc * p->c);
    v->pores = v->pores + pores_cover(w, p->own, x, z, &d) * q.weight;
  }
  v->pores = sel(left, v->pores, zero);
}

INLINE vm rows_cut(const wood_constants *w, const footprint2 *f) {
  return gt(f->aa + f->bb, splat(w->row.part * w->row.part));
}

/* Where a footprint may meet the bands of other rings. */
INLINE vm rows_meet(const wood_constants *w, const footprint2 *f) {
  return gt(f->bb, splat(w->rows_alone * w->rows_alone));
}

/* How much of a row lies under a footprint too long for one look-up: a box as long as the
 * footprint's longest direction and as wide as what is left beside that. A vessel's mean
 * chord over the box's width, of all that it has of the width, is an interval along the
 * box; the share of the box that it covers is exact but for the chord's ends, and so is
 * the area over all places. */
typedef struct {
  vf x, z;          /* direction of the box */
  vf half, inverse; /* mm: half its length; 1 / length */
  vf side;          /* half its width, in 1.118 radii */
  vf to_chord;      /* from the share of a vessel within the width to half its chord there, mm */
  vf spread;        /* vessels to either side that the box may meet */
  vf expected;      /* the same as the row has on average: known where no row is near */
  vf apart;         /* 1: what vessels share is counted once; less, twice in part */
} row_box;

/* A disc's projection has the variance of a parabola's over 5^0.5 / 2 radii. */
#define ROW_PROJECTION 1.1180340f

INLINE row_box row_box_of(const wood_constants *w, const row_place *p, const footprint2 *f) {
  row_box b;
  float radius = w->row.radius;
  footprint_axes l = footprint_split(f);
  vf long2 = vmax(square_of(l.arc) + square_of(l.rho), splat(1e-12f));
  vf inverse = inverse_root(long2), unit = splat(1.0f / (ROW_PROJECTION * radius));
  vf least = splat(ROW_SHARP * radius);
  b.x = l.arc * inverse;
  b.z = l.rho * inverse;
  b.inverse = inverse;
  b.half = splat(0.5f) * long2 * inverse;
  vf width = vmax(vabs(l.rest_arc * b.z) + vabs(l.rest_rho * b.x), least);
  b.side = splat(0.5f) * width * unit;
  b.to_chord = splat(1.5707963f * radius * radius) / width;
  vf reach = splat(0.5f) * (vabs(l.arc) + width * vabs(b.z)) + splat(w->row_largest);
  b.spread = reach * p->per_arc + splat(0.5f * w->row_jitter_arc);
  b.expected = reach * splat(w->row_density) + splat(0.5f * w->row_jitter_arc);
  /* A sum of shares that stays below 1 counts twice where two vessels overlap, once the box
   * is large beside the lens that they share: as discs of the lens's size are blurred. */
  vf r2 = splat(ROW_LENS * ROW_LENS * radius * radius), k = splat(1.0f / (12.0f * 0.2552f));
  vf x = r2 * inverse_root((r2 + k * long2) * (r2 + k * width * width));
  b.apart = vmin(x * splat(1.0f / 0.55f), splat(1.0f));
  return b;
}

/* Share of a disc's area to one side of a line at t in 1.118 radii, less a half. */
INLINE vf disc_beside(vf t) {
  t = clamp(t, splat(-1.0f), splat(1.0f));
  return t * (splat(0.75f) - splat(0.25f) * (t * t));
}

INLINE vf row_vessel_share(const wood_constants *w, const row_box *b, vu h, vf x, vf z) {
  vf along = vabs(b->x * x + b->z * z), across = b->x * z - b->z * x;
  vf small = lookup8(w->row_inverse, h >> 5), square = lookup8(w->row_square, h >> 5);
  vf t = across * splat(1.0f / (ROW_PROJECTION * w->row.radius)) * small, side = b->side * small;
  vf half = b->to_chord * square * (disc_beside(t + side) - disc_beside(t - side));
  vf overlap = vmin(b->half + half - along, splat(2.0f) * vmin(half, b->half));
  return vmax(overlap, splat(0.0f)) * b->inverse;
}

/* Footprints that the two vessels nearest along the row do not answer. */
static __attribute__((noinline)) void rows_in_parts(const wood_constants *w, const vessel_place *p,
                                                    vm cut, vessel_cover_t *v) {
  vf zero = splat(0.0f), one = splat(1.0f);
  row_place row = row_of(w, p);
  row_box box = row_box_of(w, &row, &p->f);
  vf beyond = smooth_step(splat(ROW_FADES), splat(0.5f * ROW_MOST), box.expected);
  /* along rho a footprint that is not short beside the ring meets the bands of others */
  vf rings = vsqrt(p->f.bb) * p->ring.inverse_width;
  vf others = smooth_step(splat(WOOD_ROWS_ALONE), splat(0.8f), rings);
  v->rows_faded = vmax(sel(cut, beyond, zero), sel(rows_meet(w, &p->f), others, zero));
  vm left = and_(lt(v->rows_faded, one), row.near);
  vm whole = and_(left, not_(cut)), boxed = and_(left, cut);
  vf sum = zero;
  if (any(boxed)) {
    vf spread = sel(boxed, box.spread, zero);
    /* a lane counts as many as it would alone */
    int most = 1;
    while (most < ROW_MOST && any(le(splat((float)most), spread + spread))) most++;
    for (int m = 0; m < w->rows; m++) {
      row_spot q = row_spot_of(w, &row, m, p->rho, zero, zero);
      vi below;
      vf start = vfloor(q.within - spread, &below) + one;
      q.within = q.within - start;
      q.first = q.first + below + splati(1);
      for (int a = 0; a < most; a++) {
        vf x, z;
        vu h = row_vessel(w, &row, &q, a, &x, &z);
        vf share = row_vessel_share(w, &box, h, x, z);
        sum = sum + sel(le(splat((float)a), spread + spread), share, zero);
      }
    }
    vf more = (one - box.apart) * splat(w->row.overlap);
    sum = sel(boxed, vmin(sum - sum * more, one), zero);
  }
  if (any(whole)) {
    disc d = rows_disc(w, p->f.aa, p->f.ab, p->f.bb);
    sum = sel(whole, rows_cover(w, &row, p->rho, zero, zero, &d), sum);
  }
  v->rows = sum;
}

#endif
