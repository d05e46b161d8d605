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

#include "../core/noise.h"
#include "stone.h"

#define CELLS_JITTER 0.86f /* of the lattice cell; more, and a neighbour's neighbour counts */

/* A cell near the point: where its centre is from there, and its hash. */
typedef struct {
  vf x[3], d;
  vu h;
  vi at[3];
} cells_near;

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

/* The hash of the block of 4^3 that a place on the lattice is in. */
INLINE vu cells_block(const stone_cells *c, vi x, vi y, vi z) {
  return hash_mix((vu)(x >> 2) * splatu(HASH_X) + (vu)(y >> 2) * splatu(HASH_Y) +
                  (vu)(z >> 2) * splatu(HASH_Z) + splatu(c->seed ^ 0x5bd1e995u));
}

/* What a cell's mineral goes by, below c->chance: 0..1, evenly spread over the
 * cells of a block of 4^3. Where minerals cluster, a block is rich or poor, and so are
 * blocks aslant of it, that no rows be seen: a share times 1 - c, 1 or 1 + c. */
INLINE vf cells_rank(const stone_cells *c, const vi at[3]) {
  vu b = cells_block(c, at[0], at[1], at[2]);
  const vi r0 = splati((int32_t)0xd1b54a33u), r1 = splati((int32_t)0xabc98389u),
           r2 = splati((int32_t)0x8cb92ba7u);
  vm turn = eqi((vi)(b & splatu(1u)), splati(1)), swap = eqi((vi)(b & splatu(2u)), splati(2));
  vi x = seli(turn, at[1], at[0]), y = seli(turn, at[2], at[1]), z = seli(turn, at[0], at[2]);
  vi flip = (vi)((b >> 2) & splatu(3u));
  x = seli(swap, splati(0) - x, x);
  y = seli(eqi(flip & splati(1), splati(1)), splati(0) - y, y);
  z = seli(eqi(flip & splati(2), splati(2)), splati(0) - z, z);
  vu rank = (vu)(x * r0) + (vu)(y * r1) + (vu)(z * r2) + (b & splatu(0xfffffff0u));
  vf u = to_float((vi)(rank >> 8)) * splat(1.0f / 16777216.0f);
  if (c->cluster == 0.0f) return u;
  vu other = cells_block(c, at[0] + at[1], at[1] + at[2], at[2] + at[0]);
  vu rich = (b >> 31) + (other >> 31);
  return u / (splat(1.0f - c->cluster) + splat(c->cluster) * to_float((vi)rich));
}

/* mm to cells. The lattice stands aslant, so that no face shows its rows. */
INLINE void cells_turn(const stone_cells *c, const vf v[3], vf out[3]) {
  for (int k = 0; k < 3; k++) {
    const float *row = c->turn[k];
    out[k] = splat(row[0]) * v[0] + splat(row[1]) * v[1] + splat(row[2]) * v[2];
  }
}

/* Bends the cells' faces: moves a point, in cells, by two noises, of the finer of which
 * `finer` is left. They are as good for what is uneven within a crystal: their sum, within
 * +-1.5 or so, mean 0. */
STAGE vf cells_bend(const stone_cells *c, vf finer, vf q[3]) {
  if (c->warp == 0.0f) return splat(0.0f);
  const vf at[3] = {q[0], q[1], q[2]}, coarse = splat(1.15f), fine = splat(3.1f);
  vf g[3];
  vf sum = noise_gradient3(at[0] * coarse, at[1] * coarse, at[2] * coarse, splatu(c->seed_warp), g);
  for (int k = 0; k < 3; k++) q[k] = q[k] + splat(c->warp) * g[k];
  if (!any(gt(finer, splat(0.0f)))) return sum;
  vf b = noise_gradient3(at[0] * fine, at[1] * fine, at[2] * fine, splatu(c->seed_warp + 1u), g);
  for (int k = 0; k < 3; k++) q[k] = q[k] + finer * splat(c->warp_fine) * g[k];
  return sum + finer * b;
}

/* A point in cells, their faces bent. */
INLINE void cells_place(const stone_cells *c, const vf p[3], vf q[3]) {
  cells_turn(c, p, q);
  (void)cells_bend(c, splat(1.0f), q);
}

#endif
