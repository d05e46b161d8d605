/* SPDX-License-Identifier: Apache-2.0
 *
 * Boards: a layout of wood. Object space x, y is the floor and +z its face;
 * every board is sawn from a log of its own, its grain along its length.
 *
 * A log of its own is: an offset to the seeds of all noises, an azimuth, a
 * distance and direction from the pith (the cut), and a height. Heights stay
 * near y = 0, since the reference section shears with them.
 */
#ifndef SOZAI_WOOD_BOARDS_H
#define SOZAI_WOOD_BOARDS_H

#include "../layout/relief.h"
#include "wood.h"

typedef struct {
  layout_unit unit;
  vu own;        /* added to the seeds */
  vf turn[3][3]; /* object to log, rows */
  vf tone;       /* factor of the albedo */

  /* of plies; see plies/ply.h */
  vf filler[3];        /* colour of what is no wood: glue, gaps and joints */
  vf down[3], squeeze; /* log space: down the surface; how much shorter the footprint is there */
  vf wide;             /* mm: the footprint, where rings curve under it, else 0 */
  vf bent;             /* mm: the footprint on peeled veneer, else 0 */
  vf lead;             /* mm: of the knife to a radian, of peeled veneer */
  vf tilt[3], step;    /* slope of the glue's step, object space, and its height */
  vf number, place[2], to_glue;
} wood_board;

/* The next of a board's random numbers, 0..1. */
INLINE vf board_random(vu *h) {
  *h = hash_mix(*h + splatu(HASH_X));
  return layout_random(*h);
}

/* How the board lies about the pith: direction (sine, cosine) from the face's
 * normal, by the shares of the cuts, in turns. */
INLINE vf board_cut(const wood_boards *b, vf which, vf place) {
  vf middle = splat(0.0f), spread = splat(0.05f); /* flat: within 18 degrees */
  vm rift = le(splat(b->flat), which), quarter = le(splat(b->flat + b->rift), which);
  middle = sel(rift, splat(0.125f), middle);
  spread = sel(rift, splat(0.042f), spread);
  middle = sel(quarter, splat(0.236f), middle);
  spread = sel(quarter, splat(0.014f), spread);
  return middle + spread * (place + place - splat(1.0f));
}

/* The sine of an angle of random size and its cosine; two uniform numbers make its
 * density a triangle. */
INLINE void board_leans(float most, vu *h, vf *sine, vf *cosine) {
  vf first = board_random(h), sum = first + board_random(h) - splat(1.0f);
  *sine = clamp(splat(most) * sum, splat(-0.8f), splat(0.8f));
  *cosine = vsqrt(splat(1.0f) - *sine * *sine);
}

/* How a board was sawn from its log: all that does not depend on where on it a point is. */
typedef struct {
  int filled;
  vu id; /* of the unit that it is of, */
  vf length, width;
  vu own;
  vf shade;                                      /* three uniform numbers' sum: nearly normal */
  vf flip, sa, ca;                               /* end for end; turned about the pith */
  vf st, ct, sk, ck, across, along, over, under; /* of its lean, and products of those */
  vf place[3];
} board_sawn;

/* A board's length out of the stem's direction, towards its face and within it. The
 * same turn as that of a board that is cut alone; see build/cut.c. */
INLINE void board_lean(const board_sawn *m, vf row[3][3], vf q[3]) {
  for (int c = 0; c < 4; c++) {
    vf *x = c < 3 ? &row[0][c] : &q[0], *y = c < 3 ? &row[1][c] : &q[1];
    vf *z = c < 3 ? &row[2][c] : &q[2];
    vf fx = *x, fy = *y, fz = *z;
    *x = m->ck * fx + m->across * fy - m->over * fz;
    *y = m->along * fy - m->sk * fx - m->under * fz;
    *z = m->st * fy + m->ct * fz;
  }
}

/* A sheet peeled off the log: x along it, y up the stem, its face outwards. What
 * lay at the angle a has the length x = R a - thickness a^2 / 4 pi before it, and
 * the radius s = sqrt(R^2 - thickness x / pi): a = 2 x / (R + s). */
