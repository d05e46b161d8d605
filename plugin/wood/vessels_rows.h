/* SPDX-License-Identifier: Apache-2.0
 *
 * Earlywood vessels, in rows along the ring boundary: 2 pi R P to a ring, evenly spaced
 * with jitter.
 */
#ifndef SOZAI_WOOD_VESSELS_ROWS_H
#define SOZAI_WOOD_VESSELS_ROWS_H

#include "vessels.h"

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
  return sel(p->near, vessel_overlap(d, w->row.overlap, sum), splat(0.0f));
}

/* An earlywood vessel at its mean radius under such a footprint. */
INLINE disc rows_disc(const wood_constants *w, vf aa, vf ab, vf bb) {
  return disc_blurred(splat(w->row.radius * w->row.radius), (matrix2){aa, ab, bb});
}

INLINE row_place row_of(const wood_constants *w, const vessel_place *p) {
  return row_at(w, p->own, &p->ring, p->rho, p->turn, vsqrt(p->f.bb));
}

INLINE vm rows_cut(const wood_constants *w, const footprint2 *f) {
  return gt(f->aa + f->bb, splat(w->row.part * w->row.part));
}

/* Where a footprint may meet the bands of other rings. */
INLINE vm rows_meet(const wood_constants *w, const footprint2 *f) {
  return gt(f->bb, splat(w->rows_alone * w->rows_alone));
}

#endif
