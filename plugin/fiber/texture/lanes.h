/* SPDX-License-Identifier: Apache-2.0
 *
 * The strands of a bundle: lanes side by side, each of which may hold one.
 *
 * In stages, each run over several layers before the next: a stage's work waits for its own
 * results most of the time, and does not for another layer's.
 */
#ifndef SOZAI_FIBERTEX_LANES_H
#define SOZAI_FIBERTEX_LANES_H

#include "../../core/hash.h"
#include "../../core/maths.h"
#include "texture.h"

/* How much darker a strand is where it dives at its ends, and its rim. Both are
 * divided by their means, so that neither changes a patch's. */
#define LANE_DIVE 0.5f
#define LANE_RIM 0.5f
#define LANE_ENDS 0.7f /* a strand's length over its lane's */

/* The greatest whole number not above x; its sign where it is 0 is either. */
INLINE vf whole_of(vf x) {
#ifdef ROUND_DOWN_
  return ROUND_DOWN_(x);
#else
  vi whole;
  return vfloor(x, &whole);
#endif
}

/* A wave of period 1 and amplitude 1/8, of parabolas, with its slope. */
INLINE vf wave(vf turns, vf *slope) {
  vf t = turns - whole_of(turns + splat(0.5f));
  vf a = vabs(t) + vabs(t), b = splat(1.0f) - a;
  *slope = b - a;
  return t * b;
}

/* A hash from its k-th byte on, from the top: a number within +-HASH_ONE. */
INLINE vf field_of(vu h, int k) { return to_float((vi)(h << (8 * k))); }
#define FIELD(x) ((x) / HASH_ONE) /* what it is multiplied by to lie within +-x */

/* 1 / sqrt(1 + x) for 0 <= x <= 1.6, within 0.003; what is steeper counts as that. */
INLINE vf lane_inverse_root(vf x) {
  x = vmin(x, splat(1.6f));
  return splat(0.9985f) + x * (splat(-0.4755f) + x * (splat(0.2435f) + x * splat(-0.0545f)));
}

typedef struct {
  vf x, y;           /* place in the bundle, mm: along; across, straightened */
  vf bend;           /* slope of the bundle itself there */
  vf inverse_length; /* of a strand there, half */
  vf widen;          /* how much broader strands look at the eye's slant */
  vf thin, reach;    /* how far a strand's middle lies off that's, over a field's 2^31; half of
                      * its own */
  vf many;           /* how many strands it has, of what is usual */
  vf full;           /* the same as what b is below where there is one */
  vu h;              /* the bundle */
} lane_place;

/* A footprint, as lanes see it: of a strand's thickness, which all layers share. */
typedef struct {
  vf s, inverse_box, half; /* of the box that stands for the footprint */
  vf inverse_end;
  vf wide; /* 0 where nearness is a strand's, 1 where it is the mean's */
} lane_filter;

INLINE lane_filter lane_filter_of(float radius, vf s) {
  vf box = vmax(s, splat(0.02f * radius));
  /* what lies bare within a footprint of some strands is near them on the average */
  return (lane_filter){s, splat(1.0f) / box, box * splat(0.5f),
                       splat(1.0f) / vmax(s, splat(2.0f * radius)),
                       smooth_step(splat(1.2f * radius), splat(5.0f * radius), s)};
}

/* From lanes, 0, to their bundle's mean, 1. */
INLINE vf lane_far(const fibertex_layer *c, vf s) {
  vf t = clamp01((s - splat(c->vague)) * splat(c->vague_inverse));
  return t * t * (splat(3.0f) - splat(2.0f) * t);
}

/* What a layer shows: coverage, and of the strand that covers most the rest. */
typedef struct {
  vf cover;  /* by its strands, */
  vf mean;   /* and by what is no more than a mean of them */
  vf slope;  /* of the centreline, the bundle's and its own */
  vf across; /* place across the strand, -1 to 1 */
  vf tone;   /* over a field's 2^31 */
  vf second, bright;
  vf soft; /* how near a strand is, 0 to 1: it takes light from what is below */
  vu id;
} lane_hit;

/* One lane's strand at the point. */
typedef struct {
  vf cover, slope, lo, hi, r;
  vf off, thick;             /* from its centreline; half of its thickness, seen squarely */
  vf from;                   /* its middle, along it */
  vf frequency, turns, tilt; /* of its swing and its drift */
  vu id;
} lane_strand;

/* Where the two lanes are that may cover the point: the first one's key, and how far off its
 * middle. */
typedef struct {
  vu key;
  vf off;
} lane_pair;

INLINE void lane_pair_of(const fibertex_layer *c, const lane_place *p, lane_pair *q) {
  vf at = p->y * splat(c->inverse_spacing) - splat(0.5f), low = whole_of(at);
  q->off = (at - low) * splat(c->spacing);
  q->key = p->h + (vu)to_int(low) * splatu(HASH_X);
}

/* A second number of chance for a strand: its upper half is good. */
INLINE vu lane_more(vu id) { return id * splatu(0x846ca68bu); }

/* Whether it is of the second colour: 1, else 0. */
INLINE vf lane_second(const fibertex_constants *w, vu id) {
  vi chance = (vi)(lane_more(id) & splatu(0xff00u));
  return sel(lti(chance, splati(w->second_chance << 8)), splat(1.0f), splat(0.0f));
}

/* What chance gives a strand; second: which lane of the two. Two things share a field where nobody
 * sees that they go together. */
