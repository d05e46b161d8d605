/* SPDX-License-Identifier: Apache-2.0 */
#define _GNU_SOURCE
#include "colour.h"

#include <dlfcn.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "../../api/sozai_colour.h"
#include "scalar.h"
#include "status.h"

/* ---- sozai-colour.so beside us ---------------------------------------- */

/* Services stay open until the last deinit: opening a config takes
 * milliseconds, and a scene creates many textures with the same one. */
typedef struct opened {
  struct opened *next;
  const sozai_colour_1 *service;
  char *config; /* NULL: the default */
} opened;

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static char *beside; /* path of sozai-colour.so */
static void *library;
static const sozai_entry_v1 *entry;
static const sozai_colour_factory_1 *factory;
static opened *services;
static int tried, warned;

void colour_plugin_path(const char *path) {
  Dl_info where;
  if (!path || !strchr(path, '/')) {
    path = dladdr((void *)(uintptr_t)&colour_plugin_path, &where) ? where.dli_fname : "";
  }
  const char *slash = strrchr(path, '/');
  size_t n = slash ? (size_t)(slash - path) + 1 : 0;
  static const char name[] = "sozai-colour.so";
  char *joined = malloc(n + sizeof name);
  if (!joined) return;
  memcpy(joined, path, n);
  memcpy(joined + n, name, sizeof name);
  pthread_mutex_lock(&lock);
  free(beside);
  beside = joined;
  pthread_mutex_unlock(&lock);
}

void colour_close(void) {
  pthread_mutex_lock(&lock);
  while (services) {
    opened *next = services->next;
    if (factory) factory->close(services->service);
    free(services->config);
    free(services);
    services = next;
  }
  if (entry) entry->deinit();
  if (library) dlclose(library);
  free(beside);
  beside = NULL;
  library = NULL;
  entry = NULL;
  factory = NULL;
  tried = warned = 0;
  pthread_mutex_unlock(&lock);
}

/* With the lock held. NULL: there is none, or it does not load. */
static const sozai_colour_factory_1 *load_beside(const sozai_host *host) {
  if (tried) return factory;
  tried = 1;
  if (!beside) return NULL;
  library = dlopen(beside, RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    host_log(host, SOZAI_LOG_INFO, "no colour service: %s", dlerror());
    return NULL;
  }
  entry = dlsym(library, SOZAI_COLOUR_ENTRY_SYMBOL);
  if (!entry || entry->abi_major != SOZAI_ABI_MAJOR || entry->init(beside) != SOZAI_OK) {
    host_log(host, SOZAI_LOG_WARNING, "%s is no colour service of ABI %u", beside, SOZAI_ABI_MAJOR);
    entry = NULL;
    dlclose(library);
    library = NULL;
    return NULL;
  }
  factory = entry->get_factory(SOZAI_COLOUR_FACTORY_1);
  return factory;
}

static int same(const char *a, const char *b) { return a == b || (a && b && strcmp(a, b) == 0); }

/* The service for a config, opened if it is not yet. *out NULL: there is none. */
static int32_t open_beside(const sozai_host *host, const sozai_colour_1 **out) {
  int32_t r = SOZAI_OK;
  *out = NULL;
  pthread_mutex_lock(&lock);
  const sozai_colour_factory_1 *make = load_beside(host);
  if (make) {
    for (opened *o = services; o && !*out; o = o->next) {
      if (same(o->config, host->colour_config)) *out = o->service;
    }
    if (!*out) {
      char message[512] = "";
      opened *o = calloc(1, sizeof *o);
      char *config = host->colour_config ? strdup(host->colour_config) : NULL;
      if (!o || (host->colour_config && !config)) {
        r = fail(SOZAI_ERROR_MEMORY, "out of memory: opening a colour config");
      } else {
        r = make->open(host->colour_config, &o->service, message, sizeof message);
        if (r != SOZAI_OK) fail(r, "colour config: %s", message);
      }
      if (r == SOZAI_OK) {
        o->config = config;
        o->next = services;
        services = o;
        *out = o->service;
      } else {
        free(o);
        free(config);
      }
    }
  }
  pthread_mutex_unlock(&lock);
  return r;
}

/* ---- names of sRGB ---------------------------------------------------- */

