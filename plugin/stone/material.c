/* SPDX-License-Identifier: Apache-2.0
 *
 * Stone as a material: its description, and the choice of kernel.
 */
#include "material.h"

#include "../core/cpu.h"
#include "build.h"
#include "catalogue.h"
#include "parameters.h"
#include "stone.h"

#define PASTE_(a, b) a##b
#define KERNEL(suffix) PASTE_(stone_kernel_, suffix)

extern const stone_kernel KERNEL(scalar_1);
#if defined(__x86_64__)
extern const stone_kernel KERNEL(sse2_4), KERNEL(avx2_8), KERNEL(avx2_1), KERNEL(avx512_16),
    KERNEL(avx512_4), KERNEL(avx512_1);
#elif defined(__aarch64__)
extern const stone_kernel KERNEL(neon_4);
#endif

/* For each instruction set the wide kernel, one for what a few lanes hold, and
 * one for a point alone: a mostly empty block costs what a full one does. */
typedef struct {
  const stone_kernel *wide, *narrow, *single;
} stone_kernels;

static const stone_kernels kernels[CPU_COUNT] = {
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
  stone_constants constants;
  stone_kernels use;
} stone_state;

static const sozai_texture_info *describe(void) {
  static sozai_texture_info info = {
      .size = sizeof(sozai_texture_info),
      .revision = 1,
      .id = "stone",
      .label = "Stone",
      .doc = "Solid stone: crystals, beds, inclusions, specks, veins and holes as one field in "
             "space, under a mason's finish.",
      .parameters = stone_parameters,
      .presets = stone_catalogue,
      .channels = stone_channels,
      .parameter_count = STONE_PARAMETERS,
      .component_count = STONE_COMPONENTS,
  };
  /* counts of arrays of another file are no constants in C; init calls this
   * once, alone, before anyone else can */
  if (!info.preset_count) {
    info.channel_count = stone_channel_count;
    info.preset_count = stone_catalogue_count;
  }
  return &info;
}

static int32_t build(void *state, const sozai_host *host, const settings *s,
                     const float (*colours)[3], const image_set *images) {
  stone_state *w = state;
  (void)images;
  int set;
  int32_t r = cpu_choose(&set);
  if (r) return r;
  w->use = kernels[set];
  return stone_build(&w->constants, host, s, colours, w->use.wide);
}

static void evaluate(const void *state, const sozai_batch *b, float *const *out, uint64_t wanted) {
  const stone_state *w = state;
  stone_io io = {b, out, wanted};
  const stone_kernels *k = &w->use;
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
  return ((const stone_state *)state)->use.wide->name;
}

const material stone_material = {describe, sizeof(stone_state), build, evaluate, instruction_set};
