/* SPDX-License-Identifier: Apache-2.0
 *
 * Knots: branches that the stem grew round.
 *
 * A knot's axis leaves the pith in a direction (c, s) and rises with a slope.
 * About it stand, in the square section of the branch,
 *   u   mm along that direction, a mm to the side of it, h mm above the axis
 *   d   sqrt of a quadratic form of (a, h), a little oblong, and a linear one: of its
 *       ovals the pith is not the middle but a focus, nearer to a conifer's upper side
 * The branch had the radius d when the stem had the radius
 *   K(d) = born + length ((1 - q) e + q e^2), e = d / radius,
 * which is when its wood there was laid down: its own rings are those of K.
 * While it lives, the growth front is the nearer of the two, and the stem's rises
 * to the branch's (the collar): with r the branch's radius at the time, in the stem
 *   rho' = rho - high r max(1 - m, 0)^3, m = (d / r - 1) / wide,
 * and in the branch K(d) - high d, which is the same where they meet. high and wide
 * are larger above and below it than at its sides. From its death on r stands
 * still, bark lies about it, and the collar sinks back. What is laid down after it
 * has been shed closes over it from the sides, latest in the middle.
 *
 * Fibres part round it as a stream does round a post: those that pass at a to
 * the side come from a (1 - G F), F falling off as the square of the distance.
 *
 * All effects end at a finite distance, all derivatives are exact; along rho the
 * front's derivative stays positive, so that rings never cross. After: the
 * union of stem and branch of Larsson et al., "Procedural texturing of solid
 * wood with knots", SIGGRAPH 2022; the stream round a knot of Goodman & Bodig
 * (1978) and Foley (2001); what collar and bark look like, of Shigo (1985).
 */
#ifndef SOZAI_WOOD_KNOTS_H
#define SOZAI_WOOD_KNOTS_H

#include "knot_bend.h"
#include "knot_cover.h"
#include "knot_taps.h"

/* What a point brings to all knots. */
typedef struct {
  vf y, s;         /* height on the stem; footprint */
  const vf *n;     /* the surface's normal; */
  int ball;        /* or none is known */
  vf rho;          /* the clear stem's */
  knot_taps *taps; /* where any footprint is wide, else NULL */
} knot_eye;

/* One of them. */
INLINE void knot_add(const wood_knots *all, const wood_knot *k, const knot_eye *e, vf close,
                     stem_place *p, knot_place *out) {
  knot_section o = knot_section_at(all, k, e->y, p);
  vf sees = splat(k->sees) + splat(0.75f) * e->s;
  vm bent = and_(o.grown, lt(o.a * o.a + splat(0.25f) * o.h * o.h, splat(k->near)));
  vm seen = and_(o.grown, lt(o.square, sees * sees));
  if (!any(or_(bent, seen))) return;
  knot_section_slopes(k, &o);
  if (e->taps) {
    vm taken = and_(or_(bent, seen), le(e->s, splat(2.0f * KNOT_NEAR)));
    knot_taps_add(k, &o, taken, e->s, e->taps);
  }
  if (any(bent)) knot_bend(all, k, &o, bent, e->s, p, out);
  if (any(seen)) {
    knot_see(all, k, &o, e->rho, p->inverse_r, e->s, e->n, e->ball, close, seen, out);
  }
}

/* Likewise of the cover of a wide footprint, and of its rings. */
INLINE void knot_add_wide(const wood_knots *all, const wood_knot *k, const knot_eye *e, vf middle,
                          stem_place *p, knot_place *out) {
  knot_section o = knot_section_at(all, k, e->y, p);
  vf reach = splat(k->sees) + splat(0.75f) * e->s;
  vf about = vmin(reach + splat(0.6f * k->bends), splat(k->sees + 1.5f * KNOT_FAR));
  vm near = and_(lt(o.square, reach * reach), o.grown_wide);
  vm raised =
      and_(and_(lt(o.square, about * about), o.grown_wide), lt(splat(2.0f * KNOT_NEAR), e->s));
  if (e->taps) knot_taps_add(k, &o, raised, e->s, e->taps);
  if (!any(near)) return;
  knot_section_slopes(k, &o);
  knot_see(all, k, &o, e->rho, p->inverse_r, e->s, e->n, e->ball, middle, near, out);
}

INLINE int32_t knot_least(vi x) {
  int32_t lanes[LANES], least;
  memcpy(lanes, &x, sizeof lanes);
  least = lanes[0];
  for (int i = 1; i < LANES; i++) least = lanes[i] < least ? lanes[i] : least;
  return least;
}

/* The lists of the points' cells, each knot once and in order. Mostly it is one cell. */
typedef struct {
  const int32_t *index;
  int same;
  int32_t one, last; /* the cell's */
  vi at, end;        /* of each point's own */
} knot_lists;

INLINE knot_lists knot_lists_of(const wood_knots *all, vi cell) {
  knot_lists q = {.index = all->index};
  q.at = gatheri(all->first, cell);
  q.end = gatheri(all->first, cell + splati(1));
  int32_t from[LANES], to[LANES];
  memcpy(from, &q.at, sizeof from);
  memcpy(to, &q.end, sizeof to);
  q.one = from[0];
  q.last = to[0];
  q.same = 1;
  for (int i = 1; i < LANES; i++) q.same &= from[i] == from[0];
  return q;
}

