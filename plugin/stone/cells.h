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

#include "../core/patch.h"
#include "../core/vectors.h"
#include "square.h"
#include "stone.h"
#include "value.h"

/* A cell near the point: where its centre is from there, its hash, and the place on the lattice
 * that its kind goes by (cells_first). */
typedef struct {
  vf x[3], d;
  vu h;
  vi at[3];
} cells_near;

/* Where the centre is of a cell whose middle is `from` away: ten bits of the hash to
 * an axis, and more below them that do no harm. */
INLINE void cells_centre(const stone_cells *c, vu h, vf x, vf y, vf z, vf out[3]) {
  const vf k = splat(c->jitter);
  out[0] = to_float((vi)h) * k + x;
  out[1] = to_float((vi)(h << 10)) * k + y;
  out[2] = to_float((vi)(h << 20)) * k + z;
}

/* What cells go by: all alike, by weights, or by weights that are sorted. */
enum { CELLS_ALIKE, CELLS_GRADED, CELLS_SORTED };

INLINE int cells_order(const stone_cells *c) {
  return c->sorted ? CELLS_SORTED : c->grading > 0.0f ? CELLS_GRADED : CELLS_ALIKE;
}

/* A cell's hash. sum: of its axes' parts, all of them odd multiples, so that its lowest bit tells
 * the two halves of a chequered lattice apart. Where cells are sorted that bit becomes the weight's
 * first: one half's bodies are large and lie as the closest packing of balls does, the other's are
 * small and lie in its octahedral voids (Conway and Sloane, Sphere Packings, Lattices and Groups,
 * Springer, 3rd ed., 1999). */
INLINE vu cells_hash(int order, vu sum) {
  vu h = hash_upper(sum);
  if (order != CELLS_SORTED) return h;
  return (h & splatu(~(1u << 26))) | ((sum & splatu(1u)) << 26);
}

/* A cell's weight, 0 or more, and a little, so that no distance is denormal, which
 * some hosts have flushed to zero. */
INLINE vf cells_weight(const stone_cells *c, vu h) {
  float half = 0.5f * c->grading;
  return to_float((vi)(h << 5)) * splat(half / HASH_ONE) + splat(half + 1e-6f);
}

/* A cell's number, of those about a point: its place on the lattice, two bits to an axis. */
INLINE vi cells_number(vi at, int axis) { return (at & splati(3)) << (2 * axis); }

/* How many cells on from the point's own, -1 to 1, that is along an axis. */
INLINE vi cells_step(vi number, vi own, int axis) {
  return (((number >> (2 * axis)) - own + splati(1)) & splati(3)) - splati(1);
}

/* Along each axis the point's own cell: which it is, how far from the point its middle is, and its
 * part of the hash. */
typedef struct {
  vi whole[3];
  vf from[3];
  vu hash[3];
} cells_own;

INLINE void cells_look_own(const stone_cells *c, const vf q[3], cells_own *o) {
  static const uint32_t prime[3] = {HASH_X, HASH_Y, HASH_Z};
  for (int k = 0; k < 3; k++) {
    o->from[k] = splat(0.5f) - (q[k] - vfloor(q[k], &o->whole[k]));
    o->hash[k] = (vu)o->whole[k] * splatu(prime[k]) + splatu(k ? 0u : c->seed);
  }
}

/* Along each axis that, its neighbour on the nearer side and that on the further: from the
 * point to their middles, their parts of the hash, and of the cell's number. */
typedef struct {
  vf from[3][3];
  vu hash[3][3];
  vi number[3][3];
} cells_about;

INLINE void cells_look_about(const cells_own *own, cells_about *a) {
  static const uint32_t prime[3] = {HASH_X, HASH_Y, HASH_Z};
  for (int k = 0; k < 3; k++) {
    vf o = own->from[k];
    vi whole = own->whole[k];
    vm up = lt(o, splat(0.0f));
    vf t = sel(up, splat(1.0f), splat(-1.0f));
    vu step = (vu)seli(up, splati((int32_t)prime[k]), splati((int32_t)(0u - prime[k])));
    vi on = seli(up, splati(1), splati(-1));
    a->from[k][0] = o;
    a->from[k][1] = o + t;
    a->from[k][2] = o - t;
    a->hash[k][0] = own->hash[k];
    a->hash[k][1] = own->hash[k] + step;
    a->hash[k][2] = own->hash[k] - step;
    a->number[k][0] = cells_number(whole, k);
    a->number[k][1] = cells_number(whole + on, k);
    a->number[k][2] = cells_number(whole - on, k);
  }
}

