/* SPDX-License-Identifier: Apache-2.0
 *
 * From a place in a ply to the log that its veneer was cut from.
 *
 * A ply has a frame of its own: X across its grain, Y along it (up the stem), Z
 * out of its upper side. It is laid from pieces, side by side along X. A peeled
 * piece is bent back round its log (X is an arc), a sliced leaf and a strip are
 * where they were, so far from the pith.
 */
#ifndef SOZAI_WOOD_PLY_H
#define SOZAI_WOOD_PLY_H

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

/* The surface's direction that goes down through the plies fastest; object space. */
INLINE void ply_downwards(const vf n[3], int ball, vf out[3]) {
  vf zero = splat(0.0f), rise = n[2];
  if (ball) {
    out[0] = out[1] = zero;
    out[2] = splat(-1.0f);
    return;
  }
  vf flat2 = n[0] * n[0] + n[1] * n[1];
  vf k = inverse_root(vmax(flat2, splat(1e-12f)));
  k = sel(gt(flat2, splat(1e-10f)), k, zero);
  out[0] = n[0] * rise * k;
  out[1] = n[1] * rise * k;
  out[2] = zero - flat2 * k;
}

/* How far a footprint of side 1 reaches along a direction, a share of it down the
 * surface. */
INLINE vf ply_extent(const vf g[3], const vf n[3], int ball, const vf down[3], vf share) {
  vf all = g[0] * g[0] + g[1] * g[1] + g[2] * g[2], zero = splat(0.0f);
  vf out = g[0] * n[0] + g[1] * n[1] + g[2] * n[2];
  vf low = g[0] * down[0] + g[1] * down[1] + g[2] * down[2];
  if (ball) out = zero;
  vf level = vmax(all - out * out - low * low, zero);
  low = low * share;
  return vsqrt(level + low * low);
}

#define PLY_LEAN 0.7f /* of a lathe check: along the sheet to a mm up */

/* Lathe checks: slits that lean and open to the side that lay on the log, one to
 * a step along the sheet, of a depth of its own that changes along the grain. At
 * x, y and `high` above that side; e: mm, of the footprint along x. Their share. */
INLINE vf ply_checks(const wood_plies *p, vu own, vf x, vf y, vf high, vf thick, vf e) {
  vf one = splat(1.0f), zero = splat(0.0f), wide = splat(0.035f);
  vf step = vmax(splat(1.3f) * thick, splat(0.3f)), most = splat(p->check_depth) * thick;
  vf leaned = x + splat(PLY_LEAN) * high, inverse = one / step;
  vi cell, part;
  vf t = leaned * inverse, within = t - vfloor(t, &cell);
  vu h = hash_mix((vu)cell * splatu(HASH_X) + own + splatu(HASH_Z));
  vf at = splat(0.25f) + splat(0.5f) * layout_random(h);
  vf along = y * splat(1.0f / 26.0f) + layout_random(hash_mix(h + splatu(HASH_Y)));
  vf low = vfloor(along, &part), f = along - low;
  /* depth: from one random number to the next */
  vf from = layout_random(hash_mix(h + (vu)part * splatu(HASH_Y)));
  vf to = layout_random(hash_mix(h + ((vu)part + splatu(1)) * splatu(HASH_Y)));
  vf reach = most * mix(from, to, f * f * (splat(3.0f) - f - f));
  vf width = wide * clamp01(one - high / vmax(reach, splat(1e-4f)));
  vf near = cover_share((within - at) * step, vmax(e, splat(0.01f)), splat(-0.5f) * width,
                        splat(0.5f) * width);
  /* what is expected, from as much as a step on: a line's mean width, and how often */
  vf rest = clamp01(one - high / vmax(most, splat(1e-4f)));
  vf mean = wide * inverse * rest * rest * splat(0.5f);
  vf found = mix(near, mean, smooth_step(splat(0.4f) * step, step, e));
  return sel(gt(most, zero), found, zero);
}

/* The board that a point's ply is: p, object space; n: unit normal; unit: of the
 * floor's board, or none. log[3]: where it is in its log. */
