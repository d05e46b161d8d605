/* SPDX-License-Identifier: Apache-2.0
 * Taking times in turn: A B A B ..., so that what slows the machine for a while
 * slows all alike. */
#ifndef SOZAI_BENCH_MEASURE_H
#define SOZAI_BENCH_MEASURE_H

#include <stddef.h>
#include <stdint.h>
#include "failure.h"

#define MOST_REPETITIONS 64

typedef struct contestant {
  bool (*run)(void *context, double *ns, failure *why); /* one repetition */
  void *context;
} contestant;

typedef struct timing {
  double median, min; /* ns a repetition */
} timing;

/* Each runs once beforehand, untimed. */
bool measure(const contestant *who, size_t count, uint32_t repetitions, timing *out, failure *why);

#endif
