/* SPDX-License-Identifier: Apache-2.0
 * What `sozai colour` has found out, and its two forms. */
#ifndef SOZAI_CLI_COLOUR_REPORT_H
#define SOZAI_CLI_COLOUR_REPORT_H

#include "session.h"
#include "spaces.h"

typedef struct colour_use {
  const char *what; /* a material's id, or what was asked about */
  space_uses spaces;
} colour_use;

typedef struct colour_report {
  const colour *colour;
  const char *config; /* where it lies, or a phrase */
  const char *chosen; /* why that one */
  const char *working;
  bool has_chromaticities;
  float xy[8];
  colour_use *uses;
  size_t use_count;
} colour_report;

void colour_print_text(const colour_report *r);
void colour_print_json(const colour_report *r);

#endif
