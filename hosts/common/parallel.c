/* SPDX-License-Identifier: Apache-2.0 */
#define _GNU_SOURCE /* sched_getaffinity */
#include "parallel.h"
#include "ceilings.h"

#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>

typedef struct work {
  void (*task)(void *context, uint32_t i);
  void *context;
  uint32_t count;
  atomic_uint next;
} work;

uint32_t parallel_default_threads(void) {
  cpu_set_t set; /* not the machine's count: containers and taskset give us fewer */
  if (sched_getaffinity(0, sizeof set, &set) != 0) return 1;
  int count = CPU_COUNT(&set);
  if (count < 1) return 1;
  return count > MOST_THREADS ? MOST_THREADS : (uint32_t)count;
}

static void *run(void *argument) {
  work *w = argument;
  for (;;) {
    /* Checked first, so that the counter cannot run round with counts near 2^32. */
    if (atomic_load(&w->next) >= w->count) return NULL;
    uint32_t i = atomic_fetch_add(&w->next, 1);
    if (i >= w->count) return NULL;
    w->task(w->context, i);
  }
}

void parallel_for(uint32_t threads, uint32_t count, void (*task)(void *context, uint32_t i),
                  void *context) {
  work w = {.task = task, .context = context, .count = count};
  atomic_init(&w.next, 0);
  if (threads > MOST_THREADS) threads = MOST_THREADS;
  if (threads > count) threads = count;
  pthread_t helpers[MOST_THREADS];
  uint32_t started = 0;
  /* A thread that cannot be had only makes it slower. */
  while (started + 1 < threads && pthread_create(&helpers[started], NULL, run, &w) == 0) started++;
  run(&w);
  for (uint32_t i = 0; i < started; i++) pthread_join(helpers[i], NULL);
}