INLINE void veneer_at(const wood_constants *w, const vf p[3], vf e, wood_board *out, vf log[3]) {
  vf zero = splat(0.0f), one = splat(1.0f), big = splat(w->peel_radius);
  vf left = vmax(big * big - splat(w->peel_lead) * p[0], splat(0.25f)), r = vsqrt(left);
  vf s, c, angle = (p[0] + p[0]) / (big + r);
  sine_cosine(splat(w->peel_turn) - angle, &s, &c);
  const vf rows[3][3] = {{s, zero, c}, {zero, one, zero}, {zero - c, zero, s}};
  memcpy(out->turn, rows, sizeof rows);
  memset(&out->unit, 0, sizeof out->unit);
  out->own = splatu(0);
  out->tone = one;
  out->wide = zero; /* rings that curved about the log were laid flat with it */
  out->bent = e;
  out->lead = splat(0.5f * w->peel_lead);
  r = r + p[2];
  log[0] = r * c + splat(w->shift[0]);
  log[1] = p[1] + splat(w->shift[1]);
  log[2] = r * s + splat(w->shift[2]);
}

/* The sum of the next three, added as they come: C leaves the order of calls within a sum open. */
INLINE vf board_random_three(vu *h) {
  vf sum = board_random(h);
  sum = sum + board_random(h);
  return sum + board_random(h);
}

/* Three uniform numbers, of the board's own. */
INLINE vf board_shade(vu own) {
  vu h = own ^ splatu(HASH_Z);
  return board_random_three(&h);
}

/* A board's shade: a factor of its albedo, of a standard deviation as asked for; of a
 * footprint that does not lie within it as a whole, that much less. */
INLINE vf board_tone(const wood_boards *b, const layout_unit *unit, vf sum) {
  vf shade = (sum + sum - splat(3.0f)) * splat(b->tone) * unit->own;
  return vmax(splat(1.0f) + shade, splat(0.2f));
}

INLINE vu board_own(const wood_constants *w, const layout_unit *unit) {
  return hash_mix(unit->id + splatu(w->seeds[SEED_BOARDS]));
}

/* A wide footprint's shade and joint by side * side parts, each of which lies on boards
 * of its own. */
static __attribute__((noinline)) void board_by_parts(const wood_constants *w, vf x, vf y, vf e,
                                                     int side, vf *tone, vf *joint) {
  const wood_boards *b = &w->boards;
  vf part = e * splat(1.0f / (float)side), zero = splat(0.0f), one = splat(1.0f);
  vf open = zero, shade = zero;
  for (int j = 0; j < side; j++) {
    for (int i = 0; i < side; i++) {
      float middle = 0.5f * (float)(side - 1);
      layout_unit unit = layout_at(&b->layout, x + part * splat((float)i - middle),
                                   y + part * splat((float)j - middle), part);
      vf share = one - unit.joint;
      open = open + share;
      shade = shade + share * board_tone(b, &unit, board_shade(board_own(w, &unit)));
    }
  }
  *tone = shade / vmax(open, splat(1e-6f));
  *joint = one - open * splat(1.0f / (float)(side * side));
}

#define BOARD_TWO 0.3f   /* of a board's smaller side, from which a footprint is seen in two */
#define BOARD_THREE 0.8f /* parts to a side, and in three */

/* Footprints that boards are small under. */
INLINE void board_wide(const wood_constants *w, const vf p[3], vf e, wood_board *out) {
  layout_unit *unit = &out->unit;
  /* sides of irregular polygons are told as lines without ends, which small parts bear */
  int finer = w->boards.layout.kind == LAYOUT_CRAZY ? 2 : 1;
  vf size = vmin(unit->length, unit->width) * splat(1.0f / (float)finer);
  vm wide = gt(e, splat(BOARD_TWO) * size);
  if (!any(wide)) return;
  vm three = gt(e, splat(BOARD_THREE) * size);
  vf tone, joint;
  for (int k = 0; k < 2; k++) {
    vm mine = k ? three : and_(wide, not_(three));
    if (!any(mine)) continue;
    board_by_parts(w, p[0], p[1], e, (k ? 3 : 2) * finer, &tone, &joint);
    out->tone = sel(mine, tone, out->tone);
    unit->joint = sel(mine, joint, unit->joint);
  }
}

