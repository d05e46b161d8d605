/* SPDX-License-Identifier: Apache-2.0
 *
 * The core's functions as tables, one for each instruction set and width that
 * core_kernels.c is compiled for: what the tests compare, measure and time.
 */
#ifndef SOZAI_TESTS_CORE_KERNELS_H
#define SOZAI_TESTS_CORE_KERNELS_H

#include <stdint.h>

#define CORE_INPUTS 4
#define CORE_OUTPUTS 4
#define CORE_WIDEST 16 /* counts are multiples of it */

/* Fixed where a function takes a plain number. */
#define CORE_SEED 0x51ed270bu
#define CORE_KEEP_SIZE 2.0f
#define CORE_WAVE_FREQUENCY 0.25f
#define CORE_OCTAVES 5
#define CORE_LACUNARITY 2.1f
#define CORE_GAIN 0.55f

/* What a function's inputs may be. */
enum {
  DOMAIN_POSITIVE, /* normal, above zero */
  DOMAIN_ANGLE,    /* within 20,000 */
  DOMAIN_TURNS,    /* within 2^28 */
  DOMAIN_NUMBER,   /* finite, within 1e30 */
  DOMAIN_ANY,      /* infinities and NaN too */
  DOMAIN_UNIT,     /* around -1..1 */
  DOMAIN_EXPONENT, /* below 128 */
  DOMAIN_POWER,    /* 1..1000 */
  DOMAIN_WHOLE,    /* within 2^31 */
  DOMAIN_LATTICE,  /* within 2^24: what a float tells apart */
  DOMAIN_EXTENT,   /* from 0 up */
  DOMAIN_SMALL,    /* -3..3 */
  DOMAIN_BITS,     /* 32 bits, not a float */
  DOMAIN_INDEX     /* 0..31, not a float */
};

