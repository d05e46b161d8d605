/* SPDX-License-Identifier: Apache-2.0
 * The functions of image.h, handed on to sozai-pictures.so. */
#include "image.h"

#include <stdlib.h>
#include <string.h>

#include "../pictures/module.h"
#include "pictures.h"

bool image_write(const char *path, uint32_t width, uint32_t height, const image_channel *channels,
                 size_t count, const image_colour *colour, failure *why) {
  const pictures *p = pictures_load(why);
  return p && p->image_write(path, width, height, channels, count, colour, why);
}

bool image_read(image *picture, const char *path, failure *why) {
  memset(picture, 0, sizeof *picture);
  const pictures *p = pictures_load(why);
  return p && p->image_read(picture, path, why);
}

bool image_probe(const char *path, uint32_t *width, uint32_t *height, uint32_t *channels,
                 bool *integers, failure *why) {
  const pictures *p = pictures_load(why);
  return p && p->image_probe(path, width, height, channels, integers, why);
}

/* Whoever asks writes pictures too, and is told there why it cannot. */
bool image_has_text(void) {
  failure unused;
  const pictures *p = pictures_load(&unused);
  return p && p->image_has_text();
}

void image_text(float *rgb, uint32_t width, uint32_t height, uint32_t x, uint32_t y, uint32_t end,
                uint32_t size, const char *text) {
  failure unused;
  const pictures *p = pictures_load(&unused);
  if (p) p->image_text(rgb, width, height, x, y, end, size, text);
}

void image_free(image *picture) {
  for (uint32_t c = 0; c < picture->channels; c++) free(picture->names[c]);
  free(picture->names);
  free(picture->data);
  memset(picture, 0, sizeof *picture);
}
