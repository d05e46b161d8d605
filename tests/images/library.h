/* SPDX-License-Identifier: Apache-2.0
 *
 * The built sozai-colour.so and its images, for the tests of this folder.
 */
#ifndef SOZAI_TEST_IMAGES_LIBRARY_H
#define SOZAI_TEST_IMAGES_LIBRARY_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "sozai_colour.h"

extern const char *const library_path;

const sozai_entry_v1 *library_load(void); /* dlopen and init */
void library_unload(void);

typedef struct services {
  const sozai_services_1 *factory;
  sozai_services *services;
  const sozai_images_1 *images;
} services;

/* Under the shipped config. image_memory: bytes, 0: the default. */
services services_open(uint64_t image_memory);
void services_close(services *s);

/* Group fixtures: loaded, the environment out of the way, an empty folder
 * temp_path() points into. */
int library_setup(void **state);
int library_teardown(void **state);
/* The same with services as the state. */
int services_setup(void **state);
int services_teardown(void **state);

/* A request for `channels` of a file, everything else at its default. */
sozai_image_request file_request(const char *path, uint32_t channels);
/* Opened, or a failed test. */
sozai_image *open_image(const services *s, const sozai_image_request *request);
sozai_image *open_file(const services *s, const char *path, uint32_t channels);
void close_image(const services *s, sozai_image *image);
/* One look-up, a square `footprint` wide; or a failed test. */
void look(const services *s, const sozai_image *image, float at_s, float at_t, float footprint,
          float out[4]);

#define assert_contains(text, part) assert_non_null(strstr(text, part))

#endif