/* name, inputs, outputs, their domains */
#define CORE_FUNCTIONS(X)                                                                          \
  X(vmin, 2, 1, DOMAIN_ANY, DOMAIN_ANY, 0, 0)                                                      \
  X(vmax, 2, 1, DOMAIN_ANY, DOMAIN_ANY, 0, 0)                                                      \
  X(clamp01, 1, 1, DOMAIN_ANY, 0, 0, 0)                                                            \
  X(vabs, 1, 1, DOMAIN_ANY, 0, 0, 0)                                                               \
  X(choose, 4, 4, DOMAIN_ANY, DOMAIN_ANY, DOMAIN_BITS, DOMAIN_BITS)                                \
  X(vsqrt, 1, 1, DOMAIN_EXTENT, 0, 0, 0)                                                           \
  X(vfloor, 1, 2, DOMAIN_WHOLE, 0, 0, 0)                                                           \
  X(lookup16, 1, 1, DOMAIN_BITS, 0, 0, 0)                                                          \
  X(lookup8, 1, 1, DOMAIN_BITS, 0, 0, 0)                                                           \
  X(gather, 1, 1, DOMAIN_INDEX, 0, 0, 0)                                                           \
  X(gather2, 1, 2, DOMAIN_INDEX, 0, 0, 0)                                                          \
  X(gather4, 1, 4, DOMAIN_INDEX, 0, 0, 0)                                                          \
  X(sel_top, 3, 1, DOMAIN_BITS, DOMAIN_ANY, DOMAIN_ANY, 0)                                         \
  X(inverse_root, 1, 1, DOMAIN_POSITIVE, 0, 0, 0)                                                  \
  X(sine_cosine, 1, 2, DOMAIN_ANGLE, 0, 0, 0)                                                      \
  X(sine_cosine_turns, 1, 2, DOMAIN_TURNS, 0, 0, 0)                                                \
  X(arctan2, 2, 1, DOMAIN_NUMBER, DOMAIN_NUMBER, 0, 0)                                             \
  X(arcsin, 1, 1, DOMAIN_UNIT, 0, 0, 0)                                                            \
  X(log2_, 1, 1, DOMAIN_POSITIVE, 0, 0, 0)                                                         \
  X(exp2_, 1, 1, DOMAIN_EXPONENT, 0, 0, 0)                                                         \
  X(power01, 2, 1, DOMAIN_UNIT, DOMAIN_POWER, 0, 0)                                                \
  X(smooth_step, 3, 1, DOMAIN_SMALL, DOMAIN_SMALL, DOMAIN_SMALL, 0)                                \
  X(hash_mix, 1, 1, DOMAIN_BITS, 0, 0, 0)                                                          \
  X(hash_upper, 1, 1, DOMAIN_BITS, 0, 0, 0)                                                        \
  X(hash_signed, 1, 1, DOMAIN_BITS, 0, 0, 0)                                                       \
  X(noise_value1, 2, 2, DOMAIN_LATTICE, DOMAIN_BITS, 0, 0)                                         \
  X(noise_value1_cubic, 2, 2, DOMAIN_LATTICE, DOMAIN_BITS, 0, 0)                                   \
  X(noise_value2, 3, 3, DOMAIN_LATTICE, DOMAIN_LATTICE, DOMAIN_BITS, 0)                            \
  X(noise_axial1, 2, 2, DOMAIN_LATTICE, DOMAIN_BITS, 0, 0)                                         \
  X(noise_axial2, 3, 3, DOMAIN_LATTICE, DOMAIN_LATTICE, DOMAIN_BITS, 0)                            \
  X(noise_axial3, 4, 4, DOMAIN_LATTICE, DOMAIN_LATTICE, DOMAIN_LATTICE, DOMAIN_BITS)               \
  X(noise_axial3_near, 3, 4, DOMAIN_BITS, DOMAIN_BITS, DOMAIN_BITS, 0)                             \
  X(noise_axial1_twice, 1, 4, DOMAIN_BITS, 0, 0, 0)                                                \
  X(noise_value1_thrice, 1, 4, DOMAIN_BITS, 0, 0, 0)                                               \
  X(noise_value2_held, 2, 3, DOMAIN_BITS, DOMAIN_BITS, 0, 0)                                       \
  X(noise_axial2_held, 2, 3, DOMAIN_BITS, DOMAIN_BITS, 0, 0)                                       \
  X(noise_axial3_held, 3, 4, DOMAIN_BITS, DOMAIN_BITS, DOMAIN_BITS, 0)                             \
  X(noise_gradient3, 4, 4, DOMAIN_LATTICE, DOMAIN_LATTICE, DOMAIN_LATTICE, DOMAIN_BITS)            \
  X(noise_gradient3_near, 3, 4, DOMAIN_BITS, DOMAIN_BITS, DOMAIN_BITS, 0)                          \
  X(noise_fractal3, 4, 4, DOMAIN_LATTICE, DOMAIN_LATTICE, DOMAIN_LATTICE, DOMAIN_EXTENT)           \
  X(filter_keep, 1, 1, DOMAIN_EXTENT, 0, 0, 0)                                                     \
  X(filter_wave, 1, 1, DOMAIN_EXTENT, 0, 0, 0)

#define CORE_INDEX_(name, ...) CORE_##name,
enum { CORE_FUNCTIONS(CORE_INDEX_) CORE_FUNCTION_COUNT };
#undef CORE_INDEX_

/* in and out: arrays of count numbers each; whole numbers lie in them as their
 * bits. */
typedef void core_run(uint32_t count, const float *const *in, float *const *out);

typedef struct {
  const char *name;
  uint32_t inputs, outputs;
  uint8_t domain[CORE_INPUTS];
} core_description;

typedef struct {
  const char *isa;
  uint32_t lanes;
  uint32_t reserved;
  core_run *run[CORE_FUNCTION_COUNT];
} core_kernels;

extern const core_description core_descriptions[CORE_FUNCTION_COUNT];
extern const core_kernels core_scalar_1; /* the reference */

/* The others that this machine can run; their number. */
uint32_t core_available(const core_kernels *out[8]);

/* A deterministic stream of 32 random bits. */
uint32_t core_random(uint64_t *state);
/* A number as the kernels meet them: no denormals, which take many times as
 * long and would be all that a bench measures. */
float core_ordinary(int domain, uint64_t *state);
/* The k-th number for a domain: its edges first, then random ones. */
float core_input(int domain, uint32_t k, uint64_t *state);

static inline float core_float(uint32_t bits) {
  union {
    uint32_t u;
    float f;
  } both = {.u = bits};
  return both.f;
}
static inline uint32_t core_bits(float x) {
  union {
    float f;
    uint32_t u;
  } both = {.f = x};
  return both.u;
}

#endif
