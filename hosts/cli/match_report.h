/* SPDX-License-Identifier: Apache-2.0
 * What `sozai match` prints, and the .sozai file it writes. */
#ifndef SOZAI_CLI_MATCH_REPORT_H
#define SOZAI_CLI_MATCH_REPORT_H

#include <stdio.h>
#include "match.h"

typedef struct match_report {
  const match_result *result;
  const recipe *recipe;
  const photo *photo;
  const char *path;    /* of the photograph */
  const char *working; /* name of the space that means and covariances are in */
  double width;        /* mm, of what was matched */
  double pixel;        /* mm */
  bool width_assumed;
} match_report;

/* begin: what every line begins with, "" or "# ". */
void match_print(FILE *to, const match_report *r, const char *begin);
void match_write_recipe(FILE *to, const match_report *r);

#endif
