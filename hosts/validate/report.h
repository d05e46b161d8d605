/* SPDX-License-Identifier: Apache-2.0
 * What was found, for people and for programs. */
#ifndef SOZAI_VALIDATE_REPORT_H
#define SOZAI_VALIDATE_REPORT_H

#include <stdio.h>

#include "run.h"

typedef struct report_head {
  const char *path;
  uint32_t seed;
  bool strict; /* a warning counts as a failure */
  bool thorough;
  double seconds; /* of the whole run */
} report_head;

typedef struct totals {
  uint32_t checks, passed, failed, skipped, warned;
} totals;

totals totals_of(const result *results, uint32_t count, bool strict);
/* As reported: with --strict, what only warned has failed. */
outcome outcome_of(const result *r, bool strict);
const char *outcome_name(outcome o);
/* Reasons kept, of those there were. */
uint32_t reasons_kept(atomic_uint *count);

/* Text, as it comes: head, each result in order, end. */
void text_head(FILE *to, const report_head *head, uint32_t checks);
void text_result(FILE *to, const report_head *head, const result *r, const result *before);
void text_end(FILE *to, const totals *t);
/* The table of all checks: of --list. */
void text_list(FILE *to);

void report_json(FILE *to, const report_head *head, const result *results, uint32_t count);
void report_junit(FILE *to, const report_head *head, const result *results, uint32_t count);

#endif
