/* SPDX-License-Identifier: Apache-2.0
 * The look at a PLY's header that keeps Assimp from taking all memory over a few bytes. */
#include "fuzz.h"

#include <string.h>
#include "mesh_ply.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  failure why = {0, ""};
  if (!mesh_ply_plausible(scratch_file("m.ply", data, size), &why))
    CHECK(why.exit_code == EXIT_BAD_INPUT && *why.text);
  return 0;
}
