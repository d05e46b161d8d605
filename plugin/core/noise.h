/* SPDX-License-Identifier: Apache-2.0
 *
 * Noise with its exact derivatives.
 *
 * Two families:
 *   value    random numbers at the lattice points, blended by the quintic fade.
 *   axial    along one axis (y) a gradient noise, whose gradients are value
 *            noises across the others. It is exactly zero on every lattice
 *            plane of y, y = 0 among them: a displacement made of it leaves
 *            the section at y = 0 as it was. Within +-1, and within +-0.5 of
 *            the gradients' bound; its slope along y is within
 *            AXIAL_SLOPE_BOUND times the gradients' bound.
 *   gradient classic 3-D gradient noise on the unit lattice, within +-1.2.
 *
 * Lattice coordinates must stay below 2^30 in size.
 */
#ifndef SOZAI_CORE_NOISE_H
#define SOZAI_CORE_NOISE_H

#include "hash.h"
#include "maths.h"

/* The supremum over f of |d/df| for gradients of +-1, found numerically. */
#define AXIAL_SLOPE_BOUND 1.3472f

/* A coordinate split into lattice cell and place within it. */
typedef struct {
  vu low, high; /* the hash terms of the cell's two ends */
  vf f;         /* 0..1 within the cell */
  vf w, dw;     /* the blend from low to high, and its slope */
} noise_axis;

INLINE vf noise_cell(vf x, uint32_t multiplier, noise_axis *a) {
  vi i;
  a->f = x - vfloor(x, &i);
  a->low = (vu)i * splatu(multiplier);
  a->high = a->low + splatu(multiplier);
  return a->f;
}

/* Quintic blend: two continuous derivatives. */
INLINE noise_axis noise_split(vf x, uint32_t multiplier) {
  noise_axis a;
  vf f = noise_cell(x, multiplier, &a);
  a.w = fade(f);
  a.dw = fade_slope(f);
  return a;
}

/* Cubic blend: one continuous derivative, for axes along which only the value
 * has to be smooth. */
INLINE noise_axis noise_split_cubic(vf x, uint32_t multiplier) {
  noise_axis a;
  vf f = noise_cell(x, multiplier, &a);
  a.w = f * f * (splat(3.0f) - f - f);
  a.dw = splat(6.0f) * (f - f * f);
  return a;
}

/* An axis along which the noise is axial: weights of the gradients at the
 * cell's two ends, for the value and for the slope. They bring the hash's
 * whole numbers to +-1. */
typedef struct {
  vu low, high;
  vf n0, n1;
  vf d0, d1;
} noise_stem;

INLINE noise_stem noise_split_axial(vf y, uint32_t multiplier) {
  noise_axis a;
  vf f = noise_cell(y, multiplier, &a), back = f - splat(1.0f), bump = f * back;
  /* fade and its slope, over HASH_ONE: a power of two, which rounds nothing */
  vf v = f * f * f *
         (splat(10.0f / HASH_ONE) + f * (splat(-15.0f / HASH_ONE) + f * splat(6.0f / HASH_ONE)));
  vf dw = splat(30.0f / HASH_ONE) * bump * bump, u = splat(1.0f / HASH_ONE) - v;
  noise_stem s = {a.low, a.high, f * u, back * v, u - f * dw, v + back * dw};
  return s;
}

/* Value noise in one dimension, within +-HASH_ONE. */
INLINE vf noise_value1(const noise_axis *x, vu seed, vf *dx) {
  vf a = hash_signed(x->low + seed), d = hash_signed(x->high + seed) - a;
  *dx = d * x->dw;
  return a + d * x->w;
}

