/* SPDX-License-Identifier: Apache-2.0
 *
 * Layers of cells: crystals that fill space, and bodies within it.
 *
 * A power diagram (Laguerre's: Aurenhammer, Power diagrams, SIAM J. Comput. 16,
 * 1987) of jittered lattice points: faces are planes, as of crystals that grew
 * until they met, and weights make some larger. A noise then bends the faces,
 * as the crystals of granite interlock.
 *
 * Which mineral a cell is goes by a rank that is spread evenly over every 4^3
 * cells (Roberts's generalised golden ratio in three dimensions, turned and
 * shifted at random from block to block): proportions hold over a small area as
 * modal analysis finds them to, and a wide footprint sees little else than the
 * mean.
 */
#ifndef SOZAI_STONE_CELLS_H
#define SOZAI_STONE_CELLS_H

#include "../core/filter.h"
#include "../core/noise.h"
#include "crystals.h"
#include "stone.h"

#define CELLS_REACH 0.5f   /* cells: the width of what shows through a border from behind it */
#define CELLS_JITTER 0.86f /* of the lattice cell; more, and a neighbour's neighbour counts */

/* Shares of a footprint: kinds 1 and 2, and all kinds with their brightness. */
typedef struct {
  vf cover[2], toned[3];
} cells_cover;

/* A cell near the point: where its centre is from there, and its hash. */
typedef struct {
  vf x[3], d;
  vu h;
  vi at[3];
} cells_near;

/* The footprint: two sides of the square, in cells. */
typedef struct {
  vf u[3], v[3];
} cells_square;

INLINE void cells_centre(vu h, const vf f[3], int dx, int dy, int dz, vf x[3]) {
  const float k = CELLS_JITTER / 1023.0f, o = 0.5f - 0.5f * CELLS_JITTER;
  x[0] = to_float((vi)(h >> 22)) * splat(k) + (splat((float)dx + o) - f[0]);
  x[1] = to_float((vi)((h >> 12) & splatu(1023u))) * splat(k) + (splat((float)dy + o) - f[1]);
  x[2] = to_float((vi)((h >> 2) & splatu(1023u))) * splat(k) + (splat((float)dz + o) - f[2]);
}

/* Cell n of the 27 about a point, 0 to 26: how many cells on it is. */
INLINE void cells_step(vi n, vi d[3]) {
  /* n / 9 and n / 3 of small numbers */
  vi z = (n * splati(57)) >> 9, rest = n - z * splati(9);
  vi y = (rest * splati(11)) >> 5, x = rest - y * splati(3);
  d[0] = x - splati(1);
  d[1] = y - splati(1);
  d[2] = z - splati(1);
}

/* The nearest two, by power distance, of the 27 cells about the point. Which cell
 * it is stands in the lowest bits of its distance, 4e-6 of it: then two minima and
 * a maximum keep the two, where cells' numbers and hashes would take a choice each. */
STAGE void cells_find(const stone_cells *c, const vf q[3], cells_near *first, cells_near *second) {
  vf f[3];
  vi whole[3];
  for (int k = 0; k < 3; k++) f[k] = q[k] - vfloor(q[k], &whole[k]);
  vf d1 = splat(1e30f), d2 = d1, weight = splat(c->grading / 63.0f);
  vu at = (vu)whole[0] * splatu(HASH_X) + (vu)whole[1] * splatu(HASH_Y) +
          (vu)whole[2] * splatu(HASH_Z) + splatu(c->seed);
  UNROLL(27)
  for (int n = 0; n < 27; n++) {
    int dx = n % 3 - 1, dy = n / 3 % 3 - 1, dz = n / 9 - 1;
    vu h = hash_mix(at +
                    splatu((uint32_t)dx * HASH_X + (uint32_t)dy * HASH_Y + (uint32_t)dz * HASH_Z));
    vf x[3];
    cells_centre(h, f, dx, dy, dz, x);
    vf d = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + to_float((vi)(h & splatu(63u))) * weight;
    /* never denormal, which some hosts have flushed to zero */
    vf key = float_of((bits_of(d + splat(1e-6f)) & splati(~31)) | splati(n));
    d2 = vmin(d2, vmax(d1, key));
    d1 = vmin(d1, key);
  }
  cells_near *out[2] = {first, second};
  const vf key[2] = {d1, d2};
  for (int k = 0; k < 2; k++) {
    cells_near *o = out[k];
    vi d[3];
    cells_step(bits_of(key[k]) & splati(31), d);
    vu h = hash_mix(at + (vu)d[0] * splatu(HASH_X) + (vu)d[1] * splatu(HASH_Y) +
                    (vu)d[2] * splatu(HASH_Z));
    cells_centre(h, f, 0, 0, 0, o->x);
    for (int a = 0; a < 3; a++) {
      o->x[a] = o->x[a] + to_float(d[a]);
      o->at[a] = whole[a] + d[a];
    }
    o->d = o->x[0] * o->x[0] + o->x[1] * o->x[1] + o->x[2] * o->x[2] +
           to_float((vi)(h & splatu(63u))) * weight;
    o->h = h;
  }
}

