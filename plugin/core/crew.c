/* SPDX-License-Identifier: Apache-2.0 */
#include "crew.h"

#include <stdatomic.h>
#include <stdbool.h>

#include "float_mode.h"
#include "status.h"
#include "../generator.h"

typedef struct {
  const sozai_host *host;
  void (*work)(void *context, uint32_t i);
  void *context;
  crew_progress progress;
  uint32_t jobs;
  uint8_t *ran; /* of each job: whether it has; where there is a pool */
  atomic_uint done;
  atomic_bool cancelled;
} crew;

static void run_job(void *context, uint32_t i) {
  crew *c = context;
  if (atomic_load(&c->cancelled)) return;
  if (c->ran) {
    if (c->ran[i]) return; /* what a job has moved would be moved on */
    c->ran[i] = 1;
  }
  uint64_t mode = float_mode_enter(); /* of a thread of the host's */
  c->work(c->context, i);
  float_mode_leave(mode);
  uint32_t done = atomic_fetch_add(&c->done, 1) + 1;
  double share = (double)done / c->jobs, all = c->progress.end - c->progress.begin;
  if (host_progress(c->host, c->progress.begin + share * all, c->progress.what))
    atomic_store(&c->cancelled, true);
}

int32_t crew_run(const sozai_host *host, uint32_t jobs, void (*work)(void *context, uint32_t i),
                 void *context, crew_progress progress) {
  crew c = {host, work, context, progress, jobs, NULL, 0, false};
  if (host->parallel && jobs && !(c.ran = host_alloc(host, jobs, 64))) return SOZAI_ERROR_MEMORY;
  if (host->parallel) host->parallel(host->user, jobs, run_job, &c);
  /* what a pool has left, whatever it says: one that is shut down may drop jobs and say nothing */
  for (uint32_t i = 0; i < jobs; i++) run_job(&c, i);
  host_free(host, c.ran, jobs, 64);
  if (!atomic_load(&c.cancelled)) return SOZAI_OK;
  return fail(SOZAI_ERROR_CANCELLED, "cancelled by the host: %s", progress.what);
}