/* INT32_MAX: no more. */
INLINE int32_t knot_next(knot_lists *q) {
  if (q->same) return q->one < q->last ? q->index[q->one++] : INT32_MAX;
  vi found = seli(lti(q->at, q->end), gatheri(q->index, q->at), splati(INT32_MAX));
  int32_t m = knot_least(found);
  q->at = q->at + seli(eqi(found, splati(m)), splati(1), splati(0));
  return m;
}

/* The cell of a place, and which of its parts. shift: of the board's log, in turns
 * of the period. */
typedef struct {
  vf turns;
  vm within;
  vi x, y, z; /* in parts: quarters of a cell, halves along the stem */
} knot_part;

INLINE knot_part knot_part_of(const wood_knots *all, vf shift, vf y, const stem_place *p) {
  knot_part q;
  vf zero = splat(0.0f), turns = y * splat(all->inverse_period) + shift;
  vi whole;
  q.turns = turns - vfloor(turns, &whole);
  vf fx = (p->x - splat(all->low)) * splat(4.0f * all->inverse_cell);
  vf fz = (p->z - splat(all->low)) * splat(4.0f * all->inverse_cell);
  vf most = splat(4.0f * (float)all->across);
  q.within = and_(and_(le(zero, fx), lt(fx, most)), and_(le(zero, fz), lt(fz, most)));
  vfloor(sel(q.within, fx, zero), &q.x);
  vfloor(sel(q.within, fz, zero), &q.z);
  vfloor(q.turns * splat(2.0f * (float)all->tall), &q.y);
  q.y = seli(lti(q.y, splati(2 * all->tall)), q.y, splati(2 * all->tall - 1));
  return q;
}

INLINE vi knot_cell_of(const wood_knots *all, const knot_part *q) {
  vi cell = ((q->y >> 1) * splati(all->across) + (q->z >> 2)) * splati(all->across) + (q->x >> 2);
  return seli(q->within, cell, splati(all->cells));
}

/* Whether any point may have to do with a knot. */
INLINE int knots_near(const wood_knots *all, vf shift, vf y, vf s, const stem_place *p) {
  if (any(gt(s, splat(2.0f * KNOT_NEAR)))) return 1;
  knot_part q = knot_part_of(all, shift, y, p);
  const int32_t *of = all->parts[any(gt(s, splat(KNOT_CLOSE)))];
  vi parts = gatheri(of, knot_cell_of(all, &q)), one = splati(1);
  vi which = (q.x & splati(3)) | ((q.z & splati(3)) << 2) | ((q.y & one) << 4);
  return any(eqi((parts >> which) & one, one));
}

/* All that are near, in their order. */
INLINE void knots_add(const wood_knots *all, vf shift, const knot_eye *e, stem_place *p,
                      knot_place *out) {
  vf zero = splat(0.0f), one = splat(1.0f), s = e->s;
  knot_part q = knot_part_of(all, shift, e->y, p);
  vi cell = knot_cell_of(all, &q);
  knot_lists lists = knot_lists_of(all, cell);
  knot_eye here = *e;
  here.y = e->y + shift * splat(all->period);
  here.rho = p->rho;
  vf middle = smooth_step(splat(KNOT_NEAR), splat(2.0f * KNOT_NEAR), s), close = one - middle;
  for (int32_t m = knot_next(&lists); m != INT32_MAX; m = knot_next(&lists)) {
    knot_add(all, &all->list[m], &here, close, p, out);
  }
  if (!any(gt(middle, zero))) return;
  /* the same knots once more, weighed by the rest: what they had is added, not joined */
  knot_place first = *out;
  out->cover = out->bark = out->halo = out->heart = out->check = zero;
  vf far = smooth_step(splat(KNOT_FAR), splat(2.0f * KNOT_FAR), s);
  middle = middle * (one - far);
  vi coarse = splati(all->far_across[KNOT_COARSE]);
  cell = ((q.y >> (KNOT_COARSE + 1)) * coarse + (q.z >> (KNOT_COARSE + 2))) * coarse +
         (q.x >> (KNOT_COARSE + 2));
  cell = seli(q.within, cell, splati(all->coarse)) + splati(all->cells + 1);
  lists = knot_lists_of(all, cell);
  for (int32_t m = knot_next(&lists); m != INT32_MAX; m = knot_next(&lists)) {
    knot_add_wide(all, &all->list[m], &here, middle, p, out);
  }
  out->cover = out->cover + first.cover;
  out->bark = out->bark + first.bark;
  out->halo = out->halo + first.halo;
  out->heart = out->heart + first.heart;
  out->check = out->check + first.check;
  if (!any(gt(far, zero))) return;
  vf share = sel(gt(far, zero), far * knots_far(all, p->x, q.turns, p->z, s), zero);
  out->cover = out->cover + share;
  out->heart = out->heart + splat(0.5f) * share;
  out->halo = out->halo + splat(1.0f + KNOT_HALO_SHARE) * share;
}

#endif
