/* SPDX-License-Identifier: Apache-2.0
 * A mesh's file through Assimp: the first byte says which kind, the rest is the file. What ends it
 * within Assimp is not ours to mend, so that this one is run by its name alone: see
 * docs/fuzzing.md. */
#include <string.h>

#include "mesh_check.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const char *const names[] = {"m.obj", "m.ply", "m.stl", "m.off"};
  if (size < 1 || size > 8192) return -1;
  const char *path = scratch_file(names[data[0] & 3], data + 1, size - 1);
  mesh m;
  failure why = {0, ""};
  if (!mesh_read(&m, path, 1, &why)) {
    CHECK(*why.text && !strchr(why.text, '\n'));
    return 0;
  }
  mesh_check(&m);
  mesh_free(&m);
  return 0;
}
