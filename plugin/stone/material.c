/* SPDX-License-Identifier: Apache-2.0
 *
 * Stone as a material: its description, and the choice of kernel.
 */
#include "material.h"

#include "../core/active.h"
#include "build.h"
#include "catalogue.h"
#include "parameters.h"
#include "stone.h"

KERNEL_SETS(stone_kernel, kernels);

typedef struct {
  stone_constants constants;
  kernel_set use;
} stone_state;

static const sozai_texture_info *describe(void) {
  static sozai_texture_info info = {
      .size = sizeof(sozai_texture_info),
      .revision = 38,
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
  int32_t r = kernel_choose(kernels, &w->use);
  if (r) return r;
  return stone_build(&w->constants, host, s, colours, (const stone_kernel *)w->use.wide);
}

_Static_assert(STONE_COMPONENTS <= ACTIVE_OUTPUTS, "active.h has room for fewer");

static void evaluate(const void *state, const sozai_batch *b, float *const *out, uint64_t wanted) {
  const stone_state *w = state;
  kernel_io io = {b, out, wanted};
  kernel_run(&w->use, &w->constants, &io);
}

static const char *instruction_set(const void *state) {
  return ((const stone_state *)state)->use.wide->name;
}

const material stone_material = {
    describe, sizeof(stone_state), build, evaluate, instruction_set, NULL, NULL};
