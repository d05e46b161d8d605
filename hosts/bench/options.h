/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_BENCH_OPTIONS_H
#define SOZAI_BENCH_OPTIONS_H

#include "failure.h"

typedef struct bench_options {
  bool json, quick, list, help;
  const char *filter; /* NULL: everything */
} bench_options;

bool bench_options_read(bench_options *o, int argc, char **argv, failure *why);
void bench_options_help(void);

#endif
