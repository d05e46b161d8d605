/* SPDX-License-Identifier: Apache-2.0
 *
 * What stone looks like that was split across its grain: facets that meet in ridges and hollows.
 *
 * Heights stand at the points of a lattice of tetrahedra (Perlin's simplices, Noise hardware,
 * SIGGRAPH 2001 course) and are linear within each, so that a face has planes, cut out as triangles
 * and quadrangles of any shape, that meet in edges. A noise bends the lattice: facets are dished
 * and of many sizes.
 */
#ifndef SOZAI_STONE_FACETS_H
#define SOZAI_STONE_FACETS_H

#include "field.h"
#include "stone.h"
#include "value.h"
#include "weather.h"

/* mm: how far the lattice is bent, along each axis, sd, and the bends' wavelength. */
#define FACETS_BENT 1.9f
#define FACETS_WAVE 31.0f

/* The place in the lattice: aslant of the axes, and skewed. */
static const float facets_lattice[FACET_SIZES][3][3] = {
    {{0.1515f, 1.1212f, 0.8485f}, {0.5152f, 1.2121f, -0.5152f}, {-0.8485f, 1.1212f, -0.1515f}},
    {{-0.0431f, 1.3316f, -0.4744f}, {0.8660f, 0.4082f, -1.0409f}, {-0.5207f, 0.2761f, -1.2856f}},
    {{-0.4104f, -0.7732f, 1.1107f}, {-1.3772f, -0.1806f, 0.2657f}, {-0.5992f, -1.2650f, -0.2017f}}};

/* Between heights of +-1 at the lattice's points, and how that grows. */
INLINE field facets_simplex(const vf at[3], vu seed) {
  static const uint32_t prime[3] = {HASH_X, HASH_Y, HASH_Z};
  noise_axis a[3];
  for (int k = 0; k < 3; k++) (void)noise_cell(at[k], prime[k], &a[k]);
  const vf x = a[0].f, y = a[1].f, z = a[2].f;
  vm xy = lt(y, x), xz = lt(z, x), yz = lt(z, y);
  vm x_most = and_(xy, xz), y_most = and_(not_(xy), yz);
  vm x_least = and_(not_(xy), not_(xz)), y_least = and_(xy, not_(yz));
  const vi px = splati((int32_t)HASH_X), py = splati((int32_t)HASH_Y), pz = splati((int32_t)HASH_Z);
  vu all = splatu(HASH_X + HASH_Y + HASH_Z), base = a[0].low + a[1].low + a[2].low + seed;
  vu most = (vu)seli(x_most, px, seli(y_most, py, pz));
  vu least = (vu)seli(x_least, px, seli(y_least, py, pz));
  const vf each = splat(1.0f / HASH_ONE);
  vf v0 = each * hash_signed(base), v1 = each * hash_signed(base + most),
     v2 = each * hash_signed(base + (all - least)), v3 = each * hash_signed(base + all);
  vf d1 = v1 - v0, d2 = v2 - v1, d3 = v3 - v2;
  field f;
  f.g[0] = sel(x_most, d1, sel(x_least, d3, d2));
  f.g[1] = sel(y_most, d1, sel(y_least, d3, d2));
  f.g[2] = sel(or_(x_most, y_most), sel(or_(x_least, y_least), d2, d3), d1);
  f.v = v0 + f.g[0] * x + f.g[1] * y + f.g[2] * z;
  return f;
}

#define FACETS_GONE 1.9f   /* as NOISE_GONE */
#define FACETS_MEET 0.9f   /* how fast slopes come to differ, by the footprint's width */
#define FACETS_ALONE 0.04f /* cells: narrower footprints see one place */
#define FACETS_PLACES 4    /* that wider ones see, the middles of their quarters */

/* Of one size, over the footprint: its height, and its slope in space that is not bent. q, by: the
 * place, and the ways along the footprint's sides to a quarter's middle, as bent. */