/* Configs agree on what sRGB is, not on what it is called. */
static const char *const srgb_names[] = {"sRGB",
                                         "sRGB - Texture",
                                         "srgb_texture",
                                         "Utility - sRGB - Texture",
                                         "sRGB Encoded Rec.709 (sRGB)",
                                         "srgb_rec709_scene"};
static const char *const linear_names[] = {"scene_linear", "lin_rec709", "lin_srgb",
                                           "Linear Rec.709 (sRGB)", "Linear Rec.709"};

static int is_one_of(const char *name, const char *const *list, size_t n) {
  for (size_t i = 0; i < n; i++) {
    if (strcmp(name, list[i]) == 0) return 1;
  }
  return 0;
}
#define IS_SRGB(name) is_one_of(name, srgb_names, sizeof srgb_names / sizeof *srgb_names)
#define IS_LINEAR(name) is_one_of(name, linear_names, sizeof linear_names / sizeof *linear_names)

static const char *known_name(const sozai_colour_1 *c, const char *space) {
  if (!IS_SRGB(space) || c->has_space(c->self, space)) return space;
  for (size_t i = 0; i < sizeof srgb_names / sizeof *srgb_names; i++) {
    if (c->has_space(c->self, srgb_names[i])) return srgb_names[i];
  }
  return space;
}

/* ---- without a service ------------------------------------------------ */

/* IEC 61966-2-1, mirrored for negative numbers. */
static double srgb_to_linear(double x) {
  double a = x < 0.0 ? -x : x;
  double y = a <= 0.04045 ? a / 12.92 : scalar_exp(2.4 * scalar_log((a + 0.055) / 1.055));
  return x < 0.0 ? -y : y;
}

static int32_t convert_by_formula(const char *id, const char *space, float rgb[3]) {
  if (IS_LINEAR(space)) return SOZAI_OK;
  if (!IS_SRGB(space)) {
    return fail(SOZAI_ERROR_COLOUR,
                "%s: colour space \"%.80s\" needs a colour service, and there is none; "
                "without one sRGB and lin_rec709 are known",
                id, space);
  }
  for (int c = 0; c < 3; c++) rgb[c] = (float)srgb_to_linear(rgb[c]);
  return SOZAI_OK;
}

static void warn_once(const sozai_host *host) {
  pthread_mutex_lock(&lock);
  int first = !warned;
  warned = 1;
  pthread_mutex_unlock(&lock);
  if (first) {
    host_log(host, SOZAI_LOG_WARNING,
             "no colour service: sRGB is linearised by its formula, and the working space is "
             "taken to be linear Rec.709");
  }
}

/* ---- conversion ------------------------------------------------------- */

int32_t colour_convert(const sozai_host *host, const sozai_texture_info *info, const settings *s,
                       float (*out)[3]) {
  const sozai_colour_1 *service = NULL;
  if (host->get_service) service = host->get_service(host->user, SOZAI_COLOUR_1);
  if (service && service->size < sizeof *service) {
    return fail(SOZAI_ERROR_COLOUR, "the host's colour service is of %u bytes, not %zu",
                service->size, sizeof *service);
  }
  if (!service) {
    int32_t r = open_beside(host, &service);
    if (r) return r;
  }
  if (!service) warn_once(host);
  for (uint32_t i = 0; i < info->parameter_count; i++) {
    const sozai_parameter *p = info->parameters[i];
    if (p->kind != SOZAI_KIND_COLOUR) continue;
    const char *space = s->list[i].text ? s->list[i].text : "sRGB";
    for (int c = 0; c < 3; c++) out[i][c] = (float)s->list[i].number[c];
    int32_t r;
    if (service) {
      char message[512] = "";
      r = service->to_working(service->self, known_name(service, space), out[i], 1, message,
                              sizeof message);
      if (r)
        return fail(SOZAI_ERROR_COLOUR, "%s: colour space \"%.80s\": %s", p->id, space, message);
    } else {
      r = convert_by_formula(p->id, space, out[i]);
      if (r) return r;
    }
    for (int c = 0; c < 3; c++) {
      if (!(out[i][c] > -1e6f && out[i][c] < 1e6f)) {
        return fail(SOZAI_ERROR_COLOUR, "%s: not finite in the working space", p->id);
      }
    }
  }
  return SOZAI_OK;
}
