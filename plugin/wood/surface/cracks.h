/* SPDX-License-Identifier: Apache-2.0
 *
 * Charred wood shrinks into cells, like an alligator's skin: columns along the
 * fibre, Voronoi's in the reference section, and each cracked across at places
 * of its own, all of it bent by noise. The height is a parabola of the distance to the nearest
 * crack, with a narrow core: -depth (0.45 (1 - d / W)^2 + 0.55 (1 - 4 d / W)^2), each where its
 * bracket is positive. At a column's edge the distance is 0, so that where neighbours' cracks do
 * not meet nothing jumps.
 */
#ifndef SOZAI_WOOD_SURFACE_CRACKS_H
#define SOZAI_WOOD_SURFACE_CRACKS_H

#include "../stem.h"

typedef struct {
  vf depth, x, y, z; /* over crack_depth; slopes per mm */
  vf dark;           /* 0..1: how far into the core */
} crack_place;

/* The middle of column (ix + a, iz + b), from the point's own cell's corner. */
INLINE vu crack_column(vi ix, vi iz, int a, int b, vu seed, vf *x, vf *z) {
  vu h = hash_mix((vu)(ix + splati(a)) * splatu(HASH_X) + (vu)(iz + splati(b)) * splatu(HASH_Z) +
                  seed);
  *x = splat((float)a + 0.5f) + to_float((vi)h) * splat(0.42f / 2147483648.0f);
  *z = splat((float)b + 0.5f) + to_float((vi)(h << 11)) * splat(0.42f / 2147483648.0f);
  return h;
}

/* The place, bent so that no crack is straight, and the gradient's way back. */
typedef struct {
  vf x, y, z;
  vf back[3][3]; /* rows: of x, y and z over the place's own */
} crack_warp;

INLINE crack_warp cracks_warp(const wood_surface *m, vu seed, vf x, vf y, vf z) {
  crack_warp q;
  float cell = 1.0f / m->crack_frequency[0];
  const float size[3] = {1.6f * cell, 2.2f * cell, 1.6f * cell}; /* x, y, z */
  const float reach[3] = {0.42f * cell, 0.75f * cell, 0.42f * cell};
  vf at[3] = {x, y, z}, to[3];
  for (int c = 0; c < 3; c++) {
    vf g[3], k = splat(reach[c]);
    vf n = noise_gradient3(x * splat(1.0f / size[0]), y * splat(1.0f / size[1]),
                           z * splat(1.0f / size[2]), seed + splatu(HASH_X * (uint32_t)(c + 1)), g);
    to[c] = at[c] + k * n;
    for (int i = 0; i < 3; i++) {
      q.back[c][i] = k * splat(1.0f / size[i]) * g[i] + splat(c == i ? 1.0f : 0.0f);
    }
  }
  q.x = to[0];
  q.y = to[1];
  q.z = to[2];
  return q;
}

/* A hash as a factor of a crack's distance: 1 wide open to `most` a hairline. */
INLINE vf crack_narrow(vu h, float least, float most) {
  return splat(least) + splat((most - least) / 255.0f) * to_float((vi)(h & splatu(255u)));
}

/* The nearest crack across the column: distance in mm times its factor, and
 * the slope of that along y. */
INLINE vf crack_across(vf y, float frequency, vu column, float least, float most, vf *slope) {
  vf zero = splat(0.0f), f = splat(frequency), best = splat(1e9f);
  vf u = y * f + to_float((vi)(column >> 8)) * splat(1.0f / 16777216.0f);
  vi at;
  vf within = u - vfloor(u, &at);
  *slope = zero;
  for (int i = -1; i <= 1; i++) {
    vu h = hash_mix((vu)(at + splati(i)) * splatu(HASH_Y) + column);
    vf c = within - (splat((float)i + 0.5f) + to_float((vi)h) * splat(0.36f / 2147483648.0f));
    vf narrow = crack_narrow(h, least, most), d = vabs(c) * narrow;
    vm nearer = lt(d, best);
    best = sel(nearer, d, best);
    *slope = sel(nearer, sel(lt(c, zero), zero - narrow, narrow), *slope);
  }
  return best * splat(1.0f / frequency);
}

