/* SPDX-License-Identifier: Apache-2.0
 * Running checks, each in a process of its own. */
#ifndef SOZAI_VALIDATE_RUN_H
#define SOZAI_VALIDATE_RUN_H

#include "check.h"
#include "verdict.h"

typedef struct run_options {
  const char *path;    /* the plugin, absolute */
  const char *texture; /* or NULL */
  uint32_t seed;
  uint32_t jobs;
  double time_limit; /* seconds, of a check */
  bool thorough;
} run_options;

typedef enum outcome {
  OUTCOME_NONE, /* not run yet */
  OUTCOME_PASSED,
  OUTCOME_FAILED,
  OUTCOME_SKIPPED
} outcome;

typedef struct result {
  const check *check;
  const check_group *group;
  outcome outcome;
  double seconds;
  verdict *verdict;
} result;

/* Run them all, in order where one needs another. Calls `done` after each, in
 * the order of the list. False: stopped by a signal. */
bool run_checks(const run_options *options, result *results, uint32_t count,
                void (*done)(const result *r, void *user), void *user);

#endif
