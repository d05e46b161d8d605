/* SPDX-License-Identifier: Apache-2.0
 * A photograph's file, checked, as pixels of the working space. */
#ifndef SOZAI_MATCH_PHOTO_PIXELS_H
#define SOZAI_MATCH_PHOTO_PIXELS_H

#include "photo.h"

/* Fills p's size, rgb, pixel, space and clipped; also on failure photo_free is
 * the caller's. */
bool photo_pixels(photo *p, const char *path, const photo_options *o, const colour *c,
                  failure *why);

#endif