INLINE void lane_draw(const fibertex_constants *w, const fibertex_layer *c, int ends,
                      const lane_place *p, const lane_pair *pair, int second, lane_strand *q) {
  /* the place's hash is a good one: a round is enough */
  vu id = second ? pair->key + splatu(HASH_X) : pair->key;
  id ^= id >> 15;
  id *= splatu(0x7feb352du);
  id ^= id >> 13;
  q->id = id;
  vf aside = field_of(id, 0), phase = field_of(id, 1), thick = field_of(id, 2);
  q->frequency = splat(w->own_frequency) + splat(w->own_vary) * thick;
  q->turns = p->x * q->frequency + splat(FIELD(0.5f)) * phase;
  vf off = second ? pair->off - splat(c->spacing) : pair->off;
  q->off = off - splat(c->shift) * aside;
  q->tilt = splat(c->tilt) * aside;
  q->thick = splat(c->radius) + splat(c->radius_vary) * thick;
  if (ends) q->from = vabs(p->x - p->thin * phase);
}

/* Its centreline. */
INLINE void lane_course(const fibertex_layer *c, const lane_place *p, lane_strand *q) {
  vf rate, own = wave(q->turns, &rate), sway = splat(c->sway);
  q->slope = p->bend + (sway * rate * q->frequency + q->tilt);
  q->off = q->off - (sway * own + q->tilt * p->x);
}

/* What of it a footprint has. */
INLINE void lane_cover(int ends, const lane_place *p, const lane_filter *t, lane_strand *q) {
  const vf zero = splat(0.0f), half = splat(0.5f);
  vf e = q->off * lane_inverse_root(q->slope * q->slope);
  vf r = q->thick * p->widen;
  vf lo = vmax(e - t->half, zero - r), hi = vmin(e + t->half, r);
  vf cover = vmax(hi - lo, zero) * t->inverse_box;
  q->off = e;
  q->lo = lo;
  q->hi = hi;
  q->r = r;
  if (ends) {
    vf end = (p->reach - q->from) * t->inverse_end + half;
    cover = cover * clamp01(end);
  }
  vm there = lt(to_float((vi)lane_more(q->id)), p->full);
  q->cover = sel(there, cover, zero);
}

/* How near a strand is that may not cover: 1 on it. */
INLINE vf lane_near(const fibertex_layer *c, int ends, const lane_place *p, const lane_filter *t,
                    const lane_strand *q) {
  const vf zero = splat(0.0f), half = splat(0.5f);
  /* of a thickness between that and its shadow's: then its mean hardly changes with the slant */
  vf near = (splat(1.1f) * q->thick + half * (q->r - vabs(q->off))) * splat(c->inverse_radius);
  near = clamp01(near);
  if (ends) near = near * clamp01((p->reach - q->from) * t->inverse_end + half);
  vm there = lt(to_float((vi)lane_more(q->id)), p->full);
  return sel(there, near, zero);
}

/* Coverage expected of a place in a bundle, whatever its lanes hold. */
INLINE vf lane_expected(const fibertex_layer *c, int ends, const lane_place *p) {
  const vf one = splat(1.0f);
  vf steep = vmin(p->bend * p->bend, splat(2.0f));
  vf wide = splat(c->formula) * p->many * p->widen *
            (one + steep * (splat(0.46f) - splat(0.06f) * steep));
  if (ends) {
    vf v = vabs(p->x) * p->inverse_length * splat(LANE_ENDS);
    wide = wide * clamp01((one - v) * splat(1.0f / (2.0f - 2.0f * LANE_ENDS)));
  }
  return vmin(wide, one);
}

/* Of the two that which covers more. */
INLINE void lane_choose(const fibertex_constants *w, const fibertex_layer *c, int ends,
                        const lane_place *p, const lane_filter *t, const lane_strand both[2],
                        lane_hit *q) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  const lane_strand *m = &both[0], *n = &both[1];
  q->cover = vmin(m->cover + n->cover, one);
  q->soft = splat(c->soft) * t->wide;
  if (any(lt(t->wide, one))) {
    q->soft =
        q->soft + vmax(lane_near(c, ends, p, t, m), lane_near(c, ends, p, t, n)) * (one - t->wide);
  }
  vm other = lt(m->cover, n->cover);
  vu id = (vu)seli(other, (vi)n->id, (vi)m->id);
  q->slope = sel(other, n->slope, m->slope) + zero; /* no -0 */
  /* over the part of the footprint that is covered */
  vf inverse = one / sel(other, n->r, m->r);
  vf lo = sel(other, n->lo, m->lo) * inverse, hi = sel(other, n->hi, m->hi) * inverse;
  vf sum = lo + hi;
  vf across2 = vmin((sum * sum - lo * hi) * splat(1.0f / 3.0f), one);
  q->across = clamp(sum * splat(0.5f), splat(-1.0f), one) + zero;
  q->tone = field_of(id, 3);
  q->id = id;
  q->second = w->second_chance ? lane_second(w, id) : zero;
  /* what is brighter in the middle: 1 at the mean */
  vf bright = splat(c->lift) * (splat(1.0f / (1.0f - LANE_RIM / 3.0f)) -
                                splat(LANE_RIM / (1.0f - LANE_RIM / 3.0f)) * across2);
  if (ends) {
    vf v = vmin(sel(other, n->from, m->from) * p->inverse_length, one);
    bright = bright * (splat(1.0f / (1.0f - LANE_DIVE / 3.0f)) -
                       splat(LANE_DIVE / (1.0f - LANE_DIVE / 3.0f)) * (v * v));
  }
  q->bright = bright;
  q->mean = zero;
}

/* Between the two: a layer shows a part by its strands and a part by their mean. */
INLINE void lane_blend(const fibertex_layer *c, vf far, vf expected, lane_hit *q) {
  vf near = splat(1.0f) - far;
  q->cover = near * q->cover;
  q->mean = far * expected;
  q->soft = q->soft * near + splat(c->soft) * far;
}

#endif
