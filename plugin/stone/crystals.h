/* SPDX-License-Identifier: Apache-2.0
 *
 * What is seen within a crystal, as brightness relative to its mineral, mean 1:
 * the lamellae of cleavage and of twins, straight, in each crystal in a direction
 * of its own; clouds, as of altered feldspar; the healed cracks of quartz, light,
 * and flecks of mica, dark. MacKenzie, Donaldson and Guilford, Atlas of Igneous
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

#define LAMELLAE 13.0f      /* to a cell, of the finest direction's */
#define LAMELLAE_GONE 0.4f  /* cells: wider footprints see none */
#define LAMELLAE_BOTH 0.29f /* wider: those of the nearer crystal alone, and of bodies none */
#define CRYSTAL_FINE 7.3f   /* frequency of what is fine within crystals, 1/cell */
#define CRACK_MEAN 0.1023f  /* of max(0, 1 - |n| / 0.05), n gradient noise */
#define FLECK_MEAN 0.0137f  /* of clamp01((n - 0.36) 8) */

/* What clouds, cracks and flecks are cut from: a noise's mean over the footprint, as far as
 * its middle tells, and how much it changes there; and what the footprint leaves of them. */
typedef struct {
  vf fine, extent2, keep, cloud;
} crystal_noise;

/* Whether there is anything to be seen. */
INLINE int crystal_textured(const stone_cells *c) {
  return c->cleavage > 0.0f || c->turbidity > 0.0f;
}

/* 1 up to low, 0 from high on. */
INLINE vf crystal_keep(vf wide, float low, float high) {
  vf t = clamp01((splat(high) - wide) * splat(1.0f / (high - low)));
  return t * t * (splat(3.0f) - t - t);
}

/* q: cells, before their faces are bent. wide: the square's longer side. cloud: of a
 * size of a third of a cell. */
INLINE crystal_noise crystal_at(const stone_cells *c, const vf q[3], const cells_square *s, vf wide,
                                vf cloud) {
  vf zero = splat(0.0f), g[3], f = splat(CRYSTAL_FINE), t = splat(c->turbidity);
  crystal_noise n = {zero, zero, zero, zero};
  n.cloud = cloud * t * crystal_keep(wide, 0.16f, 0.48f);
  n.keep = t * crystal_keep(wide, 0.4f / CRYSTAL_FINE, 1.4f / CRYSTAL_FINE);
  if (!any(gt(n.keep, zero))) return n;
  const vf at[3] = {q[0] * f, q[1] * f, q[2] * f};
  n.fine = value_three(at, splatu(c->seed_warp + 2u), 1, g) * splat(1.0f / HASH_ONE);
  /* of a middle's number less is left the less the noise about it knows of it */
  vf wide2 = splat(CRYSTAL_FINE * CRYSTAL_FINE) * wide * wide;
  n.fine = n.fine / (splat(1.0f) + splat(0.3f) * wide2);
  /* the corners' gradients are not all of its slope, but of its square some half */
  vf a = dot3(g, s->u), b = dot3(g, s->v);
  const float square = 0.5f * 1.8f * CRYSTAL_FINE * CRYSTAL_FINE / (HASH_ONE * HASH_ONE);
  /* a noise is no plane for long, and bends where it has no slope */
  n.extent2 = vmin(splat(square) * (a * a + b * b), splat(0.05f)) + splat(0.1f) * wide2 * wide2;
  return n;
}

/* The integral from 0 to f of value noise's blend, and of the rest. */
INLINE vf crystal_blend(vf f) { return f * f * f * (splat(1.0f) - splat(0.5f) * f); }

INLINE vf crystal_number(vu hash, vi at, uint32_t on) {
  return hash_signed((vu)at * splatu(HASH_X) + hash + splatu(on * HASH_X));
}

/* The mean over the footprint, within +-1.5; of all places 0. Value noise along the
 * crystal's direction. Each lamella is the difference of two numbers, the next one's other
 * way round, so that the sum over any number of them is that of the two ends' numbers, and
 * the integral exact however wide the footprint, if it is a line: across two sides of
 * several lamellae each there is nothing left. h: the crystal's. */
INLINE vf crystal_lamellae(vu h, const vf q[3], const cells_square *s) {
  const vf k = splat(LAMELLAE / HASH_ONE);
  vu hash = hash_upper(h ^ splatu(0x3c6ef35fu));
  vf d[3] = {to_float((vi)hash) * k, to_float((vi)(hash << 10)) * k,
             to_float((vi)(hash << 20)) * k};
  vf t = d[0] * q[0] + d[1] * q[1] + d[2] * q[2];
  vf a = d[0] * s->u[0] + d[1] * s->u[1] + d[2] * s->u[2];
  vf b = d[0] * s->v[0] + d[1] * s->v[1] + d[2] * s->v[2];
  vf one = splat(1.0f), zero = splat(0.0f), square = a * a + b * b + splat(1e-4f);
  vf inverse = inverse_root(square), side = square * inverse;
  vf least = vmin(vabs(a), vabs(b));
  vf keep = crystal_keep(least, 0.7f, 2.5f);
  if (!any(gt(keep, zero))) return zero;
  vi first[2];
  vf from = t - splat(0.5f) * side, f[2], number[2][3], sum[2];
  f[0] = from - vfloor(from, &first[0]);
  f[1] = from + side;
  f[1] = f[1] - vfloor(f[1], &first[1]);
  int wide = any(gt(side, one));
  for (uint32_t j = 0; j < 3; j++) {
    number[0][j] = crystal_number(hash, first[0], j);
    if (wide) number[1][j] = crystal_number(hash, first[1], j);
  }
  if (!wide) {
    /* the other end is in the same piece or the next */
    vm next = lti(first[0], first[1]);
    number[1][0] = sel(next, number[0][1], number[0][0]);
    number[1][1] = sel(next, number[0][2], number[0][1]);
    number[1][2] = sel(next, crystal_number(hash, first[0], 3), number[0][2]);
  }
  for (int i = 0; i < 2; i++) {
    vf low = number[i][0] - number[i][1], high = number[i][1] - number[i][2];
    sum[i] = low * f[i] + (high - low) * crystal_blend(f[i]) -
             splat(0.5f) * (number[i][0] + number[i][1]);
  }
  return keep * (sum[1] - sum[0]) * (inverse * splat(0.70710678f / HASH_ONE));
}

/* What of it does not differ from crystal to crystal: of the base's and the third
 * mineral (feldspars), and of the second (quartz). Cracks and flecks are blurred as if the
 * noise were a plane over the footprint. */
INLINE void crystal_tones(const crystal_noise *n, vf tone[2]) {
  vf zero = splat(0.0f), wide = vsqrt(n->extent2 + splat(0.015625f)),
     broad = splat(0.5f) * wide - splat(0.0125f), inverse = splat(1.0f) / (broad * wide);
  vf per = inverse * wide; /* 1 / broad */
  vf crack = splat(0.05f) * vmax(broad - vabs(n->fine), zero) * per * per - splat(CRACK_MEAN);
  vf fleck =
      clamp01(splat(0.5f) + (n->fine - splat(0.4225f)) * (inverse * broad)) - splat(FLECK_MEAN);
  tone[0] = splat(0.1f) * n->cloud + n->keep * (splat(0.16f) * n->fine - splat(0.6f) * fleck);
  tone[1] = splat(0.3f) * n->cloud + n->keep * (splat(0.3f) * n->fine + splat(0.16f) * crack);
}

#endif
