/* SPDX-License-Identifier: Apache-2.0
 *
 * Veins: fractures that filled with another mineral.
 *
 * Three families, each a stack of sheets across a direction of its own. A sheet is a
 * height over its plane, so that none closes in a loop or ends in a knot; it is rough
 * as fractures are, whose heights go with the power of 0.8 of their length (Bouchaud,
 * Scaling properties of cracks, J. Phys. Condens. Matter 9, 1997). Sheets wander by as
 * much as they stand apart: neighbours meet, run together and part again. Few are
 * wide, most are hairlines, and each swells, pinches out, and here and there runs in
 * two strands.
 */
#ifndef SOZAI_STONE_VEINS_H
#define SOZAI_STONE_VEINS_H

#include "../core/noise.h"
#include "../core/vectors.h"
#include "stone.h"

/* How folded the whole is: how far veins lie from where they would, in their spacing,
 * and how that changes. Over some eight spacings their direction wanders by fifteen
 * degrees or so, and never so far that a family's coordinate turns back. */
#define VEIN_FOLD 0.13f
#define VEIN_FOLDED 2.6f

typedef struct {
  vf v, g[3];
  vf many; /* where there are veins, and where there are few: +-0.5 or so, mean 0 */
} vein_fold;

INLINE vein_fold vein_folded(const stone_constants *w, const vf p[3]) {
  vein_fold f;
  vf k = splat(w->vein_frequency * VEIN_FOLD);
  float far = VEIN_FOLDED * w->vein_warp;
  f.many = noise_gradient3(p[0] * k, p[1] * k, p[2] * k, splatu(w->seed_vein + 2u), f.g);
  f.v = splat(far) * f.many;
  for (int a = 0; a < 3; a++) f.g[a] = splat(far * VEIN_FOLD) * f.g[a];
  return f;
}

/* A sheet's height over its plane, in spacings: two octaves that tell which sheets are
 * near, and two that matter to those alone. With VEIN_JITTER all of it is within 1. */
#define VEIN_JITTER 0.25f
#define VEIN_OCTAVES 4
static const float vein_finer[VEIN_OCTAVES] = {0.43f, 1.5f, 4.7f, 13.0f},
                   vein_height[VEIN_OCTAVES] = {0.46f, 0.17f, 0.068f, 0.03f};
#define VEIN_FINE (0.068f + 0.03f)

typedef struct {
  noise_axis u, v;
} vein_lattice;

INLINE vein_lattice vein_split(vf u, vf v, float finer) {
  vein_lattice a = {noise_split_cubic(u * splat(finer), HASH_X),
                    noise_split_cubic(v * splat(finer), HASH_Z)};
  return a;
}

/* Of one octave; adds to the slopes. */
INLINE vf vein_octave(const vein_lattice *a, vu seed, int o, float warp, vf slope[2]) {
  vf du, dv, high = splat(warp * vein_height[o] / HASH_ONE), steep = splat(vein_finer[o]) * high;
  vf n = noise_value2(&a->u, &a->v, seed, &du, &dv);
  slope[0] = slope[0] + du * steep;
  slope[1] = slope[1] + dv * steep;
  return n * high;
}

/* A family's place. Lengths in its spacings, but for those in mm. */
typedef struct {
  vf across, along[2]; /* where the point is */
  vf g[3], u[3], v[3]; /* how `across` changes, and a footprint's sides, mm: across, along, along */
  vf many, soft2, bent2; /* vein_fold; mm^2: softness, and of the roughness what a footprint does
                            not tell */
  float spacing, frequency, widest; /* mm; 1/mm; mm (half a width) */
  float crossing;                   /* of its veins, the part that is there */
} vein_family;

static const float vein_closer[VEIN_FAMILIES] = {1.0f, 1.7f, 2.9f}; /* than the first's are */
static const float vein_turned[VEIN_FAMILIES] = {1.0f, -1.0f, 0.6f};
static const float vein_crowded[VEIN_FAMILIES] = {0.8f, -0.5f, -0.9f};

/* Of which there are any veins. */
INLINE int vein_families(const stone_constants *w) {
  return w->vein_crossing > 0.0f ? VEIN_FAMILIES : 1;
}

#define VEIN_APART 0.2f /* of the spacing: strands are no farther from each other */
#define VEIN_STRAY 5.0f /* of the vein's half width */

