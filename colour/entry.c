/* SPDX-License-Identifier: Apache-2.0
 *
 * The one exported symbol, and the counting of init and deinit.
 */
#include "internal.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static uint32_t init_count;
static char *shipped_config;

static int32_t init(const char *plugin_path) {
  int32_t result = SOZAI_OK;
  pthread_mutex_lock(&lock);
  if (init_count == 0) {
    shipped_config = sozai_colour_beside(plugin_path, "sozai.ocio");
    if (!shipped_config) result = SOZAI_ERROR_MEMORY;
  }
  if (result == SOZAI_OK) init_count++;
  pthread_mutex_unlock(&lock);
  return result;
}

static void deinit(void) {
  pthread_mutex_lock(&lock);
  /* One deinit too many must not wrap the count around. */
  if (init_count > 0 && --init_count == 0) {
    free(shipped_config);
    shipped_config = NULL;
  }
  pthread_mutex_unlock(&lock);
}

const char *sozai_colour_shipped_config(void) {
  pthread_mutex_lock(&lock);
  const char *path = shipped_config;
  pthread_mutex_unlock(&lock);
  return path;
}

static const void *get_factory(const char *factory_id) {
  if (!factory_id || strcmp(factory_id, SOZAI_SERVICES_1) != 0) return NULL;
  return sozai_colour_shipped_config() ? &sozai_colour_services : NULL;
}

extern const sozai_entry_v1 sozai_colour_entry;

__attribute__((visibility("default"))) const sozai_entry_v1 sozai_colour_entry = {
    .abi_major = SOZAI_ABI_MAJOR,
    .abi_minor = SOZAI_ABI_MINOR,
    .init = init,
    .deinit = deinit,
    .get_factory = get_factory,
};
