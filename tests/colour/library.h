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

/* What one config gives. */
typedef struct service {
  sozai_services *handle;
  const sozai_colour_1 *colour;
  const sozai_display_1 *display;
} service;

extern const char *const library_path;

/* dlopen and dlsym, not yet init. */
const sozai_entry_v1 *library_load(void);
void library_unload(void);

/* Group fixtures: loaded, initialised, and $OCIO and the like out of the way. */
int library_setup(void **state);
int library_teardown(void **state);
const sozai_services_1 *library_factory(void);

/* The factory's open() of a config, whatever comes of it. NULL: no name given. */
int32_t library_open(const char *config, sozai_services **out, char *message, size_t size);

/* A service, or a failed test. NULL: the shipped config. */
service service_open(const char *config);
void service_close(service s);

/* Tests with the shipped config's services as their state. */
int shipped_setup(void **state);
int shipped_teardown(void **state);
static inline const sozai_colour_1 *colour_of(void **state) {
  return ((const service *)*state)->colour;
}
static inline const sozai_display_1 *display_of(void **state) {
  return ((const service *)*state)->display;
}

/* Where Blender's config is: SOZAI_TEST_BLENDER_CONFIG, else Debian's place for it.
 * Tests that find none there skip. */
const char *blender_config(void);

#define assert_contains(text, part) assert_non_null(strstr(text, part))

#endif
