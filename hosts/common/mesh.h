/* SPDX-License-Identifier: Apache-2.0
 * Triangle meshes in memory. */
#ifndef SOZAI_HOSTS_MESH_H
#define SOZAI_HOSTS_MESH_H

#include <stdint.h>
#include "failure.h"

typedef struct mesh {
  uint32_t point_count, triangle_count;
  float *points;     /* x y z each */
  float *normals;    /* x y z each, unit, one to a point */
  uint32_t *indices; /* three to a triangle, counter-clockwise seen from outside */
  float *uvs;        /* u v each, v upwards, one to a point; NaN in a part of a file that has
                        none; as the file has them otherwise. NULL: there are none at all */
} mesh;

/* Room for so many; the counts are set. No UVs. */
bool mesh_allocate(mesh *m, uint32_t points, uint32_t triangles, failure *why);
void mesh_free(mesh *m);

/* Any format Assimp reads, all its parts in one. scale: mm per unit of the
 * file. A point that is no number, or beyond +-1e6 mm, is refused. Normals are made where the
 * file has none, smooth up to 45 degrees. */
bool mesh_read(mesh *m, const char *path, double scale, failure *why);

#endif
