/* SPDX-License-Identifier: Apache-2.0
 *
 * Compiled as the plugin compiles its kernels, once for each instruction set
 * and width: every function of the core behind the same plain face.
 */
#include "core_kernels.h"

#include "core/filter.h"
#include "core/hash.h"
#include "core/maths.h"
#include "core/noise_held.h"
#include "core/simd.h"

#define STRING_(x) #x
#define STRING(x) STRING_(x)
#define PASTE_(a, b) a##b
#define PASTE(a, b) PASTE_(a, b)

#define IN(k) load(in[k] + i)
#define BITS(k) bits_of(load(in[k] + i))
#define OUT(k, x) store(out[k] + i, x)
#define OUT_BITS(k, x) store(out[k] + i, float_of((vi)(x)))

/* A function of the table: its body for the lanes from i on. */
#define CORE(name, ...)                                                                            \
  static void run_##name(uint32_t count, const float *const *in, float *const *out) {              \
    for (uint32_t i = 0; i < count; i += LANES) {                                                  \
      __VA_ARGS__                                                                                  \
    }                                                                                              \
  }

CORE(vmin, OUT(0, vmin(IN(0), IN(1)));)
CORE(vmax, OUT(0, vmax(IN(0), IN(1)));)
CORE(clamp01, OUT(0, clamp01(IN(0)));)
CORE(vabs, OUT(0, vabs(IN(0)));)
CORE(vsqrt, OUT(0, vsqrt(IN(0)));)

/* comparisons and masks; floats compared as numbers, NaN among them */
static void run_choose(uint32_t count, const float *const *in, float *const *out) {
  for (uint32_t i = 0; i < count; i += LANES) {
    vf a = IN(0), b = IN(1);
    vi c = BITS(2), d = BITS(3);
    vm m = or_(and_(lt(a, b), not_(lti(c, d))), or_(eq(a, b), eqi(c, d)));
    OUT(0, sel(m, a, b));
    OUT_BITS(1, seli(m, c, d));
    /* any() may spare the work, and must not miss a lane */
    OUT(2, any(m) ? sel(m, a, b) : b);
    OUT(3, any(not_(m)) ? sel(m, b, a) : b);
  }
}

static void run_vfloor(uint32_t count, const float *const *in, float *const *out) {
  for (uint32_t i = 0; i < count; i += LANES) {
    vi whole;
    OUT(0, vfloor(IN(0), &whole));
    OUT_BITS(1, whole);
  }
}

static const float thirty_two[32] = {0.0f,   1.5f,   -2.0f, 3.25f, 4e9f,  -5.0f,  6e-9f, 7.0f,
                                     8.0f,   9.0f,   10.0f, 11.0f, 12.0f, 13.75f, 14.0f, 15.0f,
                                     -16.5f, 17.0f,  18.0f, 19.0f, 20.0f, 21.0f,  22.0f, 23.0f,
                                     24.0f,  25.25f, 26.0f, 27.0f, 28.0f, 29.0f,  30.0f, -31.0f};
CORE(lookup16, OUT(0, lookup16(thirty_two, (vu)BITS(0)));)
CORE(lookup8, OUT(0, lookup8(thirty_two, (vu)BITS(0)));)
CORE(gather, OUT(0, gather(thirty_two, BITS(0)));)
static const float rows[32][4] = {
    {1.0f, -2.0f, 3.0f, 4.0f},          {5.0f, 6.0f, -7.0f, 8.0f}, [7] = {9.5f, 8e9f, 1e-9f},
    [15] = {-1.0f, 2.25f, 3.5f, 4.75f}, [16] = {6.0f, 5.0f, 4.0f}, [23] = {7.0f, 1.0f, 8.0f, 2.0f},
    [31] = {0.5f, 1.5f, 2.5f, 3.5f}};
static const float pairs[32][2] = {
    {1.0f, -2.0f},       {5.0f, 6.0f},        [7] = {9.5f, 8e9f}, [15] = {-1.0f, 2.25f},
    [16] = {6.0f, 5.0f}, [23] = {7.0f, 1.0f}, [31] = {0.5f, 1.5f}};
