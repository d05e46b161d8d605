/* SPDX-License-Identifier: Apache-2.0
 *
 * The paper's tile: stones with outlines of their own, each a square of two
 * triangles whose midpoints are displaced, with a random number to each texel
 * over that; joints at one height. It repeats exactly.
 */
#ifndef SOZAI_STONE_PAPER_TILE_H
#define SOZAI_STONE_PAPER_TILE_H

#include "../core/hash.h"
#include "../core/maths.h"
#include "field.h"
#include "stone.h"

typedef struct {
  vi stone;
  vf x, y;  /* texels, in the stone's place from its corner */
  vf depth; /* texels within the outline; below 0 in the joint */
  vu h;     /* of the texel within the tile */
} tile_place;

/* How far in the outline lies along a side, at t of its length. */
INLINE vf tile_inset(const stone_tile *t, vi stone, int side, vf along) {
  vi i;
  vf a = clamp(along * splat((float)t->parts), splat(0.0f), splat((float)t->parts - 0.001f));
  vf f = a - vfloor(a, &i);
  vi at = (stone * splati(4) + splati(side)) * splati(PAPER_PARTS + 1) + i;
  return mix(gather(t->inset, at), gather(t->inset, at + splati(1)), f);
}

/* x, y: texels, in the plane. */
STAGE tile_place tile_in(const stone_tile *t, vf x, vf y) {
  tile_place q;
  vi unused, row, column;
  vf half = splat(0.5f);
  y = y + splat(t->start);
  y = y - splat(t->tile[1]) * vfloor((y + half) * splat(t->inverse_tile[1]), &unused);
  vf r = vfloor((y + half) / splat(t->width), &row);
  x = x + splat(t->start) + r * splat(t->shift);
  x = x - splat(t->tile[0]) * vfloor((x + half) * splat(t->inverse_tile[0]), &unused);
  vf c = vfloor((x + half) / splat(t->length), &column);
  q.h = (vu)to_int(x + half) * splatu(HASH_X) + (vu)to_int(y + half) * splatu(HASH_Y);
  q.stone = row * splati(t->across) + column;
  q.stone = seli(lti(splati(PAPER_STONES - 1), q.stone), splati(PAPER_STONES - 1), q.stone);
  q.x = x - c * splat(t->length) + half;
  q.y = y - r * splat(t->width) + half;
  vf u = q.x * splat(1.0f / t->length), v = q.y * splat(1.0f / t->width);
  q.depth = vmin(vmin(q.y - tile_inset(t, q.stone, 0, u),
                      splat(t->width) - q.y - tile_inset(t, q.stone, 1, u)),
                 vmin(q.x - tile_inset(t, q.stone, 2, v),
                      splat(t->length) - q.x - tile_inset(t, q.stone, 3, v)));
  return q;
}
/* The middle of texel (x, y), whole numbers. */
INLINE tile_place tile_at(const stone_tile *t, vf x, vf y) { return tile_in(t, x, y); }

/* Share of a footprint of `wide` texels that is joint. */
INLINE vf tile_joint(const stone_tile *t, vf x, vf y, vf wide) {
  vf half = splat(0.5f), e = vmax(wide, splat(0.05f)),
     size = splat(t->length < t->width ? t->length : t->width);
  tile_place q = tile_in(t, x - half, y - half);
  vf near = clamp01(half - q.depth / e);
  return mix(near, splat(t->share), smooth_step(splat(0.25f) * size, size, wide));
}

/* H' of a texel, code. keep: of its random number; the rest is its mean. */
STAGE vf tile_height(const stone_tile *t, vu seed, vf x, vf y, vf keep) {
  tile_place q = tile_at(t, x, y);
  vi i, j;
  vf n = splat((float)t->grid), last = n - splat(0.001f);
  vf a = clamp(q.x * n * splat(1.0f / t->length), splat(0.0f), last);
  vf b = clamp(q.y * n * splat(1.0f / t->width), splat(0.0f), last);
  vf u = a - vfloor(a, &i), v = b - vfloor(b, &j);
  vi at = q.stone * splati(PAPER_GRID * PAPER_GRID) + j * splati(PAPER_GRID) + i;
  vf h00 = gather(t->height, at), h11 = gather(t->height, at + splati(PAPER_GRID + 1));
  vf h10 = gather(t->height, at + splati(1)), h01 = gather(t->height, at + splati(PAPER_GRID));
  /* the triangle below the diagonal or above it */
  vf low = h00 + u * (h10 - h00) + v * (h11 - h10), high = h00 + v * (h01 - h00) + u * (h11 - h01);
  vf h = sel(lt(v, u), low, high);
  vf r = to_float((vi)(hash_mix(q.h + seed) >> 8)) * splat(1.0f / 16777215.0f);
  h = splat(t->alpha) * (h + splat(t->dh) * mix(splat(0.5f), r, keep));
  vf in = clamp01(q.depth * splat(1.0f / t->repair));
  return mix(splat(t->joint_height), h, in);
}

/* The relief as a field over x, y: between the middles of texels in straight
 * lines, as a bump map is read. p: mm. *lost: variance of slope. */
STAGE field tile_relief(const stone_constants *w, const vf p[3], vf s, vf *lost) {
  const stone_tile *t = &w->tile;
  vf half = splat(0.5f), one = splat(1.0f), k = splat(w->inverse_texel);
  vf wide = s * k, size = splat(t->length < t->width ? t->length : t->width);
  vf keep = one - smooth_step(splat(0.7f), splat(2.5f), wide);
  vf far = smooth_step(splat(0.2f) * size, splat(0.7f) * size, wide);
  /* a wide footprint reads further apart */
  vf step = vmax(one, wide), x = p[0] * k - half, y = p[1] * k - half;
  vi unused;
  vf x0 = vfloor(x, &unused), y0 = vfloor(y, &unused), u = x - x0, v = y - y0;
  vm apart = gt(step, splat(1.5f));
  x0 = sel(apart, vfloor(x - half * step + half, &unused), x0);
  y0 = sel(apart, vfloor(y - half * step + half, &unused), y0);
  vf dx = sel(apart, vfloor(step + half, &unused), one);
  u = sel(apart, half, u);
  v = sel(apart, half, v);
  vu seed = splatu(w->seed ^ 0x27d4eb2fu);
  vf h00 = tile_height(t, seed, x0, y0, keep), h10 = tile_height(t, seed, x0 + dx, y0, keep);
  vf h01 = tile_height(t, seed, x0, y0 + dx, keep),
     h11 = tile_height(t, seed, x0 + dx, y0 + dx, keep);
  field f = field_of(mix(mix(h00, h10, u), mix(h01, h11, u), v));
  vf slope = k / dx * (one - far) * splat(t->mm);
  f.g[0] = mix(h10 - h00, h11 - h01, v) * slope;
  f.g[1] = mix(h01 - h00, h11 - h10, u) * slope;
  /* 256 is the face */
  f.v = (mix(f.v, splat(t->mean), far) - splat(256.0f)) * splat(t->mm);
  *lost = splat(t->lost) * (one - keep * keep) + splat(t->lost * 0.5f) * far;
  return f;
}

#endif
