/* SPDX-License-Identifier: Apache-2.0
 *
 * What is seen within a crystal, as brightness relative to its mineral, mean 1:
 * the lamellae of cleavage and of twins, straight, in each crystal in a direction
 * of its own; clouds, as of altered feldspar; the healed cracks of quartz, light,
 * and flecks of mica, dark. Cracks are sheets along the stone's rift, in every crystal
 * the same: they are what a quarryman splits it by. Dale, The Commercial Granites of
 * New England, USGS Bulletin 738 (1923); MacKenzie, Donaldson and Guilford, Atlas of Igneous
 * Rocks and their Textures (1982); Deer, Howie and Zussman, An Introduction to the
 * Rock-Forming Minerals (1992).
 *
 * Each part fades as the footprint grows past its size, to its mean, which is 0. Of a
 * noise's clamped parts the mean is a number, measured; property.stone_solid would
 * find another.
 */
#ifndef SOZAI_STONE_CRYSTALS_H
#define SOZAI_STONE_CRYSTALS_H

#include "../core/filter.h"
#include "square.h"
#include "stone.h"
#include "value.h"

#define LAMELLAE 13.0f        /* to a cell, of the finest direction's */
#define ZONES 9.0f            /* to a cell, from the outline inwards */
#define ZONES_GONE 0.42f      /* cells: wider footprints see none */
#define LAMELLAE_GONE 0.4f    /* cells: wider footprints see none */
#define LAMELLAE_BODIES 0.29f /* the same of those within bodies */
#define LAMELLAE_NEXT 0.05f   /* those of the second nearest crystal begin to go, */
#define LAMELLAE_ONE 0.14f    /* and are gone */
#define CRYSTAL_FINE 7.3f     /* frequency of what is fine within crystals, 1/cell */
#define CRYSTAL_SEEN 0.055f   /* cells: squares up to which that is seen, */
#define CRYSTAL_GONE 0.19f    /* and from which on not; */
#define CRYSTAL_SEEN4 0.12f   /* the same of squares in quarters */
#define CRYSTAL_GONE4 0.21f
#define CRACK_SHEETS 5.5f  /* to a cell across the rift */
#define CRACK_SWAY 0.32f   /* of their distance over the noise: steeper, they would close */
#define CRACK_WIDE 0.055f  /* of their distance: half of one's width */
#define FLECK_MEAN 0.0137f /* of clamp01((n - 0.36) 8) */

/* What flecks are cut from: a noise's mean over the footprint, as far as its middle tells, how
 * much it changes there, and by what along each side. And cracks, where `sheet` is whole: the
 * place across the rift, which the noise sways. */
typedef struct {
  vf fine, extent2, along[2];
  vf sheet, sheet_along[2];
} crystal_noise;

/* Whether there is anything to be seen. */
INLINE int crystal_textured(const stone_cells *c) {
  return c->cleavage > 0.0f || c->turbidity > 0.0f || c->zoning > 0.0f;
}

/* 1 up to low, 0 from high on. */
INLINE vf crystal_keep(vf wide, float low, float high) {
  vf t = clamp01((splat(high) - wide) * splat(1.0f / (high - low)));
  return vmin(t * t * (splat(3.0f) - t - t), splat(1.0f));
}

/* q: cells, before their faces are bent. wide: the square's longer side. */
INLINE crystal_noise crystal_at(const stone_cells *c, const vf q[3], const cells_square *s,
                                vf wide) {
  const vf f = splat(CRYSTAL_FINE), at[3] = {q[0] * f, q[1] * f, q[2] * f};
  crystal_noise n;
  vf g[3];
  n.fine = value_three(at, splatu(c->seed_warp + 2u), 1, g) * splat(1.0f / HASH_ONE);
  /* of a middle's number less is left the less the noise about it knows of it */
  vf wide2 = splat(CRYSTAL_FINE * CRYSTAL_FINE) * wide * wide;
  n.fine = n.fine / (splat(1.0f) + splat(0.3f) * wide2);
  /* the corners' gradients are not all of its slope, but of its square some half */
  vf a = dot3(g, s->u), b = dot3(g, s->v);
  n.along[0] = a * splat(CRYSTAL_FINE / HASH_ONE);
  n.along[1] = b * splat(CRYSTAL_FINE / HASH_ONE);
  const float square = 0.5f * 1.8f * CRYSTAL_FINE * CRYSTAL_FINE / (HASH_ONE * HASH_ONE);
  /* a noise is no plane for long, and bends where it has no slope */
  const float rift[3] = {0.77f * CRACK_SHEETS, -0.53f * CRACK_SHEETS, 0.355f * CRACK_SHEETS};
  vf across[3] = {splat(rift[0]), splat(rift[1]), splat(rift[2])}, sway = splat(CRACK_SWAY);
  n.sheet = dot3(across, q) + sway * n.fine;
  n.sheet_along[0] = dot3(across, s->u) + sway * n.along[0];
  n.sheet_along[1] = dot3(across, s->v) + sway * n.along[1];
  n.extent2 = vmin(splat(square) * (a * a + b * b), splat(0.05f)) + splat(0.1f) * wide2 * wide2;
  return n;
}