CORE(gather2, vf v[2]; gather2(pairs, BITS(0), v); OUT(0, v[0]); OUT(1, v[1]);)
CORE(gather4, vf v[4]; gather4(rows, BITS(0), v); for (int c = 0; c < 4; c++) OUT(c, v[c]);)
CORE(sel_top, OUT(0, sel_top((vu)BITS(0), IN(1), IN(2)));)

CORE(inverse_root, OUT(0, inverse_root(IN(0)));)
CORE(sine_cosine, vf s, c; sine_cosine(IN(0), &s, &c); OUT(0, s); OUT(1, c);)
CORE(sine_cosine_turns, vf s, c; sine_cosine_turns(IN(0), &s, &c); OUT(0, s); OUT(1, c);)
CORE(arctan2, OUT(0, arctan2(IN(0), IN(1)));)
CORE(arcsin, OUT(0, arcsin(IN(0)));)
CORE(log2_, OUT(0, log2_(IN(0)));)
CORE(exp2_, OUT(0, exp2_(IN(0)));)
CORE(power01, OUT(0, exp2_(power01_log2(vabs(IN(0)), IN(1))));)
CORE(smooth_step, vf a = vmin(IN(0), IN(1)), b = vmax(IN(0), IN(1)) + splat(0.125f);
     OUT(0, smooth_step(a, b, IN(2)));)

CORE(hash_mix, OUT_BITS(0, hash_mix((vu)BITS(0)));)
CORE(hash_upper, OUT_BITS(0, hash_upper((vu)BITS(0)));)
CORE(hash_signed, OUT(0, hash_signed((vu)BITS(0)));)

CORE(noise_value1, noise_axis x = noise_split(IN(0), HASH_X); vf dx;
     OUT(0, noise_value1(&x, (vu)BITS(1), &dx)); OUT(1, dx);)
CORE(noise_value1_cubic, noise_axis x = noise_split_cubic(IN(0), HASH_X); vf dx;
     OUT(0, noise_value1(&x, (vu)BITS(1), &dx)); OUT(1, dx);)
CORE(noise_value2, noise_axis x = noise_split(IN(0), HASH_X), z = noise_split(IN(1), HASH_Z);
     vf dx, dz; OUT(0, noise_value2(&x, &z, (vu)BITS(2), &dx, &dz)); OUT(1, dx); OUT(2, dz);)
CORE(noise_axial1, noise_stem y = noise_split_axial(IN(0), HASH_Y); vf dy;
     OUT(0, noise_axial1(&y, (vu)BITS(1), &dy)); OUT(1, dy);)
CORE(noise_axial2, noise_stem y = noise_split_axial(IN(0), HASH_Y);
     noise_axis t = noise_split(IN(1), HASH_X); vf dy, dt;
     OUT(0, noise_axial2(&y, &t, (vu)BITS(2), &dy, &dt)); OUT(1, dy); OUT(2, dt);)
CORE(noise_axial3, noise_axis x = noise_split(IN(0), HASH_X), z = noise_split(IN(2), HASH_Z);
     noise_stem y = noise_split_axial(IN(1), HASH_Y); vf dx, dy, dz;
     OUT(0, noise_axial3(&x, &y, &z, (vu)BITS(3), &dx, &dy, &dz)); OUT(1, dx); OUT(2, dy);
     OUT(3, dz);)
/* The same where lanes are in one cell: 64 points to a cell, anywhere in it. */
#define CELL_POINTS 64u
#define WITHIN(k, cell)                                                                            \
  (to_float((vi)((vu)BITS(k) >> 8)) * splat(1.0f / 16777216.0f) + splat((float)(cell)))
CORE(noise_axial3_near, uint32_t cell = i / CELL_POINTS;
     noise_axis x = noise_split(WITHIN(0, cell), HASH_X), z = noise_split(WITHIN(2, 3), HASH_Z);
     noise_stem y = noise_split_axial(WITHIN(1, -2 * (int32_t)cell), HASH_Y); vf dx, dy, dz;
     OUT(0, noise_axial3(&x, &y, &z, splatu(cell *HASH_Z), &dx, &dy, &dz)); OUT(1, dx); OUT(2, dy);
     OUT(3, dz);)
