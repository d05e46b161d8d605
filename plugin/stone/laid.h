/* SPDX-License-Identifier: Apache-2.0
 *
 * A stone of a paving: which one is here, where in the quarry's block it was
 * cut, and the outline of its edge as height.
 *
 * The edge is a profile of the distance m from the joint's middle: the joint's
 * floor, its wall, the stone's chamfer and rounding, the face. It is the same
 * beyond the middle, so that under a footprint it is a difference of two values
 * of its integral.
 */
#ifndef SOZAI_STONE_LAID_H
#define SOZAI_STONE_LAID_H

#include "../layout/units.h"
#include "../layout/wander.h"
#include "field.h"
#include "stone.h"

#define LAID_LEAST 0.05f /* mm: a point's own blur across an edge */

typedef struct {
  layout_unit unit;
  vu own;       /* hash */
  vf row[2][2]; /* of the bent plane along x and y: wander.h */
  field m;      /* mm from the joint's middle */
  vf edge;      /* mm from the stone's edge, inside positive */
  vf joint;     /* share of the footprint */
  vf near, e;   /* 1 where the footprint is below a stone's size; its side */
  vf c, s;      /* how the block is turned */
  vf shift[3];  /* mm, and moved */
  vf tone[3];   /* factors of the albedo */
} laid;

/* A footprint's square in object space: its sides, unit, and its face's normal, or NULL for the
 * plane's. */
typedef struct {
  vf side[2][3];
  const vf *n;
} laid_square;

INLINE vf laid_random(vu *h) {
  *h = hash_mix(*h + splatu(HASH_X));
  return layout_random(*h);
}
/* Nearly normal, sd 1. */
INLINE vf laid_normal(vu *h) {
  vf sum = laid_random(h) + laid_random(h) + laid_random(h);
  return sum + sum - splat(3.0f);
}

/* A slope in the bent plane to one in space. */
INLINE void laid_slope(const laid *q, vf x, vf y, vf out[3]) {
  out[0] = x * q->row[0][0] + y * q->row[1][0];
  out[1] = x * q->row[0][1] + y * q->row[1][1];
  out[2] = splat(0.0f);
}

/* Round the corner that the nearest two sides make: the distance to a circle
 * within both. Where there is one. */
INLINE vm laid_corner(const stone_paving *v, const cover *c, vf *edge, vf *nx, vf *ny) {
  vf one = splat(1.0f), zero = splat(0.0f), r = splat(v->corner), half = splat(v->half);
  vf a = r - (c->nearest - half), b = r - (c->second - half);
  vf cosine = c->nx * c->mx + c->ny * c->my;
  vf k = one / vmax(one - cosine * cosine, splat(0.05f));
  vf alpha = (a - cosine * b) * k, beta = (b - cosine * a) * k;
  vm there = and_(and_(gt(alpha, zero), gt(beta, zero)),
                  and_(gt(b, zero), lt(vabs(cosine), splat(0.97f))));
  if (!any(there)) return there;
  vf x = alpha * c->nx + beta * c->mx, y = alpha * c->ny + beta * c->my;
  vf square = vmax(x * x + y * y, splat(1e-12f)), inverse = inverse_root(square);
  *edge = sel(there, r - square * inverse, *edge);
  *nx = sel(there, x * inverse, *nx);
  *ny = sel(there, y * inverse, *ny);
  return there;
}

#define CORNER_OPEN 2.5f /* of its radius: how far a joint reaches between corners, mostly */
#define CORNER_SEEN 0.6f /* of its radius: footprints that a line across a corner tells, */
#define CORNER_GONE 1.5f /* and such that it does not */

/* Which stone is at a place, and how much of the footprint is joint. p and n, the face's
 * normal, or NULL for the plane's: object space. nx, ny: away from the stone's edge. */
