/* SPDX-License-Identifier: Apache-2.0
 * Pictures in files, through OpenImageIO. */
#ifndef SOZAI_HOSTS_IMAGE_H
#define SOZAI_HOSTS_IMAGE_H

#include <stddef.h>
#include <stdint.h>
#include "failure.h"

#ifdef __cplusplus
extern "C" {
#endif

#define IMAGE_UINT8 0
#define IMAGE_UINT16 1
#define IMAGE_HALF 2
#define IMAGE_FLOAT 3

/* One channel to write: pixel i is data[i * stride], row by row from the top. */
typedef struct image_channel {
  const char *name; /* "R", "albedo.R", "dive" */
  const float *data;
  size_t stride;
  int type; /* IMAGE_*; channels may differ only in an EXR */
} image_channel;

/* What a file says of its colours. */
typedef struct image_colour {
  const char *space;           /* EXR: the attribute colorSpace; NULL: not said */
  const float *chromaticities; /* EXR: 8, x y of red, green, blue, white; NULL: not said */
  bool srgb;                   /* PNG: the chunk sRGB, and gAMA and cHRM that go with it */
} image_colour;

/* The format is that of the path's ending. Integer types take 0 to 1. colour
 * may be NULL. */
bool image_write(const char *path, uint32_t width, uint32_t height, const image_channel *channels,
                 size_t count, const image_colour *colour, failure *why);

/* A picture read: float whatever the file holds. */
typedef struct image {
  uint32_t width, height, channels;
  char **names; /* of the channels */
  float *data;  /* (y * width + x) * channels + channel */
} image;

bool image_read(image *picture, const char *path, failure *why);
/* Its size alone, and whether its numbers are integers; no pixel is read. */
bool image_probe(const char *path, uint32_t *width, uint32_t *height, uint32_t *channels,
                 bool *integers, failure *why);
void image_free(image *picture);

/* Whether there is a font to write in. */
bool image_has_text(void);
/* Dark letters of `size` pixels onto a picture of three floats a pixel, their
 * base line beginning at x, y. What reaches past x = end is cut off: from a comma on, or from a
 * word on with dots in its place. Nothing without a font. */
void image_text(float *rgb, uint32_t width, uint32_t height, uint32_t x, uint32_t y, uint32_t end,
                uint32_t size, const char *text);

#ifdef __cplusplus
}
#endif

#endif
