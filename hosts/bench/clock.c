/* SPDX-License-Identifier: Apache-2.0 */
#define _POSIX_C_SOURCE 200809L
#include "clock.h"

#include <time.h>

static double read_clock(clockid_t which) {
  struct timespec t;
  clock_gettime(which, &t);
  return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

double thread_ns(void) { return read_clock(CLOCK_THREAD_CPUTIME_ID); }
double wall_ns(void) { return read_clock(CLOCK_MONOTONIC); }
