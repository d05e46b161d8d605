/* SPDX-License-Identifier: Apache-2.0
 *
 * What is made while something fails: together, everything that allocates.
 */
#ifndef SOZAI_TESTS_FAILURE_CASES_H
#define SOZAI_TESTS_FAILURE_CASES_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "allocator.h"
#include "sozai.h"

extern const sozai_entry_v1 *entry;
extern const sozai_textures_1 *textures;
extern const sozai_geometry_1 *geometry;
extern const sozai_memory_1 *memory;

typedef struct {
  const char *name;
  const char *texture; /* or NULL: */
  const char *generator;
  const char *preset;
  const sozai_value *values;
  uint32_t count;
} made;

/* After cases_open; ends with one without a name. */
extern made cases[];

int cases_open(void **unused);
int cases_close(void **unused);

/* One of them: what create or grow gave. */
typedef struct {
  sozai_texture *texture;
  sozai_geometry *geometry;
} thing;

int32_t case_make(const made *c, const sozai_host *host, thing *out);
void case_free(thing *t);

#endif
