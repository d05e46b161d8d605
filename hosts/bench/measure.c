/* SPDX-License-Identifier: Apache-2.0 */
#include "measure.h"

#include <stdlib.h>
#include "cancel.h"

#define MOST_CONTESTANTS 4

static int ascending(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static timing summarise(double *samples, uint32_t count) {
  qsort(samples, count, sizeof *samples, ascending);
  double low = samples[(count - 1) / 2], high = samples[count / 2];
  return (timing){.median = 0.5 * (low + high), .min = samples[0]};
}

bool measure(const contestant *who, size_t count, uint32_t repetitions, timing *out, failure *why) {
  static double samples[MOST_CONTESTANTS][MOST_REPETITIONS + 1];
  if (count > MOST_CONTESTANTS || repetitions > MOST_REPETITIONS)
    return fail(why, EXIT_FAILURE, "too much to measure at once");
  for (uint32_t k = 0; k <= repetitions; k++)
    for (size_t i = 0; i < count; i++) {
      if (cancel_requested()) return fail(why, EXIT_FAILURE, "stopped");
      if (!who[i].run(who[i].context, &samples[i][k], why)) return false;
    }
  for (size_t i = 0; i < count; i++) out[i] = summarise(samples[i] + 1, repetitions);
  return true;
}
