/* SPDX-License-Identifier: Apache-2.0
 *
 * A layer of cells under a footprint: a look where it is small, looks side by side
 * where it is not, and past what those reach the mean.
 */
#ifndef SOZAI_STONE_FOOTPRINT_H
#define SOZAI_STONE_FOOTPRINT_H

#include "bodies.h"
#include "crystals.h"

/* Shares of a footprint: kinds 1 and 2, and all kinds with their brightness. */
typedef struct {
  vf cover[2], toned[3];
} cells_cover;

INLINE cells_cover cells_none(void) {
  vf zero = splat(0.0f);
  return (cells_cover){{zero, zero}, {zero, zero, zero}};
}

/* Whether a cell's mineral is of kind 1, or of kind 2. */
typedef struct {
  vm first, second;
} cells_kind;

INLINE cells_kind cells_kind_of(const stone_cells *c, const vi at[3]) {
  vf u = cells_rank(c, at);
  vm first = lt(u, splat(c->chance[0]));
  return (cells_kind){first, and_(lt(u, splat(c->chance[1])), not_(first))};
}

/* A cell's share goes to its mineral, and with the cell's brightness. uneven: that
 * within the cell, of kinds 0 and 2, and of kind 1. */
INLINE void cells_add(const stone_cells *c, vu h, const cells_kind *kind, vf share,
                      const vf uneven[2], cells_cover *out) {
  vf zero = splat(0.0f);
  vf own = splat(c->variation / HASH_ONE) * hash_signed(h + splatu(HASH_Y));
  vf tone = uneven[0] + own, tone1 = uneven[1] + own;
  vf a = sel(kind->first, share, zero), b = sel(kind->second, share, zero);
  out->cover[0] = out->cover[0] + a;
  out->cover[1] = out->cover[1] + b;
  out->toned[0] = out->toned[0] + (share - a - b) * tone;
  out->toned[1] = out->toned[1] + a * tone1;
  out->toned[2] = out->toned[2] + b * tone;
}

/* A square well below a cell's size: the two cells that it meets. wide: its longer
 * side; fine: how much of the faces' finer bends is left. nearest: the cell that its
 * middle is in. Of bodies, those of kind 0 are not there, and nobody asks for toned[0]. */
INLINE void cells_look(const stone_cells *c, const vf p[3], const cells_square *s, vf wide, vf fine,
                       cells_cover *out, vu *nearest) {
  vf straight[3], q[3], share[2], one = splat(1.0f), zero = splat(0.0f);
  cells_turn(c, p, straight);
  for (int k = 0; k < 3; k++) q[k] = straight[k];
  vf cloud = cells_bend(c, fine, q), uneven = cloud * splat(1.3f * c->variation) + one;
  cells_near near[2];
  cells_find(c, q, &near[0], &near[1]);
  *nearest = near[0].h;
  cells_kind kind[2];
  vm there[2];
  for (int n = 0; n < 2; n++) {
    kind[n] = cells_kind_of(c, near[n].at);
    there[n] = c->shaped ? or_(kind[n].first, kind[n].second) : le(zero, one);
  }
  if (!any(or_(there[0], there[1]))) return;
  cells_shares(c, &near[0], &near[1], s, &share[0], &share[1]);
  int textured = crystal_textured(c);
  crystal_noise inner;
  if (textured) inner = crystal_at(c, straight, s, wide, cloud);
  for (int n = 0; n < 2; n++) {
    if (!any(and_(there[n], gt(share[n], zero)))) continue;
    vf tone[2] = {uneven, uneven};
    if (textured) {
      crystal_tones(c, &inner, near[n].h, straight, s, tone);
      for (int k = 0; k < 2; k++) tone[k] = vmax(tone[k] + uneven, zero);
    }
    cells_add(c, near[n].h, &kind[n], share[n], tone, out);
  }
}

#define CELLS_STEPS 6        /* looks along a side of the footprint, at most */
#define CELLS_FINE 1.5f      /* cells: wider footprints do not tell the finer of the faces' bends */
#define CELLS_LOOK_MOST 0.5f /* cells: a look at bodies sees past all of their faces but one */