/* Value noise in two dimensions, within +-HASH_ONE. */
INLINE vf noise_value2(const noise_axis *x, const noise_axis *z, vu seed, vf *dx, vf *dz) {
  /* one sum and three steps, which are constants, to the corners */
  vu s = x->low + z->low + seed, right = x->high - x->low, up = z->high - z->low;
  vf a = hash_signed(s), b = hash_signed(s + right) - a;
  vf c = hash_signed(s + up), d = hash_signed(s + (right + up)) - c;
  vf p = a + b * x->w, q = c + d * x->w - p;
  *dx = mix(b, d, z->w) * x->dw;
  *dz = q * z->dw;
  return p + q * z->w;
}

/* Axial noise in y alone: gradients are numbers within +-1. */
INLINE vf noise_axial1(const noise_stem *y, vu seed, vf *dy) {
  vf g0 = hash_signed(y->low + seed), g1 = hash_signed(y->high + seed);
  *dy = g0 * y->d0 + g1 * y->d1;
  return g0 * y->n0 + g1 * y->n1;
}

/* Axial noise in y with gradients varying along t. */
INLINE vf noise_axial2(const noise_stem *y, const noise_axis *t, vu seed, vf *dy, vf *dt) {
  vf t0, t1;
  vf g0 = noise_value1(t, y->low + seed, &t0);
  vf g1 = noise_value1(t, y->high + seed, &t1);
  *dt = t0 * y->n0 + t1 * y->n1;
  *dy = g0 * y->d0 + g1 * y->d1;
  return g0 * y->n0 + g1 * y->n1;
}

/* Axial noise in y with gradients varying over x and z. */
#ifndef WITHIN_A_POINT
#ifdef HOLDS
/* Of lanes that share a cell, as neighbours mostly do: its corners are hashed one to
 * a lane, x fastest, and what is alike for all is taken once. */
typedef struct {
  spread value; /* of the corners, */
  spread right; /* the next one's less it, */
  spread turn;  /* and what that is at the next pair less what it is here */
} cell_corners;

/* base: the hash term of the first corner; beside: of the others over it. */
INLINE cell_corners noise_corners_at(vu base, vu beside) {
  vf a = hash_signed(base + beside), b = next_lane(a) - a;
  return (cell_corners){spread_of(a), spread_of(b), spread_of(third_lane(b) - b)};
}

/* Corners of noise_axial3: along x, then z. */
INLINE vu noise_beside3(void) {
  return (vu){0,      HASH_X,          HASH_Z,          HASH_X + HASH_Z,
              HASH_Y, HASH_Y + HASH_X, HASH_Y + HASH_Z, HASH_Y + HASH_X + HASH_Z};
}

INLINE vf noise_axial3_in(const cell_corners *at, const noise_axis *x, const noise_stem *y,
                          const noise_axis *z, vf *dx, vf *dy, vf *dz) {
  vf g[2], gx[2], gz[2];
  UNROLL(2)
  for (int c = 0; c < 2; c++) {
    int k = 4 * c;
    vf low = splat(at->right.of[k]), p = splat(at->value.of[k]) + low * x->w;
    vf q = splat(at->value.of[k + 2]) + splat(at->right.of[k + 2]) * x->w - p;
    gx[c] = (low + splat(at->turn.of[k]) * z->w) * x->dw;
    gz[c] = q * z->dw;
    g[c] = p + q * z->w;
  }
  *dx = gx[0] * y->n0 + gx[1] * y->n1;
  *dz = gz[0] * y->n0 + gz[1] * y->n1;
  *dy = g[0] * y->d0 + g[1] * y->d1;
  return g[0] * y->n0 + g[1] * y->n1;
}
#endif

