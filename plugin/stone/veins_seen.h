/* SPDX-License-Identifier: Apache-2.0
 *
 * Veins under a footprint.
 *
 * A sheet bends along itself, while across itself how far off it is tells all: so a wide
 * footprint is cut, for each family, in strips that go across its sheets.
 */
#ifndef SOZAI_STONE_VEINS_SEEN_H
#define SOZAI_STONE_VEINS_SEEN_H

#include "veins.h"

#define VEIN_STRIPS 4          /* of a whole footprint, and twos of quarters */
#define VEIN_STRIPS_WIDE 45.0f /* to a spacing of the first family's */
#define VEIN_KEPT 3.0f         /* of a family's own spacings: footprints that are seen, */
#define VEIN_GONE 7.0f         /* and that see its mean alone */

/* A footprint in strips along one of its directions. Lengths in mm. */
typedef struct {
  vf u, v;       /* that direction, in the footprint's sides; unit */
  vf inverse[2]; /* one over them, and not over nothing */
  vf wide;       /* a strip */
} vein_cut;

/* The direction in which `across` grows, or any if it does not. */
INLINE vein_cut vein_cut_of(const stone_constants *w, int family, const vein_fold *fold,
                            const vf t1[3], const vf t2[3], vf s, vf strips) {
  const vf one = splat(1.0f), least = splat(1e-3f);
  const float *m = w->vein_frame[family][0];
  vein_cut c;
  vf g[3];
  for (int k = 0; k < 3; k++) g[k] = splat(m[k]) + splat(vein_turned[family]) * fold->g[k];
  vf u = dot3(g, t1), v = dot3(g, t2), k = inverse_root(u * u + v * v + splat(1e-12f));
  c.u = u * k;
  c.v = v * k;
  vm level = lt(c.u * c.u + c.v * c.v, splat(0.5f));
  c.u = sel(level, one, c.u);
  c.v = sel(level, splat(0.0f), c.v);
  c.inverse[0] = one / sel(lt(vabs(c.u), least), least, c.u);
  c.inverse[1] = one / sel(lt(vabs(c.v), least), least, c.v);
  c.wide = (vabs(c.u) + vabs(c.v)) * s / strips;
  return c;
}

/* Where a strip, `off` from the footprint's middle, lies within it: its own middle, and its length.
 */
INLINE vf vein_strip_of(const vein_cut *c, vf s, vf off, vf *length) {
  vf half = splat(0.5f), h = half * s;
  vf a = off * c->v * c->inverse[0], b = splat(0.0f) - off * c->u * c->inverse[1];
  vf reach_a = vabs(h * c->inverse[0]), reach_b = vabs(h * c->inverse[1]);
  vf low = vmax(a - reach_a, b - reach_b), high = vmin(a + reach_a, b + reach_b);
  *length = vmax(high - low, splat(0.0f));
  return half * (low + high);
}

/* The share of a family. strips: how many, 1 where one part is all. */
INLINE vf vein_family_seen(const stone_constants *w, const vf p[3], const vf t1[3], const vf t2[3],
                           vf s, vf strips, const vein_fold *fold, int family) {
  const vf half = splat(0.5f), zero = splat(0.0f);
  vein_cut c = vein_cut_of(w, family, fold, t1, t2, s, strips);
  vf sum = zero, all = zero;
  for (int j = 0; j < VEIN_STRIPS; j++) {
    vm there = lt(splat((float)j), strips);
    if (!any(there)) break;
    vf off = (splat((float)j + 0.5f) - half * strips) * c.wide, length, at[3], u[3], v[3];
    vf on = vein_strip_of(&c, s, off, &length);
    for (int k = 0; k < 3; k++) {
      vf across = t1[k] * c.u + t2[k] * c.v, along = t2[k] * c.u - t1[k] * c.v;
      at[k] = p[k] + across * on + along * off;
      u[k] = across * length;
      v[k] = along * c.wide;
    }
    vein_fold here = vein_folded(w, at);
    vf share = vein_family_strip(w, at, u, v, &here, family);
    sum = sel(there, sum + length * share, sum);
    all = sel(there, all + length, all);
  }
  return sum / vmax(all, splat(1e-12f));
}

/* Of all families, in a part of side s of a footprint that is `wide` spacings of the first's.
 * strips: how many, 1 where one look is all. */
STAGE vf vein_part_share(const stone_constants *w, const vf p[3], const vf t1[3], const vf t2[3],
                         vf s, vf wide, vf strips) {
  const int families = vein_families(w);
  vf one = splat(1.0f), zero = splat(0.0f), free = one, u[3], v[3];
  vm several = gt(strips, one);
  const int alone = any(not_(several)), cut = any(several);
  vein_fold fold = vein_folded(w, p);
  for (int k = 0; k < 3; k++) {
    u[k] = t1[k] * s;
    v[k] = t2[k] * s;
  }
  for (int f = 0; f < families; f++) {
    vf own = wide * splat(vein_closer[f]), mean = splat(w->vein_mean[f]), share = mean;
    vf keep = one - smooth_step(splat(VEIN_KEPT), splat(VEIN_GONE), own);
    if (any(gt(keep, zero))) {
      if (alone) share = vein_family_share(w, p, u, v, &fold, f);
      if (cut) share = sel(several, vein_family_seen(w, p, t1, t2, s, strips, &fold, f), share);
      share = sel(lt(keep, one), sel(gt(keep, zero), mix(mean, share, keep), mean), share);
    }
    free = free * (one - share);
  }
  return one - free;
}

/* Over the footprint. t1, t2: its sides, s: mm. Families cross: where veins of several are in a
 * wide footprint, quarters of it tell how they lie over one another. */
INLINE vf vein_share(const stone_constants *w, const vf p[3], const vf t1[3], const vf t2[3],
                     vf s) {
  vf one = splat(1.0f), quarter = splat(0.25f), wide = s * splat(w->vein_frequency), share = one;
  vi whole;
  vf few = vmax(s * splat(1.5f / w->vein_width), wide * splat(39.0f));
  vf parts = vmax(wide * splat(VEIN_STRIPS_WIDE), vmin(few, splat(1.3f)));
  vf strips = clamp(vfloor(parts + splat(0.87f), &whole), one, splat(VEIN_STRIPS + 1.0f));
  vm quartered = gt(strips, splat(VEIN_STRIPS));
  if (any(not_(quartered))) share = vein_part_share(w, p, t1, t2, s, wide, strips);
  if (!any(quartered)) return share;
  vf sum = splat(0.0f), half = splat(0.5f) * s;
  for (int i = 0; i < 4; i++) {
    vf u = quarter * (i & 1 ? s : splat(0.0f) - s), v = quarter * (i & 2 ? s : splat(0.0f) - s);
    vf at[3];
    for (int k = 0; k < 3; k++) at[k] = p[k] + t1[k] * u + t2[k] * v;
    sum = sum + vein_part_share(w, at, t1, t2, half, wide, splat(2.0f));
  }
  return sel(quartered, sum * quarter, share);
}

#endif