/* 0..1, evenly spread over the cells of a block of 4^3. */
INLINE vf cells_rank(const stone_cells *c, const vi at[3]) {
  vu b = hash_mix((vu)(at[0] >> 2) * splatu(HASH_X) + (vu)(at[1] >> 2) * splatu(HASH_Y) +
                  (vu)(at[2] >> 2) * splatu(HASH_Z) + splatu(c->seed ^ 0x5bd1e995u));
  const vi r0 = splati((int32_t)0xd1b54a33u), r1 = splati((int32_t)0xabc98389u),
           r2 = splati((int32_t)0x8cb92ba7u);
  vm turn = eqi((vi)(b & splatu(1u)), splati(1)), swap = eqi((vi)(b & splatu(2u)), splati(2));
  vi x = seli(turn, at[1], at[0]), y = seli(turn, at[2], at[1]), z = seli(turn, at[0], at[2]);
  vi flip = (vi)((b >> 2) & splatu(3u));
  x = seli(swap, splati(0) - x, x);
  y = seli(eqi(flip & splati(1), splati(1)), splati(0) - y, y);
  z = seli(eqi(flip & splati(2), splati(2)), splati(0) - z, z);
  vu rank = (vu)(x * r0) + (vu)(y * r1) + (vu)(z * r2) + (b & splatu(0xfffffff0u));
  return to_float((vi)(rank >> 8)) * splat(1.0f / 16777216.0f);
}

/* The extent over the square of a number that changes by g to a cell. */
INLINE vf cells_extent2(const cells_square *s, const vf g[3], float blur) {
  vf u = g[0] * s->u[0] + g[1] * s->u[1] + g[2] * s->u[2];
  vf v = g[0] * s->v[0] + g[1] * s->v[1] + g[2] * s->v[2];
  vf all = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
  return u * u + v * v + all * splat(blur * blur) + splat(1e-12f);
}

/* How far a body's faces lie within its cell's. */
INLINE vf cells_erosion(const stone_cells *c, vu h) {
  vf u = to_float((vi)(hash_mix(h ^ splatu(0x7feb3c5du)) >> 8)) * splat(1.0f / 16777216.0f);
  return splat(c->erode) + splat(c->erode_spread) * u;
}

INLINE vf cells_radius(const stone_cells *c, vu h) {
  vf u = to_float((vi)(hash_mix(h ^ splatu(0x2545f491u)) >> 8)) * splat(1.0f / 16777216.0f);
  return splat(c->radius) * (splat(1.0f) - splat(c->radius_spread) * u);
}

/* How much of the ball about a cell's centre the square shows. */
INLINE vf cells_ball(const stone_cells *c, const cells_near *n, const cells_square *s) {
  vf radius = cells_radius(c, n->h);
  vf r2 = n->x[0] * n->x[0] + n->x[1] * n->x[1] + n->x[2] * n->x[2] + splat(1e-12f);
  vf k = inverse_root(r2);
  vf e = vsqrt(cells_extent2(s, n->x, c->blur)) * k;
  return clamp01(splat(0.5f) + (radius - r2 * k) / e);
}

/* A square no larger than about a cell: of the nearest two cells, how much each
 * has of it. Exact for a plane between two. */
