/* SPDX-License-Identifier: Apache-2.0
 *
 * The strands of a bundle: lanes side by side, each of which may hold one.
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

/* A wave of period and amplitude 1, of parabolas, with its slope. */
INLINE vf wave(vf turns, vf *slope) {
  vi whole;
  vf t = turns - vfloor(turns + splat(0.5f), &whole);
  vf a = vabs(t);
  *slope = splat(8.0f) - splat(32.0f) * a;
  return t * (splat(8.0f) - splat(16.0f) * a);
}

/* The k-th byte of a hash, from the top, within -128 to 127. */
INLINE vf byte_of(vu h, int k) { return to_float((vi)(h << (8 * k)) >> 24); }

/* 1 / sqrt(1 + x) for 0 <= x <= 1.6, within 0.003; what is steeper counts as that. */
INLINE vf lane_inverse_root(vf x) {
  x = vmin(x, splat(1.6f));
  return splat(0.9985f) + x * (splat(-0.4755f) + x * (splat(0.2435f) + x * splat(-0.0545f)));
}

typedef struct {
  vf x, y;           /* place in the bundle, mm: along; across, straightened */
  vf bend;           /* slope of the bundle itself there */
  vf rest2;          /* what the bundle's radius leaves at this level, squared */
  vf chord;          /* half of the bundle's extent along x there */
  vf inverse_length; /* of a strand there, half */
  vf widen;          /* how much broader strands look at the eye's slant */
  vf full;           /* how many strands it has, of what is usual */
  vu h;              /* the bundle */
} lane_place;

/* A footprint, as lanes see it: of a strand's thickness, which all layers share. */
typedef struct {
  vf s, inverse_box, half; /* of the box that stands for the footprint */
  vf inverse_end;
} lane_filter;

INLINE lane_filter lane_filter_of(float radius, vf s) {
  vf box = vmax(s, splat(0.02f * radius));
  return (lane_filter){s, splat(1.0f) / box, box * splat(0.5f),
                       splat(1.0f) / vmax(s, splat(2.0f * radius))};
}

/* What a layer shows: coverage, and of the strand that covers most the rest. */
typedef struct {
  vf cover;
  vf slope;  /* of the centreline, the bundle's and its own */
  vf across; /* place across the strand, -1 to 1 */
  vf tone, second, bright;
  vf soft;   /* how near a strand is, 0 to 1: it takes light from what is below */
  vf detail; /* 1 where strands are seen, 0 where only their mean is */
  vu id;
} lane_hit;

/* One lane's strand at the point. */
typedef struct {
  vf cover, slope, lo, hi, r, from, near;
  vu a, b;
} lane_strand;

INLINE void lane_at(const fibertex_constants *w, const fibertex_layer *c, int ends,
                    const lane_place *p, vi j, const lane_filter *t, lane_strand *q) {
  const vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f);
  vu a = hash_mix(p->h + (vu)j * splatu(HASH_X));
  vu b = (a ^ (a >> 15)) * splatu(0x2c1b3c6du);
  b ^= b >> 13;
  q->a = a;
  q->b = b;
  vm there = lt(to_float((vi)(b >> 16)), p->full * splat(c->presence));
  vf f = splat(w->own_frequency) + splat(0.4f / 128.0f * w->own_frequency) * byte_of(b, 3), rate;
  vf own = wave(p->x * f + splat(1.0f / 256.0f) * byte_of(a, 1), &rate);
  vf tilt = splat(c->tilt) * byte_of(a ^ b, 0);
  vf centre = (to_float(j) + half) * splat(c->spacing) + splat(c->shift) * byte_of(a, 0) +
              splat(c->sway) * own + tilt * p->x;
  q->slope = p->bend + splat(c->sway) * rate * f + tilt;
  vf e = (p->y - centre) * lane_inverse_root(q->slope * q->slope);
  vf thick = splat(w->radius_spread * (1.0f / 128.0f)) * byte_of(a, 2);
  vf r = splat(c->radius) * (one + thick) * p->widen;
  vf lo = vmax(e - t->half, zero - r), hi = vmin(e + t->half, r);
  vf cover = vmax(hi - lo, zero) * t->inverse_box;
  q->lo = lo;
  q->hi = hi;
  q->r = r;
  /* of a thickness between that and its shadow's: then its mean hardly changes with the slant */
  vf blur = splat(0.5f) * r + splat(1.1f * c->radius) * (one + thick);
  vf near = clamp01((blur - half * vabs(e)) * splat(c->inverse_radius));
  q->from = zero;
  if (ends) {
    q->from = vabs(p->x - p->chord * (splat((1.0f - LANE_ENDS) / 128.0f) * byte_of(b, 2)));
    vf end = clamp01((p->chord * splat(LANE_ENDS) - q->from) * t->inverse_end + half);
    cover = cover * end;
    near = near * end;
  }
  q->near = sel(there, near, zero);
  q->cover = sel(there, cover, zero);
}