/* Held from block to block: four times 64 points to a cell, the third of them anywhere. */
#define HELD(name, ...)                                                                            \
  static void run_##name(uint32_t count, const float *const *in, float *const *out) {              \
    static noise_held held;                                                                        \
    noise_held_none(&held);                                                                        \
    for (uint32_t i = 0; i < count; i += LANES) {                                                  \
      uint32_t group = i / CELL_POINTS, cell = group / 4;                                          \
      vu seed = splatu(cell * HASH_Z), far = splatu(group % 4 == 2 ? 3 : 0);                       \
      __VA_ARGS__                                                                                  \
    }                                                                                              \
  }
#define ABOUT(k, cell) (WITHIN(k, cell) + to_float((vi)((vu)BITS(k) & far)))
HELD(noise_axial1_twice, noise_stem y = noise_split_axial(ABOUT(0, cell), HASH_Y); vf n[2], dy[2];
     noise_axial1_twice(&y, seed, CORE_SEED, &held, n, dy); OUT(0, n[0]); OUT(1, n[1]);
     OUT(2, dy[0]); OUT(3, dy[1]);)
HELD(noise_value1_thrice, noise_axis x = noise_split(ABOUT(0, cell), HASH_X); vf n[3], dx[3];
     noise_value1_thrice(&x, seed, &held, n, dx); OUT(0, n[0]); OUT(1, n[1]); OUT(2, n[2]);
     OUT(3, (dx[0] + dx[1]) + dx[2]);)
HELD(noise_value2_held, noise_axis x = noise_split(ABOUT(0, cell), HASH_X),
     z = noise_split(ABOUT(1, -5), HASH_Z);
     vf dx, dz; OUT(0, noise_value2_held(&x, HASH_X, &z, HASH_Z, seed, &held, &dx, &dz));
     OUT(1, dx); OUT(2, dz);)
HELD(noise_axial2_held, noise_stem y = noise_split_axial(ABOUT(0, cell), HASH_Y);
     noise_axis t = noise_split(ABOUT(1, 7), HASH_X); vf dy, dt;
     OUT(0, noise_axial2_held(&y, &t, seed, &held, &dy, &dt)); OUT(1, dy); OUT(2, dt);)
HELD(noise_axial3_held, noise_axis x = noise_split(ABOUT(0, cell), HASH_X),
     z = noise_split(ABOUT(2, 3), HASH_Z);
     noise_stem y = noise_split_axial(ABOUT(1, -2 * (int32_t)cell), HASH_Y); vf dx, dy, dz;
     OUT(0, noise_axial3_held(&x, &y, &z, seed, &held, &dx, &dy, &dz)); OUT(1, dx); OUT(2, dy);
     OUT(3, dz);)
CORE(noise_gradient3, vf g[3]; OUT(0, noise_gradient3(IN(0), IN(1), IN(2), (vu)BITS(3), g));
     OUT(1, g[0]); OUT(2, g[1]); OUT(3, g[2]);)
CORE(noise_gradient3_near, int32_t cell = (int32_t)(i / CELL_POINTS); vf g[3];
     OUT(0, noise_gradient3(WITHIN(0, cell), WITHIN(1, -cell), WITHIN(2, 3),
                            splatu((uint32_t)cell *HASH_Z), g));
     OUT(1, g[0]); OUT(2, g[1]); OUT(3, g[2]);)
CORE(noise_fractal3, vf g[3]; OUT(0, noise_fractal3(IN(0), IN(1), IN(2), CORE_SEED, CORE_OCTAVES,
                                                    CORE_LACUNARITY, CORE_GAIN, IN(3), g));
     OUT(1, g[0]); OUT(2, g[1]); OUT(3, g[2]);)

CORE(filter_keep, OUT(0, filter_keep(IN(0), CORE_KEEP_SIZE));)
CORE(filter_wave, OUT(0, filter_wave(IN(0), CORE_WAVE_FREQUENCY));)

#define CORE_TABLE PASTE(core_, SOZAI_KERNEL_SUFFIX)
extern const core_kernels CORE_TABLE;
#define ENTRY(name, ...) run_##name,
const core_kernels CORE_TABLE = {STRING(SOZAI_ISA_NAME), LANES, 0, {CORE_FUNCTIONS(ENTRY)}};
