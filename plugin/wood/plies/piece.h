/* SPDX-License-Identifier: Apache-2.0
 *
 * From a place in a ply to the log that its veneer was cut from.
 *
 * A ply has a frame of its own: X across its grain, Y along it (up the stem), Z
 * out of its upper side. It is laid from pieces, side by side along X. A peeled
 * piece is bent back round its log (X is an arc), a sliced leaf and a strip are
 * where they were, so far from the pith.
 */
#ifndef SOZAI_WOOD_PLIES_PIECE_H
#define SOZAI_WOOD_PLIES_PIECE_H

#include "../../core/lanes.h"
#include "../boards.h"

/* What taps.h tells about each ply that is asked, as columns. */
enum {
  TAP_NUMBER,  /* of the ply, 0: the first sheet's face */
  TAP_KIND,    /* PLY_CORE... */
  TAP_CROSSED, /* 1: its grain runs across the faces' */
  TAP_THICK,   /* mm, of the ply */
  TAP_DEPTH,   /* mm, below its middle */
  TAP_SHARE,   /* of the footprint's way down: 1: all of it lies in the ply's wood */
  TAP_GLUE,    /* share of its cell's part of the footprint that is glue */
  TAP_EDGE,    /* mm, of the point from the nearest glue: negative within it */
  TAP_STEP,    /* mm: height that the glue adds */
  TAP_TILT,    /* its slope down the surface */
  TAP_COLUMNS
};

typedef struct {
  const float *column[TAP_COLUMNS];
} ply_taps;

/* What a ply is told, and what it is by that. */
typedef struct {
  vf in[TAP_COLUMNS];
  vi number;
  vm face, back, strips, crossed;
} ply_told;

INLINE void ply_told_of(const ply_taps *taps, uint32_t i, uint32_t lanes, ply_told *t) {
  vf half = splat(0.5f);
  for (int c = 0; c < TAP_COLUMNS; c++) t->in[c] = load_lanes(taps->column[c], i, lanes);
  vfloor(t->in[TAP_NUMBER], &t->number);
  t->face = and_(gt(t->in[TAP_KIND], half), lt(t->in[TAP_KIND], splat(2.5f)));
  t->back = and_(t->face, gt(t->in[TAP_KIND], splat(1.5f)));
  t->strips = gt(t->in[TAP_KIND], splat(2.5f));
  t->crossed = gt(t->in[TAP_CROSSED], half);
}

/* A place in the ply's frame; and the frame's Y in object space. */
typedef struct {
  vf x, y;   /* mm */
  vf yx, yy; /* direction */
} ply_frame;

/* Returns what tells one sheet from another: of a floor's, its board. */
INLINE vu ply_frame_of(const wood_constants *w, const vf p[3], vf s, vm crossed, layout_unit *unit,
                       ply_frame *f) {
  /* the faces': along the grain of a sheet, +y, or of the floor's board */
  vf zero = splat(0.0f), half = splat(0.5f), cu = zero, su = splat(1.0f);
  vf u = p[1], v = zero - p[0];
  vu sheet = splatu(0);
  if (w->boards.layout.kind != LAYOUT_NONE) {
    *unit = layout_at(&w->boards.layout, p[0], p[1], s);
    u = unit->u - half * unit->length;
    v = unit->v - half * unit->width;
    cu = unit->c;
    su = unit->s;
    sheet = unit->id;
  } else {
    memset(unit, 0, sizeof *unit);
  }
  /* the ply's: Y along (cu, su), X to its right; crossed: a quarter turn on */
  f->x = sel(crossed, u, zero - v);
  f->y = sel(crossed, v, u);
  f->yx = sel(crossed, zero - su, cu);
  f->yy = sel(crossed, cu, su);
  return sheet;
}

/* The piece of a ply that a place is in: a stretch of peeled veneer, a leaf or a strip. */
typedef struct {
  vu ply;                 /* its hash */
  vu own, next;           /* the log's, or the flitch's; where its random numbers go on from */
  vi number;              /* along the ply's X */
  vf wide, across, along; /* mm; 0..1; mm, from its middle */
  vf turn, over, mirror;  /* -1: the other way up the stem; the other side up; so matched */
  vf deeper;              /* mm: how far down in its flitch */
  vm leaf, peeled;
  vf at[3];                  /* mm: the place as it lay in the log, from the piece's middle */
  vf row_x[3], row_y[3], up; /* object space to that: rows, and the last one's z */
  vf lead;                   /* mm: thickness over pi */
} ply_piece;

/* The leaves of a sliced face come off one flitch, each deeper in it by its
 * thickness; every other one is turned over. */