/* Coverage expected of a place in a bundle, whatever its lanes hold. */
INLINE vf lane_expected(const fibertex_layer *c, int ends, const lane_place *p) {
  const vf one = splat(1.0f);
  vf steep = vmin(p->bend * p->bend, splat(2.0f));
  vf wide = splat(c->formula) * p->full * p->widen *
            (one + steep * (splat(0.46f) - splat(0.06f) * steep));
  if (ends) {
    vf v = vabs(p->x) * p->inverse_length * splat(LANE_ENDS);
    wide = wide * clamp01((one - v) * splat(1.0f / (2.0f - 2.0f * LANE_ENDS)));
  }
  return vmin(wide, one);
}

INLINE void lanes_at(const fibertex_constants *w, const fibertex_layer *c, int ends,
                     const lane_place *p, const lane_filter *t, lane_hit *q) {
  const vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f);
  vf far = smooth_step(splat(0.6f * c->spacing), splat(c->vague), t->s);
  vm some = gt(far, zero);
  *q = (lane_hit){zero, zero,           zero,      zero,     splat(w->second_share),
                  one,  splat(c->soft), one - far, splatu(0)};
  if (any(lt(far, one))) {
    lane_strand m, n;
    vi j;
    (void)vfloor(p->y * splat(c->inverse_spacing) - half, &j);
    lane_at(w, c, ends, p, j, t, &m);
    lane_at(w, c, ends, p, j + splati(1), t, &n);
    q->cover = vmin(m.cover + n.cover, one);
    /* what lies bare within a footprint as wide as a strand is near it on the average */
    vf wide = smooth_step(splat(0.2f * c->radius), splat(1.6f * c->radius), t->s);
    q->soft = vmax(m.near, n.near);
    q->soft = sel(gt(wide, zero), q->soft + (splat(c->soft) - q->soft) * wide, q->soft);
    vm other = lt(m.cover, n.cover);
    vu a = (vu)seli(other, (vi)n.a, (vi)m.a), b = (vu)seli(other, (vi)n.b, (vi)m.b);
    q->slope = sel(other, n.slope, m.slope);
    /* over the part of the footprint that is covered */
    vf inverse = one / sel(other, n.r, m.r);
    vf lo = sel(other, n.lo, m.lo) * inverse, hi = sel(other, n.hi, m.hi) * inverse;
    vf across2 = vmin((lo * lo + lo * hi + hi * hi) * splat(1.0f / 3.0f), one);
    q->across = clamp((lo + hi) * half, splat(-1.0f), one);
    q->tone = splat(1.0f / 128.0f) * byte_of(a, 3);
    q->id = a;
    q->second = sel(lti((vi)(b & splatu(0xffu)), splati(w->second_chance)), one, zero);
    vf bright = splat(1.0f / (1.0f - LANE_RIM / 3.0f)) -
                splat(LANE_RIM / (1.0f - LANE_RIM / 3.0f)) * across2;
    if (ends) {
      vf v = vmin(sel(other, n.from, m.from) * p->inverse_length, one);
      bright = bright * (splat(1.0f / (1.0f - LANE_DIVE / 3.0f)) -
                         splat(LANE_DIVE / (1.0f - LANE_DIVE / 3.0f)) * v * v);
    }
    q->bright = bright * splat(c->lift);
  }
  if (!any(some)) return;
  vf near = one - far, expected = lane_expected(c, ends, p);
  if (!any(lt(far, one))) { /* what the rest would come to */
    q->cover = expected;
    q->slope = p->bend;
    return;
  }
  /* the mean of what is covered has its strands in proportion to coverage */
  vf seen = near * q->cover, all = seen + far * expected;
  vf part = seen / vmax(all, splat(1e-6f)), rest = one - part;
  q->cover = sel(some, all, q->cover);
  q->slope = sel(some, q->slope * part + p->bend * rest, q->slope);
  q->across = sel(some, q->across * part + zero, q->across); /* no -0 */
  q->id = (vu)seli(lt(far, one), (vi)q->id, splati(0));
  q->tone = sel(some, q->tone * part, q->tone);
  q->second = sel(some, q->second * part + splat(w->second_share) * rest, q->second);
  q->bright = sel(some, q->bright * part + rest, q->bright);
  q->soft = sel(some, q->soft * near + splat(c->soft) * far, q->soft);
}

#endif
