/* SPDX-License-Identifier: Apache-2.0
 *
 * What fills joints: sharp sand, or mortar of it. Grains of one size, packed, in a ground of finer
 * ones. A grain is a ball about a jittered point, the largest of r^2 - d^2: where two have the
 * place the face between them is flat, as of a power diagram, and what is seen of each is angular.
 */
#ifndef SOZAI_STONE_SAND_H
#define SOZAI_STONE_SAND_H

#include "value.h"
#include "weather.h"

/* Cells: how far a centre strays along each axis, and radii squared, the middle of their range and
 * half of that. With the largest of both no ball reaches past the two cells about a place along an
 * axis: stray + radius is less than 1. */
#define SAND_STRAY 0.3f
#define SAND_RADIUS2 0.24f
#define SAND_RADIUS2_SPREAD 0.24f
/* Of r^2 - d^2, cells: how far a grain stands out. The plane that it is broken along: how far over
 * the middle, and how steep along each axis, at most. */
#define SAND_RISE 0.7f
#define SAND_BROKEN 0.15f
#define SAND_TILT 0.5f
#define SAND_STEEP 1.2f /* how fast that comes in from where two grains touch */

#define SAND_FINER 2.7f     /* the fines' frequency over the grains' */
#define SAND_EDGE 0.06f     /* cells: how soft a grain's outline is */
#define SAND_GONE 1.7f      /* as NOISE_GONE */
#define SAND_SHADED 0.6f    /* of the height, cells: how much darker what lies low is */
#define SAND_CLOUDS 0.07f   /* frequency of damp and dust, of the grains' */
#define SAND_DARKEST -0.85f /* no grain is black */

/* Means over a plane, in cells: of the height that a layer of grains has over its ground, and of
 * the square of its slope along one axis (property.stone_sand measures them). */
#define SAND_HEIGHT 0.044f
#define SAND_SLOPE2 0.085f

/* A grain as it is found: r^2 - d^2, the place over its centre, its number. */
typedef struct {
  vf in, x[3];
  vu h;
} sand_grain;

INLINE void sand_choose(vm m, const sand_grain *from, sand_grain *to) {
  to->in = sel(m, from->in, to->in);
  for (int k = 0; k < 3; k++) to->x[k] = sel(m, from->x[k], to->x[k]);
  to->h = (vu)seli(m, (vi)from->h, (vi)to->h);
}

/* The two that have the place most. at: cells. */
INLINE void sand_find(const vf at[3], uint32_t seed, sand_grain near[2]) {
  static const uint32_t prime[3] = {HASH_X, HASH_Y, HASH_Z};
  const vf by = splat(SAND_STRAY / HASH_ONE), one = splat(1.0f);
  noise_axis a[3];
  for (int k = 0; k < 3; k++) (void)noise_cell(at[k], prime[k], &a[k]);
  near[0].in = near[1].in = splat(-9.0f);
  near[0].h = near[1].h = splatu(0u);
  for (int k = 0; k < 3; k++) near[0].x[k] = near[1].x[k] = one;
  for (int c = 0; c < 8; c++) {
    sand_grain g;
    g.h = hash_upper(value_corner(a, c, splatu(seed)));
    for (int k = 0; k < 3; k++) {
      vf from = c >> k & 1 ? a[k].f - one : a[k].f;
      g.x[k] = from - by * to_float((vi)(g.h << (10 * (unsigned)k)));
    }
    /* of bits that are little in those */
    vf r2 = splat(SAND_RADIUS2) + splat(SAND_RADIUS2_SPREAD / HASH_ONE) * to_float((vi)(g.h << 5));
    g.in = r2 - dot3(g.x, g.x);
    vm first = gt(g.in, near[0].in), second = gt(g.in, near[1].in);
    sand_choose(second, &g, &near[1]);
    sand_choose(first, &near[0], &near[1]);
    sand_choose(first, &g, &near[0]);
  }
}

/* Light and dark: most grains differ little, some much. */
INLINE vf sand_tone(vu h) {
  vf u = to_float((vi)(hash_mix(h ^ splatu(0x2545f491u)))) * splat(1.0f / HASH_ONE);
  return u * (splat(0.17f) + splat(0.35f) * u * u);
}

/* A dome that is broken off along a plane of the grain's own; 0 where there is no grain. Towards
 * the next grain less is off, and where they touch nothing: there their domes are as high. */
