/* SPDX-License-Identifier: Apache-2.0
 * Tree and fiber with any preset and values, as far as memory and the host's patience go. */
#include <string.h>

#include "bounded.h"
#include "fiber/generator.h"
#include "grown.h"
#include "tree/generator.h"
#include "values.h"

/* Few and young, unless the input's values say otherwise: most presets are full-grown. */
static uint32_t small(sozai_value *list, int tree, const sozai_buffer *box) {
  static const sozai_value of_tree[] = {
      {.id = "age", .kind = SOZAI_KIND_FLOAT, .number = {4}},
      {.id = "leaves_most", .kind = SOZAI_KIND_INT, .number = {1000}}};
  const sozai_value of_fiber[] = {{.id = "hull", .kind = SOZAI_KIND_BUFFER, .buffer = box},
                                  {.id = "count", .kind = SOZAI_KIND_INT, .number = {4}},
                                  {.id = "iterations", .kind = SOZAI_KIND_INT, .number = {8}},
                                  {.id = "cells", .kind = SOZAI_KIND_INT, .number = {16}},
                                  {.id = "attempts", .kind = SOZAI_KIND_INT, .number = {100}}};
  uint32_t count = tree ? 2 : 5;
  memcpy(list, tree ? of_tree : of_fiber, count * sizeof *list);
  return count;
}

/* Whose numbers decide how long it takes; they are the limits' tests' to try. */
static int is_patience(const char *id) {
  static const char *const ids[] = {"count",  "vertices", "iterations", "attempts",
                                    "rounds", "cells",    "packing",    "halvings",
                                    "age",    "spacing",  "turns_year", "contact"};
  for (size_t i = 0; id && i < sizeof ids / sizeof *ids; i++)
    if (strcmp(ids[i], id) == 0) return 1;
  return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const float points[24] = {-9, -9, -9, 9, -9, -9, -9, 9, -9, 9, 9, -9,
                                   -9, -9, 9,  9, -9, 9,  -9, 9, 9,  9, 9, 9};
  static const uint32_t indices[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                       2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  const sozai_buffer box = {.size = sizeof box,
                            .kind = SOZAI_BUFFER_MESH,
                            .dims = {8, 12},
                            .points = points,
                            .indices = indices};
  bytes b = {data, size};
  uint8_t what = take_u8(&b);
  const generator *kind = what & 1 ? &tree_generator : &fiber_generator;
  const sozai_generator_info *info = kind->describe();
  uint32_t preset = take_below(&b, info->preset_count + 1);
  sozai_value list[VALUES_MOST + 8];
  uint32_t count = small(list, what & 1, &box);
  values v;
  values_take(&v, &b, info->parameters, info->parameter_count);
  for (uint32_t i = 0; i < v.count; i++)
    if (!is_patience(v.list[i].id)) list[count++] = v.list[i];
  bounded_begin(&(bounded_limits){.bytes = 48 << 20, .calls = 100});
  grown_try(kind, preset ? info->presets[preset - 1]->id : NULL, list, count);
  bounded_end();
  values_free(&v);
  return 0;
}
