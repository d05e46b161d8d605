/* SPDX-License-Identifier: Apache-2.0 */
#include "host.h"

#include <stdio.h>
#include <string.h>
#include "cancel.h"
#include "parallel.h"
#include "progress.h"

static void log_line(void *user, int32_t severity, const char *text) {
  const host *h = user;
  if (severity < SOZAI_LOG_WARNING && !h->verbose) return;
  static const char *const names[] = {"debug", "info", "warning", "error"};
  bool known = severity >= SOZAI_LOG_DEBUG && severity <= SOZAI_LOG_ERROR;
  progress_clear();
  fprintf(stderr, "sozai: %s: %s\n", known ? names[severity] : "log", text ? text : "");
}

static int32_t run_parallel(void *user, uint32_t count, void (*task)(void *context, uint32_t i),
                            void *context) {
  const host *h = user;
  parallel_for(h->threads, count, task, context);
  return 0;
}

static int32_t show_progress(void *user, float fraction, const char *what) {
  (void)user;
  progress_show(fraction, what);
  return cancel_requested() ? 1 : 0;
}

static const void *get_service(void *user, const char *service_id) {
  const host *h = user;
  const colour *c = h->colour;
  return c && c->services && service_id ? c->table->get(c->services, service_id) : NULL;
}

void host_init(host *h, uint32_t threads, bool verbose, const colour *colour, const char *config) {
  memset(h, 0, sizeof *h);
  h->threads = threads;
  h->verbose = verbose;
  h->colour = colour;
  h->abi.size = sizeof h->abi;
  h->abi.user = h;
  h->abi.log = log_line;
  h->abi.parallel = run_parallel;
  h->abi.progress = show_progress;
  h->abi.get_service = get_service;
  h->abi.colour_config = config;
}
