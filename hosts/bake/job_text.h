/* SPDX-License-Identifier: Apache-2.0
 * What is being baked, as text: a line "name: value" for everything that
 * decides a pixel. */
#ifndef SOZAI_BAKE_JOB_TEXT_H
#define SOZAI_BAKE_JOB_TEXT_H

#include <stdbool.h>
#include "failure.h"

/* Whole or not at all: other workers may be reading it. replace: over one that
 * is there; else that one stays. */
bool job_text_write(const char *path, const char *text, bool replace, failure *why);
/* Whether the file says the same; names the first line that differs. */
bool job_text_check(const char *path, const char *text, failure *why);

#endif
