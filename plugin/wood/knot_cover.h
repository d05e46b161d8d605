/* SPDX-License-Identifier: Apache-2.0
 *
 * Which share of a footprint a knot has: of one up to twice KNOT_NEAR mm across by
 * the knots whose collar may reach it, up to twice KNOT_FAR by those that lie within
 * it, and beyond by a mean over cells of the log.
 */
#ifndef SOZAI_WOOD_KNOT_COVER_H
#define SOZAI_WOOD_KNOT_COVER_H

#include "../core/filter.h"
#include "knot_table.h"
#include "stem.h"

typedef struct {
  vf cover, bark, check;           /* shares of the footprint; a check is within its knot */
  vf near;                         /* 1: within reach of a knot */
  vf turn, turn_x, turn_y, turn_z; /* radians by which the fibres part; as rho's derivatives */
  vf inside;                       /* 1: the point is in a knot, and what follows is of it */
  vf a, h;                         /* mm in its section, moved apart from the stem's */
  vf along[3];                     /* its axis */
  vf out[3], round[3];             /* rows: from space to its section, radially and round */
} knot_place;

INLINE knot_place knot_none(void) {
  vf o = splat(0.0f);
  return (knot_place){.cover = o,
                      .bark = o,
                      .check = o,
                      .near = o,
                      .turn = o,
                      .turn_x = o,
                      .turn_y = o,
                      .turn_z = o,
                      .inside = o,
                      .a = o,
                      .h = o,
                      .along = {o, o, o},
                      .out = {o, o, o},
                      .round = {o, o, o}};
}

/* A point in the section of a knot; see knots.h. */
typedef struct {
  vf u, a, h, hx, hz; /* hx, hz: of h along x and z; along y it is the cosine */
  vf square, d, da, dh;
  vm grown, grown_wide; /* the knot is there; or within a wide footprint */
} knot_section;

INLINE knot_section knot_section_of(const wood_knots *all, const wood_knot *k, vf y,
                                    const stem_place *p) {
  knot_section o;
  vf kc = splat(k->c), ks = splat(k->s);
  o.u = p->x * kc + p->z * ks;
  o.a = p->z * kc - p->x * ks;
  vf away = y - splat(k->height);
  vi unused;
  vf turns = vfloor(away * splat(all->inverse_period) + splat(0.5f), &unused);
  away = away - splat(all->period) * turns;
  o.h = splat(k->cosine) * (away - splat(k->slope) * o.u);
  o.hx = splat(-k->cosine * k->slope * k->c);
  o.hz = splat(-k->cosine * k->slope * k->s);
  o.square = o.a * o.a + splat(k->squash) * o.h * o.h + splat(2.0f * k->lean) * o.a * o.h;
  vf inverse = inverse_root(vmax(o.square, splat(1e-6f)));
  o.d = o.square * inverse;
  o.da = (o.a + splat(k->lean) * o.h) * inverse;
  o.dh = (splat(k->squash) * o.h + splat(k->lean) * o.a) * inverse;
  o.grown = and_(gt(o.u, splat(0.0f)), lt(o.u, splat(k->reach)));
  o.grown_wide = and_(gt(o.u, splat(-KNOT_FAR)), lt(o.u, splat(k->reach + KNOT_FAR)));
  return o;
}

/* e when the stem had grown by the share tau: the inverse of K. */
INLINE vf knot_grown(const wood_knot *k, vf tau) {
  vf straight = splat(1.0f - k->q);
  return splat(2.0f) * tau / (straight + vsqrt(straight * straight + splat(4.0f * k->q) * tau));
}

/* Up to where it was left when it broke off: rounded, and aslant. */
typedef struct {
  vf end, by_d, by_a, by_h; /* rho, and its derivatives */
} knot_stub;

INLINE knot_stub knot_stub_of(const wood_knot *k, vf a, vf h, vf d) {
  vf zero = splat(0.0f), ca = splat(KNOT_SLANT * k->check_c), ch = splat(KNOT_SLANT * k->check_s);
  vf round = splat(KNOT_ROUND * k->inverse_radius) * d;
  return (knot_stub){splat(k->end) - round * d - ca * a - ch * h, zero - round - round, zero - ca,
                     zero - ch};
}

/* Length of row g within the surface. */
INLINE vf knot_extent(const vf g[3], const vf n[3], int ball) {
  vf square = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
  if (!ball) {
    vf gn = g[0] * n[0] + g[1] * n[1] + g[2] * n[2];
    square = vmax(square - gn * gn, splat(0.0f));
  }
  return vsqrt(square);
}

/* Share of -e/2 .. e/2 about x that is within -half .. half. */
INLINE vf knot_overlap(vf x, vf half, vf e) {
  vf low = vmax(x - splat(0.5f) * e, splat(0.0f) - half), high = vmin(x + splat(0.5f) * e, half);
  return clamp01((high - low) / e);
}

/* The footprint over a knot's section. */
typedef struct {
  vf a, h, d, wa, wh, wd; /* mm; w: how far the footprint reaches along each */
  vf radius;              /* mm, there */
} knot_window;

/* Share of it within `more` mm of the knot: while it is small by the distance
 * from the knot's edge, and when it is large by a square of the same area. */
INLINE vf knot_share(const knot_window *q, vf more) {
  vf edge = clamp01(splat(0.5f) - (q->d - q->radius - more) / q->wd);
  vf large = smooth_step(splat(0.6f), splat(1.2f), q->wd / q->radius);
  if (!any(gt(large, splat(0.0f)))) return edge;
  vf half = splat(0.8862f) * (q->radius + more);
  vf part = knot_overlap(q->a, half, q->wa) * knot_overlap(q->h, half, q->wh);
  return sel(gt(large, splat(0.0f)), mix(edge, part, large), edge);
}

