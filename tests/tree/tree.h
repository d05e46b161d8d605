/* SPDX-License-Identifier: Apache-2.0
 * Trees from text. */
#ifndef SOZAI_TESTS_TREE_H
#define SOZAI_TESTS_TREE_H

#include "../growing.h"

/* "age=7 orders=4 ..."; field: NULL or a field table. The result's code. */
int32_t grow_code(const sozai_host *host, const char *preset, const char *values, const char *field,
                  sozai_geometry **out);
/* The same, which must work. */
sozai_geometry *grow(const char *preset, const char *values, const char *field);

/* Its table "nodes" as the text of a field table; to be freed. */
char *field_text(const sozai_geometry *g);

const sozai_curves *curves_of(const sozai_geometry *g, uint32_t level);
const sozai_mesh *mesh_of(const sozai_geometry *g, uint32_t level);

#endif
