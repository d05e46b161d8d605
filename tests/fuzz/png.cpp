// SPDX-License-Identifier: Apache-2.0
// The frame of a PNG file.
#include "fuzz.h"

#include "png.hpp"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  const char *damage = sozai::images::png_damage(scratch_file("p.png", data, size));
  CHECK(!damage || *damage);
  return 0;
}