INLINE void laid_find(const stone_constants *w, const vf p[3], const vf n[3], vf s, laid *q, vf *nx,
                      vf *ny) {
  const stone_paving *v = &w->paving;
  vf one = splat(1.0f), zero = splat(0.0f), at[2] = {p[0], p[1]};
  q->row[0][0] = q->row[1][1] = one;
  q->row[0][1] = q->row[1][0] = zero;
  if (v->wander.amplitude > 0.0f) layout_wander_at(&v->wander, p[0], p[1], at, q->row);
  cover c;
  q->unit = layout_find(&v->layout, at[0], at[1], n, s, &c);
  const layout_unit *u = &q->unit;
  vf edge = u->edge;
  *nx = c.nx;
  *ny = c.ny;
  q->joint = u->joint;
  if (v->corner > 0.0f) {
    vm round = laid_corner(v, &c, &edge, nx, ny);
    vf e = cover_extent(&c, *nx, *ny, vmax(s, splat(COVER_LEAST)));
    /* across a joint lies the next stone; between rounded corners it is farther, and farther still
     * where seams run through: of that wide footprints know the mean */
    vf narrow = one - smooth_step(zero, splat(CORNER_SEEN * v->corner), e);
    vf beyond = sel(round, splat(CORNER_OPEN * v->corner) * (one + narrow), zero);
    vf far_side = splat(-2.0f * v->half) - beyond;
    vf joint = vmax(cover_share(edge, e, far_side, zero), q->joint);
    /* a wide footprint has its part of them wherever it is */
    vf size = vmin(u->length, u->width), r = splat(v->corner);
    vf wide = smooth_step(splat(CORNER_SEEN) * r, splat(CORNER_GONE) * r, e);
    vf mean = one - (one - q->joint) * splat(1.0f - v->corner_share);
    joint = mix(joint, mean, wide);
    /* which the share of all the plane has, too */
    vf far = smooth_step(size, splat(2.0f) * size, e);
    q->joint = mix(joint, q->joint, far);
  }
  q->edge = edge;
  q->own = hash_mix(u->id + splatu(w->seed ^ 0x68bc21ebu));
}

/* A stone's shade, of each component; it counts as much as the footprint lies on it. */
INLINE void laid_tone(const stone_paving *v, const laid *q, vf tone[3]) {
  vf one = splat(1.0f);
  for (int k = 0; k < 3; k++) tone[k] = one;
  if (!(v->tone > 0.0f || v->tint > 0.0f)) return;
  vu h = q->own ^ splatu(0x5f356495u);
  vf shade = vmax(one + laid_normal(&h) * splat(v->tone) * q->unit.own, splat(0.2f));
  vf warm = clamp(laid_normal(&h) * splat(v->tint) * q->unit.own, splat(-0.4f), splat(0.4f));
  tone[0] = shade * (one + warm);
  tone[1] = shade;
  tone[2] = shade * (one - warm);
}

/* Shade and joint of a footprint by side * side parts, each of which lies on stones of its
 * own. t1, t2: the footprint's sides. */
STAGE void laid_by_parts(const stone_constants *w, const vf p[3], const vf n[3], const vf t1[3],
                         const vf t2[3], vf s, int side, vf tone[3], vf *joint) {
  vf part = s * splat(1.0f / (float)side), open = splat(0.0f), one = splat(1.0f);
  for (int k = 0; k < 3; k++) tone[k] = open;
  for (int i = 0; i < side * side; i++) {
    float middle = 0.5f * (float)(side - 1);
    vf u = part * splat((float)(i % side) - middle), v = part * splat((float)(i / side) - middle);
    vf at[3], own[3], nx, ny;
    for (int k = 0; k < 3; k++) at[k] = p[k] + t1[k] * u + t2[k] * v;
    laid q;
    laid_find(w, at, n, part, &q, &nx, &ny);
    laid_tone(&w->paving, &q, own);
    vf share = one - q.joint;
    open = open + share;
    for (int k = 0; k < 3; k++) tone[k] = tone[k] + share * own[k];
  }
  vf each = one / vmax(open, splat(1e-6f));
  for (int k = 0; k < 3; k++) tone[k] = tone[k] * each;
  *joint = one - open * splat(1.0f / (float)(side * side));
}

