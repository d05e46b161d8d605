/* SPDX-License-Identifier: Apache-2.0 */
#include "colour.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "plugin.h"

#define SERVICE_NAME "sozai-colour.so"

static char *beside(const char *plugin_path) {
  const char *slash = strrchr(plugin_path, '/');
  size_t folder = slash ? (size_t)(slash - plugin_path) + 1 : 0;
  char *path = malloc(folder + sizeof SERVICE_NAME);
  if (!path) return NULL;
  memcpy(path, plugin_path, folder);
  memcpy(path + folder, SERVICE_NAME, sizeof SERVICE_NAME);
  return path;
}

static bool open_service(colour *c, const char *path, const char *config, failure *why) {
  if (!plugin_load(path, SOZAI_COLOUR_ENTRY_SYMBOL, &c->library, &c->entry, why)) return false;
  c->table = c->entry->get_factory(SOZAI_SERVICES_1);
  if (!c->table) return fail(why, EXIT_FAILURE, "%s has no factory %s", path, SOZAI_SERVICES_1);
  char message[512] = "";
  sozai_services_options options = {.size = sizeof options, .config = config};
  if (c->table->open(&options, &c->services, message, sizeof message) != SOZAI_OK) {
    /* which names the config */
    return fail(why, EXIT_BAD_INPUT, "%s", *message ? message : "the colour config did not open");
  }
  if (*message) fprintf(stderr, "sozai: %s\n", message);
  c->service = c->table->get(c->services, SOZAI_COLOUR_1);
  c->display = c->table->get(c->services, SOZAI_DISPLAY_1);
  c->images = c->table->get(c->services, SOZAI_IMAGES_1);
  return true;
}

bool colour_open(colour *c, const char *plugin_path, const char *config, failure *why) {
  memset(c, 0, sizeof *c);
  char *path = beside(plugin_path);
  if (!path) return fail(why, EXIT_FAILURE, "out of memory");
  bool ok = true;
  if (access(path, F_OK) == 0)
    ok = open_service(c, path, config, why);
  else if (config)
    ok = fail(why, EXIT_FAILURE, "config %s needs %s, which is missing", config, path);
  free(path);
  if (!ok) colour_close(c);
  return ok;
}

void colour_close(colour *c) {
  if (c->services) c->table->close(c->services);
  if (c->entry) c->entry->deinit();
  if (c->library) dlclose(c->library);
  memset(c, 0, sizeof *c);
}
