/* SPDX-License-Identifier: Apache-2.0 */
#define _GNU_SOURCE /* dladdr */
#include "library.h"

#include <dlfcn.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include "display.h"
#include "parallel.h"
#include "ceilings.h"

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static library opened;
static bool ready;

static bool open_all(library *l, failure *why) {
  Dl_info self;
  if (!dladdr(&opened, &self) || !self.dli_fname)
    return fail(why, EXIT_FAILURE, "cannot tell where this reader lies; set SOZAI_PLUGIN");
  if (!plugin_open_beside(&l->plugin, self.dli_fname, why)) return false;
  if (!colour_open(&l->colour, l->plugin.path, NULL, why)) {
    plugin_close(&l->plugin);
    return false;
  }
  host_init(&l->host, parallel_default_threads(), false, &l->colour, NULL);
  /* The terminal is the host's. */
  l->host.abi.progress = NULL;
  if (!limits_give(l->plugin.entry, &l->host.abi, why)) {
    colour_close(&l->colour);
    plugin_close(&l->plugin);
    return false;
  }
  const char *name = NULL;
  float xy[8];
  if (display_working(&l->colour, &name, xy) && name)
    snprintf(l->working, sizeof l->working, "%s", name);
  return true;
}

const library *library_get(failure *why) {
  pthread_mutex_lock(&lock);
  if (!ready) ready = open_all(&opened, why);
  bool ok = ready;
  pthread_mutex_unlock(&lock);
  return ok ? &opened : NULL;
}
