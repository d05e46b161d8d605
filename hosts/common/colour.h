/* SPDX-License-Identifier: Apache-2.0
 * The colour service beside the plugin, opened once and shared with it. */
#ifndef SOZAI_HOSTS_COLOUR_H
#define SOZAI_HOSTS_COLOUR_H

#include "failure.h"
#include "sozai_colour.h"

typedef struct colour {
  void *library;
  const sozai_entry_v1 *entry;
  const sozai_services_1 *table;
  sozai_services *services; /* NULL: there are none, and the rest is NULL too */
  const sozai_colour_1 *service;
  const sozai_display_1 *display;
  const sozai_images_1 *images;
} colour;

/* plugin_path: where sozai.so is. config: a path, or NULL for $OCIO, else the
 * shipped one. No library beside the plugin is no failure unless a config was
 * asked for by name: the services are then NULL. */
bool colour_open(colour *c, const char *plugin_path, const char *config, failure *why);
void colour_close(colour *c);

#endif
