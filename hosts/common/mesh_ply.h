/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_HOSTS_MESH_PLY_H
#define SOZAI_HOSTS_MESH_PLY_H

#include "failure.h"

/* Whether a PLY file can hold as many elements as its header says: Assimp
 * believes it, and would take minutes and all memory over a few bytes. True of
 * files that are no PLY, which Assimp is left to judge. */
bool mesh_ply_plausible(const char *path, failure *why);

#endif
