/* SPDX-License-Identifier: Apache-2.0
 *
 * A layer of cells under a footprint: a look where it is small, looks side by side
 * or a sum over bodies where it is not, and past what those reach the mean.
 */
#ifndef SOZAI_STONE_FOOTPRINT_H
#define SOZAI_STONE_FOOTPRINT_H

#include "bodies.h"
#include "crystals.h"

/* Shares of a footprint: kinds 1 and 2, and all kinds with their brightness. */
typedef struct {
  vf cover[2], toned[3];
} cells_cover;

/* The mineral of a cell: shares of kinds 1 and 2, and all with their brightness.
 * uneven: that within the cell, of kinds 0 and 2, and of kind 1. */
INLINE void cells_add(const stone_cells *c, vu h, const vi at[3], vf share, const vf uneven[2],
                      cells_cover *out) {
  vf u = cells_rank(c, at), zero = splat(0.0f);
  vf own = splat(c->variation / HASH_ONE) * hash_signed(h + splatu(HASH_Y));
  vf tone = uneven[0] + own, tone1 = uneven[1] + own;
  vm first = lt(u, splat(c->chance[0])), second = and_(lt(u, splat(c->chance[1])), not_(first));
  vf a = sel(first, share, zero), b = sel(second, share, zero);
  out->cover[0] = out->cover[0] + a;
  out->cover[1] = out->cover[1] + b;
  out->toned[0] = out->toned[0] + (share - a - b) * tone;
  out->toned[1] = out->toned[1] + a * tone1;
  out->toned[2] = out->toned[2] + b * tone;
}

/* A square well below a cell's size: the two cells that it meets. wide: its longer
 * side. nearest: the cell that its middle is in. */
INLINE void cells_look(const stone_cells *c, const vf p[3], const cells_square *s, vf wide,
                       cells_cover *out, vu *nearest) {
  vf straight[3], q[3], share[2], one = splat(1.0f);
  cells_turn(c, p, straight);
  for (int k = 0; k < 3; k++) q[k] = straight[k];
  vf cloud = cells_bend(c, q), uneven = cloud * splat(1.3f * c->variation) + one;
  cells_near near[2];
  cells_find(c, q, &near[0], &near[1]);
  cells_shares(c, &near[0], &near[1], s, &share[0], &share[1]);
  int textured = crystal_textured(c);
  crystal_noise inner;
  if (textured) inner = crystal_at(c, straight, s, wide, cloud);
  for (int n = 0; n < 2; n++) {
    vf tone[2] = {uneven, uneven};
    if (textured) {
      crystal_tones(c, &inner, near[n].h, straight, s, tone);
      for (int k = 0; k < 2; k++) tone[k] = vmax(tone[k] + uneven, splat(0.0f));
    }
    cells_add(c, near[n].h, near[n].at, share[n], tone, out);
  }
  *nearest = near[0].h;
}

/* A square of a cell's size or so: the plane cuts discs from the bodies, taken
 * for balls of their volume, and a disc for a square of its area. What lies
 * over an edge of the square the neighbouring square has the rest of, so that
 * squares side by side count every body once. The balls' area stands to the
 * bodies' as `even` says, which is measured at creation. */
