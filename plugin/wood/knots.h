/* SPDX-License-Identifier: Apache-2.0
 *
 * Knots: branches that the stem grew round.
 *
 * A knot's axis leaves the pith in a direction (c, s) and rises with a slope.
 * About it stand, in the square section of the branch,
 *   u   mm along that direction, a mm to the side of it, h mm above the axis
 *   d   sqrt of a quadratic form of (a, h): the distance, a little oblong
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

#include "../core/filter.h"
#include "knot_table.h"
#include "stem.h"

typedef struct {
  vf cover, bark, check;             /* shares of the footprint; a check is within its knot */
  vf turn, turn_x, turn_y, turn_z;   /* radians by which the fibres part; as rho's derivatives */
  vf inside;                         /* 1: the point is in a knot, and what follows is of it */
  vf a, h;                           /* mm in its section, moved apart from the stem's */
  vf along[3];                       /* its axis */
  vf out[3], round[3];               /* rows: from space to its section, radially and round */
} knot_place;

INLINE knot_place knot_none(void) {
  vf o = splat(0.0f);
  return (knot_place){.cover = o, .bark = o, .check = o, .turn = o, .turn_x = o, .turn_y = o,
                      .turn_z = o, .inside = o, .a = o, .h = o, .along = {o, o, o},
                      .out = {o, o, o}, .round = {o, o, o}};
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
  vf a, h, d, beyond;  /* mm; beyond: to the outside of the knot's surface */
  vf wa, wh, wd;       /* mm: how far the footprint reaches along each */
  vf radius;           /* mm, there */
} knot_window;

/* Share of it within `more` mm of the knot: while it is small by the distance
 * from the knot's edge, and when it is large by a square of the same area. */
INLINE vf knot_share(const knot_window *q, vf more) {
  vf edge = clamp01(splat(0.5f) - (q->beyond - more) / q->wd);
  vf large = smooth_step(splat(0.6f), splat(1.2f), q->wd / q->radius);
  if (!any(gt(large, splat(0.0f)))) return edge;
  vf half = splat(0.8862f) * (q->radius + more);
  vf part = knot_overlap(q->a, half, q->wa) * knot_overlap(q->h, half, q->wh);
  return sel(gt(large, splat(0.0f)), mix(edge, part, large), edge);
}

