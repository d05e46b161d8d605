/* SPDX-License-Identifier: Apache-2.0
 * A temporary folder for one file. */
#ifndef SOZAI_BENCH_SCRATCH_H
#define SOZAI_BENCH_SCRATCH_H

#include "failure.h"

typedef struct scratch {
  char folder[512];
  char file[560]; /* within the folder */
} scratch;

/* In $TMPDIR, else in /tmp. */
bool scratch_open(scratch *s, const char *file_name, failure *why);
/* Remove both. */
void scratch_close(scratch *s);

#endif
