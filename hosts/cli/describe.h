/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_CLI_DESCRIBE_H
#define SOZAI_CLI_DESCRIBE_H

#include <stdbool.h>
#include "sozai.h"

/* Print all there is to know of a kind of texture to standard output. */
void describe_json(const sozai_texture_info *info);
void describe_text(const sozai_texture_info *info);

/* What SOZAI_KIND_* is called. */
const char *describe_kind(uint32_t kind);
/* Whether values of this kind are numbers with a range. */
bool describe_has_range(uint32_t kind);

/* The names of SOZAI_INPUT_*, by bit. */
#define DESCRIBE_INPUTS 6
extern const char *const describe_inputs[DESCRIBE_INPUTS];

#endif
