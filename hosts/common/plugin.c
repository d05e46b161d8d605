/* SPDX-License-Identifier: Apache-2.0 */
#include "plugin.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

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

/* The folder this program stands in, with a slash at its end. */
static bool executable_folder(char *folder, size_t size) {
  ssize_t length = readlink("/proc/self/exe", folder, size - 1);
  if (length <= 0) return false;
  folder[length] = '\0';
  char *slash = strrchr(folder, '/');
  if (!slash) return false;
  slash[1] = '\0';
  return true;
}

/* The first that exists of: ../lib and the install libdir beside the program,
 * so that build trees and moved installations work, then the configured
 * libdir; in each, sozai.so itself or in a folder sozai. */
static bool find(char *found, size_t size, failure *why) {
  static const char *const relative[] = {"../lib/", "../" SOZAI_LIBDIR "/"};
  static const char *const names[] = {"sozai.so", "sozai/sozai.so"};
  char folder[PATH_MAX];
  bool known = executable_folder(folder, sizeof folder);
  for (size_t place = 0; place < 3; place++)
    for (size_t name = 0; name < 2; name++) {
      if (place < 2 && !known) continue;
      int length = place < 2 ? snprintf(found, size, "%s%s%s", folder, relative[place], names[name])
                             : snprintf(found, size, "%s/%s", SOZAI_FULL_LIBDIR, names[name]);
      if (length > 0 && (size_t)length < size && access(found, R_OK) == 0) return true;
    }
  return fail(why, EXIT_FAILURE,
              "sozai.so not found in %s../lib, %s../%s or %s; set SOZAI_PLUGIN to its path",
              known ? folder : "", known ? folder : "", SOZAI_LIBDIR, SOZAI_FULL_LIBDIR);
}

/* Beside a library, or in a folder sozai there, else in the configured libdir. */
static bool find_beside(char *found, size_t size, const char *library, failure *why) {
  const char *slash = strrchr(library, '/');
  int folder = slash ? (int)(slash + 1 - library) : 0;
  static const char *const names[] = {"sozai.so", "sozai/sozai.so"};
  for (size_t place = 0; place < 2; place++)
    for (size_t name = 0; name < 2; name++) {
      int length = place == 0 ? snprintf(found, size, "%.*s%s", folder, library, names[name])
                              : snprintf(found, size, "%s/%s", SOZAI_FULL_LIBDIR, names[name]);
      if (length > 0 && (size_t)length < size && access(found, R_OK) == 0) return true;
    }
  return fail(why, EXIT_FAILURE,
              "sozai.so not found beside %s or in %s; set SOZAI_PLUGIN to its path", library,
              SOZAI_FULL_LIBDIR);
}

/* library: what the plugin lies beside; NULL: this program. */
static bool open_found(plugin *p, const char *library, failure *why) {
  memset(p, 0, sizeof *p);
  char found[2 * PATH_MAX];
  const char *path = getenv("SOZAI_PLUGIN");
  if (!path || !*path) {
    if (!(library ? find_beside(found, sizeof found, library, why)
                  : find(found, sizeof found, why)))
      return false;
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
  return true;
}

bool plugin_open(plugin *p, failure *why) { return open_found(p, NULL, why); }

bool plugin_open_beside(plugin *p, const char *library, failure *why) {
  return open_found(p, library, why);
}

void plugin_close(plugin *p) {
  if (p->entry) p->entry->deinit();
  if (p->library) dlclose(p->library);
  free(p->path);
  memset(p, 0, sizeof *p);
}
