/* SPDX-License-Identifier: Apache-2.0
 * A picture written band by band, level by level, through OpenImageIO, so that
 * no more than a band of it is ever in memory. */
#ifndef SOZAI_BAKE_WRITER_H
#define SOZAI_BAKE_WRITER_H

#include <stdint.h>
#include "failure.h"
#include "image.h"
#include "outputs.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A word of the picture's metadata. */
typedef struct bake_word {
  const char *name, *text;
} bake_word;

typedef struct writer_spec {
  uint32_t width, height, level_count;
  uint32_t tile; /* side; 0: scanlines */
  const bake_file *file;
  image_colour colour;
  float mm_per_pixel[2]; /* 0: of a mesh, which has none in common */
  const bake_word *words;
  uint32_t word_count;
} writer_spec;

typedef struct bake_writer bake_writer;

/* path's ending is the format's. NULL: why. */
bake_writer *writer_open(const char *path, const writer_spec *spec, failure *why);
/* Go on to the next level, width x height. */
bool writer_next_level(bake_writer *w, uint32_t width, uint32_t height, failure *why);
/* Rows of the level, from row on; where there are tiles, whole rows of them. */
bool writer_rows(bake_writer *w, uint32_t row, uint32_t rows, const uint8_t *pixels, failure *why);
/* Ends it, and reads back its end: not every format's writer says when a disk
 * was full. */
bool writer_close(bake_writer *w, failure *why);
/* Ends it without looking. NULL is allowed. */
void writer_drop(bake_writer *w);

#ifdef __cplusplus
}
#endif

#endif
