/* SPDX-License-Identifier: Apache-2.0
 *
 * A ply as a footprint sees it: the board that it stands for, its shade with the checks that the
 * knife left, and what is no wood, glue and gaps.
 */
#ifndef SOZAI_WOOD_PLY_H
#define SOZAI_WOOD_PLY_H

#include "piece.h"

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

/* The square that is seen, on the surface. */
typedef struct {
  const vf *n;
  int ball;
  vf s, down[3];
} ply_eye;

/* mm: how far the ply's share of it reaches along a direction. */
INLINE vf ply_seen(const ply_eye *e, const ply_told *t, const vf g[3]) {
  return e->s * ply_extent(g, e->n, e->ball, e->down, t->in[TAP_SHARE]);
}

/* The ply's shade: of its own, and where the knife left checks. */
INLINE vf ply_tone(const wood_plies *q, const ply_told *t, const ply_eye *e, ply_piece *o) {
  vf one = splat(1.0f), tone = one;
  if (q->tone > 0.0f) {
    vf sum = board_random_three(&o->next);
    tone = vmax(one + (sum + sum - splat(3.0f)) * splat(q->tone), splat(0.2f));
  }
  if (q->check_depth > 0.0f) {
    const float lean = PLY_LEAN;
    vf slit_x[3] = {o->row_x[0], o->row_x[1], splat(lean) * o->up};
    vf high = o->at[2] + splat(0.5f) * t->in[TAP_THICK];
    vf slit =
        ply_checks(q, o->own, o->at[0], o->at[1], high, t->in[TAP_THICK], ply_seen(e, t, slit_x));
    tone = tone * (one - splat(0.6f) * sel(o->peeled, slit, splat(0.0f)));
  }
  return tone;
}

/* Share of the footprint that is a gap between the core's pieces. */
INLINE vf ply_hollow(const wood_plies *q, const ply_told *t, const ply_eye *e, const ply_piece *o) {
  vf zero = splat(0.0f), one = splat(1.0f);
  if (!(q->gap > 0.0f)) return zero;
  vf next = to_float(o->number) + sel(lt(o->along, zero), zero, one);
  vi which;
  vfloor(next, &which);
  vf open = layout_random(hash_mix(o->ply + (vu)which * splatu(HASH_X) + splatu(HASH_Z)));
  open = vmax(splat(2.0f) * open - one, zero);
  vf gap = splat(0.5f * q->gap) * open * open;
  vf from_joint = splat(0.5f) * o->wide - vabs(o->along);
  vf extent = vmax(ply_seen(e, t, o->row_x), splat(0.01f));
  return sel(t->face, zero, cover_share(from_joint, extent, zero - gap, gap));
}

/* What is no wood, as a joint of its colour: glue, gaps between the core's pieces, and the
 * floor's joints. */
INLINE void ply_fill(const wood_constants *w, const ply_told *t, vf hollow, wood_board *out) {
  const wood_plies *q = &w->plies;
  vf one = splat(1.0f), glue = t->in[TAP_GLUE], joint = out->unit.joint;
  vf wood = (one - glue) * (one - hollow) * (one - joint), filled = one - wood;
  vf inverse = one / vmax(filled, splat(1e-6f));
  for (int c = 0; c < 3; c++) {
    vf filler =
        glue * splat(q->glue_colour[c]) + (one - glue) * hollow * splat(q->hollow_colour[c]);
    filler = mix(filler, splat(w->boards.joint_colour[c]), joint);
    out->filler[c] = filler * inverse;
  }
  out->unit.joint = filled;
}

/* The board that a point's ply is: p, object space; n: unit normal; unit: of the
 * floor's board, or none. log[3]: where it is in its log. */
INLINE void ply_at(const wood_constants *w, const ply_taps *taps, uint32_t i, uint32_t lanes,
                   const vf p[3], const vf n[3], int ball, vf s, wood_board *out, vf log[3]) {
  vf zero = splat(0.0f), one = splat(1.0f);
  ply_told t;
  ply_frame f;
  ply_piece o;
  ply_eye e = {.n = n, .ball = ball, .s = s};
  ply_told_of(taps, i, lanes, &t);
  vu sheet = ply_frame_of(w, p, s, t.crossed, &out->unit, &f);
  ply_piece_of(w, &t, sheet, &f, &o);
  ply_turn(&t, &f, &o);
  ply_to_log(&w->plies, &t, &o, out->turn, log);
  ply_downwards(n, ball, e.down);
  out->own = o.own;
  out->tone = ply_tone(&w->plies, &t, &e, &o);
  ply_fill(w, &t, ply_hollow(&w->plies, &t, &e, &o), out);

  out->squeeze = one - t.in[TAP_SHARE];
  for (int c = 0; c < 3; c++) {
    const vf(*turn)[3] = out->turn;
    out->down[c] = turn[c][0] * e.down[0] + turn[c][1] * e.down[1] + turn[c][2] * e.down[2];
    out->tilt[c] = e.down[c] * t.in[TAP_TILT];
  }
  out->step = t.in[TAP_STEP];
  vm parted = lt(t.in[TAP_SHARE], splat(0.999f));
  out->wide = sel(or_(o.peeled, parted), zero, s);
  out->bent = sel(and_(o.peeled, not_(parted)), s, zero);
  out->lead = splat(0.5f) * o.lead;
  out->number = t.in[TAP_NUMBER] + one;
  out->place[0] = f.y;
  out->place[1] = o.across * o.wide;
  out->to_glue = t.in[TAP_EDGE];
}

/* A row of a map from the surface, for the part of the footprint that lies
 * within the ply: shorter on the way down. */
INLINE void ply_squeeze(const wood_board *b, vf row[3]) {
  vf along = row[0] * b->down[0] + row[1] * b->down[1] + row[2] * b->down[2];
  vf less = along * b->squeeze;
  for (int c = 0; c < 3; c++) row[c] = row[c] - less * b->down[c];
}

#endif
