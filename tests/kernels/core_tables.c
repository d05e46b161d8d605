/* SPDX-License-Identifier: Apache-2.0
 *
 * Which tables there are, and what the functions are fed.
 */
#include "core_kernels.h"

#include <math.h>

#define DESCRIBE(name, inputs, outputs, ...) {#name, inputs, outputs, {__VA_ARGS__}},
const core_description core_descriptions[CORE_FUNCTION_COUNT] = {CORE_FUNCTIONS(DESCRIBE)};

#if defined(__x86_64__)
extern const core_kernels core_sse2_4, core_avx2_8, core_avx2_1, core_avx512_16, core_avx512_4,
    core_avx512_1;
#elif defined(__aarch64__)
extern const core_kernels core_neon_4;
#endif

uint32_t core_available(const core_kernels *out[8]) {
  uint32_t n = 0;
#if defined(__x86_64__)
  __builtin_cpu_init();
  out[n++] = &core_sse2_4;
  if (__builtin_cpu_supports("avx2")) {
    out[n++] = &core_avx2_8;
    out[n++] = &core_avx2_1;
  }
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw")) {
    out[n++] = &core_avx512_16;
    out[n++] = &core_avx512_4;
    out[n++] = &core_avx512_1;
  }
#elif defined(__aarch64__)
  out[n++] = &core_neon_4;
#endif
  return n;
}

uint32_t core_random(uint64_t *state) {
  uint64_t z = *state += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return (uint32_t)(z >> 32);
}

static const float edges[] = {0.0f,
                              -0.0f,
                              1.0f,
                              -1.0f,
                              0.5f,
                              -0.5f,
                              2.0f,
                              0.25f,
                              0.75f,
                              1.5f,
                              3.0f,
                              -3.0f,
                              0.99999994f,
                              1.0000001f,
                              -0.99999994f,
                              0x1p-149f,
                              -0x1p-149f,
                              0x1p-127f,
                              0x1p-126f,
                              -0x1p-126f,
                              1e-30f,
                              1e-10f,
                              -1e-10f,
                              0.41421356f,
                              0.41421357f,
                              0.70710677f,
                              0.70710678f,
                              0.78539816f,
                              1.5707963f,
                              -1.5707963f,
                              3.1415927f,
                              6.2831853f,
                              255.0f,
                              -126.0f,
                              -126.5f,
                              -127.0f,
                              -1000.0f,
                              127.0f,
                              127.9f,
                              1023.0f,
                              1024.5f,
                              16383.5f,
                              -16384.5f,
                              19999.0f,
                              8388607.5f,
                              8388608.0f,
                              -8388607.5f,
                              16777215.0f,
                              -16777215.0f,
                              2097151.75f,
                              2097152.25f,
                              1073741760.0f,
                              -1073741760.0f,
                              2147483520.0f,
                              -2147483520.0f,
                              268435440.0f,
                              1e30f,
                              -1e30f,
                              0x1.fffffep127f,
                              INFINITY,
                              -INFINITY,
                              NAN};
#define EDGES ((uint32_t)(sizeof edges / sizeof edges[0]))

static int within(int domain, float x) {
  float a = fabsf(x);
  switch (domain) {
  case DOMAIN_POSITIVE:
    return x >= 0x1p-126f && a < INFINITY;
  case DOMAIN_ANGLE:
    return a < 20000.0f;
  case DOMAIN_TURNS:
    return a < 0x1p28f;
  case DOMAIN_NUMBER:
    return a <= 1e30f;
  case DOMAIN_UNIT:
    return a <= 1.25f;
  case DOMAIN_EXPONENT:
    return x < 127.5f && a < 1e6f;
  case DOMAIN_POWER:
    return x >= 1.0f && x <= 1000.0f;
  case DOMAIN_WHOLE:
    return a < 0x1p31f;
  case DOMAIN_LATTICE:
    return a < 0x1p24f;
  case DOMAIN_EXTENT:
    return x >= 0.0f && a < 1e6f;
  case DOMAIN_SMALL:
    return a <= 3.0f;
  default:
    return 1;
  }
}

float core_ordinary(int domain, uint64_t *state) {
  uint32_t r = core_random(state);
  float unit = (float)(r >> 8) * 0x1p-24f, sign = core_random(state) & 1u ? -1.0f : 1.0f;
  switch (domain) {
  case DOMAIN_BITS:
    return core_float(r);
  case DOMAIN_INDEX:
    return core_float(r & 31u);
  case DOMAIN_POSITIVE:
  case DOMAIN_EXTENT:
    return unit + 0.001f;
  case DOMAIN_POWER:
    return 1.0f + 49.0f * unit;
  case DOMAIN_ANGLE:
    return sign * unit * 20.0f;
  case DOMAIN_EXPONENT:
    return sign * unit * 120.0f;
  case DOMAIN_LATTICE:
    return sign * unit * 50.0f;
  case DOMAIN_TURNS:
    return sign * unit * 8.0f;
  case DOMAIN_SMALL:
    return sign * unit * 3.0f;
  default:
    return sign * unit;
  }
}

/* Half of them with every size alike, half of them where the work is done. */
static float attempt(int domain, uint64_t *state) {
  uint32_t r = core_random(state), s = core_random(state);
  if (s & 2u) return core_float(r);
  if (s & 4u)
    return ldexpf((s & 1u ? -1.0f : 1.0f) * (1.0f + (float)(r >> 8) * 0x1p-24f),
                  (int)((s >> 8) % 32u) - 12);
  return core_ordinary(domain, state);
}

float core_input(int domain, uint32_t k, uint64_t *state) {
  if (domain == DOMAIN_BITS) return core_float(core_random(state));
  if (domain == DOMAIN_INDEX) return core_float(core_random(state) & 31u);
  /* inputs run through the edges at different speeds, so that they meet */
  if (k < EDGES * EDGES) {
    float x = edges[k % EDGES];
    if (within(domain, x)) return x;
  }
  for (;;) {
    float x = attempt(domain, state);
    if (within(domain, x)) return x;
  }
}
