/* SPDX-License-Identifier: Apache-2.0
 * A mesh's UV charts: which point of the mesh a texel shows.
 *
 * v runs upwards, a picture's rows downwards. Tile 1001 + i + 10 j (UDIM) is
 * the square of u from i to i + 1, v from j to j + 1; i is 0 to 9, and the last
 * tile 9999. */
#ifndef SOZAI_SURFACE_ATLAS_H
#define SOZAI_SURFACE_ATLAS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "failure.h"
#include "mesh.h"
#include "texels.h"

typedef struct atlas atlas; /* immutable once opened */

/* How many texels past a chart's border still show the chart. */
#define ATLAS_DILATION 16

/* path: any mesh that Assimp reads; scale: mm per unit of the file. Refused:
 * what mesh_read refuses, a mesh without UVs, and UVs that are in no tile.
 * Triangles whose own UVs are no use are left out and counted; see
 * atlas_counts. [thread-safe] */
bool atlas_open(atlas **out, const char *path, double scale, failure *why);
/* NULL is allowed. [exclusive] */
void atlas_close(atlas *a);

/* The tiles that any chart reaches into by more than 1e-5 of a tile, at least
 * one. [thread-safe] */
uint32_t atlas_udim_count(const atlas *a);
/* Of the k-th: 1001 + i + 10 j, ascending; 0: there is no k-th. [thread-safe] */
int atlas_udim(const atlas *a, uint32_t k);

/* As it was read, with UVs. [thread-safe] */
const mesh *atlas_mesh(const atlas *a);

typedef struct atlas_counts {
  uint32_t triangles;  /* of the mesh; the rest are counts of these */
  uint32_t without;    /* left out: UVs that are no numbers, as of a corner that has none */
  uint32_t afar;       /* left out: UVs past 1e6, where a float has no room for texels */
  uint32_t degenerate; /* left out: no area in UV space */
  uint32_t outside;    /* left out: no part of it lies in a tile */
  uint32_t hidden;     /* its middle lies under an earlier triangle, which is shown there */
  uint64_t bytes;      /* of memory that the atlas holds */
} atlas_counts;

/* [thread-safe] */
const atlas_counts *atlas_counts_of(const atlas *a);
/* One line about what was left out or is hidden; false: nothing was, and text
 * is empty. [thread-safe] */
bool atlas_warning(const atlas *a, char *text, size_t size);

/* The texels x to x+w, y to y+h (row 0 at the top) of a picture of width x
 * height texels over one tile; any size up to 2^20 a side, so the levels of a
 * mipmap are pictures of their own. A texel's values depend on the picture's
 * size and its own place in it, never on the rectangle.
 *   covered 1  the texel's centre lies in a triangle, of several the first:
 *              the triangle's point there, its interpolated normal, and as
 *              footprint the root of the area of mesh that the texel shows
 *   covered 2  within ATLAS_DILATION texels of a triangle: the same of the
 *              nearest. The point goes on in the triangle's plane for two
 *              texels, so that a bilinear look-up at a border is as good as
 *              elsewhere, and stays there beyond
 *   covered 0  farther: one place for all, with a footprint of 1e4 mm, at which
 *              a material gives its mean
 * false: no such tile, or a rectangle out of the picture; out is then
 * untouched. Allocates nothing. [thread-safe] */
bool atlas_texels(const atlas *a, int udim, uint32_t width, uint32_t height, uint32_t x, uint32_t y,
                  uint32_t w, uint32_t h, const surface_room *out);

#endif