/* One of them. */
INLINE void knot_add(const wood_knots *all, const wood_knot *k, vf y,
                     vf s, const vf n[3], int ball, stem_place *p, knot_place *out) {
  vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f), two = splat(2.0f);
  vf kc = splat(k->c), ks = splat(k->s), cosine = splat(k->cosine);
  vf u = p->x * kc + p->z * ks, a = p->z * kc - p->x * ks;
  vf away = y - splat(k->height);
  vi unused;
  away = away - splat(all->period) * vfloor(away * splat(all->inverse_period) + half, &unused);
  vf h = cosine * (away - splat(k->slope) * u);
  vf hx = splat(-k->cosine * k->slope * k->c), hz = splat(-k->cosine * k->slope * k->s);

  /* the section */
  vf square = a * a + splat(k->squash) * h * h + splat(2.0f * k->lean) * a * h;
  vm grown = and_(gt(u, zero), lt(u, splat(k->reach)));
  vm near = and_(grown, lt(square, splat(k->farthest * k->farthest)));
  if (!any(near)) return;
  vf inverse_d = inverse_root(vmax(square, splat(1e-6f))), d = square * inverse_d;
  vf da = (a + splat(k->lean) * h) * inverse_d;
  vf dh = (splat(k->squash) * h + splat(k->lean) * a) * inverse_d;

  /* the branch's front, and its radius, when the stem's was here */
  vf rho = p->rho, born = splat(k->born), dead = splat(k->death);
  vm alive = lt(rho, dead);
  vf lives = sel(alive, one, zero), front = vmin(rho, dead), q = splat(k->q);
  vf e = d * splat(k->inverse_radius), straight = splat(1.0f - k->q);
  vf own = born + splat(k->length) * e * (straight + q * e);
  vf own_d = splat(k->length * k->inverse_radius) * (straight + two * q * e);
  vf since = vmax(front - born, splat(0.05f)), tau = since * splat(k->inverse_length);
  vf now = two * tau / (straight + vsqrt(straight * straight + splat(4.0f * k->q) * tau));
  vf radius = splat(k->radius) * now;
  vf radius_rho = lives * splat(k->radius * k->inverse_length) / (straight + two * q * now);

  /* after its death, and after it fell */
  vf relax = splat(0.6f * k->inverse_radius), after = vmax(rho - dead, zero) * relax;
  vf fade = one / (one + after * after), fade_rho = zero - two * after * relax * fade * fade;
  vm gone = lt(splat(k->end), rho), there = and_(near, not_(gone));
  vf keep = one - smooth_step(splat(2.0f * k->radius), splat(6.0f * k->radius), s);

  /* the collar, deeper above and below than at the sides */
  vf n2 = vmax(a * a + h * h, splat(1e-6f)), inverse_n2 = one / n2;
  vf upright = h * h * inverse_n2, steep = two * a * h * inverse_n2 * inverse_n2;
  vf wide = splat(KNOT_WIDE) + splat(KNOT_WIDE_RISING) * upright, inverse_wide = one / wide;
  vf high = splat(k->high) + splat(k->high_rising) * upright;
  vf x = front - own, inverse_radius = one / vmax(radius, splat(1e-3f));
  vm in = and_(there, gt(x, zero));
  vf m = vmax(d * inverse_radius - one, zero) * inverse_wide, v = vmax(one - m, zero);
  vf v2 = v * v, v3 = v2 * v, hill = high * radius * v3 * keep;
  vf falls = splat(3.0f) * high * v2 * inverse_wide * keep; /* -d hill / d d */
  falls = sel(gt(m, zero), falls, zero);
  vf hill_radius = high * v3 * keep + falls * d * inverse_radius;
  vf hill_g = radius * (splat(k->high_rising) * v3 * keep + falls * splat(KNOT_WIDE_RISING) * m);
  vf new_rho = sel(in, own - high * d, rho - fade * hill);
  vf by_rho = sel(in, zero, one - fade * hill_radius * radius_rho - fade_rho * hill);
  vf by_d = sel(in, own_d - high, fade * falls);
  vf by_g = zero - sel(in, splat(k->high_rising) * d, fade * hill_g);

  /* the scar closes */
  vf fresh = clamp01(one - (rho - splat(k->end)) * splat(0.5f * k->inverse_radius));
  vf within = vmax(one - e * e, zero), dent = splat(0.4f * k->radius) * keep;
  vm scar = and_(near, and_(gone, gt(within, zero)));
  if (any(scar)) {
    vf closing = within * within * fresh * fresh;
    new_rho = sel(scar, new_rho + dent * closing, new_rho);
    vf less = dent * within * within * fresh * splat(k->inverse_radius);
    by_rho = sel(scar, by_rho - less, by_rho);
    vf inward = splat(-4.0f) * dent * within * e * splat(k->inverse_radius) * fresh * fresh;
    by_d = sel(scar, by_d + inward, by_d);
  }

  vf by_a = by_d * da - by_g * steep * h, by_h = by_d * dh + by_g * steep * a;
  vm touched = and_(near, or_(or_(in, scar), gt(v, zero)));

  /* the fibres part */
  vf inverse_r2 = one / vmax(radius * radius, splat(1e-4f));
  vf t = (a * a + splat(1.0f / (KNOT_STREAM * KNOT_STREAM)) * h * h) * inverse_r2;
  vf window = vmax(one - t * splat(1.0f / KNOT_WINDOW), zero);
  vm parting = and_(near, gt(window, zero));
  if (any(parting)) {
    vf f = inverse_root(one + t * t), whole = f * window * window;
    vf slope = zero - t * f * f * f * window * window - splat(2.0f / KNOT_WINDOW) * f * window;
    vf g = splat(all->grain) * fade * keep * p->inverse_r, shift = zero - g * a * whole;
    vf t_radius = zero - two * t * radius * inverse_r2;
    vf turn_a = zero - g * (whole + a * slope * two * a * inverse_r2);
    vf turn_h =
        zero - g * a * slope * splat(2.0f / (KNOT_STREAM * KNOT_STREAM)) * h * inverse_r2;
    vf turn_rho = zero - g * a * slope * t_radius * radius_rho -
                  splat(all->grain) * fade_rho * keep * p->inverse_r * a * whole;
    vf spread = zero - shift * p->inverse_r;
    vf tx = turn_h * hx - turn_a * ks + turn_rho * p->rho_x + spread * p->c;
    vf tz = turn_h * hz + turn_a * kc + turn_rho * p->rho_z + spread * p->s;
    vf ty = turn_h * cosine + turn_rho * p->rho_y;
    out->turn = out->turn + sel(parting, shift, zero);
    out->turn_x = out->turn_x + sel(parting, tx, zero);
    out->turn_y = out->turn_y + sel(parting, ty, zero);
    out->turn_z = out->turn_z + sel(parting, tz, zero);
  }

  /* how much of it the footprint sees */
  vf row_a[3] = {zero - ks, zero, kc}, row_h[3] = {hx, cosine, hz}, row_d[3];
  for (int c = 0; c < 3; c++) row_d[c] = da * row_a[c] + dh * row_h[c];
  knot_window q_ = {a, h, d, (zero - x) / own_d, s, s, s, vmax(radius, splat(0.05f))};
  q_.beyond = sel(alive, q_.beyond, d - splat(k->radius));
  q_.wd = vmax(s * knot_extent(row_d, n, ball), splat(0.08f));
  q_.wa = vmax(s * knot_extent(row_a, n, ball), splat(0.08f));
  q_.wh = vmax(s * knot_extent(row_h, n, ball), splat(0.08f));
  vf close = one - smooth_step(splat(KNOT_NEAR), splat(2.0f * KNOT_NEAR), s);
  vf ends = clamp01(half - (rho - splat(k->end)) / (s + splat(0.2f)));
  vf share = sel(near, knot_share(&q_, zero) * ends * close, zero);
  vf shell = splat(all->bark) * clamp01((rho - dead) * splat(0.3f));
  vf skin = zero;
  if (any(gt(shell, zero))) {
    vf with = sel(near, knot_share(&q_, shell) * ends * close, zero);
    skin = vmax(with - share, zero);
    /* and over the end of what is left of it */
    vf past = vabs(rho - splat(k->end) - half * shell);
    vf cap = clamp01(half - (past - half * shell) / (s + splat(0.2f))) * close;
    vf face = clamp01(half - (d - splat(k->radius)) / q_.wd);
    skin = vmax(skin, sel(near, cap * face * vmin(shell / (s + splat(0.2f)), one), zero));
  }
  /* a dry branch has split across its pith, most in the middle */
  if (all->check > 0.0f) {
    vf cc = splat(k->check_c), cs = splat(k->check_s), line = a * cc + h * cs, row[3];
    for (int c = 0; c < 3; c++) row[c] = cc * row_a[c] + cs * row_h[c];
    vf from = vmax(one - square * splat(1.3f * k->inverse_radius * k->inverse_radius), zero);
    vf gap = splat(all->check * k->radius) * from * sel(alive, half, one);
    vf e = vmax(s * knot_extent(row, n, ball), splat(0.04f));
    vf low = vmax(line - half * e, zero - half * gap), high_ = vmin(line + half * e, half * gap);
    vf split = clamp01((high_ - low) / e) * close;
    out->check = vmax(out->check, sel(in, split, zero));
  }
  out->cover = vmax(out->cover, share);
  out->bark = vmax(out->bark, skin);

  /* in it, its section is the reference */
  if (any(in)) {
    vf far = splat(k->apart);
    out->inside = sel(in, one, out->inside);
    out->a = sel(in, a + far, out->a);
    out->h = sel(in, h - far, out->h);
    vf along[3] = {kc, splat(k->slope), ks};
    for (int c = 0; c < 3; c++) {
      out->along[c] = sel(in, along[c] * cosine, out->along[c]);
      out->out[c] = sel(in, row_d[c], out->out[c]);
      out->round[c] = sel(in, da * row_h[c] - dh * row_a[c], out->round[c]);
    }
  }

  p->rho = sel(touched, vmax(new_rho, zero), p->rho);
  vf nx = by_rho * p->rho_x - by_a * ks + by_h * hx;
  vf ny = by_rho * p->rho_y + by_h * cosine;
  vf nz = by_rho * p->rho_z + by_a * kc + by_h * hz;
  p->rho_x = sel(touched, nx, p->rho_x);
  p->rho_y = sel(touched, ny, p->rho_y);
  p->rho_z = sel(touched, nz, p->rho_z);
}

