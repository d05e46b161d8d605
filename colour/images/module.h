/* SPDX-License-Identifier: Apache-2.0
 *
 * What sozai-colour.so and sozai-images.so know of each other. They are built and
 * installed together, so this may change: SOZAI_IMAGES_MODULE must then change too.
 *
 * Two libraries, because OpenImageIO takes a quarter of a second to load, which a
 * palette should not wait for, and because one that is missing must not take the
 * colours with it.
 */
#ifndef SOZAI_IMAGES_MODULE_H
#define SOZAI_IMAGES_MODULE_H

#include "sozai_colour.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SOZAI_IMAGES_MODULE 1u
#define SOZAI_IMAGES_MODULE_SYMBOL "sozai_images_entry"

/* How a picture's numbers become the working space's. */
typedef struct sozai_image_conversion {
  int32_t colour;  /* 0: data, kept as they are */
  const void *how; /* NULL: they are in the working space. One for each space. */
} sozai_image_conversion;

/* What sozai-images.so asks of sozai-colour.so. Lives as long as the images. */
typedef struct sozai_image_colours {
  void *self;
  /* The conversion of a space, or, where it is NULL, of that which the config's
   * rules give a path. COLOUR, MEMORY. [thread-safe] */
  int32_t (*find)(void *self, const char *space, const char *path, sozai_image_conversion *out,
                  char *message, size_t message_size);
  /* count colours, r g b a each, in place; a may come out changed. how: not NULL.
   * [thread-safe] */
  int32_t (*apply)(const void *how, float *rgba, uint64_t count, char *message,
                   size_t message_size);
} sozai_image_colours;

/* The one symbol that sozai-images.so exports. The functions that are not named
 * here are those of sozai_images_1, whose `self` open() gives. */
typedef struct sozai_images_module {
  uint32_t version; /* SOZAI_IMAGES_MODULE */
  /* memory: bytes of pictures to hold at most, 0: 1 GiB. [thread-safe] */
  int32_t (*open)(const sozai_image_colours *colours, uint64_t memory, sozai_images_1 *out,
                  char *message, size_t message_size);
  /* Images must have been closed. [exclusive] */
  void (*close)(sozai_images_1 *images);
} sozai_images_module;

#ifdef __cplusplus
}
#endif

#endif
