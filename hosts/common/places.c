/* SPDX-License-Identifier: Apache-2.0 */
#include "places.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *const folders[] = {"", "sozai/"};
#define FOLDERS (sizeof folders / sizeof *folders)

/* Below `base`, the first `length` letters of it. */
static bool is_below(char *found, size_t size, const char *base, int length, const char *then,
                     const char *name) {
  for (size_t i = 0; i < FOLDERS; i++) {
    int n = snprintf(found, size, "%.*s%s%s%s", length, base, then, folders[i], name);
    if (n > 0 && (size_t)n < size && access(found, R_OK) == 0) return true;
  }
  return false;
}

static bool is_configured(char *found, size_t size, const char *name) {
  return is_below(found, size, SOZAI_FULL_LIBDIR, (int)strlen(SOZAI_FULL_LIBDIR), "/", name);
}

/* The folder this program stands in, with a slash at its end; or empty. */
static void executable_folder(char *folder, size_t size) {
  ssize_t length = readlink("/proc/self/exe", folder, size - 1);
  folder[length > 0 ? length : 0] = '\0';
  char *slash = strrchr(folder, '/');
  folder[slash ? slash + 1 - folder : 0] = '\0';
}

bool places_find(char *found, size_t size, const char *name, failure *why) {
  char folder[PATH_MAX];
  executable_folder(folder, sizeof folder);
  int length = (int)strlen(folder);
  if (length && (is_below(found, size, folder, length, "../lib/", name) ||
                 is_below(found, size, folder, length, "../" SOZAI_LIBDIR "/", name)))
    return true;
  return is_configured(found, size, name) ||
         fail(why, EXIT_FAILURE, "%s not found in %s../lib, %s../%s or %s", name, folder, folder,
              SOZAI_LIBDIR, SOZAI_FULL_LIBDIR);
}

bool places_find_beside(char *found, size_t size, const char *name, const char *library,
                        failure *why) {
  const char *slash = strrchr(library, '/');
  int length = slash ? (int)(slash + 1 - library) : 0;
  return is_below(found, size, library, length, "", name) || is_configured(found, size, name) ||
         fail(why, EXIT_FAILURE, "%s not found beside %s or in %s", name, library,
              SOZAI_FULL_LIBDIR);
}
