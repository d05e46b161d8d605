/* SPDX-License-Identifier: Apache-2.0
 *
 * Which share of a footprint a knot has: of one up to twice KNOT_NEAR mm across by
 * the knots whose collar may reach it, up to twice KNOT_FAR by those that lie within
 * it, and beyond by a mean over cells of the log.
 *
 * A footprint that is narrow beside the knot sees a straight edge. A wide one is cut
 * into chords: the knot is a cone, of which any line across it sees a stretch that
 * is known exactly, and the lines that see any of it are known too.
 */
#ifndef SOZAI_WOOD_KNOT_COVER_H
#define SOZAI_WOOD_KNOT_COVER_H

#include "../core/filter.h"
#include "knot_table.h"
#include "stem.h"

typedef struct {
  vf late, nodes;                  /* the stem's latewood by nodes over the footprint; how far so */
  vf own;                          /* its own latewood */
  vf cover, bark, check;           /* shares of the footprint; a check is within its knot */
  vf halo;                         /* 0..1: resin in the wood about it, and in the knot wholly */
  vf heart;                        /* cover times 1 at its pith to 0 at its edge, and its tone */
  vf near;                         /* 1: within reach of a knot */
  vf turn, turn_x, turn_y, turn_z; /* radians by which the fibres part; as rho's derivatives */
  vf inside;                       /* 1: the point is in a knot, and what follows is of it */
  vf a, h;                         /* mm in its section, moved apart from the stem's */
  vf along[3];                     /* its axis */
  vf out[3], round[3];             /* rows: from space to its section, radially and round */
} knot_place;

