/* SPDX-License-Identifier: Apache-2.0
 *
 * The built sozai-colour.so, for the tests of this folder.
 */
#ifndef SOZAI_TEST_COLOUR_LIBRARY_H
#define SOZAI_TEST_COLOUR_LIBRARY_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "sozai_colour.h"

extern const char *const library_path;

/* dlopen and dlsym, not yet init. */
const sozai_entry_v1 *library_load(void);
void library_unload(void);

/* Group fixtures: loaded, initialised, and $OCIO and the like out of the way. */
int library_setup(void **state);
int library_teardown(void **state);
const sozai_colour_factory_1 *library_factory(void);

/* A service, or a failed test. NULL: the shipped config. */
const sozai_colour_1 *service_open(const char *config);
void service_close(const sozai_colour_1 *service);

/* Tests with the shipped config's service as their state. */
int shipped_setup(void **state);
int shipped_teardown(void **state);

#define assert_contains(text, part) assert_non_null(strstr(text, part))

#endif
