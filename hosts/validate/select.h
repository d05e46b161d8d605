/* SPDX-License-Identifier: Apache-2.0
 * Which checks are run, and over what. */
#ifndef SOZAI_VALIDATE_SELECT_H
#define SOZAI_VALIDATE_SELECT_H

#include "failure.h"
#include "run.h"

/* The checks whose names the extended regular expression matches; NULL: all.
 * *out is to be freed. */
bool select_checks(const char *only, result **out, uint32_t *count, failure *why);

/* Whether the plugin has that texture or generator, as far as it can be asked. */
bool select_texture(const char *path, const char *id, double time_limit, failure *why);

#endif
