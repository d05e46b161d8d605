/* SPDX-License-Identifier: Apache-2.0
 *
 * Rings under a wide footprint on peeled veneer. Bent back round its log the sheet
 * all but follows the rings, and what takes it across them is how pith, outline and
 * undulation stray: over a few millimetres no longer by a straight line. So the
 * square is cut into parts, and the stem is asked at the middle of each.
 */
#ifndef SOZAI_WOOD_PLIES_WIDE_H
#define SOZAI_WOOD_PLIES_WIDE_H

#include "../figure.h"
#include "../rings_curved.h"
#include "../stages/block.h"

/* mm: footprints from which on there are parts, and from which on they are all there
 * is; where four give way to sixteen. */
#define WIDE_FROM 3.0f
#define WIDE_TO 6.0f
#define WIDER_FROM 12.0f
#define WIDER_TO 18.0f

/* Means over side x side parts. */
static __attribute__((noinline)) void wide_rings_grid(const wood_constants *w, vu own, int ball,
                                                      const block *k, int side,
                                                      vf mean[RING_MEANS]) {
  const vf *p = k->p, *n = k->nrm;
  vf axis_x = splat(w->peeled ? w->shift[0] : 0.0f), axis_z = splat(w->peeled ? w->shift[2] : 0.0f);
  vf px = p[0] - axis_x, pz = p[2] - axis_z;
  float share = 1.0f / (float)side;
  vf zero = splat(0.0f), one = splat(1.0f), part = splat(share) * k->board.bent;
  vf inverse_r = inverse_root(vmax(px * px + pz * pz, one)), rise = k->board.lead * inverse_r;
  /* the sheet's normal, which leans as its spiral rises */
  vf nx = n[0] + rise * pz * inverse_r, nz = n[2] - rise * px * inverse_r;
  for (int what = 0; what < RING_MEANS; what++) mean[what] = zero;
  for (int i = 0; i < side; i++) {
    vf s, c, along = splat((float)i - 0.5f * (float)(side - 1)) * part;
    sine_cosine(along * inverse_r, &s, &c);
    vf turned[3] = {c * nx - s * nz, n[1], c * nz + s * nx}, out = one + along * rise * inverse_r;
    vf x = (c * px - s * pz) * out + axis_x, z = (c * pz + s * px) * out + axis_z;
    for (int j = 0; j < side; j++) {
      vf y = p[1] + splat((float)j - 0.5f * (float)(side - 1)) * part;
      stem_place q;
      undulation_sum u = undulation_none();
      q.pith = pith_at(w, own, y, NULL);
      q.lost = q.lost_slope = q.eye = zero;
      stem_about(x, z, &q);
      for (int o = 0; o < 2; o++) {
        undulation_octave octave = undulation_octave_of(w, o);
        undulation_add(&octave, own, y, part, NULL, &q, &u);
      }
      figure_add(w, own, y, part, splat(share) * k->extent, &q, &u);
      stem_rho(w, y, &u, &q);
      vf row[3] = {q.rho_x, q.rho_y - q.rho_x * q.pith.dx - q.rho_z * q.pith.dz, q.rho_z};
      vf reach = rings_extent(&q, row, turned, ball, part);
      ring_place at = ring_at(w, q.rho);
      mean[MEAN_LATE] = mean[MEAN_LATE] + ring_average(w, MEAN_LATE, &at, q.rho, reach);
      if (w->pore_growth != 0.0f) {
        mean[MEAN_PORE] = mean[MEAN_PORE] + ring_average(w, MEAN_PORE, &at, q.rho, reach);
      }
      if (w->rows) mean[MEAN_ROW] = mean[MEAN_ROW] + ring_average(w, MEAN_ROW, &at, q.rho, reach);
      if (w->parenchyma.margin > 0.0f) {
        vf margin = ring_average(w, MEAN_MARGIN, &at, q.rho, reach);
        mean[MEAN_MARGIN] = mean[MEAN_MARGIN] + margin;
      }
    }
  }
  for (int what = 0; what < RING_MEANS; what++) mean[what] = mean[what] * splat(share * share);
}

/* For a block that has a wide one; `room` is where its means are kept. */
static __attribute__((noinline)) void wide_rings_of(const wood_constants *w, vu own, int ball,
                                                    block *k, wide_rings *room) {
  vf s = k->board.bent, zero = splat(0.0f), more[RING_MEANS];
  k->wide = room;
  room->share = smooth_step(splat(WIDE_FROM), splat(WIDE_TO), s);
  if (k->knot) {
    const knot_place *q = k->knot;
    room->share = sel(gt(q->near + q->cover + q->bark, zero), zero, room->share);
  }
  vm few = and_(gt(s, splat(WIDE_FROM)), lt(s, splat(WIDER_TO)));
  vm many = gt(s, splat(WIDER_FROM));
  for (int what = 0; what < RING_MEANS; what++) room->mean[what] = zero;
  if (any(few)) wide_rings_grid(w, own, ball, k, 2, room->mean);
  if (!any(many)) return;
  wide_rings_grid(w, own, ball, k, 4, more);
  vf wider = smooth_step(splat(WIDER_FROM), splat(WIDER_TO), s);
  for (int what = 0; what < RING_MEANS; what++) {
    vf both = mix(room->mean[what], more[what], wider);
    room->mean[what] = sel(many, sel(few, both, more[what]), room->mean[what]);
  }
}

/* `mean` as found by a straight line, and the parts' in its place. */
INLINE vf wide_rings_mean(int what, const block *k, vf mean) {
  const wide_rings *q = k->wide;
  return sel(gt(q->share, splat(0.0f)), mix(mean, q->mean[what], q->share), mean);
}

#endif