/* Of a strip, what a footprint of an extent shows that lies there: by its two sides, since a
 * sharp one's width is below what a distance is known to. */
INLINE vf vein_strip(vf low, vf high, vf inverse) {
  const vf half = splat(0.5f);
  return clamp01(half + high * inverse) - clamp01(half + low * inverse);
}

/* Streaks along a vein: value noise on a sheet's roughness' cells along it, and VEIN_STREAK cells
 * across half of its greatest width; and one finer. */
#define VEIN_STREAK 2.6f
#define VEIN_STREAK_FINER 2.3f
#define VEIN_STREAK_CUT 0.6f /* of those cells: wider footprints are seen in two parts */
#define VEIN_STREAK_HIGH 1.25f

/* Of a value noise's place what it tells of an extent's mean, and of a finer one's. By regression
 * over 60,000 of each: 0.87 of one cell (0.88), 0.61 of two (0.64), 0.39 of three (0.45); past 8
 * nothing. */
INLINE void vein_streak_keep(vf e, vf keep[2]) {
  const vf one = splat(1.0f), finer = splat(VEIN_STREAK_FINER * VEIN_STREAK_FINER);
  e = vmin(e, splat(100.0f));
  vf e2 = splat(0.137f) * e * e, a = one + e2, b = one + finer * e2, k = splat(1.1f) / (a * b);
  keep[0] = vmax(b * k - splat(0.1f), splat(0.0f));
  keep[1] = vmax(a * k - splat(0.1f), splat(0.0f));
}

/* Within +-1, mean 0. x: the place across, in cells; keep: of the noise and of the finer one. */
INLINE vf vein_streak(vu seed, const vein_lattice fine[2], vf x, const vf keep[2]) {
  const vf far = splat(128.0f), zero = splat(0.0f), one = splat(1.0f);
  const noise_axis *along[2] = {&fine[0].u, &fine[1].v};
  const float finer[2] = {1.0f, VEIN_STREAK_FINER}, high[2] = {1.0f, 0.7f};
  vf n = zero, unused;
  for (uint32_t o = 0; o < 2; o++) {
    if (!any(gt(keep[o], zero))) continue;
    noise_axis across = noise_split_cubic(clamp(x * splat(finer[o]), zero - far, far), HASH_Z);
    n = n + splat(high[o]) * keep[o] *
                noise_value2(along[o], &across, seed + splatu(50u + o), &unused, &unused);
  }
  return clamp(splat(VEIN_STREAK_HIGH / HASH_ONE) * n, splat(-1.0f), one);
}

/* How much of its colour a vein has, so far off its middle. e2: the footprint's extent across it,
 * squared; mm. */
INLINE vf vein_streaks(const stone_constants *w, const vein_family *f, vu seed, vf widest, vf d,
                       vf e2, const vein_lattice fine[2]) {
  const vf one = splat(1.0f), zero = splat(0.0f), most = splat(0.5f * w->vein_variation);
  vf per = splat(VEIN_STREAK) / vmax(widest, splat(1e-4f * f->spacing));
  vf x = d * per, e = vsqrt(e2) * per, n;
  vm cut = gt(e, splat(VEIN_STREAK_CUT));
  vf part = sel(cut, splat(0.5f) * e, e);
  vf keep[2];
  vein_streak_keep(part, keep);
  if (!any(gt(keep[0], zero))) return one - most;
  if (any(cut)) {
    vf off = sel(cut, splat(0.25f) * e, zero);
    n = splat(0.5f) *
        (vein_streak(seed, fine, x - off, keep) + vein_streak(seed, fine, x + off, keep));
  } else {
    n = vein_streak(seed, fine, x, keep);
  }
  return one - most * (one + n);
}

/* The share of the footprint that a sheet takes. widest: half its width, at most, mm; from,
 * slope: how far off it is, and how it lies, by its two wide octaves. */
