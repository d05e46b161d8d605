/* SPDX-License-Identifier: Apache-2.0 */
#include "plugin.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

int plugin_open(plugin *p, const char *path) {
  memset(p, 0, sizeof *p);
  p->library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (!p->library) {
    fprintf(stderr, "%s\n", dlerror());
    return -1;
  }
  p->entry = dlsym(p->library, SOZAI_ENTRY_SYMBOL);
  if (!p->entry || p->entry->abi_major != SOZAI_ABI_MAJOR) {
    fprintf(stderr, "%s: no %s of ABI %u\n", path, SOZAI_ENTRY_SYMBOL, SOZAI_ABI_MAJOR);
    return -1;
  }
  return 0;
}

int plugin_start(plugin *p, const char *path) {
  if (plugin_open(p, path)) return -1;
  if (p->entry->init(ALONE) != SOZAI_OK) {
    fprintf(stderr, "%s: init failed\n", path);
    return -1;
  }
  p->textures = p->entry->get_factory(SOZAI_TEXTURES_1);
  return p->textures ? 0 : -1;
}

void plugin_stop(plugin *p) {
  p->entry->deinit();
  dlclose(p->library);
  memset(p, 0, sizeof *p);
}

sozai_texture *plugin_wood(const plugin *p, const char *preset, const char *grain) {
  /* with a grain, also what else is seldom on */
  const sozai_value values[] = {
      {.id = "grain", .kind = SOZAI_KIND_CHOICE, .text = grain},
      {.id = "reflection", .kind = SOZAI_KIND_CHOICE, .text = "fibre_cone"},
      {.id = "coat", .kind = SOZAI_KIND_FLOAT, .number = {0.5}},
      {.id = "heartwood_years", .kind = SOZAI_KIND_FLOAT, .number = {20}}};
  sozai_texture *t = NULL;
  if (p->textures->create(NULL, "wood", preset, values, grain ? 4 : 0, &t) != SOZAI_OK) {
    fprintf(stderr, "create %s: %s\n", preset ? preset : "wood", p->textures->last_error());
  }
  return t;
}