/* Over a footprint: as many looks as it takes, and past what those reach the
 * expected shares. t1, t2: the square's sides, unit; s: mm. Whether one look
 * at the point itself was all; then nearest is the cell that it is in. */
STAGE int cells_at(const stone_cells *c, const vf p[3], const vf t1[3], const vf t2[3], vf s,
                   cells_cover *out, vu *nearest) {
  vf zero = splat(0.0f), one = splat(1.0f);
  cells_square all, part;
  cells_turn(c, t1, all.u);
  cells_turn(c, t2, all.v);
  for (int k = 0; k < 3; k++) {
    all.u[k] = all.u[k] * s;
    all.v[k] = all.v[k] * s;
  }
  vf wide[2] = {cells_length(all.u), cells_length(all.v)}, n[2], inverse[2], side[2];
  vf most = vmax(wide[0], wide[1]);
  vf keep = one - smooth_step(splat(c->fade), splat(2.0f * c->fade), most);
  vf fine = one - smooth_step(splat(CELLS_FINE), splat(1.5f * CELLS_FINE), most);
  for (int k = 0; k < 2; k++) {
    vi whole;
    vf dense = splat(c->looks) / (one + splat(0.12f) * wide[k]);
    vf looks = vfloor(wide[k] * dense + splat(1.4f), &whole);
    n[k] = clamp(looks, one, splat(CELLS_STEPS));
    inverse[k] = side[k] = one / n[k];
    if (c->shaped) {
      side[k] = vmin(side[k], splat(CELLS_LOOK_MOST) / vmax(wide[k], splat(CELLS_LOOK_MOST)));
    }
  }
  for (int k = 0; k < 3; k++) {
    part.u[k] = all.u[k] * side[0];
    part.v[k] = all.v[k] * side[1];
  }
  vf part_wide = vmax(cells_length(part.u), cells_length(part.v));
  cells_cover sum = cells_none();
  vm seen = gt(keep, zero), more = gt(n[0] * n[1], one);
  int once = !any(or_(more, not_(seen)));
  for (int j = 0; j < CELLS_STEPS; j++) {
    vm row = and_(seen, lt(splat((float)j), n[1]));
    if (!any(row)) break;
    vf v = (splat((float)j + 0.5f) * inverse[1] - splat(0.5f)) * s;
    for (int i = 0; i < CELLS_STEPS; i++) {
      vm there = and_(row, lt(splat((float)i), n[0]));
      if (!any(there)) break;
      vf u = (splat((float)i + 0.5f) * inverse[0] - splat(0.5f)) * s, at[3];
      for (int k = 0; k < 3; k++) at[k] = p[k] + t1[k] * u + t2[k] * v;
      cells_cover look = cells_none();
      cells_look(c, at, &part, part_wide, fine, &look, nearest);
      for (int k = 0; k < 2; k++) {
        sum.cover[k] = sel(there, sum.cover[k] + look.cover[k], sum.cover[k]);
      }
      for (int k = 0; k < 3; k++) {
        sum.toned[k] = sel(there, sum.toned[k] + look.toned[k], sum.toned[k]);
      }
    }
  }
  vf each = inverse[0] * inverse[1];
  if (c->shaped) {
    vf at = part_wide * splat(1.0f / CELLS_LOOK_MOST);
    each = each / (one + splat(c->swell) * at * at);
  }
  for (int k = 0; k < 2; k++) {
    vf mean = splat(c->mean[k]);
    out->cover[k] = sel(seen, mix(mean, sum.cover[k] * each, keep), mean);
  }
  for (int k = 0; k < 3; k++) {
    vf mean = splat(k ? c->mean[k - 1] : 1.0f - c->mean[0] - c->mean[1]);
    out->toned[k] = sel(seen, mix(mean, sum.toned[k] * each, keep), mean);
  }
  return once;
}

#endif
