/* SPDX-License-Identifier: Apache-2.0
 * What sozai-pictures.so exports, for hosts/common/pictures.c, which loads it.
 * No contract: the two are of one build. */
#ifndef SOZAI_PICTURES_MODULE_H
#define SOZAI_PICTURES_MODULE_H

#include "image.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PICTURES_SYMBOL "sozai_pictures"

struct bake_writer; /* hosts/bake/writer.h */
struct writer_spec;

/* The functions of image.h and writer.h, under their names there. */
typedef struct pictures {
  const char *version; /* of the build; first, so that another build's can be told */
  bool (*image_write)(const char *path, uint32_t width, uint32_t height,
                      const image_channel *channels, size_t count, const image_colour *colour,
                      failure *why);
  bool (*image_read)(image *picture, const char *path, failure *why);
  bool (*image_probe)(const char *path, uint32_t *width, uint32_t *height, uint32_t *channels,
                      bool *integers, failure *why);
  bool (*image_has_text)(void);
  void (*image_text)(float *rgb, uint32_t width, uint32_t height, uint32_t x, uint32_t y,
                     uint32_t end, uint32_t size, const char *text);
  struct bake_writer *(*writer_open)(const char *path, const struct writer_spec *spec,
                                     failure *why);
  bool (*writer_next_level)(struct bake_writer *w, uint32_t width, uint32_t height, failure *why);
  bool (*writer_rows)(struct bake_writer *w, uint32_t row, uint32_t rows, const uint8_t *pixels,
                      failure *why);
  bool (*writer_close)(struct bake_writer *w, failure *why);
  void (*writer_drop)(struct bake_writer *w);
} pictures;

#ifdef __cplusplus
}
#endif

#endif