INLINE void cells_shares(const stone_cells *c, const cells_near *a, const cells_near *b,
                         const cells_square *s, vf *first, vf *second) {
  vf g[3];
  for (int k = 0; k < 3; k++) g[k] = splat(2.0f) * (a->x[k] - b->x[k]);
  vf length2 = g[0] * g[0] + g[1] * g[1] + g[2] * g[2] + splat(1e-12f);
  vf e = inverse_root(cells_extent2(s, g, c->blur));
  vf t = (b->d - a->d) * e;
  if (!c->shaped) {
    *first = clamp01(splat(0.5f) + t);
    if (c->depth > 0.0f) {
      /* light that has gone on behind the border */
      vf far = inverse_root(cells_extent2(s, g, CELLS_REACH));
      *first = mix(*first, clamp01(splat(0.5f) + (b->d - a->d) * far), splat(c->depth));
    }
    *second = splat(1.0f) - *first;
    return;
  }
  vf shift = length2 * inverse_root(length2) * e;
  *first = clamp01(splat(0.5f) + t - shift * cells_erosion(c, a->h));
  *second = clamp01(splat(0.5f) - t - shift * cells_erosion(c, b->h));
  if (c->radius < 4.0f) {
    *first = vmin(*first, cells_ball(c, a, s));
    *second = vmin(*second, cells_ball(c, b, s));
  }
}

/* mm to cells. The lattice stands aslant, so that no face shows its rows. */
INLINE void cells_turn(const stone_cells *c, const vf v[3], vf out[3]) {
  for (int k = 0; k < 3; k++) {
    const float *row = c->turn[k];
    out[k] = splat(row[0]) * v[0] + splat(row[1]) * v[1] + splat(row[2]) * v[2];
  }
}

/* A point in cells, its faces bent. The noise that bends them is as good for
 * what is uneven within a crystal: within +-1.5 or so, mean 0. */
STAGE vf cells_place(const stone_cells *c, const vf p[3], vf q[3]) {
  cells_turn(c, p, q);
  if (c->warp == 0.0f) return splat(0.0f);
  vf g[3], fine[3];
  vf a = noise_gradient3(q[0] * splat(1.15f), q[1] * splat(1.15f), q[2] * splat(1.15f),
                         splatu(c->seed_warp), g);
  vf b = noise_gradient3(q[0] * splat(3.1f), q[1] * splat(3.1f), q[2] * splat(3.1f),
                         splatu(c->seed_warp + 1u), fine);
  for (int k = 0; k < 3; k++) {
    q[k] = q[k] + splat(c->warp) * g[k] + splat(c->warp_fine) * fine[k];
  }
  return a + b;
}

INLINE vf cells_length(const vf x[3]) { return vsqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]); }

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

/* A square well below a cell's size: the two cells that it meets. nearest: the one
 * that its middle is in. */
INLINE void cells_look(const stone_cells *c, const vf p[3], const cells_square *s, cells_cover *out,
                       vu *nearest) {
  vf q[3], share[2];
  vf cloud = cells_place(c, p, q), one = splat(1.0f);
  vf uneven = cloud * splat(1.3f * c->variation) + one;
  cells_near near[2];
  cells_find(c, q, &near[0], &near[1]);
  cells_shares(c, &near[0], &near[1], s, &share[0], &share[1]);
  crystal_square square = {{s->u[0], s->u[1], s->u[2]}, {s->v[0], s->v[1], s->v[2]}, one};
  crystal_noise inner;
  if (c->textured) {
    cells_turn(c, p, q);
    square.wide = vmax(cells_length(s->u), cells_length(s->v));
    inner = crystal_at(c, q, &square, cloud);
  }
  for (int n = 0; n < 2; n++) {
    vf tone[2] = {uneven, uneven};
    if (c->textured) {
      crystal_tones(c, &inner, near[n].h, q, &square, tone);
      for (int k = 0; k < 2; k++) tone[k] = vmax(tone[k] + uneven, splat(0.0f));
    }
    cells_add(c, near[n].h, near[n].at, share[n], tone, out);
  }
  *nearest = near[0].h;
}

/* How far x lies along a side of the square, in sides, and how much of the side
 * a body of half that width covers. */
INLINE vf cells_overlap(vf x, vf half) {
  vf high = vmin(x + half, splat(0.5f)), low = vmax(x - half, splat(-0.5f));
  return vmax(high - low, splat(0.0f));
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
      if (any(and_(there, not_(summed)))) cells_look(c, at, &part, &look, nearest);
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