INLINE vf vein_sheet(const stone_constants *w, const vein_family *f, vu seed, vf widest, vf from,
                     vf slope[2], const vein_lattice fine[2]) {
  const vf one = splat(1.0f);
  vf rough = splat(0.0f), unused;
  for (int o = 2; o < VEIN_OCTAVES; o++) {
    vf fast[2] = {splat(0.0f), splat(0.0f)};
    rough =
        rough + vein_octave(&fine[o - 2], seed + splatu(7u * (uint32_t)o), o, w->vein_warp, fast);
    /* a slope tells of the sides of a wide vein as little as they are far from its middle */
    vf tells = one / (one + widest * splat(2.0f * vein_finer[o] / f->spacing));
    for (int i = 0; i < 2; i++) slope[i] = slope[i] + tells * fast[i];
  }
  /* how wide: of few much, and along its way more and less */
  vein_lattice a = vein_split(f->along[0], f->along[1], 0.37f),
               b = vein_split(f->along[0], f->along[1], 0.9f);
  vf swell = noise_value2(&a.u, &a.v, seed + splatu(40u), &unused, &unused),
     strands =
         noise_value2(&b.u, &b.v, seed + splatu(41u), &unused, &unused) +
         splat(0.45f) * noise_value2(&fine[0].u, &fine[0].v, seed + splatu(42u), &unused, &unused);
  swell = clamp01(splat(0.35f) + splat(1.2f / HASH_ONE) * swell + f->many + splat(2.0f) * rough);
  vf wide = swell * widest;
  /* a lesser strand, which leaves it on either side and comes back */
  const float far = VEIN_APART * f->spacing, alone = 0.2f * HASH_ONE;
  vf apart =
      wide * splat(VEIN_STRAY / HASH_ONE) * (strands - clamp(strands, splat(-alone), splat(alone)));
  apart = clamp(apart, splat(-far), splat(far));
  /* the sheet's normal, in the family's frame */
  vf g[3] = {f->g[0], f->g[1] - slope[0], f->g[2] - slope[1]};
  vf k = inverse_root(vmax(dot3(g, g), splat(0.09f)));
  vf d = (from - rough) * k * splat(f->spacing), eu = dot3(g, f->u) * k, ev = dot3(g, f->v) * k;
  vf extent2 = eu * eu + ev * ev, inverse = one / vsqrt(extent2 + f->soft2);
  /* on the strand's side, and of the strand what the vein itself does not cover */
  vf to = sel(lt(apart, splat(0.0f)), splat(0.0f) - d, d), strand = vabs(apart);
  vf low = vmax(strand - splat(0.55f) * wide, wide), high = vmax(strand + splat(0.55f) * wide, low);
  vf share = vein_strip(splat(0.0f) - wide - to, wide - to, inverse) +
             vein_strip(low - to, high - to, inverse);
  if (w->vein_variation > 0.0f && any(gt(share, splat(0.0f))))
    share = share * vein_streaks(w, f, seed, widest, d, extent2 + f->bent2, fine);
  return share;
}

/* strip: see vein_family_strip. */
INLINE void vein_open(const stone_constants *w, int strip, const vf p[3], const vf u[3],
                      const vf v[3], const vein_fold *fold, int family, vein_family *f) {
  const float(*m)[3] = w->vein_frame[family];
  const float frequency = w->vein_frequency * vein_closer[family];
  const vf one = splat(1.0f), quarter = splat(0.25f), side = splat(vein_turned[family]);
  vf at[3];
  for (int k = 0; k < 3; k++) {
    vf row[3] = {splat(m[k][0]), splat(m[k][1]), splat(m[k][2])};
    at[k] = dot3(row, p) * splat(frequency);
    f->u[k] = dot3(row, u);
    f->v[k] = dot3(row, v);
    f->g[k] = side * dot3(row, fold->g);
  }
  f->g[0] = f->g[0] + one;
  f->across = at[0] + side * splat(vein_closer[family]) * fold->v;
  f->along[0] = at[1];
  f->along[1] = at[2];
  f->many = splat(vein_crowded[family]) * fold->many;
  f->crossing = family == 0 ? 1.0f : w->vein_crossing;
  f->frequency = frequency;
  f->spacing = 1.0f / frequency;
  /* of a sheet within half a spacing of another's place nothing reaches over that */
  float widest = 0.5f * w->vein_width / vein_closer[family], soft = w->vein_soft;
  f->widest = widest < 0.25f * f->spacing ? widest : 0.25f * f->spacing;
  if (soft > 0.4f * f->spacing) soft = 0.4f * f->spacing;
  /* what bends within the footprint blurs: an octave's sd is 0.37 of its height */
  vf along2 = quarter * (f->v[1] * f->v[1] + f->v[2] * f->v[2]);
  along2 = along2 + (strip ? along2 : quarter * (f->u[1] * f->u[1] + f->u[2] * f->u[2]));
  f->bent2 = splat(0.0f);
  for (int o = 2; o < VEIN_OCTAVES; o++) {
    const float sd = 0.37f * f->spacing * w->vein_warp * vein_height[o];
    const float finer = vein_finer[o] * frequency;
    vf bent = vmin(along2 * splat(finer * finer), one);
    f->bent2 = f->bent2 + splat(12.0f * sd * sd) * bent * bent;
  }
  f->soft2 = splat(soft * soft + 1e-12f) + f->bent2;
}

