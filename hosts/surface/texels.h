/* SPDX-License-Identifier: Apache-2.0
 * Where the texels of a rectangle of a picture lie on a surface. */
#ifndef SOZAI_SURFACE_TEXELS_H
#define SOZAI_SURFACE_TEXELS_H

#include <stdint.h>

/* Arrays of w*h each, row by row from the top. */
typedef struct surface_room {
  float *point[3];  /* mm, object space */
  float *normal[3]; /* unit, outward */
  float *footprint; /* mm: side of the square that the texel stands for */
  float *across[3]; /* mm: from a texel's left side to its right one, on the surface, */
  float *down[3];   /* and from its upper side to its lower one; a mesh's may be NULL */
  uint8_t *covered; /* 1: on the surface, 2: dilated past a seam, 0: far from all of it */
} surface_room;

#endif
