/* SPDX-License-Identifier: Apache-2.0
 *
 * Fibre as a material: its description, and the choice of kernel.
 */
#include "material.h"

#include "../../core/cpu.h"
#include "build.h"
#include "presets.h"
#include "parameters.h"
#include "texture.h"

#define PASTE_(a, b) a##b
#define KERNEL(suffix) PASTE_(fibertex_kernel_, suffix)

extern const fibertex_kernel KERNEL(scalar_1);
#if defined(__x86_64__)
extern const fibertex_kernel KERNEL(sse2_4), KERNEL(avx2_8), KERNEL(avx2_1), KERNEL(avx512_16),
    KERNEL(avx512_4), KERNEL(avx512_1);
#elif defined(__aarch64__)
extern const fibertex_kernel KERNEL(neon_4);
#endif

/* For each instruction set the wide kernel, one for what a few lanes hold, and
 * one for a point alone: a mostly empty block costs what a full one does. */
typedef struct {
  const fibertex_kernel *wide, *narrow, *single;
} fibertex_kernels;

static const fibertex_kernels kernels[CPU_COUNT] = {
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
  fibertex_constants constants;
  fibertex_kernels use;
} fibertex_state;

static const sozai_texture_info *describe(void) {
  static sozai_texture_info info = {
      .size = sizeof(sozai_texture_info),
      .revision = 1,
      .id = "fiber",
      .label = "Fibre",
      .doc = "Aggregates of fibres as a surface shows them: every strand near, and from afar a "
             "density with directions. Felt, wadding, pile, dust, and cloth of yarns.",
      .parameters = fibertex_parameters,
      .channels = fibertex_channels,
      .parameter_count = FIBERTEX_PARAMETERS,
      .component_count = FIBERTEX_COMPONENTS,
  };
  /* init calls this once, alone, before anyone else can: presets are made of
   * the catalogue of fibres then */
  if (!info.preset_count) {
    info.channel_count = fibertex_channel_count;
    info.presets = fibertex_presets(&info.preset_count);
  }
  return &info;
}

static int32_t build(void *state, const sozai_host *host, const settings *s,
                     const float (*colours)[3], const image_set *images) {
  fibertex_state *w = state;
  (void)host;
  (void)images;
  int set;
  int32_t r = cpu_choose(&set);
  if (r) return r;
  w->use = kernels[set];
  return fibertex_build(&w->constants, s, colours, w->use.wide);
}

static void evaluate(const void *state, const sozai_batch *b, float *const *out, uint64_t wanted) {
  const fibertex_state *w = state;
  fibertex_io io = {b, out, wanted};
  const fibertex_kernels *k = &w->use;
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
  return ((const fibertex_state *)state)->use.wide->name;
}

const material fibertex_material = {describe, sizeof(fibertex_state), build, evaluate, instruction_set};
