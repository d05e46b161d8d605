/* SPDX-License-Identifier: Apache-2.0
 *
 * The one exported symbol, and the counting of init and deinit.
 */
#include "internal.h"
#include "ceilings.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static uint32_t init_count;
static char *shipped_config;
static char *images_library;

static void forget_paths(void) {
  free(shipped_config);
  free(images_library);
  shipped_config = NULL;
  images_library = NULL;
}

static int32_t init(const char *plugin_path) {
  int32_t result = SOZAI_OK;
  pthread_mutex_lock(&lock);
  if (init_count == 0) {
    shipped_config = sozai_colour_beside(plugin_path, "sozai.ocio");
    images_library = sozai_colour_beside(plugin_path, "sozai-images.so");
    if (!shipped_config || !images_library) result = SOZAI_ERROR_MEMORY;
    if (result != SOZAI_OK) forget_paths();
  }
  if (result == SOZAI_OK) init_count++;
  pthread_mutex_unlock(&lock);
  return result;
}

static void deinit(void) {
  pthread_mutex_lock(&lock);
  /* One deinit too many must not wrap the count around. */
  if (init_count > 0 && --init_count == 0) {
    forget_paths();
  }
  pthread_mutex_unlock(&lock);
}

static const char *locked(char *const *path) {
  pthread_mutex_lock(&lock);
  const char *found = *path;
  pthread_mutex_unlock(&lock);
  return found;
}

const char *sozai_colour_shipped_config(void) { return locked(&shipped_config); }

const char *sozai_colour_images_library(void) { return locked(&images_library); }

static const void *get_factory(const char *factory_id) {
  if (!factory_id || !sozai_colour_shipped_config()) return NULL;
  if (strcmp(factory_id, SOZAI_SERVICES_1) == 0) return &sozai_colour_services;
  if (strcmp(factory_id, SOZAI_LIMITS_1) == 0) return &sozai_colour_limits;
  return NULL;
}

extern const sozai_entry_v1 sozai_colour_entry;

__attribute__((visibility("default"))) const sozai_entry_v1 sozai_colour_entry = {
    .abi_major = SOZAI_ABI_MAJOR,
    .abi_minor = SOZAI_ABI_MINOR,
    .init = init,
    .deinit = deinit,
    .get_factory = get_factory,
};