INLINE void ply_at(const wood_constants *w, const ply_taps *taps, uint32_t i, uint32_t lanes,
                   const vf p[3], const vf n[3], int ball, vf s, wood_board *out, vf log[3]) {
  const wood_plies *q = &w->plies;
  vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f), two = splat(2.0f);
  vf in[TAP_COLUMNS];
  for (int c = 0; c < TAP_COLUMNS; c++) in[c] = load_lanes(taps->column[c], i, lanes);
  vi number, piece;
  vfloor(in[TAP_NUMBER], &number);
  vm face = and_(gt(in[TAP_KIND], splat(0.5f)), lt(in[TAP_KIND], splat(2.5f)));
  vm back = and_(face, gt(in[TAP_KIND], splat(1.5f))), strips = gt(in[TAP_KIND], splat(2.5f));
  vm crossed = gt(in[TAP_CROSSED], half);

  /* the faces' frame: along the grain of a sheet, +y, or of the floor's board */
  vf cu = zero, su = one, u = p[1], v = zero - p[0];
  layout_unit *unit = &out->unit;
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
  vf x = sel(crossed, u, zero - v), y = sel(crossed, v, u);
  vf yx = sel(crossed, zero - su, cu), yy = sel(crossed, cu, su);

  vu ply =
      hash_mix((vu)number * splatu(HASH_Y) + sheet * splatu(HASH_Z) + splatu(w->seeds[SEED_PLIES]));
  vu h = ply;
  /* either way up the stem; a core's veneer either way over, faces with the side
   * that lay outwards in the log to the outside */
  vf turn = sel(lt(board_random(&h), half), one, splat(-1.0f));
  vf over = sel(lt(board_random(&h), half), one, splat(-1.0f));
  over = sel(face, sel(back, splat(-1.0f), one), over);
  vf wide = sel(face, splat(q->width[1]), splat(q->width[0]));
  vf place = x / wide + board_random(&h), across = place - vfloor(place, &piece);
  vf depth = zero - in[TAP_DEPTH];

  /* the leaves of a sliced face come off one flitch, each deeper in it by its
   * thickness; every other one is turned over */
  vm leaf = q->face_cut == FACE_ROTARY ? lt(one, zero) : face;
  vf deeper = zero, mirror = one;
  h = hash_mix(ply + (vu)piece * splatu(HASH_X));
  if (q->face_cut != FACE_ROTARY && q->match != MATCH_RANDOM) {
    vi flitch, odd = piece & splati(1);
    vf low = vfloor((to_float(piece) + splat(0.5f)) * splat(1.0f / PLIES_LEAVES), &flitch);
    deeper = sel(leaf, (to_float(piece) - splat((float)PLIES_LEAVES) * low) * in[TAP_THICK], zero);
    vu whole = hash_mix(ply + (vu)flitch * splatu(HASH_X));
    h = (vu)seli(leaf, (vi)whole, (vi)h);
    if (q->match == MATCH_BOOK) mirror = sel(leaf, one - to_float(odd + odd), one);
  }
  out->own = h;

  /* within the piece, from its middle; turned up or down, over or not */
  vf along = (across - half) * wide, flip = turn * over * mirror;
  vf from_joint = half * wide - vabs(along);
  vf px = along * flip, py = y * turn, pz = depth * over * mirror;
  vf radius = splat(q->radius) * (splat(0.7f) + splat(0.8f) * board_random(&h));
  vf around = board_random(&h);
  vf height = (board_random(&h) + board_random(&h) - one) * splat(300.0f);
  vf beside = board_random(&h);
  vm peeled = not_(or_(leaf, strips));
  /* as veneer_at */
  vf lead = in[TAP_THICK] * splat(0.31830989f);
  vf r = vsqrt(vmax(radius * radius - lead * px, splat(0.25f)));
  vf angle = sel(peeled, (px + px) * splat(0.15915494f) / (radius + r), zero);
  vf bent = sel(peeled, zero, px);
  vf sn, cs, sn2, cs2;
  sine_cosine_turns(around - angle, &sn, &cs);
  /* a leaf's way from the pith is along its face's normal, or in its plane; a
   * strip's is anywhere */
  sine_cosine_turns(around + beside, &sn2, &cs2);
  vf ax = sel(strips, cs2, cs), az = sel(strips, sn2, sn);
  if (q->face_cut == FACE_QUARTERED) {
    ax = sel(leaf, sn, ax);
    az = sel(leaf, zero - cs, az);
  }
  vf from_pith = sel(peeled, r, radius), out_z = pz - deeper;
  if (q->face_cut == FACE_QUARTERED) {
    from_pith = sel(leaf, vmax(radius, half * wide + splat(10.0f)), from_pith);
  }
  log[0] = bent * sn + out_z * cs + from_pith * ax;
  log[1] = py + height;
  log[2] = zero - bent * cs + out_z * sn + from_pith * az;

  vf row_x[3] = {yy * flip, (zero - yx) * flip, zero};
  vf row_y[3] = {yx * turn, yy * turn, zero};
  vf row_z[3] = {zero, zero, over * mirror};
  for (int c = 0; c < 3; c++) {
    out->turn[0][c] = row_x[c] * sn + row_z[c] * cs;
    out->turn[1][c] = row_y[c];
    out->turn[2][c] = row_z[c] * sn - row_x[c] * cs;
  }

  /* its shade: of its own, and where the knife left checks */
  out->tone = one;
  if (q->tone > 0.0f) {
    vf sum = board_random(&h) + board_random(&h) + board_random(&h);
    out->tone = vmax(one + (sum + sum - splat(3.0f)) * splat(q->tone), splat(0.2f));
  }
  vf down[3];
  ply_downwards(n, ball, down);
  out->squeeze = one - in[TAP_SHARE];
  if (q->check_depth > 0.0f) {
    const float lean = PLY_LEAN;
    vf slit_x[3] = {row_x[0], row_x[1], splat(lean) * row_z[2]};
    vf e = s * ply_extent(slit_x, n, ball, down, in[TAP_SHARE]), high = pz + half * in[TAP_THICK];
    vf slit = ply_checks(q, out->own, px, py, high, in[TAP_THICK], e);
    out->tone = out->tone * (one - splat(0.6f) * sel(peeled, slit, zero));
  }

  /* glue, gaps between the core's pieces, and the floor's joints */
  vf glue = in[TAP_GLUE], hollow = zero, joint = unit->joint;
  if (q->gap > 0.0f) {
    vf next = to_float(piece) + sel(lt(along, zero), zero, one);
    vi which;
    vfloor(next, &which);
    vf open = layout_random(hash_mix(ply + (vu)which * splatu(HASH_X) + splatu(HASH_Z)));
    open = vmax(two * open - one, zero);
    vf gap = splat(0.5f * q->gap) * open * open;
    vf e = s * ply_extent(row_x, n, ball, down, in[TAP_SHARE]);
    hollow = cover_share(from_joint, vmax(e, splat(0.01f)), zero - gap, gap);
    hollow = sel(face, zero, hollow);
  }
  vf wood = (one - glue) * (one - hollow) * (one - joint), filled = one - wood;
  vf inverse = one / vmax(filled, splat(1e-6f));
  for (int c = 0; c < 3; c++) {
    vf filler =
        glue * splat(q->glue_colour[c]) + (one - glue) * hollow * splat(q->hollow_colour[c]);
    filler = mix(filler, splat(w->boards.joint_colour[c]), joint);
    out->filler[c] = filler * inverse;
  }
  unit->joint = filled;

  for (int c = 0; c < 3; c++) {
    const vf(*t)[3] = out->turn;
    out->down[c] = t[c][0] * down[0] + t[c][1] * down[1] + t[c][2] * down[2];
    out->tilt[c] = down[c] * in[TAP_TILT];
  }
  out->step = in[TAP_STEP];
  vm parted = lt(in[TAP_SHARE], splat(0.999f));
  out->wide = sel(or_(peeled, parted), zero, s);
  out->bent = sel(and_(peeled, not_(parted)), s, zero);
  out->lead = half * lead;
  out->number = in[TAP_NUMBER] + one;
  out->place[0] = y;
  out->place[1] = across * wide;
  out->to_glue = in[TAP_EDGE];
}

/* A row of a map from the surface, for the part of the footprint that lies
 * within the ply: shorter on the way down. */
INLINE void ply_squeeze(const wood_board *b, vf row[3]) {
  vf along = row[0] * b->down[0] + row[1] * b->down[1] + row[2] * b->down[2];
  vf less = along * b->squeeze;
  for (int c = 0; c < 3; c++) row[c] = row[c] - less * b->down[c];
}

#endif
