/* SPDX-License-Identifier: Apache-2.0
 * Measuring one entry. */
#ifndef SOZAI_BENCH_RUN_H
#define SOZAI_BENCH_RUN_H

#include "board.h"
#include "entries.h"
#include "yardstick.h"

/* What wood.create and wood.load are compared with: their goal. */
#define CREATE_GOAL_NS 5e6

typedef struct bench {
  plugin plugin;
  board board;
  yardstick *yardstick; /* NULL: no entry needs it */
  const char *picture;  /* the yardstick's file */
  uint32_t repetitions;
  uint32_t counted_batches; /* stepped through to count operations */
} bench;

/* Times in ns a point, or a create or a load. NAN: not known, or of no sense. */
typedef struct result {
  const char *name;
  const char *instruction_set; /* "" where it is not known */
  uint32_t batch;              /* 0: not in batches */
  double ns, ns_min;
  double yardstick_ns, yardstick_min;
  double ratio;                 /* of medians: how often it fits into the yardstick */
  double speedup, speedup_best; /* over one thread: of medians; of the shortest times */
  double ops, float_ops;        /* a point */
  double peak_gops;
  double limit_ns;
} result;

bool entry_needs_yardstick(const entry *e);

/* *skipped: this machine cannot. */
bool entry_run(const bench *b, const entry *e, result *out, bool *skipped, failure *why);

#endif
