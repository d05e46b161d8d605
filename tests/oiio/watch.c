/* SPDX-License-Identifier: Apache-2.0 */
#include "watch.h"

#include <dlfcn.h>
#include <stddef.h>
#include <string.h>
#include "sozai.h"

static const sozai_entry_v1 *real;
static sozai_textures_1 table;
static watch seen;

static int32_t evaluate(const sozai_texture *texture, const sozai_batch *batch) {
  seen.batches++;
  seen.points += batch->count;
  for (uint32_t k = 0; k < batch->out_count && k < 64; k++)
    if (batch->out[k]) seen.asked |= (uint64_t)1 << k;
  const sozai_textures_1 *t = real->get_factory(SOZAI_TEXTURES_1);
  return t->evaluate(texture, batch);
}

static int32_t init(const char *path) {
  (void)path;
  void *library = dlopen(SOZAI_TEST_PLUGIN, RTLD_NOW | RTLD_LOCAL);
  real = library ? dlsym(library, SOZAI_ENTRY_SYMBOL) : NULL;
  return real ? real->init(SOZAI_TEST_PLUGIN) : SOZAI_ERROR_FILE;
}

static void deinit(void) { real->deinit(); }

static const void *get_factory(const char *id) {
  const void *factory = real->get_factory(id);
  if (!factory || strcmp(id, SOZAI_TEXTURES_1) != 0) return factory;
  table = *(const sozai_textures_1 *)factory;
  table.evaluate = evaluate;
  return &table;
}

__attribute__((visibility("default"))) watch watch_take(void);
watch watch_take(void) {
  watch taken = seen;
  memset(&seen, 0, sizeof seen);
  return taken;
}

__attribute__((visibility("default"))) extern const sozai_entry_v1 sozai_entry;
const sozai_entry_v1 sozai_entry = {SOZAI_ABI_MAJOR, SOZAI_ABI_MINOR, init, deinit, get_factory};