INLINE knot_place knot_none(void) {
  vf o = splat(0.0f);
  return (knot_place){.late = o,
                      .nodes = o,
                      .own = o,
                      .cover = o,
                      .bark = o,
                      .check = o,
                      .halo = o,
                      .heart = o,
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
  vf u, a, h, hx, hz;            /* hx, hz: of h along x and z; along y it is the cosine */
  vf square, inverse, d, da, dh; /* square: of p, and 1 / p */
  vm grown, grown_wide;          /* the knot is there; or within a wide footprint */
} knot_section;

INLINE knot_section knot_section_at(const wood_knots *all, const wood_knot *k, vf y,
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
  o.square = o.a * o.a + splat(k->squash) * o.h * o.h + splat(2.0f * k->lean) * o.a * o.h;
  o.grown = and_(gt(o.u, splat(0.0f)), lt(o.u, splat(k->reach)));
  o.grown_wide = and_(gt(o.u, splat(-KNOT_FAR)), lt(o.u, splat(k->reach + KNOT_FAR)));
  return o;
}

/* What not all have need of. */
INLINE void knot_section_slopes(const wood_knot *k, knot_section *o) {
  o->hx = splat(-k->cosine * k->slope * k->c);
  o->hz = splat(-k->cosine * k->slope * k->s);
  vf inverse = inverse_root(vmax(o->square, splat(1e-6f)));
  vf pa = splat(k->pith_a), ph = splat(k->pith_h);
  o->inverse = inverse;
  o->d = o->square * inverse + pa * o->a + ph * o->h;
  o->da = (o->a + splat(k->lean) * o->h) * inverse + pa;
  o->dh = (splat(k->squash) * o->h + splat(k->lean) * o->a) * inverse + ph;
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

/* A footprint over a knot: a square of side s on the surface, its sides along t, where
 * the surface runs along the knot's axis as steeply as it does, and v across it.
 * The section is stretched so that the knot is round. */
typedef struct {
  vf u, x, y;        /* mm, of its middle: along the axis; in the section */
  vf along;          /* mm that the axis runs from one end of t to the other */
  vf xt, yt, xv, yv; /* likewise, in the section, along t and along v */
} knot_window;

INLINE knot_window knot_window_of(const wood_knot *k, const knot_section *o, const vf n[3],
                                  int ball, vf s) {
  knot_window q;
  vf zero = splat(0.0f), kc = splat(k->c), ks = splat(k->s), lean = splat(k->lean), t[3], v[3];
  vf tall = splat(k->upright);
  q.u = o->u;
  q.x = o->a + lean * o->h;
  q.y = tall * o->h;
  /* a ball's section is the knot's own */
  vf face[3] = {kc, zero, ks};
  if (!ball) {
    for (int c = 0; c < 3; c++) face[c] = n[c];
  }
  /* t: the axis within the surface; where the surface is square to it, any */
  vf square = kc * face[0] + ks * face[2];
  t[0] = kc - square * face[0];
  t[1] = zero - square * face[1];
  t[2] = ks - square * face[2];
  vf runs = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
  vm none = lt(runs, splat(1e-4f));
  t[0] = sel(none, zero - face[2], t[0]);
  t[1] = sel(none, zero, t[1]);
  t[2] = sel(none, face[0], t[2]);
  runs = sel(none, face[0] * face[0] + face[2] * face[2], runs);
  vf unit = inverse_root(vmax(runs, splat(1e-6f)));
  for (int c = 0; c < 3; c++) t[c] = t[c] * unit;
  for (int c = 0; c < 3; c++) {
    v[c] = face[(c + 1) % 3] * t[(c + 2) % 3] - face[(c + 2) % 3] * t[(c + 1) % 3];
  }
  q.along = ball ? s : s * vabs(t[0] * kc + t[2] * ks);
  q.along = vmax(q.along, splat(0.2f));
  vf at = t[2] * kc - t[0] * ks, av = v[2] * kc - v[0] * ks;
  vf ht = o->hx * t[0] + splat(k->cosine) * t[1] + o->hz * t[2];
  vf hv = o->hx * v[0] + splat(k->cosine) * v[1] + o->hz * v[2];
  q.xt = s * (at + lean * ht);
  q.yt = s * tall * ht;
  q.xv = s * (av + lean * hv);
  q.yv = s * tall * hv;
  return q;
}

/* mm of d that the footprint has across the knot's edge, where it lies in the
 * direction of the footprint's middle. */
INLINE vf knot_edge_width(const wood_knot *k, const knot_window *q, vf inverse) {
  vf dx = q->x * inverse + splat(k->pith_x), dy = q->y * inverse + splat(k->pith_y);
  vf t = dx * q->xt + dy * q->yt, v = dx * q->xv + dy * q->yv;
  return vsqrt(t * t + v * v);
}

/* Likewise of rho less that of the knot's end. */
INLINE vf knot_end_width(const wood_knot *k, const knot_window *q, const knot_section *o,
                         const knot_stub *stub) {
  vf dx = q->x * o->inverse + splat(k->pith_x), dy = q->y * o->inverse + splat(k->pith_y);
  vf tall = splat(1.0f / k->upright), lean = splat(k->lean), ht = q->yt * tall, hv = q->yv * tall;
  vf t =
      stub->by_d * (dx * q->xt + dy * q->yt) + stub->by_a * (q->xt - lean * ht) + stub->by_h * ht;
  vf v =
      stub->by_d * (dx * q->xv + dy * q->yv) + stub->by_a * (q->xv - lean * hv) + stub->by_h * hv;
  t = q->along - t;
  return vmax(vsqrt(t * t + v * v), splat(0.2f));
}

/* The branch's radius when the stem's was rho, and the bark about it. */
INLINE vf knot_radius_at(const wood_knot *k, vf rho) {
  vf tau = vmax(vmin(rho, splat(k->death)) - splat(k->born), splat(0.05f));
  return vmax(splat(k->radius) * knot_grown(k, tau * splat(k->inverse_length)), splat(0.05f));
}

INLINE vf knot_bark_at(const wood_knots *all, const wood_knot *k, vf rho) {
  return splat(all->bark) * clamp01((rho - splat(k->death)) * splat(0.3f));
}

typedef struct {
  vf knot, bark, halo;
} knot_shares;

/* A line along v, in halves of the footprint: how far the section's pith is from it,
 * and where along it; both shift with the size of the ring that it cuts. */
typedef struct {
  vf x, at, inverse;
  vf across, down; /* of a ring's middle, over d */
} knot_line;

/* Of it within d. */
INLINE vf knot_chord(const wood_knot *k, const knot_line *l, vf d) {
  vf zero = splat(0.0f), half = splat(0.5f);
  vf x = l->x - l->across * d, middle = l->at + l->down * d, r = splat(k->round) * d;
  vf chord = vsqrt(vmax(r * r - x * x, zero)) * l->inverse;
  return vmax(vmin(middle + chord, half) - vmax(middle - chord, zero - half), zero);
}

/* Of the square: chords along v are exact, and t is gone through by Gauss and
 * Legendre's rule over the part of it that meets the knot, and over that which meets its
 * halo. scale: of rho over u; end: rho of it here, and over how much of rho. */
INLINE knot_shares knot_chords(const wood_knots *all, const wood_knot *k, const knot_window *q,
                               vf scale, vf end, vf ends_over, vf edge) {
  static const float node[4] = {-0.8611363f, -0.3399810f, 0.3399810f, 0.8611363f};
  static const float weight[4] = {0.1739274f, 0.3260726f, 0.3260726f, 0.1739274f};
  vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f);
  vf v2 = vmax(q->xv * q->xv + q->yv * q->yv, splat(1e-9f)), inverse = inverse_root(v2);
  vf x0 = (q->x * q->yv - q->y * q->xv) * inverse, x1 = (q->xt * q->yv - q->yt * q->xv) * inverse;
  vf mx = splat(k->middle_x), my = splat(k->middle_y);
  knot_line line = {.inverse = inverse,
                    .across = (mx * q->yv - my * q->xv) * inverse,
                    .down = (mx * q->xv + my * q->yv) * inverse * inverse};
  vf inverse_along = one / q->along, inverse_scale = one / scale;
  /* the end is rounded, and aslant: its mean, the wider the footprint the more nearly that
   * of all of it; and over what length, where it is not cut along */
  vf whole = smooth_step(splat(0.8f * k->radius), splat(2.0f * k->radius), edge);
  vf aslant = splat(KNOT_ASLANT * k->radius);
  vf left = mix(end, splat(k->end - 0.5f * KNOT_ROUND * k->radius), whole);
  vf ends = vmin(left * inverse_scale, splat(k->reach));
  aslant = mix(vmin(ends_over, aslant), aslant, whole);
  aslant = vmax(aslant * clamp01(splat(2.0f) - q->along / aslant), splat(1e-3f));
  vf inverse_aslant = one / aslant, over = ends + half * aslant;
  vf first = clamp((zero - q->u) * inverse_along, zero - half, half);
  vf final = clamp((over - q->u) * inverse_along, first, half);
  vf last = scale * (q->u + q->along * final), thick = knot_bark_at(all, k, last);
  vf widest = knot_radius_at(k, last), cap = thick * inverse_scale;
  x1 = sel(lt(vabs(x1), splat(1e-4f)), splat(1e-4f), x1);
  vf across = one / x1, middle = zero - x0 * across, size = vabs(across);
  vf drift = line.across * across;
  knot_shares sum = {zero, zero, zero};
  /* 0: knot and bark; 1: the halo; 2: bark over the end */
  for (int part = 0; part < 3; part++) {
    vf d = part == 0 ? widest + thick : part == 1 ? splat(KNOT_HALO_FAR) * widest : widest;
    vf from = first, to = final;
    if (part == 2) {
      if (!any(lt(zero, cap))) continue;
      from = clamp((over - aslant - q->u) * inverse_along, zero - half, half);
      to = clamp((over + cap - q->u) * inverse_along, from, half);
    }
    /* rings shrink to the pith: what is between holds all of them */
    vf reach = splat(k->round) * d * size, aside = drift * d;
    vf low = vmax(from, middle + vmin(aside, zero) - reach);
    vf high = vmax(vmin(to, middle + vmax(aside, zero) + reach), low);
    for (int i = 0; i < 4; i++) {
      vf t = half * (low + high) + splat(0.5f * node[i]) * (high - low);
      vf u = q->u + q->along * t, there = scale * u, r = knot_radius_at(k, there);
      vf px = q->x + q->xt * t, py = q->y + q->yt * t, share = splat(weight[i]) * (high - low);
      vf stands = clamp01((over - u) * inverse_aslant);
      vf covered = clamp01((over + cap - u) * inverse_aslant) - stands;
      share = share * (part == 2 ? covered : stands);
      line.x = x0 + x1 * t;
      line.at = zero - (px * q->xv + py * q->yv) * inverse * inverse;
      if (part == 1) {
        vf near = knot_chord(k, &line, splat(KNOT_HALO_NEAR) * r);
        vf far = knot_chord(k, &line, splat(KNOT_HALO_FAR) * r);
        sum.halo = sum.halo + share * mix(far, near, splat(KNOT_HALO_OF_NEAR));
        continue;
      }
      vf in = knot_chord(k, &line, r);
      if (part == 2) {
        sum.bark = sum.bark + share * in;
        continue;
      }
      vf both = knot_chord(k, &line, r + knot_bark_at(all, k, there));
      sum.knot = sum.knot + share * in;
      sum.bark = sum.bark + share * vmax(both - in, zero);
    }
  }
  return sum;
}

/* Integral of the halo from the pith to d. */
INLINE vf knot_halo_to(vf d, vf radius) {
  vf wide = splat(KNOT_HALO) * radius, left = splat(1.0f) - clamp01((d - radius) / wide);
  return vmin(d, radius) + wide * splat(1.0f / 3.0f) * (splat(1.0f) - left * left * left);
}

/* Share of -e/2 .. e/2 about x that is within -half .. half. */
INLINE vf knot_overlap(vf x, vf half, vf e) {
  vf low = vmax(x - splat(0.5f) * e, splat(0.0f) - half), high = vmin(x + splat(0.5f) * e, half);
  return clamp01((high - low) / e);
}

INLINE vf knot_union(vf a, vf b) { return a + b - a * b; }

/* Share of a check at `line` mm across it; dx, dy: its direction across in the section. */
INLINE vf knot_split(const wood_knot *k, const knot_window *q, float c, float s, vf line, vf gap) {
  vf inverse_tall = splat(1.0f / k->upright), lean = splat(k->lean), cc = splat(c), cs = splat(s);
  vf ht = q->yt * inverse_tall, hv = q->yv * inverse_tall;
  vf across_t = cc * (q->xt - lean * ht) + cs * ht, across_v = cc * (q->xv - lean * hv) + cs * hv;
  vf e = vmax(vsqrt(across_t * across_t + across_v * across_v), splat(0.04f));
  return knot_overlap(line, splat(0.5f) * gap, e);
}

/* A dry branch has split across its pith, most in the middle, and from there to one
 * side, most on the way. */
INLINE vf knot_checked(const wood_knots *all, const wood_knot *k, const knot_section *o,
                       const knot_window *q, vf rho, vf radius) {
  vf zero = splat(0.0f), one = splat(1.0f), far = o->d / radius;
  vf width = splat(all->check) * radius * sel(lt(rho, splat(k->death)), splat(0.5f), one);
  vf from = vmax(one - o->square / (splat(0.77f) * radius * radius), zero);
  vf line = o->a * splat(k->check_c) + o->h * splat(k->check_s);
  vf first = knot_split(k, q, k->check_c, k->check_s, line, width * from);
  vf side = o->h * splat(k->split_c) - o->a * splat(k->split_s);
  vf line2 = o->a * splat(k->split_c) + o->h * splat(k->split_s);
  vf on = vmax(one - far * far, zero) * vmin(far * splat(3.0f), one);
  on = sel(lt(zero, side), on, zero);
  return vmax(first, knot_split(k, q, k->split_c, k->split_s, line2, splat(0.7f) * width * on));
}

/* Of one knot, where `near`, weighed. rho: the stem's. */
INLINE void knot_see(const wood_knots *all, const wood_knot *k, const knot_section *o, vf rho,
                     vf inverse_r, vf s, const vf n[3], int ball, vf weight, vm near,
                     knot_place *out) {
  vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f);
  knot_window q = knot_window_of(k, o, n, ball, s);
  vf scale = clamp(rho * inverse_r, half, splat(2.0f));
  weight = sel(near, weight, zero);
  /* on the pith's other side, the front's radius along this knot is below zero */
  rho = rho + scale * (o->u - vabs(o->u));

  /* the part of the footprint along the knot in which there is one; its middle */
  vf inwards = vmin(splat(k->radius) / vmax(o->d, splat(1e-3f)), one);
  knot_stub stub = knot_stub_of(k, o->a * inwards, o->h * inwards, o->d * inwards);
  vf end = stub.end, inverse_along = one / q.along;
  vf ends = knot_end_width(k, &q, o, &stub);
  vf low = clamp((zero - o->u) * inverse_along, zero - half, half);
  vf high = vmin(vmin((end - rho) / ends, (splat(k->reach) - o->u) * inverse_along), half);
  high = vmax(high, low);
  vf there = rho + half * (low + high) * q.along, radius = knot_radius_at(k, there);
  vf shell = knot_bark_at(all, k, there);

  /* a narrow footprint, by the distance from the edge; a wide one, chord by chord */
  vf edge = knot_edge_width(k, &q, o->inverse);
  vf large = smooth_step(splat(0.4f), splat(0.8f), edge / radius);
  vf wd = vmax(edge, splat(0.08f)), beyond = (o->d - radius) / wd, along = high - low;
  vf share = clamp01(half - beyond) * along;
  vf skin = vmax(clamp01(half - beyond + shell / wd) * along - share, zero);
  vf reach = half * wd, halo = knot_halo_to(o->d + reach, radius);
  halo = (halo - knot_halo_to(o->d - reach, radius)) / wd * along;
  if (any(gt(shell, zero))) {
    /* and over the end of what is left of it */
    vf cap = knot_overlap(rho - end - half * shell, half * shell, ends);
    skin = vmax(skin, cap * clamp01(half - (o->d - splat(k->radius)) / wd));
  }
  /* 1 - (d / radius)^2 in its mean over the footprint, or over all of the knot */
  vf heart = clamp01(one - (o->d * o->d + wd * wd * splat(1.0f / 6.0f)) / (radius * radius));
  if (any(gt(large, zero))) {
    knot_shares c = knot_chords(all, k, &q, scale, end, ends, edge);
    vm some = gt(large, zero);
    share = sel(some, mix(share, c.knot, large), share);
    skin = sel(some, mix(skin, c.bark, large), skin);
    halo = sel(some, mix(halo, c.halo, large), halo);
    heart = sel(some, mix(heart, half, large), heart);
  }
  share = share * weight;
  out->bark = vmax(out->bark, skin * weight);
  out->halo = knot_union(out->halo, halo * weight);
  if (!any(gt(share, zero))) return;
  if (all->check > 0.0f) {
    out->check = vmax(out->check, knot_checked(all, k, o, &q, rho, radius) * share);
  }
  out->heart = out->heart + (heart + splat(k->tone)) * share;
  out->cover = knot_union(out->cover, share);
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
