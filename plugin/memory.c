/* SPDX-License-Identifier: Apache-2.0
 *
 * The functions of sozai.memory/1: what would be taken, before it is.
 */
#include "core/status.h"
#include "generator.h"
#include "material.h"

const sozai_memory_1 memory_table = {texture_memory, geometry_memory, geometry_mesh_memory,
                                     geometry_curves_memory, fail_message};
