/* SPDX-License-Identifier: Apache-2.0
 *
 * The functions of sozai.memory/1: what would be taken, before it is.
 */
#include "core/status.h"
#include "generator.h"
#include "material.h"

int32_t memory_clear(sozai_memory *out, const char *call) {
  if (!out) return fail(SOZAI_ERROR_ARGUMENT, "memory: %s: out is NULL", call);
  if (out->size < sizeof *out) {
    return fail(SOZAI_ERROR_ARGUMENT, "memory: %s: out.size is %u: set it to sizeof(sozai_memory)",
                call, out->size);
  }
  *out = (sozai_memory){.size = out->size};
  return SOZAI_OK;
}

const sozai_memory_1 memory_table = {texture_memory, geometry_memory, geometry_mesh_memory,
                                     geometry_curves_memory, fail_message};
