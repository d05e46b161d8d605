/* SPDX-License-Identifier: Apache-2.0
 * The plugin's geometry, opened once, and what tests of every generator ask of
 * it. A test of fibre includes fiber.h in its place, one of trees tree.h. */
#ifndef SOZAI_TESTS_GROWING_H
#define SOZAI_TESTS_GROWING_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "sozai.h"

const sozai_geometry_1 *geometry(void);

/* "count=100 length=4 ..." as values, whose texts are in copy; how many. */
uint32_t values_of(const char *text, char copy[1024], sozai_value *out, uint32_t most);
/* What was grown without fault; else the test fails, with the plugin's message. */
sozai_geometry *expect_grown(int32_t code, sozai_geometry *g);

sozai_table table_of(const sozai_geometry *g, const char *id);
double cell(const sozai_table *t, uint64_t row, const char *column);
double statistic(const sozai_geometry *g, const char *column);

/* FNV-1a, on from hash. */
uint64_t fold(uint64_t hash, const void *data, size_t bytes);

/* A host's `parallel`: the tasks last to first, or none of them. */
int32_t backwards(void *user, uint32_t count, void (*task)(void *context, uint32_t i),
                  void *context);
/* Half of them, and refuses; or every other, and says nothing. */
int32_t give_up(void *user, uint32_t count, void (*task)(void *context, uint32_t i), void *context);
int32_t drop(void *user, uint32_t count, void (*task)(void *context, uint32_t i), void *context);
int32_t refuse(void *user, uint32_t count, void (*task)(void *context, uint32_t i), void *context);

/* A host's `progress`, and the furthest that it was told. */
extern float furthest;
int32_t told(void *user, float fraction, const char *what);

#endif
