/* SPDX-License-Identifier: Apache-2.0
 *
 * The built plugin as a stranger sees it: opened by its path, through the
 * public header alone.
 */
#ifndef SOZAI_TESTS_PLUGIN_H
#define SOZAI_TESTS_PLUGIN_H

#include "sozai.h"

#define COMPONENTS 64u /* more than any texture has */

/* No colour service lies there: sRGB goes by its formula, on every machine,
 * and what is tested is this library alone. */
#define ALONE "/nonexistent/sozai.so"

typedef struct {
  void *library;
  const sozai_entry_v1 *entry;
  const sozai_textures_1 *textures; /* after init */
} plugin;

/* 0, or -1 with the reason on stderr. */
int plugin_open(plugin *p, const char *path);
/* The same and init. */
int plugin_start(plugin *p, const char *path);
void plugin_stop(plugin *p);

/* A texture, or NULL with the reason on stderr. grain NULL: the preset's own. */
sozai_texture *plugin_wood(const plugin *p, const char *preset, const char *grain);

/* SplitMix64: the same numbers on every machine, without a library's help. */
static inline uint64_t mix64(uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

#endif