INLINE vf noise_axial3(const noise_axis *x, const noise_stem *y, const noise_axis *z, vu seed,
                       vf *dx, vf *dy, vf *dz) {
#ifdef SPREADS
  vu base = x->low + y->low + z->low + seed;
  if (alike((vi)base)) {
    cell_corners at = noise_corners_at(base, noise_beside3());
    return noise_axial3_in(&at, x, y, z, dx, dy, dz);
  }
#endif
  vf x0, z0, x1, z1;
  vf g0 = noise_value2(x, z, y->low + seed, &x0, &z0);
  vf g1 = noise_value2(x, z, y->high + seed, &x1, &z1);
  *dx = x0 * y->n0 + x1 * y->n1;
  *dz = z0 * y->n0 + z1 * y->n1;
  *dy = g0 * y->d0 + g1 * y->d1;
  return g0 * y->n0 + g1 * y->n1;
}
#else
/* One point alone: the eight corners are eight lanes, x fastest, then z. */
INLINE vf noise_axial3(const noise_axis *x, const noise_stem *y, const noise_axis *z, vu seed,
                       vf *dx, vf *dy, vf *dz) {
  vu i = x->high - x->low, j = y->high - y->low, k = z->high - z->low;
  u8 h = (u8){0, i, k, i + k, j, i + j, j + k, i + j + k} + (x->low + z->low + y->low + seed);
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  f8 a = to_f8((i8)h), b = next_f8(a) - a;
  f8 p = a + b * x->w, q = second_f8(p) - p;
  f8 g = p + q * z->w;
  f8 gx = (b + (second_f8(b) - b) * z->w) * x->dw, gz = q * z->dw;
  *dx = gx[0] * y->n0 + gx[4] * y->n1;
  *dz = gz[0] * y->n0 + gz[4] * y->n1;
  *dy = g[0] * y->d0 + g[4] * y->d1;
  return g[0] * y->n0 + g[4] * y->n1;
}
#endif

#ifdef WITHIN_A_POINT
/* Of one point, what is the same for several octaves or noises: one to a lane. */
typedef struct {
  u4 low, high;
  f4 w, dw;
} noise_axes;

/* noise_split_cubic */
INLINE noise_axes noise_split_cubic4(f4 x, uint32_t multiplier) {
  i4 i;
  f4 f = x - floor_f4(x, &i);
  noise_axes a;
  a.low = (u4)i * multiplier;
  a.high = a.low + multiplier;
  a.w = f * f * (3.0f - f - f);
  a.dw = 6.0f * (f - f * f);
  return a;
}

/* noise_split_axial of two: the lanes are the low and the high end of the first's cell,
 * then the second's. y: each twice. */
typedef struct {
  u4 end;
  f4 n, d;
} noise_stems;

INLINE noise_stems noise_split_axial2(f4 y, uint32_t multiplier) {
  i4 i;
  f4 f = y - floor_f4(y, &i), back = f - 1.0f, bump = f * back;
  f4 v = f * f * f * (10.0f / HASH_ONE + f * (-15.0f / HASH_ONE + f * all_f4(6.0f / HASH_ONE)));
  f4 dw = 30.0f / HASH_ONE * bump * bump, u = 1.0f / HASH_ONE - v;
  f4 place = even_odd(f, back), weight = even_odd(u, v);
  noise_stems s = {(u4)i * multiplier + (u4){0, multiplier, 0, multiplier}, place * weight,
                   less_more(weight, place * dw)};
  return s;
}

/* Both noises, then both slopes. */
INLINE f4 noise_axial1_two(const noise_stems *y, u4 seed) {
  f4 g = hash_signed4(y->end + seed);
  return pairs_f4(g * y->n, g * y->d);
}

/* noise_axial2 of two over one t. dt: its lower two lanes. */
INLINE f4 noise_axial2_two(const noise_stems *y, const noise_axis *t, u4 seed, f4 *dt) {
  u4 s = y->end + seed;
  f4 a = hash_signed4(s + t->low), d = hash_signed4(s + t->high) - a;
  f4 g = a + d * t->w, slope = d * t->dw * y->n;
  *dt = pairs_f4(slope, slope);
  return pairs_f4(g * y->n, g * y->d);
}

/* noise_value2 without slopes. */
INLINE f4 noise_value2_four(const noise_axes *x, const noise_axes *z, u4 seed) {
  u4 s0 = z->low + seed, s1 = z->high + seed;
  f4 a = hash_signed4(x->low + s0), b = hash_signed4(x->high + s0) - a;
  f4 c = hash_signed4(x->low + s1), d = hash_signed4(x->high + s1) - c;
  f4 p = a + b * x->w, q = c + d * x->w - p;
  return p + q * z->w;
}

