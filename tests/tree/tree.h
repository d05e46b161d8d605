/* SPDX-License-Identifier: Apache-2.0
 * The plugin's geometry, opened once, and trees from text. */
#ifndef SOZAI_TESTS_TREE_H
#define SOZAI_TESTS_TREE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "sozai.h"

const sozai_geometry_1 *geometry(void);

/* "age=7 orders=4 ..."; field: NULL or a field table. The result's code. */
int32_t grow_code(const sozai_host *host, const char *preset, const char *values, const char *field,
                  sozai_geometry **out);
/* The same, which must work. */
sozai_geometry *grow(const char *preset, const char *values, const char *field);

sozai_table table_of(const sozai_geometry *g, const char *id);
double cell(const sozai_table *t, uint64_t row, const char *column);
double statistic(const sozai_geometry *g, const char *column);
/* Its table "nodes" as the text of a field table; to be freed. */
char *field_text(const sozai_geometry *g);

const sozai_curves *curves_of(const sozai_geometry *g, uint32_t level);
const sozai_mesh *mesh_of(const sozai_geometry *g, uint32_t level);
/* FNV-1a, on from hash. */
uint64_t fold(uint64_t hash, const void *data, size_t bytes);

#endif
