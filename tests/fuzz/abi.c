/* SPDX-License-Identifier: Apache-2.0
 * The whole plugin over the ABI: a texture of any kind and preset, any values for it, then a batch
 * of any inputs; what comes out is finite, what was not asked for is untouched, and all memory
 * comes back. */
#define _GNU_SOURCE /* setenv */
#include <string.h>

#include "batch.h"
#include "bounded.h"
#include "values.h"

static void read_back(const sozai_textures_1 *textures, const sozai_texture *t) {
  const sozai_texture_info *info = textures->info_of(t);
  for (uint32_t i = 0; i < info->parameter_count; i++) {
    sozai_value v;
    CHECK(textures->value(t, info->parameters[i]->id, &v) == SOZAI_OK);
  }
  CHECK(textures->bytes(t) > 0 && *textures->instruction_set(t));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  const sozai_textures_1 *textures = batch_plugin();
  bytes b = {data, size};
  const sozai_texture_info *info = textures->info(take_below(&b, textures->count()));
  uint32_t preset = take_below(&b, info->preset_count + 1);
  setenv("SOZAI_CPU", take_u8(&b) & 1 ? "scalar" : "", 1);
  values v;
  values_take(&v, &b, info->parameters, info->parameter_count);
  bounded_begin(&(bounded_limits){.bytes = 96 << 20, .calls = 60});
  sozai_texture *t = (sozai_texture *)(uintptr_t)8;
  int32_t r = textures->create(&bounded_host, info->id,
                               preset ? info->presets[preset - 1]->id : NULL, v.list, v.count, &t);
  values_free(&v);
  if (r == SOZAI_OK) {
    read_back(textures, t);
    batch_try(t, &b);
    batch_try(t, &b);
    textures->destroy(t);
  } else
    CHECK(!t && *textures->last_error() && !strchr(textures->last_error(), '\n'));
  bounded_end();
  return 0;
}