INLINE vf knot_union(vf a, vf b) { return a + b - a * b; }

/* Of one knot, where `near`, weighed. rho: the stem's. */
INLINE void knot_see(const wood_knots *all, const wood_knot *k, const knot_section *o, vf rho, vf s,
                     const vf n[3], int ball, vf weight, vm near, knot_place *out) {
  vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f), dead = splat(k->death);
  vf kc = splat(k->c), ks = splat(k->s);
  vf row_u[3] = {kc, zero, ks}, row_a[3] = {zero - ks, zero, kc};
  vf row_h[3] = {o->hx, splat(k->cosine), o->hz}, row_d[3];
  for (int c = 0; c < 3; c++) row_d[c] = o->da * row_a[c] + o->dh * row_h[c];

  /* the part of the footprint along the knot in which there is one; its middle */
  vf wu = vmax(s * knot_extent(row_u, n, ball), splat(0.2f));
  vf end = knot_stub_of(k, o->a, o->h, vmin(o->d, splat(k->radius))).end;
  vf low = vmax(splat(-0.5f) * wu, zero - o->u);
  vf high = vmin(vmin(half * wu, end - rho), splat(k->reach) - o->u);
  vf along = clamp01((high - low) / wu), there = rho + half * (low + high);
  vf front = vmin(there, dead);
  vf tau = vmax(front - splat(k->born), splat(0.05f)) * splat(k->inverse_length);
  knot_window q = {.a = o->a, .h = o->h, .d = o->d};
  q.radius = vmax(splat(k->radius) * knot_grown(k, tau), splat(0.05f));
  q.wd = vmax(s * knot_extent(row_d, n, ball), splat(0.08f));
  q.wa = vmax(s * knot_extent(row_a, n, ball), splat(0.08f));
  q.wh = vmax(s * knot_extent(row_h, n, ball), splat(0.08f));
  weight = sel(near, weight, zero);
  vf seen = along * weight, share = knot_share(&q, zero) * seen, radius = q.radius;
  vf shell = splat(all->bark) * clamp01((there - dead) * splat(0.3f)), skin = zero;
  if (any(gt(shell, zero))) {
    skin = vmax(knot_share(&q, shell) * seen - share, zero);
    /* and over the end of what is left of it */
    vf past = vabs(rho - end - half * shell), e = wu + splat(0.2f);
    vf cap = clamp01(half - (past - half * shell) / e) * vmin(shell / e, one) * weight;
    q.radius = splat(k->radius);
    skin = vmax(skin, cap * knot_share(&q, zero));
  }
  /* a dry branch has split across its pith, most in the middle */
  if (all->check > 0.0f) {
    vf cc = splat(k->check_c), cs = splat(k->check_s), line = o->a * cc + o->h * cs, row[3];
    for (int c = 0; c < 3; c++) row[c] = cc * row_a[c] + cs * row_h[c];
    vf from = vmax(one - o->square / (splat(0.77f) * radius * radius), zero);
    vf gap = splat(all->check) * radius * from * sel(lt(rho, dead), half, one);
    vf split = knot_overlap(line, half * gap, vmax(s * knot_extent(row, n, ball), splat(0.04f)));
    out->check = vmax(out->check, split * share);
  }
  out->cover = knot_union(out->cover, share);
  out->bark = vmax(out->bark, skin);
}

/* Share of knots in a cell of the level's, between those about the point. */
INLINE vf knots_in_cells(const wood_knots *all, vi level, vf x, vf turns, vf z) {
  vi nx = gatheri(all->far_across, level), ny = gatheri(all->far_tall, level);
  vf inverse = splat(all->inverse_cell) * gather(all->far_scale, level), half = splat(0.5f);
  vi ix, iy, iz;
  vf fx = (x - splat(all->low)) * inverse - half, fz = (z - splat(all->low)) * inverse - half;
  vf fy = turns * to_float(ny) - half;
  vf most = to_float(nx);
  fx = clamp(fx, splat(-1.0f), most);
  fz = clamp(fz, splat(-1.0f), most);
  fx = fx - vfloor(fx, &ix);
  fy = fy - vfloor(fy, &iy);
  fz = fz - vfloor(fz, &iz);
  vf sum = splat(0.0f);
  for (int k = 0; k < 8; k++) {
    vi cx = ix + splati(k & 1), cy = iy + splati(k >> 1 & 1), cz = iz + splati(k >> 2);
    vf weight = (k & 1 ? fx : splat(1.0f) - fx) * (k >> 1 & 1 ? fy : splat(1.0f) - fy) *
                (k >> 2 ? fz : splat(1.0f) - fz);
    cy = seli(lti(cy, splati(0)), cy + ny, cy);
    cy = seli(lti(cy, ny), cy, cy - ny);
    vm within = and_(lti(splati(-1), cx), lti(cx, nx));
    within = and_(within, and_(lti(splati(-1), cz), lti(cz, nx)));
    vi at = gatheri(all->far_first, level) + (cy * nx + cz) * nx + cx;
    sum = sum + weight * sel(within, gather(all->far, seli(within, at, splati(0))), splat(0.0f));
  }
  return sum;
}

/* What a footprint wider than single knots sees of them. */
INLINE vf knots_far(const wood_knots *all, vf x, vf turns, vf z, vf s) {
  vf level = log2_(vmax(s * splat(0.7f * all->inverse_cell), splat(1.0f)));
  vi low;
  level = vmin(level, splat(KNOT_LEVELS - 1.0f));
  vf part = level - vfloor(level, &low);
  vi high = seli(lti(low, splati(KNOT_LEVELS - 1)), low + splati(1), low);
  return mix(knots_in_cells(all, low, x, turns, z), knots_in_cells(all, high, x, turns, z), part);
}

#endif