#define LAID_TWO 0.3f   /* of a stone's smaller side, from which a footprint is seen in two */
#define LAID_FOUR 0.8f  /* parts to a side, and in four; */
#define CORNER_TWO 0.4f /* the same of a corner's radius */
#define CORNER_FOUR 1.0f
#define LAID_MANY 12.0f /* from which parts vary by what the mean is off by: sd 0.001 */

INLINE void laid_wide(const stone_constants *w, const vf p[3], const vf n[3], const vf t1[3],
                      const vf t2[3], vf s, laid *q) {
  /* sides of irregular polygons are told as lines without ends, which small parts bear */
  int finer = w->paving.layout.kind == LAYOUT_CRAZY ? 2 : 1;
  vf size = vmin(q->unit.length, q->unit.width) * splat(1.0f / (float)finer), tone[3], joint;
  vf from = splat(LAID_TWO) * size, from4 = splat(LAID_FOUR) * size;
  if (w->paving.corner > 0.0f) {
    from = vmin(from, splat(CORNER_TWO * w->paving.corner));
    /* finer parts are small to a corner already */
    if (finer == 1) from4 = vmin(from4, splat(CORNER_FOUR * w->paving.corner));
  }
  vm wide = and_(gt(s, from), lt(s, splat(LAID_MANY) * size)), four = and_(wide, gt(s, from4));
  for (int k = 0; k < 2; k++) {
    vm mine = k ? four : and_(wide, not_(four));
    if (!any(mine)) continue;
    laid_by_parts(w, p, n, t1, t2, s, (k ? 4 : 2) * finer, tone, &joint);
    for (int c = 0; c < 3; c++) q->tone[c] = sel(mine, tone[c], q->tone[c]);
    q->joint = sel(mine, joint, q->joint);
  }
}

/* p and n, the face's normal, or NULL for the plane's: object space. t1, t2: the
 * footprint's sides there. */
STAGE void laid_at(const stone_constants *w, const vf p[3], const vf n[3], const vf t1[3],
                   const vf t2[3], vf s, laid *q) {
  const stone_paving *v = &w->paving;
  const layout *l = &v->layout;
  vf one = splat(1.0f), zero = splat(0.0f), nx, ny;
  laid_find(w, p, n, s, q, &nx, &ny);
  laid_tone(v, q, q->tone);
  laid_wide(w, p, n, t1, t2, s, q);
  const layout_unit *u = &q->unit;
  q->e = vmax(s, splat(LAID_LEAST));
  q->m.v = vmax(q->edge + splat(v->half), zero);
  vf co = splat(l->cosine), si = splat(l->sine);
  laid_slope(q, nx * co - ny * si, nx * si + ny * co, q->m.g);
  vf size = vmin(u->length, u->width);
  q->near = one - smooth_step(splat(0.7f) * size, splat(1.6f) * size, q->e);

  vu h = q->own;
  /* where rings bend the frame, any direction that does not */
  vf turn = laid_random(&h);
  vi quarter = to_int(turn * splat(4.0f));
  vf c0 = u->c, s0 = u->s;
  if (l->kind == LAYOUT_ARCS || l->kind == LAYOUT_CIRCLES || l->kind == LAYOUT_FAN) {
    sine_cosine_turns(laid_random(&h), &s0, &c0);
  }
  vm odd = eqi(quarter & splati(1), splati(1)), back = eqi(quarter & splati(2), splati(2));
  vf c1 = sel(odd, zero - s0, c0), s1 = sel(odd, c0, s0);
  q->c = sel(back, zero - c1, c1);
  q->s = sel(back, zero - s1, s1);
  for (int k = 0; k < 3; k++) {
    q->shift[k] = laid_random(&h) * splat(8192.0f) - splat(4096.0f) + splat(w->offset[k]);
  }
}

