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
#define LAMELLAE_GONE 0.29f /* cells: wider footprints see none */
#define CRYSTAL_FINE 7.3f   /* frequency of what is fine within crystals, 1/cell */
#define CRACK_MEAN 0.1023f  /* of max(0, 1 - |n| / 0.05), n gradient noise */
#define FLECK_MEAN 0.0137f  /* of clamp01((n - 0.36) 8) */

/* What clouds, cracks and flecks are cut from: a noise and how much it changes
 * over the footprint; and what the footprint leaves of them. */
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
  /* the corners' gradients are not all of its slope, but of its square some half */
  vf a = g[0] * s->u[0] + g[1] * s->u[1] + g[2] * s->u[2];
  vf b = g[0] * s->v[0] + g[1] * s->v[1] + g[2] * s->v[2];
  const float square = 0.5f * 1.8f * CRYSTAL_FINE * CRYSTAL_FINE / (HASH_ONE * HASH_ONE);
  n.extent2 =
      vmin(splat(square) * (a * a + b * b), splat(0.05f)); /* a noise is no plane for long */
  return n;
}

/* The integral from 0 to f of value noise's blend, and of the rest. */
INLINE vf crystal_blend(vf f) { return f * f * f * (splat(1.0f) - splat(0.5f) * f); }

/* The mean over the footprint, within +-1.5; of all places 0. Value noise along the
 * crystal's direction, its integral exact for up to two lamellae. Each is the difference
 * of two numbers, the next one's other way round: many together are as good as none. h:
 * the crystal's. */
INLINE vf crystal_lamellae(vu h, const vf q[3], const cells_square *s) {
  const vf k = splat(LAMELLAE / HASH_ONE);
  vu hash = hash_upper(h ^ splatu(0x3c6ef35fu));
  vf d[3] = {to_float((vi)hash) * k, to_float((vi)(hash << 10)) * k,
             to_float((vi)(hash << 20)) * k};
  vf t = d[0] * q[0] + d[1] * q[1] + d[2] * q[2];
  vf a = d[0] * s->u[0] + d[1] * s->u[1] + d[2] * s->u[2];
  vf b = d[0] * s->v[0] + d[1] * s->v[1] + d[2] * s->v[2];
  vf one = splat(1.0f), zero = splat(0.0f), wide = vsqrt(a * a + b * b + splat(1e-4f));
  vf keep = crystal_keep(wide, 1.0f, 2.0f), side = vmin(wide, splat(2.0f));
  if (!any(gt(keep, zero))) return zero;
  vi first;
  vf from = t - splat(0.5f) * side, f = from - vfloor(from, &first);
  vf number[5], value[4], high[3];
  int pieces = 0;
  for (int i = 0; i < 5; i++) {
    /* the last of the three pieces below is not reached by a side of one */
    if (i == 4 && !any(gt(side, one))) break;
    number[i] = hash_signed((vu)first * splatu(HASH_X) + hash + splatu((uint32_t)i * HASH_X));
    if (i > 0) value[i - 1] = number[i - 1] - number[i];
    pieces = i - 1;
  }
  /* from f to f + side over three pieces of one each, of which the first begins at f */
  high[0] = vmin(f + side, one);
  high[1] = clamp01(f + side - one);
  high[2] = vmax(f + side - splat(2.0f), zero);
  vf sum = value[0] * (high[0] - f) +
           (value[1] - value[0]) * (crystal_blend(high[0]) - crystal_blend(f));
  for (int i = 1; i < pieces; i++)
    sum = sum + value[i] * high[i] + (value[i + 1] - value[i]) * crystal_blend(high[i]);
  return keep * sum / (side * splat(1.4142135f * HASH_ONE));
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
