/* SPDX-License-Identifier: Apache-2.0
 * A field table, and the tree that is grown from it: the first byte says how far. */
#include "fuzz.h"

#include <string.h>
#include "bounded.h"
#include "core/status.h"
#include "grown.h"
#include "tree/generator.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const char *const resample[] = {"measured", "sibling"};
  if (size < 1 || size > 20000) return -1;
  char *text = malloc(size);
  CHECK(text);
  memcpy(text, data + 1, size - 1);
  text[size - 1] = '\0';
  const sozai_value values[] = {
      {.id = "field", .kind = SOZAI_KIND_TEXT, .text = text},
      {.id = "resample", .kind = SOZAI_KIND_CHOICE, .text = resample[data[0] & 1]},
      {.id = "orders", .kind = SOZAI_KIND_INT, .number = {data[0] >> 1 & 3}},
      {.id = "age", .kind = SOZAI_KIND_FLOAT, .number = {1 + (data[0] >> 3)}}};
  bounded_begin(&(bounded_limits){.bytes = 64 << 20, .calls = 200});
  grown_try(&tree_generator, NULL, values, 4);
  bounded_end();
  free(text);
  return 0;
}
