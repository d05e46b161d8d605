/* SPDX-License-Identifier: Apache-2.0
 * A figure of a paper: how it is drawn and measured. */
#ifndef SOZAI_CLI_FIGURE_H
#define SOZAI_CLI_FIGURE_H

#include "json.h"
#include "session.h"

typedef struct figure {
  const char *name;  /* of its files */
  const char *title; /* what it shows */
  /* Draw folder/name.png, and write the measured numbers as members of the
   * object that is open in j. */
  bool (*draw)(session *s, const char *folder, const char *name, json *j, failure *why);
} figure;

#endif
