/* SPDX-License-Identifier: Apache-2.0
 * Finding, checking and loading sozai.so. */
#ifndef SOZAI_HOSTS_PLUGIN_H
#define SOZAI_HOSTS_PLUGIN_H

#include "failure.h"
#include "sozai.h"

typedef struct plugin {
  void *library;
  char *path;
  const sozai_entry_v1 *entry;
  const sozai_textures_1 *textures;
  const sozai_geometry_1 *geometry; /* NULL: an older plugin, without it */
} plugin;

/* Load $SOZAI_PLUGIN if that is set, else the sozai.so that belongs to this
 * program: see places.h. */
bool plugin_open(plugin *p, failure *why);
/* The same for a library that other programs load: $SOZAI_PLUGIN, else the
 * sozai.so beside that library's file, else the configured place. */
bool plugin_open_beside(plugin *p, const char *library, failure *why);
void plugin_close(plugin *p);

/* Load a library, read the version of the entry struct it exports under
 * `symbol`, and initialise it. Shared with the colour service. */
bool plugin_load(const char *path, const char *symbol, void **library, const sozai_entry_v1 **entry,
                 failure *why);

#endif
