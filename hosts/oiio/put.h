/* SPDX-License-Identifier: Apache-2.0
 * Numbers as they are evaluated, one array for each component, into a picture's
 * texels, where a texel's lie side by side. */
#ifndef SOZAI_OIIO_PUT_H
#define SOZAI_OIIO_PUT_H

#include <stddef.h>
#include <stdint.h>
#include <stdbool.h>

typedef struct put_layer {
  uint32_t component; /* of the batch */
  uint32_t offset;    /* bytes from the texel's first */
  bool half;          /* else float */
  bool encoded;       /* 0.5 + 0.5 of the value */
} put_layer;

/* A rectangle of texels in memory, strides in bytes. */
typedef struct put_place {
  char *first;
  ptrdiff_t texel, row;
  uint32_t w, h;
} put_place;

/* planes[k]: w * h numbers of layer k, at most SURFACE_BLOCK, row by row; they
 * may be changed. */
void put_layers(const put_layer *layers, uint32_t count, float *const *planes, const put_place *to);
/* Zeros in `bytes` of each texel. */
void put_zeros(const put_place *to, size_t bytes);

#endif
