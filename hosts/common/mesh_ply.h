/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_HOSTS_MESH_PLY_H
#define SOZAI_HOSTS_MESH_PLY_H

#include "failure.h"

/* Whether a PLY file holds as many elements as its header says, and its faces no
 * corner that is none of its points: Assimp believes both, and would take minutes
 * and all memory over a few bytes, or read where nothing is. True of files that
 * are no PLY, which Assimp is left to judge. */
bool mesh_ply_plausible(const char *path, failure *why);

#endif
