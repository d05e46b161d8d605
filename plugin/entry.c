/* SPDX-License-Identifier: Apache-2.0
 *
 * The one exported symbol, and the counting of init and deinit.
 */
#include <pthread.h>
#include <stdatomic.h>
#include <string.h>

#include "core/colour.h"
#include "core/limits.h"
#include "core/services.h"
#include "core/status.h"
#include "generator.h"
#include "material.h"
#include "wood/material.h"

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static atomic_uint inits;

int textures_ready(void) { return atomic_load(&inits) != 0; }

static int32_t init(const char *plugin_path) {
  int32_t r = SOZAI_OK;
  pthread_mutex_lock(&lock);
  if (atomic_load(&inits) == 0) {
    if (!status_open()) r = SOZAI_ERROR_MEMORY;
    services_plugin_path(plugin_path);
    for (uint32_t i = 0; i < registry_count; i++) registry[i]->describe();
    geometry_describe();
  }
  if (r == SOZAI_OK) atomic_fetch_add(&inits, 1);
  pthread_mutex_unlock(&lock);
  return r;
}

static void deinit(void) {
  pthread_mutex_lock(&lock);
  if (atomic_load(&inits) && atomic_fetch_sub(&inits, 1) == 1) {
    colour_close();
    services_close();
    status_close();
  }
  pthread_mutex_unlock(&lock);
}

static const void *get_factory(const char *id) {
  if (!id || !textures_ready()) return NULL;
  if (strcmp(id, SOZAI_TEXTURES_1) == 0) return &textures_table;
  if (strcmp(id, SOZAI_WOOD_1) == 0) return &wood_table;
  if (strcmp(id, SOZAI_GEOMETRY_1) == 0) return &geometry_table;
  if (strcmp(id, SOZAI_LIMITS_1) == 0) return &limits_table;
  if (strcmp(id, SOZAI_MEMORY_1) == 0) return &memory_table;
  return NULL;
}

__attribute__((visibility("default"))) extern const sozai_entry_v1 sozai_entry;
const sozai_entry_v1 sozai_entry = {SOZAI_ABI_MAJOR, SOZAI_ABI_MINOR, init, deinit, get_factory};
