/* SPDX-License-Identifier: Apache-2.0
 *
 * An image service as a renderer has one: its own texture system, which knows
 * nothing of sozai. And a way to write the pictures it reads.
 */
#ifndef SOZAI_TEST_HOST_IMAGES_H
#define SOZAI_TEST_HOST_IMAGES_H

#include "sozai_colour.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Over an OpenImageIO TextureSystem; files only, as they are, linear. */
const sozai_images_1 *host_images_open(void);
void host_images_close(void);
/* Look-ups so far. */
uint64_t host_images_lookups(void);

/* width x height of r g b, top row first. 0: done. The file's name says its format;
 * 8-bit formats are written as sRGB. */
int host_images_write(const char *path, int width, int height, const float *rgb);

#ifdef __cplusplus
}
#endif

#endif