/* Object space to the stone's block, and its transpose. */
INLINE void laid_turn(const laid *q, vf v[3]) {
  vf x = v[0] * q->c + v[1] * q->s;
  v[1] = v[1] * q->c - v[0] * q->s;
  v[0] = x;
}
INLINE void laid_turn_back(const laid *q, vf v[3]) {
  vf x = v[0] * q->c - v[1] * q->s;
  v[1] = v[0] * q->s + v[1] * q->c;
  v[0] = x;
}

/* ---- what depends on the distance from the joint's middle -------------- */

/* 1 up to a, 0 from a + w on; and its integral from 0. m >= 0. */
INLINE vf fall_at(vf m, float a, float w) {
  vf t = clamp01((m - splat(a)) * splat(1.0f / w));
  return splat(1.0f) - t * t * (splat(3.0f) - t - t);
}
INLINE vf fall_integral(vf m, float a, float w) {
  vf x = clamp(m - splat(a), splat(0.0f), splat(w)), t = x * splat(1.0f / w);
  return vmin(m, splat(a)) + x - splat(w) * t * t * t * (splat(1.0f) - splat(0.5f) * t);
}

/* How wide the rounded edge is here, mm, as chipped edges differ. */
typedef struct {
  field wide;
  vf inverse;
} laid_round;

/* 1 at the stone's edge, 0 where its face begins. in: from the edge. */
INLINE vf profile_fallen(const laid_round *r, vf in) {
  return splat(1.0f) - clamp01(in * r->inverse);
}

INLINE vf profile_at(const stone_paving *v, const laid_round *r, vf m) {
  vf h = splat(0.0f), in = m - splat(v->half);
  if (v->depth > 0.0f) h = h - splat(v->depth) * fall_at(m, v->half - v->wall, v->wall);
  if (v->chamfer > 0.0f) {
    h = h - splat(v->slope) * (splat(v->chamfer) - clamp(in, splat(0.0f), splat(v->chamfer)));
  }
  if (v->round > 0.0f) {
    vf t = profile_fallen(r, in);
    h = h - splat(v->drop) * t * t;
  }
  return h;
}

/* Integrals from 0 of the height, and of the square of its slope. */
INLINE vf profile_integral(const stone_paving *v, const laid_round *r, vf m) {
  vf one = splat(1.0f), sum = splat(0.0f), zero = sum, half = splat(v->half);
  vf in = m - half, joint = vmin(m, half);
  if (v->depth > 0.0f) sum = sum - splat(v->depth) * fall_integral(m, v->half - v->wall, v->wall);
  if (v->chamfer > 0.0f) {
    vf x = clamp(in, zero, splat(v->chamfer));
    sum = sum - splat(v->slope) * (splat(v->chamfer) * (joint + x) - splat(0.5f) * x * x);
  }
  if (v->round > 0.0f) {
    vf t = profile_fallen(r, in);
    sum = sum - splat(v->drop) * (joint + r->wide.v * splat(1.0f / 3.0f) * (one - t * t * t));
  }
  return sum;
}
INLINE vf profile_square(const stone_paving *v, const laid_round *r, vf m) {
  vf one = splat(1.0f), sum = splat(0.0f), zero = sum, in = m - splat(v->half);
  if (v->depth > 0.0f) {
    vf t = clamp01((m - splat(v->half - v->wall)) * splat(1.0f / v->wall));
    sum = sum + splat(36.0f * v->depth * v->depth / v->wall) *
                    (t * t * t * (splat(1.0f / 3.0f) + t * (splat(-0.5f) + splat(0.2f) * t)));
  }
  if (v->chamfer > 0.0f) {
    sum = sum + splat(v->slope * v->slope) * clamp(in, zero, splat(v->chamfer));
  }
  if (v->round > 0.0f) {
    vf t = profile_fallen(r, in);
    sum = sum + splat(4.0f / 3.0f * v->drop * v->drop) * r->inverse * (one - t * t * t);
  }
  return sum;
}
/* What the height's integral changes by as the rounding grows wider. */
INLINE vf profile_widened(const stone_paving *v, const laid_round *r, vf m) {
  vf t = profile_fallen(r, m - splat(v->half));
  return splat(v->drop * (-1.0f / 3.0f)) * (splat(1.0f) - t * t * (splat(3.0f) - t - t));
}

