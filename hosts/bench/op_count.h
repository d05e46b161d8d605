/* SPDX-License-Identifier: Apache-2.0
 * Counting the vector arithmetic that some work executes. */
#ifndef SOZAI_BENCH_OP_COUNT_H
#define SOZAI_BENCH_OP_COUNT_H

#include <stdbool.h>
#include <stdint.h>

typedef struct op_count {
  uint64_t floating, integer; /* vector instructions: see decode.h */
  uint64_t instructions;      /* all */
} op_count;

/* Runs the work once, one instruction at a time, and counts. False where that
 * cannot be done: other processors, or a system that does not step. */
bool op_count_run(void (*work)(void *context), void *context, op_count *out);

#endif