INLINE void ply_match(const wood_plies *q, const ply_told *t, ply_piece *o) {
  vi flitch, odd = o->number & splati(1);
  vf at = to_float(o->number), one = splat(1.0f);
  vf low = vfloor((at + splat(0.5f)) * splat(1.0f / PLIES_LEAVES), &flitch);
  o->deeper = sel(o->leaf, (at - splat((float)PLIES_LEAVES) * low) * t->in[TAP_THICK], splat(0.0f));
  vu whole = hash_mix(o->ply + (vu)flitch * splatu(HASH_X));
  o->own = (vu)seli(o->leaf, (vi)whole, (vi)o->own);
  if (q->match == MATCH_BOOK) o->mirror = sel(o->leaf, one - to_float(odd + odd), one);
}

INLINE void ply_piece_of(const wood_constants *w, const ply_told *t, vu sheet, const ply_frame *f,
                         ply_piece *o) {
  const wood_plies *q = &w->plies;
  vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f);
  o->ply = hash_mix((vu)t->number * splatu(HASH_Y) + sheet * splatu(HASH_Z) +
                    splatu(w->seeds[SEED_PLIES]));
  vu h = o->ply;
  /* either way up the stem; a core's veneer either way over, faces with the side
   * that lay outwards in the log to the outside */
  o->turn = sel(lt(board_random(&h), half), one, splat(-1.0f));
  vf over = sel(lt(board_random(&h), half), one, splat(-1.0f));
  o->over = sel(t->face, sel(t->back, splat(-1.0f), one), over);
  o->wide = sel(t->face, splat(q->width[1]), splat(q->width[0]));
  vf place = f->x / o->wide + board_random(&h);
  o->across = place - vfloor(place, &o->number);
  o->along = (o->across - half) * o->wide;
  o->leaf = q->face_cut == FACE_ROTARY ? lt(one, zero) : t->face;
  o->peeled = not_(or_(o->leaf, t->strips));
  o->deeper = zero;
  o->mirror = one;
  o->own = hash_mix(o->ply + (vu)o->number * splatu(HASH_X));
  if (q->face_cut != FACE_ROTARY && q->match != MATCH_RANDOM) ply_match(q, t, o);
  o->next = o->own;
}

/* Turned up or down, over or not: as it lay in the log. */
INLINE void ply_turn(const ply_told *t, const ply_frame *f, ply_piece *o) {
  vf zero = splat(0.0f), flip = o->turn * o->over * o->mirror, depth = zero - t->in[TAP_DEPTH];
  o->at[0] = o->along * flip;
  o->at[1] = f->y * o->turn;
  o->at[2] = depth * o->over * o->mirror;
  o->up = o->over * o->mirror;
  o->row_x[0] = f->yy * flip;
  o->row_x[1] = (zero - f->yx) * flip;
  o->row_y[0] = f->yx * o->turn;
  o->row_y[1] = f->yy * o->turn;
  o->row_x[2] = o->row_y[2] = zero;
}

/* Where it lay in the log, and how: a peeled one bent back as by veneer_at. */
INLINE void ply_to_log(const wood_plies *q, const ply_told *t, ply_piece *o, vf turn[3][3],
                       vf log[3]) {
  vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f);
  vf radius = splat(q->radius) * (splat(0.7f) + splat(0.8f) * board_random(&o->next));
  vf around = board_random(&o->next);
  vf height = (board_random(&o->next) + board_random(&o->next) - one) * splat(300.0f);
  vf beside = board_random(&o->next);
  vf px = o->at[0];
  o->lead = t->in[TAP_THICK] * splat(0.31830989f);
  vf r = vsqrt(vmax(radius * radius - o->lead * px, splat(0.25f)));
  vf angle = sel(o->peeled, (px + px) * splat(0.15915494f) / (radius + r), zero);
  vf bent = sel(o->peeled, zero, px);
  vf sn, cs, sn2, cs2;
  sine_cosine_turns(around - angle, &sn, &cs);
  /* a leaf's way from the pith is along its face's normal, or in its plane; a
   * strip's is anywhere */
  sine_cosine_turns(around + beside, &sn2, &cs2);
  vf ax = sel(t->strips, cs2, cs), az = sel(t->strips, sn2, sn);
  vf from_pith = sel(o->peeled, r, radius), out_z = o->at[2] - o->deeper;
  if (q->face_cut == FACE_QUARTERED) {
    ax = sel(o->leaf, sn, ax);
    az = sel(o->leaf, zero - cs, az);
    from_pith = sel(o->leaf, vmax(radius, half * o->wide + splat(10.0f)), from_pith);
  }
  log[0] = bent * sn + out_z * cs + from_pith * ax;
  log[1] = o->at[1] + height;
  log[2] = zero - bent * cs + out_z * sn + from_pith * az;
  const vf row_z[3] = {zero, zero, o->up};
  for (int c = 0; c < 3; c++) {
    turn[0][c] = o->row_x[c] * sn + row_z[c] * cs;
    turn[1][c] = o->row_y[c];
    turn[2][c] = row_z[c] * sn - o->row_x[c] * cs;
  }
}

#endif