INLINE field sand_rise(const sand_grain *a, const sand_grain *b) {
  const vf zero = splat(0.0f), two = splat(2.0f);
  field off = field_of(splat(SAND_RISE) * a->in - splat(SAND_BROKEN)), rise;
  vu h = hash_upper(a->h);
  vf most = splat(SAND_STEEP) * (a->in - b->in), slope[3];
  for (int k = 0; k < 3; k++) {
    vf lean = splat(SAND_TILT / HASH_ONE) * to_float((vi)(h << (10 * (unsigned)k)));
    slope[k] = splat(-2.0f * SAND_RISE) * a->x[k];
    off.v = off.v - lean * a->x[k];
    off.g[k] = slope[k] - lean;
  }
  vm broken = gt(off.v, zero), near = lt(most, off.v);
  rise.v = splat(SAND_RISE) * a->in - vmax(vmin(off.v, most), zero);
  vm there = gt(rise.v, zero);
  rise.v = vmax(rise.v, zero);
  for (int k = 0; k < 3; k++) {
    vf g = sel(near, splat(SAND_STEEP) * two * (b->x[k] - a->x[k]), off.g[k]);
    rise.g[k] = sel(there, slope[k] - sel(broken, g, zero), zero);
  }
  return rise;
}

/* Grains of one size: how far they rise over their ground, cells; their shade, and how much of the
 * footprint they are. */
typedef struct {
  field rise;
  vf tone, cover;
} sand_layer;

INLINE sand_layer sand_grains(const vf at[3], uint32_t seed, vf e) {
  sand_layer q;
  sand_grain near[2];
  sand_find(at, seed, near);
  const sand_grain *a = &near[0], *b = &near[1];
  vf half = splat(0.5f), g[3], inverse = splat(1.0f) / (e + splat(SAND_EDGE));
  for (int k = 0; k < 3; k++) g[k] = a->x[k] - b->x[k];
  vf each = half * inverse, tiny = splat(1e-6f);
  vf own = clamp01(half + (a->in - b->in) * each * inverse_root(dot3(g, g) + tiny));
  q.cover = clamp01(half + a->in * each * inverse_root(dot3(a->x, a->x) + tiny));
  q.tone = mix(sand_tone(b->h), sand_tone(a->h), own);
  q.rise = sand_rise(a, b);
  return q;
}

/* Its height over its mean, mm; light and dark, of mean 0; variance of slope along one axis that
 * the footprint averages out. */
typedef struct {
  field height;
  vf tone, lost;
} sand;

/* p: object space; frequency: 1/mm. */
STAGE sand sand_at(const vf p[3], float frequency, uint32_t seed, vf s) {
  const float(*row)[3] = value_aslant, mm = 1.0f / frequency; /* no face shows rows of grains */
  vf zero = splat(0.0f), at[3], by = splat(frequency / 11.0f), unused = zero;
  vf e = s * splat(frequency), keep = weather_keep(e, SAND_GONE),
     fine = weather_keep(e * splat(SAND_FINER), SAND_GONE);
  sand q = {field_of(zero), zero, zero};
  q.lost = splat(SAND_SLOPE2) * (splat(1.0f) - keep * keep);
  if (any(gt(keep, zero))) {
    for (int k = 0; k < 3; k++)
      at[k] = by * (splat(row[k][0]) * p[0] + splat(row[k][1]) * p[1] + splat(row[k][2]) * p[2]);
    sand_layer grains = sand_grains(at, seed, e), ground = {field_of(zero), zero, zero};
    if (any(gt(fine, zero))) {
      for (int k = 0; k < 3; k++) at[k] = at[k] * splat(SAND_FINER);
      ground = sand_grains(at, seed + 1u, e * splat(SAND_FINER));
    }
    /* whichever stands higher */
    vm over = gt(grains.rise.v, ground.rise.v * fine * splat(1.0f / SAND_FINER));
    vf g[3];
    for (int k = 0; k < 3; k++) g[k] = sel(over, grains.rise.g[k], ground.rise.g[k] * fine);
    vf high = sel(over, grains.rise.v, ground.rise.v * fine * splat(1.0f / SAND_FINER));
    q.height.v = keep * (high - splat(SAND_HEIGHT)) * splat(mm);
    for (int k = 0; k < 3; k++)
      q.height.g[k] = keep * splat(1.0f / 11.0f) *
                      (splat(row[0][k]) * g[0] + splat(row[1][k]) * g[1] + splat(row[2][k]) * g[2]);
    q.tone = keep * (mix(ground.tone * fine, grains.tone, grains.cover) +
                     splat(SAND_SHADED) * (high - splat(SAND_HEIGHT)));
  }
  q.tone = q.tone + weather_noise(p, frequency * SAND_CLOUDS, seed + 2u, 0.4f, s, &unused).v;
  q.tone = vmax(q.tone, splat(SAND_DARKEST));
  return q;
}

#endif
