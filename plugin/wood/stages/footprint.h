/* SPDX-License-Identifier: Apache-2.0
 *
 * The footprint in the reference section: over rho, and over the arc.
 */
#ifndef SOZAI_WOOD_STAGES_FOOTPRINT_H
#define SOZAI_WOOD_STAGES_FOOTPRINT_H

#include "../plies/ply.h"
#include "../rings_curved.h"
#include "block.h"

/* The row of the map from the surface to rho. */
INLINE void stem_row(block *k) {
  const stem_place *stem = &k->stem;
  k->b[0] = stem->rho_x;
  k->b[1] = stem->rho_y - stem->rho_x * stem->pith.dx - stem->rho_z * stem->pith.dz;
  k->b[2] = stem->rho_z;
}

/* Whether the footprint over rho is that of the wood's own rows. */
INLINE int reach_is_plain(const wood_constants *w, int boards, const block *k) {
  return !k->knot && !(boards && w->plies.count);
}

INLINE void stage_reach(const wood_constants *w, int boards, const wood_io *io, block *k) {
  stem_row(k);
  vf b[3] = {k->b[0], k->b[1], k->b[2]};
  if (reach_is_plain(w, boards, k)) {
    k->section.f.bb = footprint_along(b, k->nrm, !io->in->normal[0], &k->bn) * (k->s * k->s);
    k->reach = vsqrt(k->section.f.bb + splat(12.0f) * k->stem.lost);
    return;
  }
  if (boards && w->plies.count) ply_squeeze(&k->board, b);
  k->reach = rings_extent(&k->stem, b, k->nrm, !io->in->normal[0], k->s);
}

/* The row of the map from surface to arc of the reference section. */
INLINE void section_arc_row(const block *k, vf a[3]) {
  const stem_place *stem = &k->stem;
  vf zero = splat(0.0f);
  vf ratio = stem->rho * stem->inverse_r;
  vf phi_rho =
      (k->grain.d_t * k->ring.inverse_width - k->phase * stem->rho * k->divisor) * k->divisor;
  vf shear = stem->rho * phi_rho, g = stem->rho * k->grain.g * k->divisor;
  vf tx = zero - ratio * stem->s, tz = ratio * stem->c;
  a[0] = tx - shear * k->b[0];
  a[1] = zero - tx * stem->pith.dx - tz * stem->pith.dz - g - shear * k->b[1];
  a[2] = tz - shear * k->b[2];
  if (k->knot) {
    const knot_place *q = k->knot;
    a[0] = a[0] + stem->rho * q->turn_x;
    a[1] = a[1] + stem->rho * (q->turn_y - q->turn_x * stem->pith.dx - q->turn_z * stem->pith.dz);
    a[2] = a[2] + stem->rho * q->turn_z;
  }
}

/* Rows of the map from surface to arc and rho of the reference section; in a knot,
 * to its own. */
INLINE void section_rows(const block *k, vf a[3], vf b[3]) {
  section_arc_row(k, a);
  for (int c = 0; c < 3; c++) b[c] = k->b[c];
  if (!k->knot) return;
  vm in = gt(k->knot->inside, splat(0.0f));
  for (int c = 0; c < 3; c++) {
    a[c] = sel(in, k->knot->round[c], a[c]);
    b[c] = sel(in, k->knot->out[c], b[c]);
  }
}

/* The footprint over them. */
INLINE footprint2 footprint_in_section(const wood_constants *w, int boards, const wood_io *io,
                                       const block *k) {
  vf a[3], b[3];
  section_rows(k, a, b);
  if (boards && w->plies.count) {
    ply_squeeze(&k->board, a);
    ply_squeeze(&k->board, b);
  }
  return footprint_through(a, b, k->nrm, !io->in->normal[0], k->s);
}

/* The same where stage_reach has seen to rho. */
INLINE footprint2 footprint_after_reach(const wood_constants *w, int boards, const wood_io *io,
                                        const block *k) {
  if (!reach_is_plain(w, boards, k)) return footprint_in_section(w, boards, io, k);
  int ball = !io->in->normal[0];
  vf a[3], an, q = k->s * k->s;
  section_arc_row(k, a);
  footprint2 f = {footprint_along(a, k->nrm, ball, &an) * q, a[0] * k->b[0], k->section.f.bb};
  f.ab = f.ab + a[1] * k->b[1] + a[2] * k->b[2];
  if (!ball) f.ab = f.ab - an * k->bn;
  f.ab = f.ab * q;
  return f;
}

/* By how much less the arc shears along rho in the bolt. */
INLINE vf bolt_shear(const block *k) {
  vf rho = k->stem.rho, turn = k->in.d * k->divisor;
  vf shear = rho * ((k->in.d_t * k->ring.inverse_width - turn * rho * k->divisor) * k->divisor);
  return k->knot ? sel(gt(k->knot->inside, splat(0.0f)), splat(0.0f), shear) : shear;
}

/* With the arc's row changed by so much of rho's. */
INLINE footprint2 footprint_in_bolt(const footprint2 *f, vf shear) {
  vf ab = f->ab + shear * f->bb;
  return (footprint2){vmax(f->aa + shear * (f->ab + ab), splat(0.0f)), ab, f->bb};
}

INLINE void stage_section_footprint(const wood_constants *w, int boards, const wood_io *io,
                                    block *k) {
  k->section.f = footprint_after_reach(w, boards, io, k);
  if (k->in.moved) k->bolt.f = footprint_in_bolt(&k->section.f, bolt_shear(k));
}

#endif