INLINE void cells_sum(const stone_cells *c, const vf p[3], const cells_square *s,
                      cells_cover *out) {
  vf q[3], f[3], n[3], zero = splat(0.0f), one = splat(1.0f);
  cells_turn(c, p, q);
  vi whole[3];
  for (int k = 0; k < 3; k++) f[k] = q[k] - vfloor(q[k], &whole[k]);
  for (int k = 0; k < 3; k++) {
    int i = (k + 1) % 3, j = (k + 2) % 3;
    n[k] = s->u[i] * s->v[j] - s->u[j] * s->v[i];
  }
  vf nn = inverse_root(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] + splat(1e-20f));
  vf uu = s->u[0] * s->u[0] + s->u[1] * s->u[1] + s->u[2] * s->u[2] + splat(1e-12f);
  vf vv = s->v[0] * s->v[0] + s->v[1] * s->v[1] + s->v[2] * s->v[2] + splat(1e-12f);
  vf iu = inverse_root(uu), iv = inverse_root(vv);
  vu at = (vu)whole[0] * splatu(HASH_X) + (vu)whole[1] * splatu(HASH_Y) +
          (vu)whole[2] * splatu(HASH_Z) + splatu(c->seed);
  const vf even[2] = {one, one};
  UNROLL(27)
  for (int m = 0; m < 27; m++) {
    int dx = m % 3 - 1, dy = m / 3 % 3 - 1, dz = m / 9 - 1;
    vu h = hash_mix(at +
                    splatu((uint32_t)dx * HASH_X + (uint32_t)dy * HASH_Y + (uint32_t)dz * HASH_Z));
    vf x[3];
    cells_centre(h, f, dx, dy, dz, x);
    vf r = splat(0.62f) - splat(1.1f) * cells_erosion(c, h);
    if (c->radius < 4.0f) r = vmin(r, cells_radius(c, h));
    vf d = (x[0] * n[0] + x[1] * n[1] + x[2] * n[2]) * nn;
    vf r2 = r * vabs(r) - d * d;
    vm met = gt(r2, zero);
    if (!any(met)) continue; /* they would add nothing */
    vf half = splat(0.886227f) * vsqrt(vmax(r2, zero));
    vf a = (x[0] * s->u[0] + x[1] * s->u[1] + x[2] * s->u[2]) * iu * iu;
    vf b = (x[0] * s->v[0] + x[1] * s->v[1] + x[2] * s->v[2]) * iv * iv;
    vf share = splat(c->even) * cells_overlap(a, half * iu) * cells_overlap(b, half * iv);
    const vi cell[3] = {whole[0] + splati(dx), whole[1] + splati(dy), whole[2] + splati(dz)};
    cells_add(c, h, cell, sel(met, share, zero), even, out);
  }
}

#define CELLS_STEPS 6 /* along a side of the footprint, at most */

/* Over a footprint: as many looks or sums as it takes, and past what those
 * reach the expected shares. t1, t2: the square's sides, unit; s: mm. Whether one look
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
  vf wide[2] = {cells_length(all.u), cells_length(all.v)}, n[2], inverse[2];
  vf most = vmax(wide[0], wide[1]);
  vf keep = one - smooth_step(splat(c->fade), splat(2.0f * c->fade), most);
  vm summed = c->shaped ? gt(most, splat(1.3f)) : lt(one, zero);
  for (int k = 0; k < 2; k++) {
    vi whole;
    vf looks = vfloor(wide[k] * splat(c->looks) + splat(1.4f), &whole);
    vf sums = vfloor(wide[k] + splat(0.9f), &whole);
    n[k] = clamp(sel(summed, sums, looks), one, splat(CELLS_STEPS));
    inverse[k] = one / n[k];
  }
  for (int k = 0; k < 3; k++) {
    part.u[k] = all.u[k] * inverse[0];
    part.v[k] = all.v[k] * inverse[1];
  }
  vf part_wide = vmax(cells_length(part.u), cells_length(part.v));
  cells_cover sum = {{zero, zero}, {zero, zero, zero}};
  vm seen = gt(keep, zero), more = gt(n[0] * n[1], one);
  int once = !any(or_(or_(more, summed), not_(seen)));
  for (int j = 0; j < CELLS_STEPS; j++) {
    vm row = and_(seen, lt(splat((float)j), n[1]));
    if (!any(row)) break;
    vf v = (splat((float)j + 0.5f) * inverse[1] - splat(0.5f)) * s;
    for (int i = 0; i < CELLS_STEPS; i++) {
      vm there = and_(row, lt(splat((float)i), n[0]));
      if (!any(there)) break;
      vf u = (splat((float)i + 0.5f) * inverse[0] - splat(0.5f)) * s, at[3];
      for (int k = 0; k < 3; k++) at[k] = p[k] + t1[k] * u + t2[k] * v;
      cells_cover look = {{zero, zero}, {zero, zero, zero}}, whole = look;
      if (any(and_(there, not_(summed)))) cells_look(c, at, &part, part_wide, &look, nearest);
      if (c->shaped && any(and_(there, summed))) cells_sum(c, at, &part, &whole);
      for (int k = 0; k < 2; k++) {
        vf x = sum.cover[k] + sel(summed, whole.cover[k], look.cover[k]);
        sum.cover[k] = sel(there, x, sum.cover[k]);
      }
      for (int k = 0; k < 3; k++) {
        vf x = sum.toned[k] + sel(summed, whole.toned[k], look.toned[k]);
        sum.toned[k] = sel(there, x, sum.toned[k]);
      }
    }
  }
  vf each = inverse[0] * inverse[1];
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
