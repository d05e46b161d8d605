/* SPDX-License-Identifier: Apache-2.0 */
#include "plugin.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "places.h"

bool plugin_load(const char *path, const char *symbol, void **library, const sozai_entry_v1 **entry,
                 failure *why) {
  void *handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (!handle) return fail(why, EXIT_FAILURE, "cannot load %s: %s", path, dlerror());
  const sozai_entry_v1 *e = dlsym(handle, symbol);
  if (!e)
    fail(why, EXIT_FAILURE, "%s exports no %s: not a sozai library", path, symbol);
  else if (e->abi_major != SOZAI_ABI_MAJOR)
    fail(why, EXIT_FAILURE, "%s has ABI version %u.%u; this program needs %u", path, e->abi_major,
         e->abi_minor, SOZAI_ABI_MAJOR);
  else if (!e->init || !e->deinit || !e->get_factory)
    fail(why, EXIT_FAILURE, "%s: its entry lacks a function", path);
  else {
    int32_t result = e->init(path);
    if (result == SOZAI_OK) {
      *library = handle;
      *entry = e;
      return true;
    }
    fail(why, EXIT_FAILURE, "%s did not initialise: error %d", path, (int)result);
  }
  dlclose(handle);
  return false;
}

/* library: what the plugin lies beside; NULL: this program. */
static bool open_found(plugin *p, const char *library, failure *why) {
  memset(p, 0, sizeof *p);
  char found[2 * PATH_MAX];
  const char *path = getenv("SOZAI_PLUGIN");
  if (!path || !*path) {
    if (!(library ? places_find_beside(found, sizeof found, "sozai.so", library, why)
                  : places_find(found, sizeof found, "sozai.so", why)))
      return fail(why, EXIT_FAILURE, "%s; set SOZAI_PLUGIN to its path", why->text);
    path = found;
  }
  /* Absolute: dlopen would look a bare name up in the system's folders, and the
   * plugin looks for the colour service beside itself. */
  p->path = realpath(path, NULL);
  if (!p->path) return fail(why, EXIT_FAILURE, "no such plugin: %s", path);
  if (!plugin_load(p->path, SOZAI_ENTRY_SYMBOL, &p->library, &p->entry, why)) {
    free(p->path);
    p->path = NULL;
    return false;
  }
  p->textures = p->entry->get_factory(SOZAI_TEXTURES_1);
  if (!p->textures) {
    fail(why, EXIT_FAILURE, "%s has no factory %s", p->path, SOZAI_TEXTURES_1);
    plugin_close(p);
    return false;
  }
  p->geometry = p->entry->get_factory(SOZAI_GEOMETRY_1);
  return true;
}

bool plugin_open_beside(plugin *p, const char *library, failure *why) {
  if (open_found(p, library, why)) return true;
  const char *asked = getenv("SOZAI_PLUGIN");
  if (asked && *asked) why->exit_code = EXIT_BAD_INPUT;
  return false;
}

bool plugin_open(plugin *p, failure *why) { return plugin_open_beside(p, NULL, why); }

void plugin_close(plugin *p) {
  if (p->entry) p->entry->deinit();
  if (p->library) dlclose(p->library);
  free(p->path);
  memset(p, 0, sizeof *p);
}
