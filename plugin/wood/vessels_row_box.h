/* SPDX-License-Identifier: Apache-2.0
 *
 * Earlywood rows under footprints too long for one look-up: each vessel by its share of a
 * box, in one pass.
 */
#ifndef SOZAI_WOOD_VESSELS_ROW_BOX_H
#define SOZAI_WOOD_VESSELS_ROW_BOX_H

#include "footprint_parts.h"
#include "vessels_rows.h"

#define ROW_MOST 8     /* vessels of a row under a footprint */
#define ROW_FADES 2.5f /* of half of those: from here on the mean fades in */
#define ROW_SHARP 0.3f /* of a radius: no box is narrower, as no vessel's edge is sharper */
#define ROW_LENS 0.5f  /* of a radius: what two vessels share is smaller than either */

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
