/* SPDX-License-Identifier: Apache-2.0
 *
 * From a batch to blocks: the point and its normal, the board that it lies on, and where in the
 * log that was cut from.
 */
#ifndef SOZAI_WOOD_STAGES_LOAD_H
#define SOZAI_WOOD_STAGES_LOAD_H

#include "../../layout/relief.h"
#include "axes.h"
#include "wants.h"

/* The board's channels, and the normal of its bevelled edges and cupped face. */
INLINE void stage_board(const wood_constants *w, int boards, const wood_io *io, block *k,
                        vf normal[3]) {
  vf zero = splat(0.0f), id = zero, u = zero, v = zero, edge = zero, height = zero;
  if (boards && w->boards.layout.kind == LAYOUT_NONE) {
    if (w->plies.count) {
      id = k->board.number;
      u = k->board.place[0];
      v = k->board.place[1];
      edge = k->board.to_glue;
    }
  } else if (boards) {
    const layout_unit *unit = &k->board.unit;
    layout_height h = layout_relief(&w->boards.layout, &w->boards.profile, unit, k->s);
    id = layout_number(unit->id);
    u = unit->u;
    v = unit->v;
    edge = unit->edge;
    height = h.height;
    if (io->in->normal[0]) {
      /* the face is tilted, the sides are not */
      vf face = vmax(normal[2], zero);
      normal[0] = normal[0] - face * h.slope_x;
      normal[1] = normal[1] - face * h.slope_y;
      unit_direction(normal);
    }
  }
  if (boards && w->plies.count) {
    height = height + k->board.step;
    if (io->in->normal[0]) {
      for (int c = 0; c < 3; c++) normal[c] = normal[c] - k->board.tilt[c];
      unit_direction(normal);
    }
  }
  store_lanes(io, WOOD_BOARD_ID, k, id);
  store_lanes(io, WOOD_BOARD_U, k, u);
  store_lanes(io, WOOD_BOARD_V, k, v);
  store_lanes(io, WOOD_BOARD_EDGE, k, edge);
  for (int c = 0; c < 3; c++) store_lanes(io, WOOD_NORMAL + c, k, normal[c]);
  store_lanes(io, WOOD_HEIGHT, k, height);
}

INLINE void stage_load(const wood_constants *w, int boards, const wood_io *io,
                       const wood_wants *want, board_sawn *sawn, block *k) {
  vf p[3];
  UNROLL(3)
  for (int c = 0; c < 3; c++) p[c] = finite_coordinate(load_lanes(io->in->point[c], k->i, k->n));
  k->s = splat(0.0f);
  if (io->in->footprint) {
    k->s = clamp(load_lanes(io->in->footprint, k->i, k->n), splat(0.0f), splat(1e4f));
  }
  if (!boards && !want->board && k->o && as_before(io->in->normal, k->i, k->n)) {
    const block *before = k - 1;
    to_log(w, boards, k, p, k->p);
    for (int c = 0; c < 3; c++) k->p[c] = k->p[c] + splat(w->shift[c]);
    for (int c = 0; c < 3; c++) k->nrm[c] = before->nrm[c];
    k->up2 = before->up2;
    k->inverse_up = before->inverse_up;
    k->extent = k->s * (k->up2 * k->inverse_up);
    return;
  }
  vf normal[3] = {splat(0.0f), splat(0.0f), splat(1.0f)};
  if (io->in->normal[0]) {
    for (int c = 0; c < 3; c++) normal[c] = load_lanes(io->in->normal[c], k->i, k->n);
    unit_direction(normal);
  }
  if (boards && want->taps) {
    ply_at(w, want->taps, k->i, k->n, p, normal, !io->in->normal[0], k->s, &k->board, k->p);
  } else if (boards) {
    board_at(w, p, k->s, sawn, &k->board, k->p);
  } else {
    to_log(w, boards, k, p, k->p);
    for (int c = 0; c < 3; c++) k->p[c] = k->p[c] + splat(w->shift[c]);
  }
  k->up2 = splat(1.0f);
  if (want->board || boards) stage_board(w, boards, io, k, normal);
  to_log(w, boards, k, normal, k->nrm);
  if (io->in->normal[0]) k->up2 = vmax(splat(1.0f) - k->nrm[1] * k->nrm[1], splat(0.0f));
  k->inverse_up = inverse_root(vmax(k->up2, splat(1e-12f)));
  k->extent = k->s * (k->up2 * k->inverse_up);
}

#endif
