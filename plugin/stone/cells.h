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

#include "stone.h"
#include "value.h"

#define CELLS_JITTER 0.86f /* of the lattice cell; more, and a neighbour's neighbour counts */

/* A cell near the point: where its centre is from there, and its hash. */
typedef struct {
  vf x[3], d;
  vu h;
  vi at[3];
} cells_near;

/* Where the centre is of a cell whose middle is `from` away: ten bits of the hash to
 * an axis, and more below them that do no harm. */
INLINE void cells_centre(vu h, vf x, vf y, vf z, vf out[3]) {
  const vf k = splat(0.5f * CELLS_JITTER / HASH_ONE);
  out[0] = to_float((vi)h) * k + x;
  out[1] = to_float((vi)(h << 10)) * k + y;
  out[2] = to_float((vi)(h << 20)) * k + z;
}

/* A cell's weight, 0 or more, and a little, so that no distance is denormal, which
 * some hosts have flushed to zero. */
INLINE vf cells_weight(const stone_cells *c, vu h) {
  float half = 0.5f * c->grading;
  return to_float((vi)(h << 5)) * splat(half / HASH_ONE) + splat(half + 1e-6f);
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

/* Along each axis the point's own cell, its neighbour on the nearer side and that on
 * the further: from the point to their middles, their parts of the hash, and of the
 * number among the 27. */
typedef struct {
  vf from[3][3];
  vu hash[3][3];
  vi number[3][3];
} cells_about;

INLINE void cells_look_about(const stone_cells *c, const vf q[3], vi whole[3], cells_about *a) {
  static const uint32_t prime[3] = {HASH_X, HASH_Y, HASH_Z};
  static const int32_t stride[3] = {1, 3, 9};
  for (int k = 0; k < 3; k++) {
    vf o = splat(0.5f) - (q[k] - vfloor(q[k], &whole[k]));
    vm up = lt(o, splat(0.0f));
    vf t = sel(up, splat(1.0f), splat(-1.0f));
    vu own = (vu)whole[k] * splatu(prime[k]) + splatu(k ? 0u : c->seed);
    vu step = (vu)seli(up, splati((int32_t)prime[k]), splati((int32_t)(0u - prime[k])));
    vi on = seli(up, splati(stride[k]), splati(-stride[k])), none = splati(k ? 0 : 13);
    a->from[k][0] = o;
    a->from[k][1] = o + t;
    a->from[k][2] = o - t;
    a->hash[k][0] = own;
    a->hash[k][1] = own + step;
    a->hash[k][2] = own - step;
    a->number[k][0] = none;
    a->number[k][1] = none + on;
    a->number[k][2] = none - on;
  }
}

/* Cell x, y, z of those, 0 to 2 along each axis: its number stands in the lowest bits
 * of its distance, 4e-6 of it. Then two minima and a maximum keep the nearest two,
 * where cells' numbers and hashes would take a choice each. */
INLINE void cells_try(const stone_cells *c, int graded, const cells_about *a, int x, int y, int z,
                      vf *d1, vf *d2) {
  vu h = hash_upper(a->hash[0][x] + a->hash[1][y] + a->hash[2][z]);
  vf at[3];
  cells_centre(h, a->from[0][x], a->from[1][y], a->from[2][z], at);
  vf d =
      at[0] * at[0] + at[1] * at[1] + at[2] * at[2] + (graded ? cells_weight(c, h) : splat(1e-6f));
  vi n = a->number[0][x] + a->number[1][y] + a->number[2][z];
  vf key = float_of((bits_of(d) & splati(~31)) | n);
  *d2 = vmin(*d2, vmax(*d1, key));
  *d1 = vmin(*d1, key);
}

INLINE int cells_further(int n) { return (n % 3 == 2) + (n / 3 % 3 == 2) + (n / 9 == 2); }

/* Those of the 27 of which `further` says so. */
#define CELLS_TRY_ALL(which)                                                                       \
  UNROLL(27)                                                                                       \
  for (int n = 0; n < 27; n++) {                                                                   \
    if (which) cells_try(c, graded, a, n % 3, n / 3 % 3, n / 9, d1, d2);                           \
  }

INLINE void cells_nearest(const stone_cells *c, int graded, const cells_about *a, vf *d1, vf *d2) {
  CELLS_TRY_ALL(cells_further(n) == 0)
  /* No cell on the further side is nearer than the square of the distance there; nor
   * one that is further along two axes than the sum of two, of which the least count. */
  vf square[3], sum = splat(0.0f), most = sum;
  for (int k = 0; k < 3; k++) {
    vf far = vabs(a->from[k][0]) + splat(1.0f - 0.5f * CELLS_JITTER);
    square[k] = far * far * splat(0.9999f);
    sum = sum + square[k];
    most = vmax(most, square[k]);
  }
  if (any(gt(*d2, square[0]))) {
    CELLS_TRY_ALL(n % 3 == 2 && cells_further(n) == 1)
  }
  if (any(gt(*d2, square[1]))) {
    CELLS_TRY_ALL(n / 3 % 3 == 2 && cells_further(n) == 1)
  }
  if (any(gt(*d2, square[2]))) {
    CELLS_TRY_ALL(n / 9 == 2 && cells_further(n) == 1)
  }
  if (any(gt(*d2, sum - most))) {
    CELLS_TRY_ALL(cells_further(n) >= 2)
  }
}

/* The nearest two, by power distance, of the 27 cells about the point. */
INLINE void cells_find_as(const stone_cells *c, int graded, const vf q[3], cells_near *first,
                          cells_near *second) {
  vi whole[3];
  cells_about about;
  cells_look_about(c, q, whole, &about);
  vf d1 = splat(1e30f), d2 = d1;
  cells_nearest(c, graded, &about, &d1, &d2);
  vu at = about.hash[0][0] + about.hash[1][0] + about.hash[2][0];
  cells_near *out[2] = {first, second};
  const vf key[2] = {d1, d2};
  for (int k = 0; k < 2; k++) {
    cells_near *o = out[k];
    vi d[3];
    cells_step(bits_of(key[k]) & splati(31), d);
    vu h = hash_upper(at + (vu)d[0] * splatu(HASH_X) + (vu)d[1] * splatu(HASH_Y) +
                      (vu)d[2] * splatu(HASH_Z));
    cells_centre(h, about.from[0][0] + to_float(d[0]), about.from[1][0] + to_float(d[1]),
                 about.from[2][0] + to_float(d[2]), o->x);
    for (int i = 0; i < 3; i++) o->at[i] = whole[i] + d[i];
    o->d = o->x[0] * o->x[0] + o->x[1] * o->x[1] + o->x[2] * o->x[2];
    if (graded) o->d = o->d + cells_weight(c, h);
    o->h = h;
  }
}

INLINE void cells_find(const stone_cells *c, const vf q[3], cells_near *first, cells_near *second) {
  if (c->grading > 0.0f)
    cells_find_as(c, 1, q, first, second);
  else
    cells_find_as(c, 0, q, first, second);
}

/* The hash of the block of 4^3 that a place on the lattice is in. */
INLINE vu cells_block(const stone_cells *c, vi x, vi y, vi z) {
  return hash_mix((vu)(x >> 2) * splatu(HASH_X) + (vu)(y >> 2) * splatu(HASH_Y) +
                  (vu)(z >> 2) * splatu(HASH_Z) + splatu(c->seed ^ 0x5bd1e995u));
}

/* Across the beds, which rise and fall. p: mm, bed space. */
STAGE vf beds_across(const stone_bedding *b, const vf p[3]) {
  vf unused[3], f = splat(b->wave_frequency);
  return p[1] + splat(b->wave) *
                    noise_gradient3(p[0] * f, p[1] * f, p[2] * f, splatu(b->seed_wave), unused);
}

/* How rich in bodies the beds are at a place across them: mean 1. */
INLINE vf beds_rich(const stone_bedding *b, vf y) {
  vf rich = splat(b->few);
  for (uint32_t j = 0; j < 2; j++) {
    vi bed;
    (void)vfloor(y * splat(b->frequency[j]), &bed);
    vu h = hash_mix((vu)bed * splatu(HASH_Y) + splatu(b->seed + j));
    vf u = to_float((vi)(h >> 8)) * splat(1.0f / 16777216.0f);
    rich = rich + sel(lt(u, splat(b->part)), splat(b->more), splat(0.0f));
  }
  return rich;
}

/* The same of a cell. */
INLINE vf cells_bedding(const stone_bedding *b, const vi at[3]) {
  vf p[3];
  for (int k = 0; k < 3; k++) {
    p[k] = splat(0.0f);
    for (int i = 0; i < 3; i++)
      p[k] = p[k] + splat(b->across[k][i]) * (to_float(at[i]) + splat(0.5f));
  }
  return beds_rich(b, beds_across(b, p));
}

#define BEDS_LOOKS 8

/* The same over a footprint that reaches `wide` mm across the beds. */
STAGE vf beds_mean(const stone_bedding *b, const vf p[3], vf wide) {
  vf y = beds_across(b, p), sum = splat(0.0f);
  for (int i = 0; i < BEDS_LOOKS; i++) {
    const float at = ((float)i + 0.5f) / BEDS_LOOKS - 0.5f;
    sum = sum + beds_rich(b, y + splat(at) * wide);
  }
  return sum * splat(1.0f / BEDS_LOOKS);
}

/* What a cell's mineral goes by, below c->chance times `rich`: 0..1, evenly spread
 * over the cells of a block of 4^3. Where minerals cluster, a block is rich or poor, and
 * so are blocks aslant of it, that no rows be seen: a share times 1 - c, 1 or 1 + c. */
INLINE vf cells_rank(const stone_cells *c, const vi at[3], vf *rich) {
  static const uint32_t step[3] = {0xd1b54a33u, 0xabc98389u, 0x8cb92ba7u};
  vu b = cells_block(c, at[0], at[1], at[2]), rank = b;
  for (int k = 0; k < 3; k++) {
    /* each axis either way round, by a bit of the block's own; ~x is -x but for a shift */
    vi flip = (vi)(b << (uint32_t)(29 + k)) >> 31;
    rank = rank + (vu)(at[k] ^ flip) * splatu(step[k]);
  }
  *rich = splat(1.0f);
  if (c->cluster > 0.0f) {
    vu other = cells_block(c, at[0] + at[1], at[1] + at[2], at[2] + at[0]);
    vf many = to_float((vi)((b >> 31) + (other >> 31)));
    *rich = splat(1.0f - c->cluster) + splat(c->cluster) * many;
  }
  if (c->bedded) *rich = *rich * cells_bedding(&c->beds, at);
  return to_float((vi)(rank >> 8)) * splat(1.0f / 16777216.0f);
}

/* mm to cells. The lattice stands aslant, so that no face shows its rows. */
INLINE void cells_turn(const stone_cells *c, const vf v[3], vf out[3]) {
  for (int k = 0; k < 3; k++) {
    const float *row = c->turn[k];
    out[k] = splat(row[0]) * v[0] + splat(row[1]) * v[1] + splat(row[2]) * v[2];
  }
}

#define CELLS_BEND 1.15f     /* frequency of the coarser bends, 1/cell */
#define CELLS_BEND_FINE 3.5f /* of the finer */

/* Bends the cells' faces: moves a point, in cells, by two noises, of the finer of which
 * `finer` is left. Their sum is as good for what is uneven within a crystal: sd 0.22 of
 * each, mean 0. */
INLINE vf cells_bend(const stone_cells *c, vf finer, vf q[3]) {
  if (c->warp == 0.0f) return splat(0.0f);
  const vf coarse = splat(CELLS_BEND), fine = splat(CELLS_BEND_FINE);
  const float move = 0.45f / VALUE_SD_CUBIC / HASH_ONE;
  const vf at[3] = {q[0] * coarse, q[1] * coarse, q[2] * coarse},
           finely[3] = {q[0] * fine, q[1] * fine, q[2] * fine};
  vf g[3], sum = value_three(at, splatu(c->seed_warp), g) * splat(1.0f / HASH_ONE);
  for (int k = 0; k < 3; k++) q[k] = q[k] + splat(c->warp * move) * g[k];
  if (!any(gt(finer, splat(0.0f)))) return sum;
  vf b = value_three(finely, splatu(c->seed_warp + 1u), g) * splat(1.0f / HASH_ONE);
  for (int k = 0; k < 3; k++) q[k] = q[k] + finer * splat(c->warp_fine * move) * g[k];
  return sum + finer * b;
}

/* A point in cells, their faces bent. */
INLINE void cells_place(const stone_cells *c, const vf p[3], vf q[3]) {
  cells_turn(c, p, q);
  (void)cells_bend(c, splat(1.0f), q);
}

#endif
