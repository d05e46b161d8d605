/* SPDX-License-Identifier: Apache-2.0
 * The figures of Kawai's paper that show the model at work, drawn from the
 * plugin: 5 and 6 (vessels under three grains), 7 (a cross-section and the
 * face it gives) and 9 (the figure under three lights). */
#ifndef SOZAI_CLI_FIGURES_WOOD_H
#define SOZAI_CLI_FIGURES_WOOD_H

#include "json.h"
#include "session.h"

typedef struct wood_figure {
  const char *name;  /* of its files */
  const char *title; /* what it shows */
  /* Draw folder/name.png, and write the measured numbers as members of the
   * object that is open in j. */
  bool (*draw)(session *s, const char *folder, const char *name, json *j, failure *why);
} wood_figure;

extern const wood_figure wood_figures[];
extern const size_t wood_figure_count;

#endif
