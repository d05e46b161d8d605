/* SPDX-License-Identifier: Apache-2.0
 * What a check found, in memory that it shares with the program that started
 * it, so that nothing is lost when it dies. */
#ifndef SOZAI_VALIDATE_VERDICT_H
#define SOZAI_VALIDATE_VERDICT_H

#include <stdatomic.h>
#include <stdbool.h>

#define VERDICT_LINES 10 /* reasons kept; of more, the number */
#define VERDICT_LINE 400 /* bytes each */

typedef struct verdict {
  atomic_uint asked;
  atomic_uint failures;
  atomic_uint warnings;
  atomic_bool chance;   /* used the seed */
  atomic_bool finished; /* came to its end */
  char failure[VERDICT_LINES][VERDICT_LINE];
  char warning[VERDICT_LINES][VERDICT_LINE];
  char skip[VERDICT_LINE]; /* "": not skipped */
  char doing[VERDICT_LINE];
} verdict;

/* Where this process's check writes. Without one, nothing is kept. */
void verdict_to(verdict *v);
/* The check made use of the seed. */
void verdict_chance(void);
/* Add a reason from outside of the check. */
void verdict_fail(verdict *v, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
