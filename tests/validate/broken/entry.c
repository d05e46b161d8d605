/* SPDX-License-Identifier: Apache-2.0
 * The one exported datum, and the counting of init and deinit. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "plugin.h"

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static atomic_uint inits;

bool ready(void) { return atomic_load(&inits) != 0; }

static int32_t init(const char *path) {
  (void)path;
#ifdef INIT_FAILS
  return SOZAI_ERROR_MEMORY;
#endif
#ifdef PATH_TRUSTED
  if (path[0] == '\0') return SOZAI_ERROR_ARGUMENT;
#endif
  pthread_mutex_lock(&lock);
  bool good = say_open();
  if (good) atomic_fetch_add(&inits, 1);
  pthread_mutex_unlock(&lock);
  return good ? SOZAI_OK : SOZAI_ERROR_MEMORY;
}

static void deinit(void) {
  pthread_mutex_lock(&lock);
#ifdef NOT_COUNTED
  atomic_store(&inits, 1);
#endif
#ifdef DEINIT_TRUSTED
  if (atomic_load(&inits) == 0) abort();
#endif
  if (atomic_load(&inits) && atomic_fetch_sub(&inits, 1) == 1) say_close();
  pthread_mutex_unlock(&lock);
}

static const void *get_factory(const char *id) {
#ifndef BEFORE_INIT
  if (!ready()) return NULL;
#endif
#ifdef ANY_VERSION
  if (strncmp(id, "sozai.textures/", 15) == 0) return &textures;
#endif
#ifdef TABLE_MOVES
  static _Thread_local sozai_textures_1 own;
  own = textures;
  if (strcmp(id, SOZAI_TEXTURES_1) == 0) return &own;
#endif
  if (strcmp(id, SOZAI_TEXTURES_1) == 0) return &textures;
  return strcmp(id, SOZAI_GEOMETRY_1) == 0 ? &generators : NULL;
}

#ifdef WRONG_MAJOR
#define MAJOR (SOZAI_ABI_MAJOR + 1)
#else
#define MAJOR SOZAI_ABI_MAJOR
#endif
#ifdef NO_ENTRY
#define sozai_entry sozai_plugin
#define VISIBLE
#else
#define VISIBLE __attribute__((visibility("default")))
#endif
VISIBLE extern const sozai_entry_v1 sozai_entry;
const sozai_entry_v1 sozai_entry = {MAJOR, SOZAI_ABI_MINOR, init, deinit, get_factory};

#ifdef SECOND_SYMBOL
VISIBLE extern const int another;
const int another = 1;
#endif