INLINE void board_saw(const wood_constants *w, const layout_unit *unit, board_sawn *m) {
  const wood_boards *b = &w->boards;
  vf one = splat(1.0f), zero = splat(0.0f), half = splat(0.5f);
  vu h = board_own(w, unit);
  m->filled = 1;
  m->id = unit->id;
  m->length = unit->length;
  m->width = unit->width;
  m->own = h;
  if (b->tone > 0.0f) m->shade = board_shade(h);
  vf sine, cosine;
  vf which = board_random(&h), cut = board_cut(b, which, board_random(&h));
  vf around = board_random(&h);
  sine_cosine_turns(around, &m->sa, &m->ca);
  vf height = board_random(&h) * splat(2.0f) - one;
  vf distance = splat(b->distance) * (half + splat(2.0f) * board_random(&h));
  vf side = board_random(&h); /* four ways: heart up or down, to the left or right */
  vf up = sel(lt(side, half), one, zero - one);
  vf right = sel(lt(vabs(side - half), splat(0.25f)), one, zero - one);
  m->flip = one;
  if (b->flip == FLIP_RANDOM) m->flip = sel(lt(board_random(&h), half), one, zero - one);
  if (b->flip == FLIP_ALTERNATE) {
    m->flip = one - to_float((vi)(unit->id & splatu(1u))) * splat(2.0f);
  }
  if (b->end) {
    sine_cosine_turns(which, &sine, &cosine);
    m->place[1] = height * splat(400.0f);
  } else {
    board_leans(b->lean, &h, &m->st, &m->ct);
    board_leans(b->skew, &h, &m->sk, &m->ck);
    m->across = m->sk * m->ct;
    m->along = m->ck * m->ct;
    m->over = m->sk * m->st;
    m->under = m->ck * m->st;
    sine_cosine_turns(cut, &sine, &cosine);
    distance = vmax(distance, (half * unit->width + splat(10.0f)) * sine);
    m->place[1] = height * vmax(splat(500.0f) - half * unit->length, splat(150.0f));
  }
  m->place[0] = distance * sine * right;
  m->place[2] = distance * cosine * up;
}

/* Whether every lane's board is the one it was: so it is along a row of texels, and what
 * has been made of it then need not be made again. */
INLINE int board_is(const board_sawn *m, const layout_unit *unit) {
  if (LANES == 1 || !m->filled) return 0;
  vm same = and_(eqi((vi)m->id, (vi)unit->id),
                 and_(eq(m->length, unit->length), eq(m->width, unit->width)));
  return !any(not_(same));
}

/* p: object space, mm; log[3]: where that is in the board's log. last: of the points before
 * these. */
INLINE void board_at(const wood_constants *w, const vf p[3], vf e, board_sawn *last,
                     wood_board *out, vf log[3]) {
  if (w->peeled) {
    veneer_at(w, p, e, out, log);
    return;
  }
  const wood_boards *b = &w->boards;
  vf one = splat(1.0f), zero = splat(0.0f), half = splat(0.5f);
  layout_unit *unit = &out->unit;
  *unit = layout_at(&b->layout, p[0], p[1], e);
  if (!board_is(last, unit)) board_saw(w, unit, last);
  out->own = last->own;
  out->tone = b->tone > 0.0f ? board_tone(b, unit, last->shade) : one;
  board_wide(w, p, e, out);

  vf u = unit->u - half * unit->length, v = unit->v - half * unit->width;
  vf q[3], row[3][3]; /* object to the board's cut: rows are the log's x, y, z before the turn */
  for (int c = 0; c < 3; c++) row[0][c] = row[1][c] = row[2][c] = zero;
  vf cu = unit->c * last->flip, su = unit->s * last->flip;
  if (b->end) {
    /* x along the block, the face looks up the stem, z against its v */
    row[0][0] = cu;
    row[0][1] = su;
    row[1][2] = one;
    row[2][0] = su;
    row[2][1] = zero - cu;
    q[0] = u * last->flip;
    q[1] = p[2];
    q[2] = zero - v * last->flip;
  } else {
    /* y along the board, x against its v, z its face */
    row[0][0] = su;
    row[0][1] = zero - cu;
    row[1][0] = cu;
    row[1][1] = su;
    row[2][2] = one;
    q[0] = zero - v * last->flip;
    q[1] = u * last->flip;
    q[2] = p[2];
    board_lean(last, row, q);
  }
  vf ca = last->ca, sa = last->sa;
  for (int c = 0; c < 3; c++) {
    q[c] = q[c] + last->place[c];
    out->turn[0][c] = ca * row[0][c] - sa * row[2][c];
    out->turn[1][c] = row[1][c];
    out->turn[2][c] = sa * row[0][c] + ca * row[2][c];
  }
  log[0] = ca * q[0] - sa * q[2];
  log[1] = q[1];
  log[2] = sa * q[0] + ca * q[2];
}

/* A channel of the colour of what lies in the joint. */
INLINE vf board_filler(const wood_constants *w, const wood_board *board, int c) {
  return w->plies.count ? board->filler[c] : splat(w->boards.joint_colour[c]);
}

/* What the joint and the board's shade make of a channel of the albedo. */
INLINE vf board_albedo(const wood_constants *w, const wood_board *board, int c, vf albedo) {
  return mix(albedo * board->tone, board_filler(w, board, c), board->unit.joint);
}

#endif
