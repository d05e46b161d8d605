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
#include "stone.h"

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

/* The nearest two, by power distance, of the 27 cells about the point. */
INLINE void cells_find(const stone_cells *c, const vf q[3], cells_near *first,
                       cells_near *second) {
  vf f[3];
  vi whole[3];
  for (int k = 0; k < 3; k++) f[k] = q[k] - vfloor(q[k], &whole[k]);
  vf d1 = splat(1e30f), d2 = d1, weight = splat(c->grading / 63.0f);
  vu h1 = splatu(0), h2 = h1;
  vi c1 = splati(13), c2 = c1;
  vu at = (vu)whole[0] * splatu(HASH_X) + (vu)whole[1] * splatu(HASH_Y) +
          (vu)whole[2] * splatu(HASH_Z) + splatu(c->seed);
  for (int n = 0; n < 27; n++) {
    int dx = n % 3 - 1, dy = n / 3 % 3 - 1, dz = n / 9 - 1;
    vu h = hash_mix(at + splatu((uint32_t)dx * HASH_X + (uint32_t)dy * HASH_Y +
                                (uint32_t)dz * HASH_Z));
    vf x[3];
    cells_centre(h, f, dx, dy, dz, x);
    vf d = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + to_float((vi)(h & splatu(63u))) * weight;
    vm nearest = lt(d, d1), near = lt(d, d2);
    d2 = sel(nearest, d1, sel(near, d, d2));
    h2 = (vu)seli(nearest, (vi)h1, seli(near, (vi)h, (vi)h2));
    c2 = seli(nearest, c1, seli(near, splati(n), c2));
    d1 = sel(nearest, d, d1);
    h1 = (vu)seli(nearest, (vi)h, (vi)h1);
    c1 = seli(nearest, splati(n), c1);
  }
  cells_near *out[2] = {first, second};
  const vi code[2] = {c1, c2};
  const vu hash[2] = {h1, h2};
  const vf distance[2] = {d1, d2};
  for (int k = 0; k < 2; k++) {
    /* n / 9 and n / 3 of small numbers */
    vi z = (code[k] * splati(57)) >> 9, rest = code[k] - z * splati(9);
    vi y = (rest * splati(11)) >> 5, x = rest - y * splati(3);
    const vi d[3] = {x - splati(1), y - splati(1), z - splati(1)};
    cells_centre(hash[k], f, 0, 0, 0, out[k]->x);
    for (int a = 0; a < 3; a++) {
      out[k]->x[a] = out[k]->x[a] + to_float(d[a]);
      out[k]->at[a] = whole[a] + d[a];
    }
    out[k]->d = distance[k];
    out[k]->h = hash[k];
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

/* How much of the ball about a cell's centre the square shows. */
INLINE vf cells_ball(const stone_cells *c, const cells_near *n, const cells_square *s) {
  vf u = to_float((vi)(hash_mix(n->h ^ splatu(0x2545f491u)) >> 8)) * splat(1.0f / 16777216.0f);
  vf radius = splat(c->radius) * (splat(1.0f) - splat(c->radius_spread) * u);
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
    *second = splat(1.0f) - *first;
    return;
  }
  vf shift = splat(c->erode) * length2 * inverse_root(length2) * e;
  *first = clamp01(splat(0.5f) + t - shift);
  *second = clamp01(splat(0.5f) - t - shift);
  if (c->radius < 4.0f) {
    *first = vmin(*first, cells_ball(c, a, s));
    *second = vmin(*second, cells_ball(c, b, s));
  }
}

/* A point in cells, its faces bent. */
INLINE void cells_place(const stone_cells *c, const vf p[3], vf q[3]) {
  for (int k = 0; k < 3; k++) q[k] = p[k] * splat(c->inverse_size);
  q[1] = q[1] * splat(c->across);
  if (c->warp == 0.0f) return;
  vf g[3], fine[3];
  noise_gradient3(q[0], q[1], q[2], splatu(c->seed_warp), g);
  noise_gradient3(q[0] * splat(3.1f), q[1] * splat(3.1f), q[2] * splat(3.1f),
                  splatu(c->seed_warp + 1u), fine);
  for (int k = 0; k < 3; k++) {
    q[k] = q[k] + splat(c->warp) * g[k] + splat(c->warp_fine) * fine[k];
  }
}

INLINE void cells_look(const stone_cells *c, const vf p[3], const cells_square *s,
                       cells_cover *out) {
  vf q[3], share[2], one = splat(1.0f), zero = splat(0.0f);
  cells_place(c, p, q);
  cells_near near[2];
  cells_find(c, q, &near[0], &near[1]);
  cells_shares(c, &near[0], &near[1], s, &share[0], &share[1]);
  for (int k = 0; k < 2; k++) out->cover[k] = zero;
  for (int k = 0; k < 3; k++) out->toned[k] = zero;
  for (int n = 0; n < 2; n++) {
    vf u = cells_rank(c, near[n].at);
    vf tone = one + splat(c->variation / HASH_ONE) * hash_signed(near[n].h + splatu(HASH_Y));
    vm one_of = lt(u, splat(c->chance[0]));
    vm two_of = and_(lt(u, splat(c->chance[1])), not_(one_of));
    vf a = sel(one_of, share[n], zero), b = sel(two_of, share[n], zero);
    out->cover[0] = out->cover[0] + a;
    out->cover[1] = out->cover[1] + b;
    out->toned[0] = out->toned[0] + (share[n] - a - b) * tone;
    out->toned[1] = out->toned[1] + a * tone;
    out->toned[2] = out->toned[2] + b * tone;
  }
}

#define CELLS_STEPS 6 /* looks along a side of the footprint, at most */

/* Over a footprint: as many looks as it is cells wide, and past what those
 * reach the expected shares. t1, t2: the square's sides, unit; s: mm. */
INLINE void cells_at(const stone_cells *c, const vf p[3], const vf t1[3], const vf t2[3], vf s,
                     cells_cover *out) {
  vf zero = splat(0.0f), one = splat(1.0f);
  vf wide = s * splat(c->inverse_size);
  vi whole;
  vf n = clamp(vfloor(wide * splat(1.25f) + splat(0.6f), &whole), one, splat(CELLS_STEPS));
  vf keep = one - smooth_step(splat(c->fade), splat(2.0f * c->fade), wide);
  const vf mean[5] = {splat(c->mean[0]), splat(c->mean[1]),
                      splat(1.0f - c->mean[0] - c->mean[1]), splat(c->mean[0]),
                      splat(c->mean[1])};
  vf sum[5] = {zero, zero, zero, zero, zero};
  vf inverse = one / n, h = s * inverse;
  vm seen = gt(keep, zero);
  if (any(seen)) {
    cells_square q;
    for (int k = 0; k < 3; k++) {
      vf scale = h * splat(k == 1 ? c->inverse_size * c->across : c->inverse_size);
      q.u[k] = t1[k] * scale;
      q.v[k] = t2[k] * scale;
    }
    for (int j = 0; j < CELLS_STEPS; j++) {
      vm row = and_(seen, lt(splat((float)j), n));
      if (!any(row)) break;
      vf v = (splat((float)j + 0.5f) - splat(0.5f) * n) * h;
      for (int i = 0; i < CELLS_STEPS; i++) {
        vm there = and_(row, lt(splat((float)i), n));
        if (!any(there)) break;
        vf u = (splat((float)i + 0.5f) - splat(0.5f) * n) * h, at[3];
        for (int k = 0; k < 3; k++) at[k] = p[k] + t1[k] * u + t2[k] * v;
        cells_cover look;
        cells_look(c, at, &q, &look);
        const vf part[5] = {look.cover[0], look.cover[1], look.toned[0], look.toned[1],
                            look.toned[2]};
        for (int k = 0; k < 5; k++) sum[k] = sel(there, sum[k] + part[k], sum[k]);
      }
    }
  }
  vf each = inverse * inverse;
  for (int k = 0; k < 5; k++) sum[k] = sel(seen, mix(mean[k], sum[k] * each, keep), mean[k]);
  out->cover[0] = sum[0];
  out->cover[1] = sum[1];
  for (int k = 0; k < 3; k++) out->toned[k] = sum[2 + k];
}

#endif