INLINE int32_t knot_least(vi x) {
  int32_t lanes[LANES], least;
  memcpy(lanes, &x, sizeof lanes);
  least = lanes[0];
  for (int i = 1; i < LANES; i++) least = lanes[i] < least ? lanes[i] : least;
  return least;
}

/* The list of a cell, ended by what is larger than any number. */
INLINE vi knot_next(const wood_knots *all, vi at, vi end) {
  vi found = gatheri(all->index, at);
  return seli(lti(at, end), found, splati(INT32_MAX));
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

/* All that are near, in their order. shift: of the board's log, in turns of the
 * period. */
INLINE void knots_add(const wood_knots *all, vf shift, vf y, vf s, const vf n[3], int ball,
                      stem_place *p, knot_place *out) {
  vf zero = splat(0.0f), turns = y * splat(all->inverse_period) + shift;
  vi whole, ix, iy, iz;
  *out = knot_none();
  turns = turns - vfloor(turns, &whole);
  vf fx = (p->x - splat(all->low)) * splat(all->inverse_cell);
  vf fz = (p->z - splat(all->low)) * splat(all->inverse_cell);
  vf most = splat((float)all->across);
  vm within = and_(and_(le(zero, fx), lt(fx, most)), and_(le(zero, fz), lt(fz, most)));
  vfloor(sel(within, fx, zero), &ix);
  vfloor(sel(within, fz, zero), &iz);
  vfloor(turns * splat((float)all->tall), &iy);
  iy = seli(lti(iy, splati(all->tall)), iy, splati(all->tall - 1));
  vi cell = (iy * splati(all->across) + iz) * splati(all->across) + ix;
  cell = seli(within, cell, splati(all->cells));
  vi at = gatheri(all->first, cell), end = gatheri(all->first, cell + splati(1));
  vf px = p->x, pz = p->z;
  if (any(lti(at, end))) {
    vf height = y + shift * splat(all->period);
    vi next = knot_next(all, at, end);
    for (int32_t m = knot_least(next); m != INT32_MAX; m = knot_least(next)) {
      knot_add(all, &all->list[m], height, s, n, ball, p, out);
      at = at + seli(eqi(next, splati(m)), splati(1), splati(0));
      next = knot_next(all, at, end);
    }
  }
  vf wide = smooth_step(splat(KNOT_NEAR), splat(2.0f * KNOT_NEAR), s);
  if (any(gt(wide, zero))) {
    out->cover = out->cover + sel(gt(wide, zero), wide * knots_far(all, px, turns, pz, s), zero);
  }
}

#endif
