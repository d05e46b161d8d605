/* SPDX-License-Identifier: Apache-2.0
 *
 * Vessels, looked up where they are and never listed: what their layers have in common.
 *
 *   vessels_pores.h    pores of the field
 *   vessels_bands.h    and the bands that they may stand in
 *   vessels_sheaths.h  and their sheaths of parenchyma
 *   vessels_pore_parts.h  under longer footprints
 *   vessels_rows.h     rows of the earlywood, under a footprint that one look-up answers
 *   vessels_row_box.h  and under longer ones
 *   footprint_parts.h  how a long footprint is cut into parts, for pores and for tubes.h
 *
 * Radii are normally distributed, truncated above zero.
 *
 * Filtering. A vessel is a ramp in q = (distance / radius)^2, from 1.25 where
 * it is 0 to 0.75 where it is 1: its area and its half level are the disc's.
 * Under a footprint of covariance C the disc's matrix R^2 I grows to
 * M = R^2 I + C / 0.2552 (0.2552 R^2 is the ramped disc's own variance). While
 * x = R^2 / sqrt(det M) is above 0.74 the vessel stays full in its middle, its
 * area is kept by moving the half level to q = x, and the ramp widens; below,
 * it is a cone in q whose height falls with x. The area is exact throughout,
 * the shape approximate. Beyond what is looked up the expected coverage takes over.
 * tests/property prints the errors.
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

/* The bands about a point: its place among them, in turns of the spacing, and what that changes by
 * per mm of x and z; and of bands that go round, more. */
typedef struct {
  vf phase, x, z;
  /* where they go round the stem: */
  vf fork, half;                     /* how far a band has parted; how much narrower its arms are */
  vf ring, ring_x, ring_z, ring_end; /* phase of the ring about its middle; the most of it */
} vessel_bands;

/* What a blurred disc comes to: height * clamp(top - q), with q = d^T Q d in
 * units of the mean radius. */
typedef struct {
  vf xx, xz, zz; /* of Q; xz doubled */
  vf top, height;
  vf apart; /* 1: a sum of covers that is cut off at 1 is their union; 0: it counts twice */
  const vessel_bands *bands; /* of the field's discs, where they stand in bands */
} disc;

#define DISC_FULL 0.74f  /* x from which on a disc is full in its middle */
#define DISC_APART 1.25f /* of x^2: what two discs share is smaller than either */

/* Of a matrix M, whose determinant is det, and area without the blur over pi. */
INLINE disc disc_within(vf xx, vf xz, vf zz, vf det, vf area) {
  vf one = splat(1.0f), root = inverse_root(det), x = area * root;
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
  d.bands = NULL;
  return d;
}

/* c: the footprint, 12 times its covariance. */
#define DISC_BLUR (1.0f / (12.0f * 0.2552f))

INLINE disc disc_blurred(vf radius2, matrix2 c) {
  vf k = splat(DISC_BLUR);
  vf xx = radius2 + k * c.xx, zz = radius2 + k * c.zz, xz = k * c.xz;
  vf det = vmax(xx * zz - xz * xz, radius2 * radius2);
  return disc_within(xx, xz, zz, det, radius2);
}

/* The same of an ellipse, of whose own matrix the determinant is area2. */
INLINE disc ellipse_blurred(matrix2 own, vf area2, matrix2 c) {
  vf k = splat(DISC_BLUR);
  vf xx = own.xx + k * c.xx, zz = own.zz + k * c.zz, xz = own.xz + k * c.xz;
  return disc_within(xx, xz, zz, vmax(xx * zz - xz * xz, area2), vsqrt(area2));
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
INLINE vf vessel_overlap(const disc *d, float overlap, vf sum) {
  sum = sum * d->height;
  return vmin(sum - sum * (splat(1.0f) - d->apart) * splat(overlap), splat(1.0f));
}

/* A hash as a whole number within +-HASH_ONE: a place within half a cell of the
 * cell's middle. The second, from the bits below the first's ten, leaves those
 * below 10 to the radius. */
INLINE vf hash_place(vu h) { return to_float((vi)h); }
INLINE vf hash_place2(vu h) { return to_float((vi)(h << 11)); }

#define PORE_UNIT 4294967296.0f /* a cell's side, in the units of those places */

/* From (arc, rho) at direction (c, s) to (x, z). */
INLINE matrix2 to_section(vf aa, vf ab, vf bb, vf c, vf s) {
  matrix2 m;
  vf cs = c * s, cc = c * c, ss = s * s;
  m.xx = aa * ss - (ab + ab) * cs + bb * cc;
  m.zz = aa * cc + (ab + ab) * cs + bb * ss;
  m.xz = (bb - aa) * cs + ab * (cc - ss);
  return m;
}

/* Where a point's vessels are looked up. */
typedef struct {
  vf x, z; /* mm: in the reference section */
  vf c, s; /* direction of (x, z) */
  vf turn; /* the same over 2 pi, where place_has_turn */
  vf rho;  /* mm: of the point's year */
  ring_place ring;
  footprint2 f;              /* over (arc, rho) */
  vu own;                    /* the seeds' offset */
  const vessel_bands *bands; /* where there are any */
} vessel_place;

/* Where it is worth an arc tangent for all. */
INLINE int place_has_turn(const wood_constants *w) {
  return w->has_rays || w->rows || w->has_canals || w->bands.along_arc;
}
INLINE vf place_turn(vf c, vf s) { return arctan2(s, c) * splat(0.15915494f); }

/* What is found there. */
typedef struct {
  vf pores, rows;             /* coverage, where it could be looked up */
  vf pores_faded, rows_faded; /* 1: the expected coverage is to be used */
  vf sheaths;                 /* of pores with their sheaths; faded as they are */
} vessel_cover_t;

/* 0 while sqrt(e2) is below 0.6 of the reach, 1 from the whole of it on. */
INLINE vf fade_beyond(vf e2, float reach) {
  return smooth_step(splat(0.6f * reach), splat(reach), vsqrt(e2));
}

#endif
