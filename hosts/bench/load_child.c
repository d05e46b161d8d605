/* SPDX-License-Identifier: Apache-2.0
 *
 * sozai-bench-load PLUGIN: what loading and a first create() take in a process
 * that has loaded nothing else, printed in nanoseconds. */
#define _POSIX_C_SOURCE 200809L
#include <dlfcn.h>
#include <stdio.h>
#include <time.h>
#include "sozai.h"

static double wall_ns(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

static int failed(const char *what) {
  fprintf(stderr, "sozai-bench-load: %s\n", what);
  return 1;
}

int main(int argc, char **argv) {
  if (argc != 2) return failed("usage: sozai-bench-load PLUGIN") + 1;
  double begin = wall_ns();
  void *library = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
  const sozai_entry_v1 *entry = library ? dlsym(library, SOZAI_ENTRY_SYMBOL) : NULL;
  if (!entry || entry->abi_major != SOZAI_ABI_MAJOR) return failed("no plugin of this ABI");
  if (entry->init(argv[1]) != SOZAI_OK) return failed("the plugin did not initialise");
  const sozai_textures_1 *textures = entry->get_factory(SOZAI_TEXTURES_1);
  if (!textures) return failed("the plugin has no textures");
  const sozai_value grain = {.id = "grain", .kind = SOZAI_KIND_CHOICE, .text = "compound"};
  sozai_texture *texture = NULL;
  if (textures->create(NULL, "wood", "keyaki", &grain, 1, &texture) != SOZAI_OK)
    return failed(textures->last_error());
  printf("%.0f\n", wall_ns() - begin);
  textures->destroy(texture);
  entry->deinit();
  dlclose(library);
  return 0;
}