/* The least `most` of numbers, in order. */
INLINE void cells_least(vf x, int most, vf least[]) {
  UNROLL(8)
  for (int k = most - 1; k > 0; k--) least[k] = vmin(least[k], vmax(least[k - 1], x));
  least[0] = vmin(least[0], x);
}

/* A cell at a squared distance. Its number stands in the lowest bits of that, 8e-6 of it:
 * then minima and maxima keep the nearest few, where cells' numbers and hashes
 * would take a choice each. */
INLINE void cells_keep(vf d, vi number, int most, vf key[]) {
  cells_least(float_of((bits_of(d) & splati(~63)) | number), most, key);
}

/* Cell x, y, z of those, 0 to 2 along each axis. */
INLINE void cells_try(const stone_cells *c, int graded, int most, const cells_about *a, int x,
                      int y, int z, vf key[]) {
  vu h = cells_hash(graded, a->hash[0][x] + a->hash[1][y] + a->hash[2][z]);
  vf at[3];
  cells_centre(c, h, a->from[0][x], a->from[1][y], a->from[2][z], at);
  vf d = dot3(at, at) + (graded ? cells_weight(c, h) : splat(1e-6f));
  cells_keep(d, a->number[0][x] + a->number[1][y] + a->number[2][z], most, key);
}

INLINE int cells_further(int n) { return (n % 3 == 2) + (n / 3 % 3 == 2) + (n / 9 == 2); }

/* Those of the 27 of which `further` says so. */
#define CELLS_TRY_ALL(which)                                                                       \
  UNROLL(27)                                                                                       \
  for (int n = 0; n < 27; n++) {                                                                   \
    if (which) cells_try(c, graded, most, a, n % 3, n / 3 % 3, n / 9, key);                        \
  }

/* The least `most` distances, two or three. */
INLINE void cells_nearest(const stone_cells *c, int graded, int most, const cells_own *own,
                          vf key[3]) {
  cells_about about;
  const cells_about *a = &about;
  cells_look_about(own, &about);
  CELLS_TRY_ALL(cells_further(n) == 0)
  /* No cell on the further side is nearer than the square of the distance there; nor
   * one that is further along two axes than the sum of two, of which the least count. */
  vf square[3], sum = splat(0.0f), widest = sum;
  for (int k = 0; k < 3; k++) {
    vf far = vabs(a->from[k][0]) + splat(1.0f - 0.5f * CELLS_JITTER);
    square[k] = far * far * splat(0.9999f);
    sum = sum + square[k];
    widest = vmax(widest, square[k]);
  }
  if (any(gt(key[most - 1], square[0]))) {
    CELLS_TRY_ALL(n % 3 == 2 && cells_further(n) == 1)
  }
  if (any(gt(key[most - 1], square[1]))) {
    CELLS_TRY_ALL(n / 3 % 3 == 2 && cells_further(n) == 1)
  }
  if (any(gt(key[most - 1], square[2]))) {
    CELLS_TRY_ALL(n / 9 == 2 && cells_further(n) == 1)
  }
  if (any(gt(key[most - 1], sum - widest))) {
    CELLS_TRY_ALL(cells_further(n) >= 2)
  }
}

#ifdef SPREADS
#include "cells_shared.h"
#endif

/* From a cell to the first of those that are one crystal with it, or one clot. Along each axis a
 * block of 2^3 is whole or two: crystals of one, two, four and eight cells, as in a rock whose
 * sizes are seriate. */
INLINE void cells_first(const stone_cells *c, vi at[3]) {
  if (!c->joins) return;
  vu h = hash_upper((vu)(at[0] >> 1) * splatu(HASH_X) + (vu)(at[1] >> 1) * splatu(HASH_Y) +
                    (vu)(at[2] >> 1) * splatu(HASH_Z) + splatu(c->seed ^ 0x3ad8025fu));
  for (int k = 0; k < 3; k++) {
    vm whole = lti((vi)(h >> (uint32_t)(24 - 8 * k) & splatu(255u)), splati((int32_t)c->joins));
    at[k] = at[k] - seli(whole, at[k] & splati(1), splati(0));
  }
}

/* What goes by its hash of a crystal, whose first cell that is; h: the cell's own. */
INLINE vu cells_crystal(const stone_cells *c, const vi first[3], vu h) {
  if (!c->joins || c->shaped) return h;
  return hash_upper((vu)first[0] * splatu(HASH_X) + (vu)first[1] * splatu(HASH_Y) +
                    (vu)first[2] * splatu(HASH_Z) + splatu(c->seed));
}

