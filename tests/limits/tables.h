/* SPDX-License-Identifier: Apache-2.0
 *
 * The plugin, a host that counts, and things to hand in.
 */
#ifndef SOZAI_TESTS_LIMITS_TABLES_H
#define SOZAI_TESTS_LIMITS_TABLES_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "sozai.h"

extern const sozai_entry_v1 *entry;
extern const sozai_textures_1 *textures;
extern const sozai_geometry_1 *geometry;
extern const sozai_limits_1 *limits;
extern const sozai_memory_1 *memory;

int tables_open(void **unused);
int tables_close(void **unused);

/* What its allocator has out now, and had at most. */
typedef struct {
  uint64_t live, peak;
} count;

/* A host whose allocator counts. */
sozai_host counting_host(count *c);

/* A box as a hull, mm. */
sozai_buffer box_hull(void);
/* A picture of noise round a disc, for wood's section. */
sozai_buffer section_picture(void);

uint64_t next_random(uint64_t *state);

#endif
