/* SPDX-License-Identifier: Apache-2.0
 *
 * Where this library lies.
 */
#include "internal.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char *in_folder_of(const char *path, const char *file_name) {
  const char *slash = strrchr(path, '/');
  size_t folder = slash ? (size_t)(slash - path) + 1 : 0;
  size_t name = strlen(file_name) + 1;
  char *joined = malloc(folder + name);
  if (!joined) return NULL;
  memcpy(joined, path, folder);
  memcpy(joined + folder, file_name, name);
  return joined;
}

char *sozai_colour_beside(const char *plugin_path, const char *file_name) {
  if (plugin_path) {
    char *told = in_folder_of(plugin_path, file_name);
    if (!told || access(told, R_OK) == 0) return told;
    free(told);
  }
  /* Not told, or told wrongly: the dynamic linker knows. */
  Dl_info info;
  if (dladdr(&sozai_colour_services, &info) && info.dli_fname)
    return in_folder_of(info.dli_fname, file_name);
  return in_folder_of("", file_name);
}
