/* SPDX-License-Identifier: Apache-2.0 */
#define _GNU_SOURCE
#include "services.h"

#include <dlfcn.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../api/sozai_colour.h"
#include "status.h"

/* Services stay open until the last deinit: opening a config takes
 * milliseconds, and a scene creates many textures with the same one. */
typedef struct opened {
  struct opened *next;
  sozai_services *services;
  char *config; /* NULL: the default */
} opened;

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static char *beside; /* path of sozai-colour.so */
static void *library;
static const sozai_entry_v1 *entry;
static const sozai_services_1 *factory;
static opened *list;
static int tried;

/* Absolute, since the program may change its folder before the service is wanted. */
static char *beside_path(const char *path) {
  static const char name[] = "/sozai-colour.so";
  const char *slash = strrchr(path, '/');
  char *folder = slash ? strndup(path, (size_t)(slash - path) + 1) : strdup(".");
  char *whole = folder ? realpath(folder, NULL) : NULL;
  const char *at = whole ? whole : folder;
  char *joined = at ? malloc(strlen(at) + sizeof name) : NULL;
  if (joined) stpcpy(stpcpy(joined, at), name);
  free(whole);
  free(folder);
  return joined;
}

void services_plugin_path(const char *path) {
  Dl_info where;
  if (!path || !strchr(path, '/')) {
    path = dladdr((void *)(uintptr_t)&services_plugin_path, &where) ? where.dli_fname : "";
  }
  char *joined = beside_path(path);
  if (!joined) return;
  pthread_mutex_lock(&lock);
  free(beside);
  beside = joined;
  pthread_mutex_unlock(&lock);
}

void services_close(void) {
  pthread_mutex_lock(&lock);
  while (list) {
    opened *next = list->next;
    if (factory) factory->close(list->services);
    free(list->config);
    free(list);
    list = next;
  }
  if (entry) entry->deinit();
  if (library) dlclose(library);
  free(beside);
  beside = NULL;
  library = NULL;
  entry = NULL;
  factory = NULL;
  tried = 0;
  pthread_mutex_unlock(&lock);
}

/* What is to be logged once the lock is free again: the host's log may wait for another of its
 * threads, which waits for the lock, or call create() itself. */
typedef struct {
  int32_t severity;
  char text[1024];
} remark;

/* With the lock held. NULL: there is none, or it does not load. */
static const sozai_services_1 *load_beside(remark *said) {
  if (tried) return factory;
  tried = 1;
  if (!beside) return NULL;
  library = dlopen(beside, RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    said->severity = SOZAI_LOG_INFO;
    snprintf(said->text, sizeof said->text, "no services for colour and images: %s", dlerror());
    return NULL;
  }
  entry = dlsym(library, SOZAI_COLOUR_ENTRY_SYMBOL);
  if (!entry || entry->abi_major != SOZAI_ABI_MAJOR || entry->init(beside) != SOZAI_OK) {
    said->severity = SOZAI_LOG_WARNING;
    snprintf(said->text, sizeof said->text, "%s has no services of ABI %u", beside,
             SOZAI_ABI_MAJOR);
    entry = NULL;
    dlclose(library);
    library = NULL;
    return NULL;
  }
  factory = entry->get_factory(SOZAI_SERVICES_1);
  return factory;
}

static int same(const char *a, const char *b) { return a == b || (a && b && strcmp(a, b) == 0); }

static int32_t open_services(const sozai_host *host, opened **out, remark *said) {
  char message[512] = "";
  opened *o = calloc(1, sizeof *o);
  if (!o) return fail(SOZAI_ERROR_MEMORY, "out of memory: opening a colour config");
  int32_t r = SOZAI_OK;
  if (host->colour_config && !(o->config = strdup(host->colour_config))) {
    r = fail(SOZAI_ERROR_MEMORY, "out of memory: opening a colour config");
  } else {
    sozai_services_options options = {
        .size = sizeof options, .config = host->colour_config, .image_memory = host->image_memory};
    r = factory->open(&options, &o->services, message, sizeof message);
    if (r != SOZAI_OK) fail(r, "colour config: %s", message);
  }
  if (r != SOZAI_OK) {
    free(o->config);
    free(o);
    return r;
  }
  said->severity = SOZAI_LOG_WARNING;
  stpcpy(said->text, message);
  *out = o;
  return SOZAI_OK;
}

/* The services of the host's config, opened if they are not yet. *out NULL:
 * there are none. */
static int32_t beside_services(const sozai_host *host, sozai_services **out) {
  int32_t r = SOZAI_OK;
  remark said = {0, ""};
  *out = NULL;
  pthread_mutex_lock(&lock);
  if (load_beside(&said)) {
    opened *o = list;
    while (o && !same(o->config, host->colour_config)) o = o->next;
    if (!o) {
      r = open_services(host, &o, &said);
      if (r == SOZAI_OK) {
        o->next = list;
        list = o;
      }
    }
    if (r == SOZAI_OK) *out = o->services;
  }
  pthread_mutex_unlock(&lock);
  if (*said.text) host_log(host, said.severity, "%s", said.text);
  return r;
}

int32_t services_find(const sozai_host *host, const char *id, const void **out) {
  *out = host->get_service ? host->get_service(host->user, id) : NULL;
  if (*out) return SOZAI_OK;
  sozai_services *services;
  int32_t r = beside_services(host, &services);
  if (services) *out = factory->get(services, id);
  return r;
}
