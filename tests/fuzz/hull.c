/* SPDX-License-Identifier: Apache-2.0
 * Any mesh or cloud of points as a hull, and fibre grown in it. Parameters that would make it
 * long stay small. */
#include "bounded.h"
#include "fiber/generator.h"
#include "grown.h"
#include "values.h"

static float corner(bytes *b) {
  int way = take_u8(b);
  if (way == 255) return take_float(b);
  return (float)(way % 21) - 10.0f;
}

/* As far as its bytes go; the last corners are those of a box, so that there is an inside. */
static uint32_t take_points(bytes *b, float *points, uint32_t most) {
  uint32_t count = take_u8(b) % (most + 1);
  for (uint32_t i = 0; i < count; i++)
    for (uint32_t c = 0; c < 3; c++)
      points[3 * i + c] = b->left ? corner(b) : (i >> c & 1 ? 10.0f : -10.0f);
  return count;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  enum { POINTS = 60, TRIANGLES = 120 };
  static const char *const modes[] = {"field", "exact", "literal"};
  static const char *const contacts[] = {"off", "rigid", "bend"};
  bytes b = {data, size};
  float points[3 * POINTS], normals[3 * POINTS];
  uint32_t indices[3 * TRIANGLES];
  uint8_t way = take_u8(&b), more = take_u8(&b);
  sozai_buffer hull = {.size = sizeof hull,
                       .kind = way & 64 ? SOZAI_BUFFER_POINTS : SOZAI_BUFFER_MESH};
  uint32_t triangles = take_u8(&b) % (TRIANGLES + 1), count = take_points(&b, points, POINTS);
  hull.dims[0] = count;
  hull.points = points;
  if (way & 32) {
    take_points(&b, normals, POINTS);
    for (uint32_t i = 0; i < 3 * count; i++) normals[i] = i % 3 == 1 ? 1.0f : 0.1f;
    hull.normals = normals;
  }
  if (hull.kind == SOZAI_BUFFER_MESH) {
    hull.dims[1] = triangles;
    hull.indices = indices;
    for (uint32_t i = 0; i < 3 * triangles; i++)
      indices[i] =
          b.left ? take_u8(&b) % (count + (way == 31 || count == 0)) : i % (count + (count == 0));
  }
  const sozai_value list[] = {
      {.id = way & 64 ? "hull_points" : "hull", .kind = SOZAI_KIND_BUFFER, .buffer = &hull},
      {.id = "mode", .kind = SOZAI_KIND_CHOICE, .text = modes[way % 3u]},
      {.id = "contact", .kind = SOZAI_KIND_CHOICE, .text = contacts[way / 3u % 3u]},
      {.id = "count", .kind = SOZAI_KIND_INT, .number = {1 + more % 6}},
      {.id = "vertices", .kind = SOZAI_KIND_INT, .number = {2 + more / 6 % 8}},
      {.id = "length", .kind = SOZAI_KIND_FLOAT, .number = {more & 128 ? 3 : 50}},
      {.id = "iterations", .kind = SOZAI_KIND_INT, .number = {8}},
      {.id = "attempts", .kind = SOZAI_KIND_INT, .number = {50}},
      {.id = "rounds", .kind = SOZAI_KIND_INT, .number = {3}},
      {.id = "spacing", .kind = SOZAI_KIND_FLOAT, .number = {2}},
      {.id = "cells", .kind = SOZAI_KIND_INT, .number = {more & 64 ? 16 : 8}}};
  if (count == 0) hull.indices = NULL;
  bounded_begin(&(bounded_limits){.bytes = 32 << 20, .calls = 100});
  grown_try(&fiber_generator, NULL, list, sizeof list / sizeof *list);
  bounded_end();
  return 0;
}
