/* SPDX-License-Identifier: Apache-2.0
 * What a bake is of: a surface, and of a mesh the tiles. */
#ifndef SOZAI_BAKE_GROUND_H
#define SOZAI_BAKE_GROUND_H

#include "atlas.h"
#include "surface.h"

typedef struct bake_ground {
  surface *surface;
  const atlas *atlas; /* of a mesh, else NULL */
  int *tiles;         /* of a mesh: the UDIM of each picture */
  uint32_t count;     /* of pictures */
} bake_ground;

/* Of r's texture. tiles: "1001,1002", or NULL for the recipe's own, else all there are. */
bool bake_ground_open(bake_ground *g, const recipe *r, const sozai_textures_1 *textures,
                      const sozai_texture *texture, const char *tiles, failure *why);
void bake_ground_close(bake_ground *g);

#endif