/* The cell of a key, of those about the point. */
INLINE cells_near cells_of_key(const stone_cells *c, int graded, const cells_own *own, vf key) {
  cells_near o;
  vi d[3];
  for (int i = 0; i < 3; i++) {
    d[i] = cells_step(bits_of(key), own->whole[i], i);
    o.at[i] = own->whole[i] + d[i];
  }
  o.h = cells_hash(graded, own->hash[0] + own->hash[1] + own->hash[2] + (vu)d[0] * splatu(HASH_X) +
                               (vu)d[1] * splatu(HASH_Y) + (vu)d[2] * splatu(HASH_Z));
  cells_centre(c, o.h, own->from[0] + to_float(d[0]), own->from[1] + to_float(d[1]),
               own->from[2] + to_float(d[2]), o.x);
  o.d = dot3(o.x, o.x);
  if (graded) o.d = o.d + cells_weight(c, o.h);
  cells_first(c, o.at);
  o.h = cells_crystal(c, o.at, o.h);
  return o;
}

/* The nearest `most`, by power distance, of the 27 cells about the point. together: whether
 * lanes may well lie close to each other, which changes nothing but the time. */
INLINE void cells_find_as(const stone_cells *c, int graded, int most, int together, const vf q[3],
                          cells_near out[]) {
  cells_own own;
  cells_look_own(c, q, &own);
  vf key[3] = {splat(1e30f), splat(1e30f), splat(1e30f)};
#ifdef SPREADS
  if (!together || !cells_nearest_shared(c, graded, most, &own, key))
#endif
    cells_nearest(c, graded, most, &own, key);
  (void)together;
  for (int k = 0; k < most; k++) out[k] = cells_of_key(c, graded, &own, key[k]);
}

/* The hash of the block of 4^3 that a place on the lattice is in. */
INLINE vu cells_block(const stone_cells *c, vi x, vi y, vi z) {
  return hash_mix((vu)(x >> 2) * splatu(HASH_X) + (vu)(y >> 2) * splatu(HASH_Y) +
                  (vu)(z >> 2) * splatu(HASH_Z) + splatu(c->seed ^ 0x5bd1e995u));
}