/* Even continued below 0, its integral is odd. */
INLINE vf odd_of(vf x, vf integral) {
  return sel(lt(x, splat(0.0f)), splat(0.0f) - integral, integral);
}

/* The mean over the footprint of 1 up to a and 0 from a + w on. */
STAGE field laid_fall(const laid *q, float a, float w) {
  vf half = splat(0.5f) * q->e, low = q->m.v - half, high = q->m.v + half;
  vf l = vabs(low), inverse = splat(1.0f) / q->e;
  vf value = (fall_integral(high, a, w) - odd_of(low, fall_integral(l, a, w))) * inverse;
  return field_through(q->m, value, (fall_at(high, a, w) - fall_at(l, a, w)) * inverse);
}

/* The edge's outline under the footprint; *lost: variance of slope along one
 * axis that the footprint averages out. */
STAGE field laid_profile(const stone_paving *v, const laid *q, const laid_round *r, vf *lost) {
  vf half = splat(0.5f) * q->e, low = q->m.v - half, high = q->m.v + half;
  vf l = vabs(low), inverse = splat(1.0f) / q->e, one = splat(1.0f);
  vf value = (profile_integral(v, r, high) - odd_of(low, profile_integral(v, r, l))) * inverse;
  vf slope = (profile_at(v, r, high) - profile_at(v, r, l)) * inverse;
  vf square = (profile_square(v, r, high) - odd_of(low, profile_square(v, r, l))) * inverse;
  vf far = one - q->near;
  vf stretch = q->m.g[0] * q->m.g[0] + q->m.g[1] * q->m.g[1];
  vf spread = splat(0.5f) * stretch * vmax(square - slope * slope, splat(0.0f));
  *lost = mix(spread, splat(v->slope2), far);
  field h = field_through(q->m, mix(value, splat(v->mean), far), slope * q->near);
  if (v->chipping > 0.0f) {
    vf change = profile_widened(v, r, high) - odd_of(low, profile_widened(v, r, l));
    change = change * inverse * q->near;
    for (int k = 0; k < 3; k++) h.g[k] = h.g[k] + change * r->wide.g[k];
  }
  return h;
}

/* ---- how the stone lies ------------------------------------------------ */

INLINE field laid_lie(const stone_paving *v, const laid *q) {
  vf zero = splat(0.0f), one = splat(1.0f);
  field f = field_of(zero);
  if (v->tilt == 0.0f && v->settle == 0.0f && v->crown == 0.0f) return f;
  vu h = hash_mix(q->own ^ splatu(0x2c1b3c6du));
  const layout_unit *u = &q->unit;
  vf iu = splat(2.0f) / u->length, iv = splat(2.0f) / u->width;
  vf a = u->u * iu - one, b = u->v * iv - one;
  vf ta = splat(0.7f * v->tilt) * (laid_random(&h) * splat(2.0f) - one);
  vf tb = splat(0.7f * v->tilt) * (laid_random(&h) * splat(2.0f) - one);
  vf r = laid_random(&h), sunk = splat(v->settle) * r * r;
  vf da = ta, db = tb, value = ta * a + tb * b - sunk;
  if (v->crown != 0.0f) {
    /* a polygon may reach beyond its box: no crown there */
    vf k = splat(v->crown), ca = vmax(one - a * a, zero), cb = vmax(one - b * b, zero);
    value = value + k * ca * cb;
    da = da - sel(gt(ca, zero), splat(2.0f) * k * a * cb, zero);
    db = db - sel(gt(cb, zero), splat(2.0f) * k * b * ca, zero);
  }
  vf du = da * iu * q->near, dv = db * iv * q->near;
  f.v = mix(splat(-0.333f * v->settle + 0.444f * v->crown), value, q->near);
  laid_slope(q, du * u->c - dv * u->s, du * u->s + dv * u->c, f.g);
  return f;
}

#endif
