/* SPDX-License-Identifier: Apache-2.0
 * A .sozai file as a picture: everything of the reader but the C++ of
 * OpenImageIO. */
#ifndef SOZAI_OIIO_PICTURE_H
#define SOZAI_OIIO_PICTURE_H

#include <stddef.h>
#include "output.h"
#include "surface.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PICTURE_TILE 64u        /* texels a side */
#define PICTURE_VOLUME_TILE 16u /* of a volume, all three ways */

typedef struct picture picture; /* immutable once opened */

/* What is told about it. Strings live as long as the picture. */
typedef struct picture_about {
  surface_shape shape;
  uint32_t tile[3];
  uint32_t subimage_count;
  const subimage *subimages;
  const char *material, *preset; /* the preset "" for none */
  const char *working;           /* the working space's name, or "" */
  const char *wrap;              /* as in OpenImageIO's wrapmodes: "clamp" */
} picture_about;

/* name: "PATH.sozai" or "PATH.sozai?key=value&...". Opening the same material
 * again shares its texture, likewise a mesh. [thread-safe] */
bool picture_open(picture **out, const char *name, failure *why);
/* NULL is allowed. [exclusive] */
void picture_close(picture *p);
/* [thread-safe] */
const picture_about *picture_about_of(const picture *p);
void picture_level(const picture *p, uint32_t level, uint32_t pixels[3]);

/* From begin to end, texels; what lies past the picture is filled with 0. */
typedef struct picture_box {
  uint32_t begin[3], end[3];
} picture_box;

#define PICTURE_FLOAT 0
#define PICTURE_HALF 1
#define PICTURE_NATIVE 2 /* each output's own, without gaps */

/* Components first to first + count of a texel side by side; strides in bytes
 * from texel to texel, row to row, slice to slice. */
typedef struct picture_place {
  void *data;
  int format; /* PICTURE_* */
  uint32_t first, count;
  ptrdiff_t stride[3];
} picture_place;

/* Evaluate a box of one subimage, the channels that those components are of
 * and no others, all in one go, on up to `threads` threads. Holds no lock, and
 * on one thread allocates nothing. [thread-safe] */
bool picture_read(const picture *p, uint32_t subimage, uint32_t level, const picture_box *box,
                  const picture_place *to, uint32_t threads, failure *why);

#ifdef __cplusplus
}
#endif

#endif