INLINE field facets_mean(const stone_facets *c, const float row[3][3], const vf q[3],
                         const vf by[2][3], vf e) {
  const vf per = splat(c->frequency), zero = splat(0.0f), quarter = splat(0.25f);
  vm wide = gt(e, splat(FACETS_ALONE));
  field f[FACETS_PLACES], r;
  vf at[3], way[2][3];
  int places = any(wide) ? FACETS_PLACES : 1;
  for (int k = 0; k < 3; k++) {
    at[k] = per * (splat(row[k][0]) * q[0] + splat(row[k][1]) * q[1] + splat(row[k][2]) * q[2]);
    for (int i = 0; i < 2 && places > 1; i++) {
      vf to = per * (splat(row[k][0]) * by[i][0] + splat(row[k][1]) * by[i][1] +
                     splat(row[k][2]) * by[i][2]);
      way[i][k] = sel(wide, to, zero);
    }
  }
  for (int n = 0; n < places; n++) {
    vf to[3];
    for (int k = 0; k < 3; k++) {
      to[k] = at[k];
      if (places == 1) continue;
      to[k] = to[k] + (n & 1 ? way[0][k] : zero - way[0][k]);
      to[k] = to[k] + (n & 2 ? way[1][k] : zero - way[1][k]);
    }
    f[n] = facets_simplex(to, splatu(c->seed));
  }
  if (places > 1) {
    /* of four that are the same, to the bit that */
    f[0] = field_scale(field_add(field_add(f[0], f[1]), field_add(f[2], f[3])), quarter);
  }
  r.v = f[0].v;
  for (int k = 0; k < 3; k++)
    r.g[k] = per * (splat(row[0][k]) * f[0].g[0] + splat(row[1][k]) * f[0].g[1] +
                    splat(row[2][k]) * f[0].g[2]);
  return r;
}

/* Height in mm; adds its gradient, what a footprint averages out of its variance along one axis,
 * and the height's variance. p, t1, t2: bed space. */
STAGE vf facets_at(const stone_constants *w, const vf p[3], const vf t1[3], const vf t2[3], vf s,
                   vf slope[3], vf *lost, vf *square) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  vf e[FACET_SIZES], keep[FACET_SIZES], height = zero, sum[3] = {zero, zero, zero};
  int some = 0;
  for (int i = 0; i < FACET_SIZES; i++) {
    const stone_facets *c = &w->facets[i];
    e[i] = s * splat(c->frequency);
    keep[i] = weather_keep(e[i], FACETS_GONE);
    vf told = keep[i] * keep[i] / (one + splat(FACETS_MEET) * e[i]);
    *lost = *lost + splat(c->slope2) * (one - told);
    *square = *square + splat(FACET_HEIGHT2 * c->height * c->height) * told;
    some |= any(gt(keep[i], zero));
  }
  if (!some) return zero;
  const vf f = splat(1.0f / FACETS_WAVE), bent = splat(FACETS_BENT / VALUE_SD_CUBIC / HASH_ONE);
  const vf wave[3] = {p[0] * f, p[1] * f, p[2] * f}, step = splat(0.25f) * s;
  vf off[3], grows[3][3], q[3], by[2][3];
  (void)value_three_grown(wave, splatu(w->facets[0].seed + 5u), NULL, off, grows);
  for (int k = 0; k < 3; k++) {
    q[k] = p[k] + bent * off[k];
    by[0][k] = step * (t1[k] + bent * f * dot3(grows[k], t1));
    by[1][k] = step * (t2[k] + bent * f * dot3(grows[k], t2));
  }
  for (int i = 0; i < FACET_SIZES; i++) {
    const stone_facets *c = &w->facets[i];
    if (!any(gt(keep[i], zero))) continue;
    field t = facets_mean(c, facets_lattice[i], q, by, e[i]);
    vf high = keep[i] * splat(c->height);
    height = height + high * t.v;
    for (int k = 0; k < 3; k++) sum[k] = sum[k] + high * t.g[k];
  }
  for (int k = 0; k < 3; k++) {
    vf more = sum[0] * grows[0][k] + sum[1] * grows[1][k] + sum[2] * grows[2][k];
    slope[k] = slope[k] + sum[k] + bent * f * more;
  }
  return height;
}

#endif