/* The integral from 0 to f of value noise's blend, and of the rest. */
INLINE vf crystal_blend(vf f) { return f * f * f * (splat(1.0f) - splat(0.5f) * f); }

INLINE vf crystal_number(vu hash, vi at, uint32_t on) {
  return hash_signed((vu)at * splatu(HASH_X) + hash + splatu(on * HASH_X));
}

/* A crystal's lamellae along a footprint, the first half of crystal_lamellae: where the footprint
 * begins and how far it reaches, in lamellae; one over that; what is left of them. */
typedef struct {
  vu hash;
  vf from, side, inverse, keep;
} crystal_line;

/* hash: of what lies along it; t: where, and d how that grows: lamellae. */
INLINE crystal_line crystal_line_along(vu hash, vf t, const vf d[3], const cells_square *s) {
  crystal_line o;
  o.hash = hash;
  vf a = dot3(d, s->u), b = dot3(d, s->v), square = a * a + b * b + splat(1e-4f);
  o.inverse = inverse_root(square);
  o.side = square * o.inverse;
  o.from = t - splat(0.5f) * o.side;
  o.keep = crystal_keep(vmin(vabs(a), vabs(b)), 0.7f, 2.5f);
  return o;
}

INLINE crystal_line crystal_line_of(vu h, const vf q[3], const cells_square *s) {
  const vf k = splat(LAMELLAE / HASH_ONE);
  vu hash = hash_upper(h ^ splatu(0x3c6ef35fu));
  vf d[3] = {to_float((vi)hash) * k, to_float((vi)(hash << 10)) * k,
             to_float((vi)(hash << 20)) * k};
  return crystal_line_along(hash, dot3(d, q), d, s);
}

/* A body's zones of growth, so deep below its outline. g: how that grows, cells. */
INLINE crystal_line crystal_zones_of(vu h, vf deep, const vf g[3], const cells_square *s) {
  const vf k = splat(ZONES), d[3] = {g[0] * k, g[1] * k, g[2] * k};
  return crystal_line_along(hash_upper(h ^ splatu(0x1f83d9abu)), deep * k, d, s);
}

/* wide: that some lane's footprint is longer than a lamella. */
INLINE vf crystal_line_mean(const crystal_line *o, int wide) {
  vi first[2];
  vf f[2], number[2][3], sum[2];
  f[0] = o->from - vfloor(o->from, &first[0]);
  f[1] = o->from + o->side;
  f[1] = f[1] - vfloor(f[1], &first[1]);
  for (uint32_t j = 0; j < 3; j++) {
    number[0][j] = crystal_number(o->hash, first[0], j);
    if (wide) number[1][j] = crystal_number(o->hash, first[1], j);
  }
  if (!wide) {
    /* the other end is in the same piece or the next */
    vm next = lti(first[0], first[1]);
    number[1][0] = sel(next, number[0][1], number[0][0]);
    number[1][1] = sel(next, number[0][2], number[0][1]);
    number[1][2] = sel(next, crystal_number(o->hash, first[0], 3), number[0][2]);
  }
  for (int i = 0; i < 2; i++) {
    vf low = number[i][0] - number[i][1], high = number[i][1] - number[i][2];
    sum[i] = low * f[i] + (high - low) * crystal_blend(f[i]) -
             splat(0.5f) * (number[i][0] + number[i][1]);
  }
  return o->keep * (sum[1] - sum[0]) * (o->inverse * splat(0.70710678f / HASH_ONE));
}

/* The mean over the footprint, within +-1.5; of all places 0. Value noise along the
 * crystal's direction. Each lamella is the difference of two numbers, the next one's other
 * way round, so that the sum over any number of them is that of the two ends' numbers, and
 * the integral exact however wide the footprint, if it is a line: across two sides of
 * several lamellae each there is nothing left. h: the crystal's. */
INLINE vf crystal_lamellae(vu h, const vf q[3], const cells_square *s) {
  crystal_line line = crystal_line_of(h, q, s);
  if (!any(gt(line.keep, splat(0.0f)))) return splat(0.0f);
  if (any(gt(line.side, splat(1.0f)))) return crystal_line_mean(&line, 1);
  return crystal_line_mean(&line, 0);
}

/* The nearest sheet's, of area CRACK_WIDE to a unit across, wherever the footprint is, and the
 * mean is half of that: a crack heals away as the noise falls. */
INLINE vf crystal_crack(const crystal_noise *n) {
  vf half = splat(0.5f), a = n->sheet_along[0], b = n->sheet_along[1];
  vi unused;
  vf off = vabs(n->sheet - vfloor(n->sheet, &unused) - half);
  vf wide = vsqrt(a * a + b * b + splat(4.0f * CRACK_WIDE * CRACK_WIDE));
  vf broad = half * wide, inverse = splat(1.0f) / broad;
  vf there = clamp01(half + n->fine + n->fine);
  return splat(CRACK_WIDE) * (vmax(broad - off, splat(0.0f)) * inverse * inverse * there - half);
}

/* What is cut from the noise, of the base's and the third mineral (feldspars), and of the second
 * (quartz). Cracks and flecks are blurred as if the noise were a plane over the footprint. */