/* noise_axial3 of two, x and z each twice as y is. Both noises, then both slopes along y;
 * across: both along x, then both along z. */
INLINE f4 noise_axial3_two(const noise_axes *x, const noise_stems *y, const noise_axes *z, u4 seed,
                           f4 *across) {
  seed += y->end;
  u4 s0 = z->low + seed, s1 = z->high + seed;
  f4 a = hash_signed4(x->low + s0), b = hash_signed4(x->high + s0) - a;
  f4 c = hash_signed4(x->low + s1), d = hash_signed4(x->high + s1) - c;
  f4 p = a + b * x->w, q = c + d * x->w - p;
  f4 gx = (b + (d - b) * z->w) * x->dw, gz = q * z->dw, g = p + q * z->w;
  *across = pairs_f4(gx * y->n, gz * y->n);
  return pairs_f4(g * y->n, g * y->d);
}
#endif

/* One corner of gradient noise: a gradient of three components within +-1
 * from ten bits each, times the offset. */
INLINE void noise_corner(vu h, vf x, vf y, vf z, vf *value, vf *gx, vf *gy, vf *gz) {
  h = hash_mix(h);
  vf k = splat(2.0f / 1023.0f), one = splat(1.0f);
  *gx = to_float((vi)(h >> 22)) * k - one;
  *gy = to_float((vi)((h >> 12) & splatu(1023u))) * k - one;
  *gz = to_float((vi)((h >> 2) & splatu(1023u))) * k - one;
  *value = *gx * x + *gy * y + *gz * z;
}

#ifdef SPREADS
/* The hash terms of a cell's corners over its first one's, one to a lane: x fastest, then
 * y. */
INLINE vu noise_corners(void) {
  return (vu){0,      HASH_X,          HASH_Y,          HASH_X + HASH_Y,
              HASH_Z, HASH_Z + HASH_X, HASH_Z + HASH_Y, HASH_Z + HASH_X + HASH_Y};
}

/* Gradient noise of lanes that share a cell: its corners one to a lane. base: the hash
 * term of the first. */
INLINE vf noise_gradient3_shared(vu base, const noise_axis *x, const noise_axis *y,
                                 const noise_axis *z, vf out[3]) {
  vf gradient[3], zero = splat(0.0f), v[8], e[4], s[2], r[4];
  noise_corner(base + noise_corners(), zero, zero, zero, &r[0], &gradient[0], &gradient[1],
               &gradient[2]);
  spread of[3], right[3];
  for (int k = 0; k < 3; k++) {
    of[k] = spread_of(gradient[k]);
    right[k] = spread_of(next_lane(gradient[k]) - gradient[k]);
  }
  vf fx[2] = {x->f, x->f - splat(1.0f)}, fy[2] = {y->f, y->f - splat(1.0f)},
     fz[2] = {z->f, z->f - splat(1.0f)};
  UNROLL(8)
  for (int c = 0; c < 8; c++) {
    v[c] = splat(of[0].of[c]) * fx[c & 1] + splat(of[1].of[c]) * fy[c >> 1 & 1] +
           splat(of[2].of[c]) * fz[c >> 2];
  }
  vf dx[4];
  for (int c = 0; c < 4; c++) {
    dx[c] = v[2 * c + 1] - v[2 * c];
    e[c] = v[2 * c] + dx[c] * x->w;
  }
  vf dy[2] = {e[1] - e[0], e[3] - e[2]};
  for (int c = 0; c < 2; c++) s[c] = e[2 * c] + dy[c] * y->w;
  UNROLL(3)
  for (int k = 0; k < 3; k++) {
    vf b[4];
    for (int c = 0; c < 4; c++) b[c] = splat(of[k].of[2 * c]) + splat(right[k].of[2 * c]) * x->w;
    r[k + 1] = mix(mix(b[0], b[1], y->w), mix(b[2], b[3], y->w), z->w);
  }
  out[0] = r[1] + mix(mix(dx[0], dx[1], y->w), mix(dx[2], dx[3], y->w), z->w) * x->dw;
  out[1] = r[2] + mix(dy[0], dy[1], z->w) * y->dw;
  out[2] = r[3] + (s[1] - s[0]) * z->dw;
  return mix(s[0], s[1], z->w);
}
#endif

