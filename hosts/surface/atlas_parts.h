/* SPDX-License-Identifier: Apache-2.0
 * What an atlas is made of; for its own files. */
#ifndef SOZAI_SURFACE_ATLAS_PARTS_H
#define SOZAI_SURFACE_ATLAS_PARTS_H

#include "atlas.h"
#include "atlas_tree.h"
#include "mesh.h"

#define ATLAS_ACROSS 10 /* tiles */
#define ATLAS_UP 900
#define ATLAS_LAST 9999

struct atlas {
  mesh mesh;
  atlas_tree tree;            /* over the triangles that are kept */
  uint16_t reached[ATLAS_UP]; /* bit i of [j]: a chart reaches into tile 1001 + i + 10 j */
  int *udims;
  uint32_t udim_count;
  float middle[3]; /* of the mesh's box: what is shown far from all charts */
  atlas_counts counts;
};

#endif
