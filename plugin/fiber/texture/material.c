/* SPDX-License-Identifier: Apache-2.0
 *
 * Fibre as a material: its description, and the choice of kernel.
 */
#include "material.h"

#include "../../core/active.h"
#include "build.h"
#include "parameters.h"
#include "presets.h"
#include "texture.h"

KERNEL_SETS(fibertex_kernel, kernels);

typedef struct {
  fibertex_constants constants;
  kernel_set use;
} fibertex_state;

static const sozai_texture_info *describe(void) {
  static sozai_texture_info info = {
      .size = sizeof(sozai_texture_info),
      .revision = 18,
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
  (void)images;
  int32_t r = kernel_choose(kernels, &w->use);
  if (r) return r;
  return fibertex_build(&w->constants, host, s, colours, (const fibertex_kernel *)w->use.wide);
}

_Static_assert(FIBERTEX_COMPONENTS <= ACTIVE_OUTPUTS, "active.h has room for fewer");

static void evaluate(const void *state, const sozai_batch *b, float *const *out, uint64_t wanted) {
  const fibertex_state *w = state;
  kernel_io io = {b, out, wanted};
  kernel_run(&w->use, &w->constants, &io);
}

static const char *instruction_set(const void *state) {
  return ((const fibertex_state *)state)->use.wide->name;
}

const material fibertex_material = {
    describe, sizeof(fibertex_state), build, evaluate, instruction_set, NULL, NULL};