/* Gradient noise in three dimensions with its gradient (out[3]). */
INLINE vf noise_gradient3(vf px, vf py, vf pz, vu seed, vf out[3]) {
  noise_axis x = noise_split(px, HASH_X), y = noise_split(py, HASH_Y), z = noise_split(pz, HASH_Z);
#ifdef SPREADS
  vu base = seed + x.low + y.low + z.low;
  if (alike((vi)base)) return noise_gradient3_shared(base, &x, &y, &z, out);
#endif
  vf v[8], g[8][3];
  for (int c = 0; c < 8; c++) {
    vu h = seed + (c & 1 ? x.high : x.low) + (c & 2 ? y.high : y.low) + (c & 4 ? z.high : z.low);
    noise_corner(h, x.f - splat((float)(c & 1)), y.f - splat((float)((c >> 1) & 1)),
                 z.f - splat((float)(c >> 2)), &v[c], &g[c][0], &g[c][1], &g[c][2]);
  }
  vf r[4]; /* value and the blended gradients */
  vf slope_x = splat(0.0f), slope_y, slope_z;
  vf e[4], s[2];
  for (int c = 0; c < 4; c++) e[c] = mix(v[2 * c], v[2 * c + 1], x.w);
  for (int c = 0; c < 2; c++) s[c] = mix(e[2 * c], e[2 * c + 1], y.w);
  r[0] = mix(s[0], s[1], z.w);
  slope_x = mix(mix(v[1] - v[0], v[3] - v[2], y.w), mix(v[5] - v[4], v[7] - v[6], y.w), z.w);
  slope_y = mix(e[1] - e[0], e[3] - e[2], z.w);
  slope_z = s[1] - s[0];
  for (int k = 0; k < 3; k++) {
    vf a = mix(mix(g[0][k], g[1][k], x.w), mix(g[2][k], g[3][k], x.w), y.w);
    vf b = mix(mix(g[4][k], g[5][k], x.w), mix(g[6][k], g[7][k], x.w), y.w);
    r[k + 1] = mix(a, b, z.w);
  }
  out[0] = r[1] + slope_x * x.dw;
  out[1] = r[2] + slope_y * y.dw;
  out[2] = r[3] + slope_z * z.dw;
  return r[0];
}

/* A sum of octaves of gradient noise: each `lacunarity` times finer and `gain`
 * times weaker; an octave fades out as the footprint grows from half to all of
 * its lattice spacing. Value, and gradient in out[3]. */
INLINE vf noise_fractal3(vf px, vf py, vf pz, uint32_t seed, int octaves, float lacunarity,
                         float gain, vf footprint, vf out[3]) {
  vf sum = splat(0.0f);
  out[0] = out[1] = out[2] = sum;
  float scale = 1.0f, weight = 1.0f;
  for (int o = 0; o < octaves; o++) {
    vf g[3], k = splat(scale);
    vf keep = splat(weight) * (splat(1.0f) - smooth_step(splat(0.5f), splat(1.0f), footprint * k));
    if (!any(gt(keep, splat(0.0f)))) break;
    sum =
        sum + keep * noise_gradient3(px * k, py * k, pz * k, splatu(hash1(seed + (uint32_t)o)), g);
    for (int i = 0; i < 3; i++) out[i] = out[i] + keep * k * g[i];
    scale *= lacunarity;
    weight *= gain;
  }
  return sum;
}

#endif
