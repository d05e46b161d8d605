/* SPDX-License-Identifier: Apache-2.0
 * The shapes that are made here, as meshes centred on the origin. */
#ifndef SOZAI_RENDER_SHAPES_H
#define SOZAI_RENDER_SHAPES_H

#include "mesh.h"

/* A box of that size whose edges are rounded with that radius. */
bool shape_board(mesh *m, const double size[3], double bevel, failure *why);
/* A rectangle at z = 0, facing +z. */
bool shape_plane(mesh *m, const double size[2], failure *why);

#endif
