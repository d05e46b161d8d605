/* SPDX-License-Identifier: Apache-2.0 */
#define _GNU_SOURCE /* sched_getaffinity */
#include "pin.h"

#include <pthread.h>
#include <sched.h>

static pthread_once_t once = PTHREAD_ONCE_INIT;
static cpu_set_t allowed;
static int count;
static size_t home;

static void look(void) {
  CPU_ZERO(&allowed);
  if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
  count = CPU_COUNT(&allowed);
  int here = sched_getcpu(); /* where the scheduler has just found room */
  home = here < 0 ? 0 : (size_t)here;
}

int pin_cpu_count(void) {
  pthread_once(&once, look);
  return count;
}

bool pin_to(int which) {
  if (which < 0 || which >= pin_cpu_count()) return false;
  size_t cpu = home;
  for (size_t other = 0; which > 0; other++)
    if (other != home && CPU_ISSET(other, &allowed)) {
      cpu = other;
      which--;
    }
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(cpu, &one);
  return sched_setaffinity(0, sizeof one, &one) == 0;
}

void pin_release(void) {
  if (pin_cpu_count() > 0) sched_setaffinity(0, sizeof allowed, &allowed);
}