/* widen: mm that the footprint takes at least. */
INLINE crack_place cracks_at(const wood_constants *w, vu own, vf px, vf py, vf pz, vf widen) {
  const wood_surface *m = &w->surface;
  vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f), far = splat(1e9f);
  vu seed = wood_seed(w, own, SEED_CRACKS);
  crack_warp q = cracks_warp(m, seed, px, py, pz);
  vf f = splat(m->crack_frequency[0]), ux = q.x * f, uz = q.z * f;
  vi ix, iz;
  vf fx = ux - vfloor(ux, &ix), fz = uz - vfloor(uz, &iz);
  vf least = far, mx = zero, mz = zero, cx, cz;
  vu column = splatu(0);
  for (int i = 0; i < 9; i++) {
    vu h = crack_column(ix, iz, i % 3 - 1, i / 3 - 1, seed, &cx, &cz);
    vf d = (cx - fx) * (cx - fx) + (cz - fz) * (cz - fz);
    vm nearer = lt(d, least);
    least = sel(nearer, d, least);
    mx = sel(nearer, cx, mx);
    mz = sel(nearer, cz, mz);
    column = (vu)seli(nearer, (vi)h, (vi)column);
  }
  /* that column's nearest edge: cracks along the fibre are the narrower, some
   * of them much so */
  vf edge = far, ex = zero, ez = zero;
  for (int i = 0; i < 9; i++) {
    vu h = crack_column(ix, iz, i % 3 - 1, i / 3 - 1, seed, &cx, &cz);
    vf dx = cx - mx, dz = cz - mz, d2 = dx * dx + dz * dz;
    vf k = inverse_root(vmax(d2, splat(1e-6f))),
       narrow = crack_narrow(hash_mix(h + column), 1.2f, 2.2f);
    vf d = (((mx + cx) * half - fx) * dx * k + ((mz + cz) * half - fz) * dz * k) * narrow;
    vm nearer = and_(lt(d, edge), gt(d2, splat(1e-6f)));
    edge = sel(nearer, d, edge);
    ex = sel(nearer, zero - dx * k * narrow, ex);
    ez = sel(nearer, zero - dz * k * narrow, ez);
  }
  edge = vmax(edge, zero) * splat(1.0f / m->crack_frequency[0]);

  /* across: cracks that part the cells, and hairlines between them */
  vf rise, fine_rise;
  vf d = crack_across(q.y, m->crack_frequency[1], column, 1.0f, 2.0f, &rise);
  vf fine = crack_across(q.y, 2.6f * m->crack_frequency[1], column + splatu(HASH_X), 2.0f, 3.5f,
                         &fine_rise);
  vm hair = lt(fine, d);
  d = sel(hair, fine, d);
  rise = sel(hair, fine_rise, rise);
  vm along = lt(edge, d);
  d = sel(along, edge, d);

  vf wide = splat(m->crack_width) + widen, inverse = one / wide;
  vf share = splat(m->crack_width) * inverse;
  vf outer = vmax(one - d * inverse, zero), core = vmax(one - splat(4.0f) * d * inverse, zero);
  crack_place p;
  p.depth = share * (splat(0.45f) * outer * outer + splat(0.55f) * core * core);
  p.dark = share * core;
  vf slope = zero - share * inverse * (splat(0.9f) * outer + splat(4.4f) * core);
  vf g[3] = {sel(along, slope * ex, zero), sel(along, zero, slope * rise),
             sel(along, slope * ez, zero)};
  p.x = g[0] * q.back[0][0] + g[1] * q.back[1][0] + g[2] * q.back[2][0];
  p.y = g[0] * q.back[0][1] + g[1] * q.back[1][1] + g[2] * q.back[2][1];
  p.z = g[0] * q.back[0][2] + g[1] * q.back[1][2] + g[2] * q.back[2][2];
  return p;
}

#endif
