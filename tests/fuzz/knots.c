/* SPDX-License-Identifier: Apache-2.0
 * The tables of knots that a host may hand wood, and the trees that it grows itself: all that
 * create() makes of them, without the kernel. */
#include <math.h>
#include <string.h>

#include "bounded.h"
#include "core/images.h"
#include "core/status.h"
#include "values.h"
#include "wood/build.h"
#include "wood/parameters.h"
#include "wood/species.h"

/* Nobody's plugin: generators ask for it by name. */
int textures_ready(void) { return 1; }

static void build(const settings *s) {
  static wood_constants w; /* too large for a stack under the sanitizers */
  static const float colours[WOOD_PARAMETERS][3];
  const image_set none = {0};
  memset(&w, 0, sizeof w);
  if (wood_build(&w, &bounded_host, s, colours, &none))
    CHECK(*fail_message() && !strchr(fail_message(), '\n'));
  else
    CHECK(!w.knots || w.knots->bytes > 0);
  wood_release_knots(&w, &bounded_host);
}

/* A table that is sound at first; further bytes then spoil some of its numbers. */
static sozai_buffer table(bytes *b, float *room, uint32_t columns, uint32_t rows,
                          const float *first, const float *step) {
  for (uint32_t i = 0; i < rows * columns; i++)
    room[i] = first[i % columns] + step[i % columns] * (float)(i / columns);
  for (uint32_t k = take_u8(b) % 8u; k > 0 && rows; k--) {
    float *at = &room[take_below(b, rows * columns)];
    uint8_t way = take_u8(b);
    *at = way > 240 ? take_float(b) : way > 200 ? *at * 1000 : (float)(way % 100) - 20;
  }
  return (sozai_buffer){.size = sizeof(sozai_buffer),
                        .kind = SOZAI_BUFFER_TABLE,
                        .dims = {rows, columns},
                        .data = room};
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const float knot[] = {1, 1, 12, 20, 0.3f, 0.5f, 200, 6, 0, 3};
  static const float knot_step[] = {1, 1, 1, 1, 0.7f, 0, 90, 1, 3, 0};
  static const float radius[] = {0, 1, 1}, radius_step[] = {0.34f, 2, 1};
  static const float ring[] = {0, 0, 5}, ring_step[] = {0, 500, 6};
  static const char *const trees[] = {"", "", "", "sugi", "keyaki"};
  float rooms[3][1600];
  bytes b = {data, size};
  uint8_t what = take_u8(&b), heights = 2 + take_u8(&b) % 4u;
  uint32_t knots = take_u8(&b) % 40u;
  sozai_buffer t[3] = {table(&b, rooms[0], 10, knots, knot, knot_step),
                       table(&b, rooms[1], 3, 3 * knots, radius, radius_step),
                       table(&b, rooms[2], 3, 3u * heights, ring, ring_step)};
  for (uint32_t i = 0; i < 3u * knots; i++)
    if (what & 8) rooms[1][3 * i] = (float)(i / 3);
  for (uint32_t i = 0; i < 3u * heights; i++) {
    if (what & 16) rooms[2][3 * i] = (float)(i / heights * 10);
    if (what & 16) rooms[2][3 * i + 1] = (float)(i % heights * 500);
  }
  static const char *const ids[] = {"knots", "knot_radii", "stem_rings"};
  sozai_value list[VALUES_MOST + 6];
  uint32_t count = 0;
  for (int i = 0; i < 3; i++)
    if (what >> i & 1)
      list[count++] = (sozai_value){.id = ids[i], .kind = SOZAI_KIND_BUFFER, .buffer = &t[i]};
  if (!(what & 7))
    list[count++] =
        (sozai_value){.id = "tree", .kind = SOZAI_KIND_TEXT, .text = trees[take_below(&b, 5)]};
  list[count++] =
      (sozai_value){.id = "tree_age", .kind = SOZAI_KIND_FLOAT, .number = {1 + take_u8(&b) % 12}};
  values v;
  values_take(&v, &b, wood_parameters, WOOD_PARAMETERS);
  for (uint32_t i = 0; i < v.count; i++)
    if (v.list[i].id && strcmp(v.list[i].id, "tree_age") != 0) list[count++] = v.list[i];
  const sozai_texture_info info = {.size = sizeof info,
                                   .id = "wood",
                                   .parameters = wood_parameters,
                                   .presets = wood_species,
                                   .parameter_count = WOOD_PARAMETERS,
                                   .preset_count = wood_species_count};
  settings s;
  wood_build_prepare();
  bounded_begin(&(bounded_limits){.bytes = 64 << 20, .calls = 50});
  if (settings_make(&s, &bounded_host, &info, NULL, list, count) == SOZAI_OK) {
    build(&s);
    settings_free(&s, &bounded_host);
  }
  bounded_end();
  values_free(&v);
  return 0;
}