/* Across the beds, which rise and fall. p: mm, bed space. */
INLINE vf beds_across(const stone_bedding *b, const vf p[3]) {
  vf unused[2];
  return p[1] + beds_wave(p, b->wave, b->wave_frequency, b->lag, b->seed_wave, unused);
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

/* Of a cell's block, whose hash is `own`, and of one aslant of it, how many are rich: 0 to 2. */
INLINE vf cells_rich(const stone_cells *c, const vi at[3], vu own) {
  vu other = cells_block(c, at[0] + at[1], at[1] + at[2], at[2] + at[0]);
  return to_float((vi)((own >> 31) + (other >> 31)));
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
  if (c->cluster > 0.0f)
    *rich = splat(1.0f - c->cluster) + splat(c->cluster) * cells_rich(c, at, b);
  if (c->bedded) *rich = *rich * cells_bedding(&c->beds, at);
  return to_float((vi)(rank >> 8)) * splat(1.0f / 16777216.0f);
}

INLINE void cells_turn_by(const float turn[3][3], const vf v[3], vf out[3]) {
  for (int k = 0; k < 3; k++) {
    const float *row = turn[k];
    out[k] = splat(row[0]) * v[0] + splat(row[1]) * v[1] + splat(row[2]) * v[2];
  }
}

/* mm to cells. The lattice stands aslant, so that no face shows its rows. */
INLINE void cells_turn(const stone_cells *c, const vf v[3], vf out[3]) {
  cells_turn_by(c->turn, v, out);
}

#define CELLS_BEND 1.15f     /* frequency of the coarser bends, 1/cell */
#define CELLS_BEND_FINE 3.5f /* of the finer */

/* The two noises that bend faces, coarse and fine, at a place: three numbers of each by which it
 * moves; their sum, which is as good for what is uneven within a crystal, sd 0.22, mean 0; and
 * where that is asked for how the numbers grow along each axis. known, grown: whether they have
 * been found, of layers that share them by whoever was first. */
typedef struct {
  int known[2], grown[2];
  vf n[2], g[2][3], grows[2][3][3];
} cells_bends;

INLINE void bends_none(cells_bends *b) {
  for (int o = 0; o < 2; o++) b->known[o] = b->grown[o] = 0;
}

#define CELLS_MOVE (0.45f / VALUE_SD_CUBIC / HASH_ONE)

/* The noise o. x: the place, in cells of the layer whose noises they are. along: not NULL where
 * nobody else will ask, and then they are all that it is to grow along. */
INLINE void bends_find(const stone_cells *c, uint32_t o, int together, int grown,
                       const vf (*along)[3], const vf x[3], cells_bends *b) {
  if (b->known[o] && (!grown || b->grown[o])) return;
  const vf f = splat(o ? CELLS_BEND_FINE : CELLS_BEND), at[3] = {x[0] * f, x[1] * f, x[2] * f};
  const vu seed = splatu(c->seed_warp + o);
  b->n[o] = (grown ? value_three_grown(at, seed, along, b->g[o], b->grows[o])
                   : value_three(at, seed, together, b->g[o])) *
            splat(1.0f / HASH_ONE);
  b->known[o] = 1;
  b->grown[o] = grown;
}

/* Bends the cells' faces: moves a point, in cells, by the noises, of the finer of which `finer` is
 * left. Returns their sum. */
INLINE vf cells_bend(const stone_cells *c, vf finer, int together, const vf x[3], vf q[3],
                     cells_bends *b) {
  if (c->warp == 0.0f) return splat(0.0f);
  bends_find(c, 0, together, 0, NULL, x, b);
  for (int k = 0; k < 3; k++) q[k] = q[k] + splat(c->warp * CELLS_MOVE) * b->g[0][k];
  if (!any(gt(finer, splat(0.0f)))) return b->n[0];
  bends_find(c, 1, together, 0, NULL, x, b);
  for (int k = 0; k < 3; k++) q[k] = q[k] + finer * splat(c->warp_fine * CELLS_MOVE) * b->g[1][k];
  return b->n[0] + finer * b->n[1];
}

/* cells_bend to the bit, and a square about the point as the bends leave it. kept: that `b` is for
 * others, too. */
INLINE vf cells_bend_square(const stone_cells *c, int kept, vf finer, const vf x[3], vf q[3],
                            cells_square *square, cells_bends *b) {
  const float frequency[2] = {CELLS_BEND, CELLS_BEND_FINE}, much[2] = {c->warp, c->warp_fine};
  vf way[2][3], sum = splat(0.0f);
  memcpy(way[0], square->u, sizeof square->u);
  memcpy(way[1], square->v, sizeof square->v);
  const vf(*along)[3] = (const vf(*)[3])way;
  if (c->warp == 0.0f) return sum;
  UNROLL(2)
  for (uint32_t o = 0; o < 2; o++) {
    if (o == 1 && !any(gt(finer, splat(0.0f)))) break;
    bends_find(c, o, 0, 1, kept ? NULL : along, x, b);
    vf far = splat(much[o] * CELLS_MOVE), steep = splat(frequency[o] * c->bend_scale);
    if (o == 1) far = finer * far;
    sum = o == 1 ? sum + finer * b->n[1] : b->n[0];
    for (int k = 0; k < 3; k++) {
      const vf *g = b->grows[o][k];
      q[k] = q[k] + far * b->g[o][k];
      square->u[k] = square->u[k] + far * steep * (kept ? dot3(g, way[0]) : g[0]);
      square->v[k] = square->v[k] + far * steep * (kept ? dot3(g, way[1]) : g[1]);
    }
  }
  return sum;
}

/* A point in cells, their faces bent; of layers whose noises are their own. */
INLINE void cells_place(const stone_cells *c, vf finer, const vf p[3], vf q[3]) {
  cells_bends bends;
  bends_none(&bends);
  cells_turn(c, p, q);
  const vf x[3] = {q[0], q[1], q[2]};
  (void)cells_bend(c, finer, 1, x, q, &bends);
}

/* How that place changes along two directions. t: mm. */
INLINE void cells_slopes(const stone_cells *c, vf finer, const vf p[3], const vf t1[3],
                         const vf t2[3], vf out[2][3]) {
  cells_bends bends;
  bends_none(&bends);
  cells_square square;
  vf q[3];
  cells_turn(c, p, q);
  cells_turn(c, t1, square.u);
  cells_turn(c, t2, square.v);
  const vf x[3] = {q[0], q[1], q[2]};
  (void)cells_bend_square(c, 0, finer, x, q, &square, &bends);
  memcpy(out[0], square.u, sizeof square.u);
  memcpy(out[1], square.v, sizeof square.v);
}

#endif
