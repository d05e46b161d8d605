/* SPDX-License-Identifier: Apache-2.0
 *
 * What the C and the C++ half of the library know of each other.
 */
#ifndef SOZAI_COLOUR_INTERNAL_H
#define SOZAI_COLOUR_INTERNAL_H

#include "sozai_colour.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Where the shipped config lies, or NULL: not initialised. Valid until the
 * last deinit. [thread-safe] */
const char *sozai_colour_shipped_config(void);

/* Where sozai-images.so should lie, or NULL likewise. [thread-safe] */
const char *sozai_colour_images_library(void);

/* The path of a file beside this library, to be freed; NULL: out of memory.
 * plugin_path: where the library is said to lie, or NULL. */
char *sozai_colour_beside(const char *plugin_path, const char *file_name);

extern const sozai_services_1 sozai_colour_services;

#ifdef __cplusplus
}
#endif

#endif
