/* SPDX-License-Identifier: Apache-2.0
 *
 * Wood as a material: its description, and the choice of kernel.
 */
#include "material.h"

#include "../core/cpu.h"
#include "../core/status.h"
#include "build.h"
#include "parameters.h"
#include "species.h"
#include "wood.h"

#define PASTE_(a, b) a##b
#define KERNEL(suffix) PASTE_(wood_kernel_, suffix)

extern const wood_kernel KERNEL(scalar_1);
#if defined(__x86_64__)
extern const wood_kernel KERNEL(sse2_4), KERNEL(avx2_8), KERNEL(avx2_1), KERNEL(avx512_16),
    KERNEL(avx512_4), KERNEL(avx512_1);
#elif defined(__aarch64__)
extern const wood_kernel KERNEL(neon_4);
#endif

/* For each instruction set the wide kernel, one for what a few lanes hold, and
 * one for a point alone: a mostly empty block costs what a full one does. */
typedef struct {
  const wood_kernel *wide, *narrow, *single;
} wood_kernels;

static const wood_kernels kernels[CPU_COUNT] = {
#if defined(__x86_64__)
    [CPU_AVX512] = {&KERNEL(avx512_16), &KERNEL(avx512_4), &KERNEL(avx512_1)},
    [CPU_AVX2] = {&KERNEL(avx2_8), &KERNEL(avx2_8), &KERNEL(avx2_1)},
    [CPU_SSE2] = {&KERNEL(sse2_4), &KERNEL(sse2_4), &KERNEL(scalar_1)},
#elif defined(__aarch64__)
    [CPU_NEON] = {&KERNEL(neon_4), &KERNEL(neon_4), &KERNEL(scalar_1)},
#endif
    [CPU_SCALAR] = {&KERNEL(scalar_1), &KERNEL(scalar_1), &KERNEL(scalar_1)},
};

typedef struct {
  wood_constants constants;
  wood_kernels use;
} wood_state;

static const sozai_texture_info *describe(void) {
  static sozai_texture_info info = {
      .size = sizeof(sozai_texture_info),
      .revision = 1,
      .id = "wood",
      .label = "Wood",
      .doc =
          "Solid wood sawn from a stem: rings, vessels and fibres carried by one grain, with the "
          "figure that it gives.",
      .parameters = wood_parameters,
      .presets = wood_species,
      .channels = wood_channels,
      .parameter_count = WOOD_PARAMETERS,
      .component_count = WOOD_COMPONENTS,
  };
  /* counts of arrays of another file are no constants in C; init calls this
   * once, alone, before anyone else can */
  if (!info.preset_count) {
    wood_build_prepare();
    info.channel_count = wood_channel_count;
    info.preset_count = wood_species_count;
  }
  return &info;
}

static int32_t build(void *state, const sozai_host *host, const settings *s,
                     const float (*colours)[3], const image_set *images) {
  wood_state *w = state;
  int set;
  int32_t r = cpu_choose(&set);
  if (r) return r;
  w->use = kernels[set];
  return wood_build(&w->constants, host, s, colours, images);
}

static void evaluate(const void *state, const sozai_batch *b, float *const *out, uint64_t wanted) {
  const wood_state *w = state;
  wood_io io = {b, out, wanted};
  const wood_kernels *k = &w->use;
  uint32_t lanes = k->wide->lanes, whole = b->count / lanes * lanes, rest = b->count - whole;
  /* from half a block up the wide kernel is the cheaper */
  if (rest > lanes / 2) {
    whole = b->count;
    rest = 0;
  }
  if (whole) k->wide->evaluate(&w->constants, &io, 0, whole);
  if (rest) (rest == 1 ? k->single : k->narrow)->evaluate(&w->constants, &io, whole, b->count);
}

static const char *instruction_set(const void *state) {
  return ((const wood_state *)state)->use.wide->name;
}

const material wood_material = {describe, sizeof(wood_state), build, evaluate, instruction_set};

/* ---- sozai.wood/1 ----------------------------------------------------- */

static const wood_state *state_of(const sozai_texture *t) {
  return texture_state(t, &wood_material);
}

static int32_t ring_radius(const sozai_texture *t, uint32_t count, const float *years,
                           const float *theta, const float *y, float *out_r) {
  const wood_state *w = state_of(t);
  if (!w) return fail(SOZAI_ERROR_ARGUMENT, "ring_radius: the texture is not a wood");
  if (count && (!years || !theta || !y || !out_r)) {
    return fail(SOZAI_ERROR_ARGUMENT, "ring_radius: an array is NULL");
  }
  w->use.wide->radius(&w->constants, count, years, theta, y, out_r);
  return SOZAI_OK;
}

static int32_t pith(const sozai_texture *t, uint32_t count, const float *y, float *out_x,
                    float *out_z) {
  const wood_state *w = state_of(t);
  if (!w) return fail(SOZAI_ERROR_ARGUMENT, "pith: the texture is not a wood");
  if (count && (!y || !out_x || !out_z)) {
    return fail(SOZAI_ERROR_ARGUMENT, "pith: an array is NULL");
  }
  w->use.wide->pith(&w->constants, count, y, out_x, out_z);
  return SOZAI_OK;
}

const sozai_wood_1 wood_table = {ring_radius, pith};
