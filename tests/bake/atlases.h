/* SPDX-License-Identifier: Apache-2.0
 * Atlases of meshes written for the purpose, and pictures of what they show. */
#ifndef SOZAI_TESTS_ATLASES_H
#define SOZAI_TESTS_ATLASES_H

#include <stdio.h>
#include "atlas.h"
#include "mesh.h"

#include <stdarg.h>
#include <setjmp.h>
#include <cmocka.h>

/* cmocka's fixtures: a folder for meshes, which is to be empty at the end. */
int atlas_folder(void **state);
int atlas_no_folder(void **state);

/* Of a name in it; till the next call. */
const char *path_of(const char *name);
FILE *begin_mesh(const char *name);
/* Opens what was written, and removes it. also: the mesh as read, or NULL. */
atlas *open_mesh(FILE *file, const char *name, mesh *also);

/* meshes.h has them. */
atlas *box_atlas(bool udim, mesh *also);
atlas *leg_atlas(mesh *also);
/* Of given triangles: nine numbers of points and six of UVs each. */
atlas *atlas_of(const float (*t)[15], unsigned count);

typedef struct texels {
  surface_room room;
  uint32_t w, h;
  float *memory;
} texels;

/* Filled with 0x7f; to be freed. */
texels texels_room(uint32_t w, uint32_t h);
/* A whole picture of a tile. */
texels texels_of(const atlas *a, int udim, uint32_t w, uint32_t h);
void texels_free(texels *t);

#endif
