/* SPDX-License-Identifier: Apache-2.0
 * The surface that a .sozai file shows, as a picture with a full chain of mip
 * levels: which point of the material each texel is.
 *
 *   plane   size[0] x size[1] mm about the origin at z = 0, facing +z; x runs
 *           along the rows, y up the columns
 *   board   the same on the upper face of a board, at z = half its thickness
 *   mesh    a tile of its UVs: atlas.h
 *   volume  a block of size[0] x size[1] x size[2] mm about the origin; x runs
 *           along the rows, y down the columns, z through the slices, so that
 *           a place in the volume is a place in object space and nothing is
 *           turned round; one level, and no normals
 *
 * A level is evaluated at its own texels' footprints, not shrunk from the one
 * above. */
#ifndef SOZAI_SURFACE_SURFACE_H
#define SOZAI_SURFACE_SURFACE_H

#include "periodic.h"
#include "recipe.h"
#include "texels.h"

#define SURFACE_PLANE 0
#define SURFACE_MESH 1
#define SURFACE_VOLUME 2

typedef struct surface surface; /* immutable once opened */

/* What an opened surface is, for whoever describes the picture. */
typedef struct surface_shape {
  int kind;           /* SURFACE_* */
  uint32_t levels;    /* 1 for a volume */
  uint32_t pixels[3]; /* of level 0; the third is 1 but for a volume */
  double size[3];     /* mm; 0 for a mesh */
  int udim;           /* of a mesh */
  uint32_t samples;   /* each texel is the mean of so many by so many parts */
  bool seamless;      /* a plane that fits itself: */
  periodic repeat;
} surface_shape;

/* From the recipe's surface and image, and its texture, which says whether a piece
 * of it can fit itself. Where the image's size is not said it is
 * the board's, else 1000 mm; where its resolution is not, 4096 texels on the
 * longer side. [thread-safe] */
bool surface_open(surface **out, const recipe *r, const sozai_textures_1 *textures,
                  const sozai_texture *texture, failure *why);
/* NULL is allowed. [exclusive] */
void surface_close(surface *s);

/* [thread-safe] */
const surface_shape *surface_shape_of(const surface *s);
/* Of a mesh its charts, all tiles of them; else NULL. [thread-safe] */
const struct atlas *surface_atlas(const surface *s);
/* Width, height and depth of a level: halved and rounded down, at least 1.
 * [thread-safe] */
void surface_level(const surface *s, uint32_t level, uint32_t pixels[3]);

/* The texels x to x+w, y to y+h of slice z of a level. false: they are not
 * within it, and out is untouched. The members of out may be NULL where not
 * wanted (a mesh wants all but across and down), and a volume has no normals. A texel's values
 * depend on its place alone, not on the rectangle. Allocates nothing.
 * [thread-safe] */
bool surface_texels(const surface *s, uint32_t level, uint32_t x, uint32_t y, uint32_t z,
                    uint32_t w, uint32_t h, const surface_room *out);

#endif