#define VEIN_SHEETS 48 /* that a strip is asked for, at most: more than VEIN_GONE needs */

INLINE vf vein_family_as(const stone_constants *w, int strip, const vf p[3], const vf u[3],
                         const vf v[3], const vein_fold *fold, int family) {
  const vf one = splat(1.0f), zero = splat(0.0f), half = splat(0.5f);
  vein_family f;
  vein_open(w, strip, p, u, v, fold, family, &f);
  const vf frequency = splat(f.frequency);
  vein_lattice coarse[2], fine[2];
  for (int o = 0; o < 2; o++) coarse[o] = vein_split(f.along[0], f.along[1], vein_finer[o]);
  int made = 0;
  vi middle, unused;
  (void)vfloor(f.across + half, &middle);
  vf blur = half * vsqrt(dot3(u, u) + dot3(v, v) + f.soft2);
  /* within 1.5 of the middle is what a point may see */
  vf most = one, free = one;
  if (strip) most = vfloor(half * (vabs(f.u[0]) + vabs(f.v[0])) * frequency + splat(1.5f), &unused);
  for (int n = 0; n < (strip ? VEIN_SHEETS : 3); n++) {
    const int far = (n + 1) / 2, i = n & 1 ? far : -far;
    vm asked = le(splat((float)far), most);
    if (strip && !any(asked)) break;
    vi which = middle + (vi)splatu((uint32_t)i);
    vu seed = (vu)which * splatu(HASH_Y) + splatu(w->seed_vein + 16u * (uint32_t)family + 5u);
    vf jitter = hash_signed(seed + splatu(1u)), slope[2] = {zero, zero};
    vf chance = vabs(hash_signed(seed + splatu(2u))) * splat(1.0f / HASH_ONE / f.crossing);
    vm there = and_(asked, lt(chance, one));
    if (!any(there)) continue;
    vf from = f.across - to_float(which) - splat(VEIN_JITTER / HASH_ONE) * jitter;
    for (uint32_t o = 0; o < 2; o++)
      from = from - vein_octave(&coarse[o], seed + splatu(7u * o), (int)o, w->vein_warp, slope);
    /* a sheet at sixty degrees to its plane is half as far as it is high */
    vf widest = chance * chance * chance * splat(f.widest);
    vf seen =
        widest + vmin(widest * splat(1.3f * VEIN_STRAY), splat(VEIN_APART * f.spacing)) + blur;
    vf away = seen * frequency * splat(2.0f) + splat(VEIN_FINE * w->vein_warp);
    vm near = and_(there, lt(vabs(from), away));
    if (!any(near)) continue;
    if (!made)
      for (int o = 0; o < 2; o++) fine[o] = vein_split(f.along[0], f.along[1], vein_finer[o + 2]);
    made = 1;
    vf share = vein_sheet(w, &f, seed, widest, from, slope, fine);
    free = sel(near, strip ? vmax(free - share, zero) : free * (one - share), free);
  }
  return one - free;
}

/* The share of a footprint that a family's veins take. u, v: its sides, mm. */
STAGE vf vein_family_share(const stone_constants *w, const vf p[3], const vf u[3], const vf v[3],
                           const vein_fold *fold, int family) {
  return vein_family_as(w, 0, p, u, v, fold, family);
}

/* The same where side u goes across the sheets and may be as long as several stand apart: over that
 * a sheet is as high as at the middle, and veins lie side by side. */
STAGE vf vein_family_strip(const stone_constants *w, const vf p[3], const vf u[3], const vf v[3],
                           const vein_fold *fold, int family) {
  return vein_family_as(w, 1, p, u, v, fold, family);
}

#endif
