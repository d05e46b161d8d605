/* SPDX-License-Identifier: Apache-2.0 */
#include "pictures.h"

#include <dlfcn.h>
#include <limits.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "../pictures/module.h"
#include "places.h"

static pthread_once_t once = PTHREAD_ONCE_INIT;
static const pictures *loaded;
static failure reason;

static void load(void) {
  char path[2 * PATH_MAX];
  if (!places_find(path, sizeof path, "sozai-pictures.so", &reason)) return;
  void *library = dlopen(path, RTLD_LAZY | RTLD_LOCAL);
  const pictures *found = library ? dlsym(library, PICTURES_SYMBOL) : NULL;
  if (!found) {
    const char *error = dlerror();
    fail(&reason, EXIT_FAILURE, "cannot load %s: %s", path, error ? error : "not sozai's");
  } else if (strcmp(found->version, SOZAI_VERSION) != 0)
    fail(&reason, EXIT_FAILURE, "%s is of version %s, this program of %s", path, found->version,
         SOZAI_VERSION);
  else
    loaded = found;
}

const pictures *pictures_load(failure *why) {
  pthread_once(&once, load);
  if (!loaded) *why = reason;
  return loaded;
}