INLINE void crystal_cut(const crystal_noise *n, vf tone[2]) {
  vf wide = vsqrt(n->extent2 + splat(0.015625f));
  vf fleck = clamp01(splat(0.5f) + (n->fine - splat(0.4225f)) / wide) - splat(FLECK_MEAN);
  tone[0] = splat(0.16f) * n->fine - splat(0.6f) * fleck;
  tone[1] = splat(0.3f) * n->fine + splat(0.26f) * crystal_crack(n);
}

/* Clouds, of a size of a third of a cell, in a square so wide. */
INLINE void crystal_clouds(const stone_cells *c, vf wide, vf cloud, vf tone[2]) {
  cloud = cloud * splat(c->turbidity) * crystal_keep(wide, 0.16f, 0.48f);
  tone[0] = splat(0.1f) * cloud;
  tone[1] = splat(0.3f) * cloud;
}

#define CRYSTAL_HALF 0.79f /* the root mean square of a half's sides, of the square's */

/* What of it does not differ from crystal to crystal, of those minerals. Of a square in quarters
 * the noise is seen in each half, and for longer: quarters would tell more, for twice as much.
 * keep: what is left of what is cut from it. */
typedef struct {
  crystal_noise noise[2];
  vf keep;
  int count;
} crystal_seen;

INLINE void crystal_see(const stone_cells *c, const vf q[3], const cells_square *s,
                        const cells_parts *p, vf wide, crystal_seen *o) {
  vf keep = crystal_keep(wide, CRYSTAL_SEEN, CRYSTAL_GONE), part_wide = wide;
  const int halves = p->count > 1;
  cells_square part = *s;
  if (halves) {
    vm parted = lt(p->side, splat(1.0f));
    keep = sel(parted, crystal_keep(wide, CRYSTAL_SEEN4, CRYSTAL_GONE4), keep);
    part_wide = sel(parted, splat(CRYSTAL_HALF) * wide, wide);
    for (int k = 0; k < 3; k++) part.u[k] = s->u[k] * p->side;
  }
  o->keep = splat(c->turbidity) * keep;
  o->count = any(gt(o->keep, splat(0.0f))) ? halves ? 2 : 1 : 0;
  if (!o->count) return;
  for (int i = 0; i < (halves ? 2 : 1); i++) {
    vf at[3];
    for (int k = 0; k < 3; k++) {
      vf u = s->u[k] * p->away;
      at[k] = !halves ? q[k] : i ? q[k] + u : q[k] - u;
    }
    o->noise[i] = crystal_at(c, at, &part, part_wide);
  }
}

INLINE void crystal_tones(const stone_cells *c, const crystal_seen *o, vf wide, vf cloud,
                          vf tone[2]) {
  vf cut[2][2];
  crystal_clouds(c, wide, cloud, tone);
  if (!o->count) return;
  for (int i = 0; i < o->count; i++) {
    vf here[2];
    crystal_cut(&o->noise[i], here);
    for (int k = 0; k < 2; k++) cut[k][i] = here[k];
  }
  for (int k = 0; k < 2; k++) {
    vf mean = o->count > 1 ? splat(0.5f) * (cut[k][0] + cut[k][1]) : cut[k][0];
    tone[k] = tone[k] + o->keep * mean;
  }
}

/* Of half a side to a quarter's middle, less by what a slope at the middle knows of it: then the
 * quarters' cut has the mean that it has in all places. */
#define CRYSTAL_SLOPED 0.24f

/* The same where a square's quarters are told by the noise's slope at its middle. */
INLINE void crystal_tones_sloped(const stone_cells *c, const vf q[3], const cells_square *s,
                                 vf wide, vf cloud, vf tone[2]) {
  const vf half = splat(0.5f), zero = splat(0.0f);
  const cells_parts quarters = cells_quarters();
  vf keep = splat(c->turbidity) * crystal_keep(wide, CRYSTAL_SEEN4, CRYSTAL_GONE4), cut[2][4];
  crystal_clouds(c, wide, cloud, tone);
  if (!any(gt(keep, zero))) return;
  cells_square part;
  for (int k = 0; k < 3; k++) {
    part.u[k] = s->u[k] * half;
    part.v[k] = s->v[k] * half;
  }
  crystal_noise n = crystal_at(c, q, &part, wide * half);
  const vf sloped = splat(CRYSTAL_SLOPED);
  vf middle = n.fine, u = n.along[0] * sloped, v = n.along[1] * sloped;
  vf sheet = n.sheet, sheet_u = n.sheet_along[0] * sloped, sheet_v = n.sheet_along[1] * sloped;
  for (int i = 0; i < 4; i++) {
    vf here[2];
    n.fine = cells_towards(&quarters, i, middle, u, v);
    n.sheet = cells_towards(&quarters, i, sheet, sheet_u, sheet_v);
    crystal_cut(&n, here);
    for (int k = 0; k < 2; k++) cut[k][i] = here[k];
  }
  for (int k = 0; k < 2; k++) tone[k] = tone[k] + keep * cells_mean(&quarters, cut[k]);
}

#endif
