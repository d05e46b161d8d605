/* SPDX-License-Identifier: Apache-2.0 */
#include "batch.h"

#include <dlfcn.h>
#include <math.h>
#include <string.h>

#define POINTS 40 /* more than two of the widest blocks, and a rest */
#define INPUTS 16
#define COMPONENTS 64
#define UNTOUCHED 0x7fa5a5a5u

static const sozai_textures_1 *textures;

const sozai_textures_1 *batch_plugin(void) {
  if (textures) return textures;
  void *library = dlopen(SOZAI_TEST_PLUGIN, RTLD_NOW);
  if (!library) fprintf(stderr, "%s\n", dlerror());
  CHECK(library);
  const sozai_entry_v1 *entry = dlsym(library, SOZAI_ENTRY_SYMBOL);
  /* no services lie there: a config is not what is tried here */
  CHECK(entry && entry->init("/nonexistent/sozai.so") == SOZAI_OK);
  textures = entry->get_factory(SOZAI_TEXTURES_1);
  CHECK(textures);
  return textures;
}

typedef struct work {
  float in[INPUTS][POINTS], out[COMPONENTS][POINTS];
  float *list[COMPONENTS];
  uint8_t active[POINTS];
} work;

static float coordinate(bytes *b) {
  static const float special[] = {0, -0.0f, 1e6f, -1e30f, NAN, INFINITY, 1e-40f, 900};
  uint8_t way = take_u8(b);
  if (way >= 248) return special[way - 248];
  if (way >= 232) return take_float(b);
  return (float)(way - 116) * (way & 1 ? 0.07f : 11.0f);
}

static const float *input(work *w, bytes *b, int row, int given) {
  float start[4], *to = w->in[row];
  for (int i = 0; i < 4; i++) start[i] = coordinate(b);
  for (int i = 0; i < POINTS; i++) to[i] = start[i % 4] + (i > 3 ? 0.37f * (float)i : 0.0f);
  return given ? to : NULL;
}

static void fill(float *list) {
  const uint32_t bits = UNTOUCHED;
  for (int i = 0; i < POINTS; i++) memcpy(&list[i], &bits, sizeof bits);
}

static int untouched(float x) {
  uint32_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits == UNTOUCHED;
}

void batch_try(const sozai_texture *t, bytes *b) {
  static work w;
  const sozai_texture_info *info = textures->info_of(t);
  CHECK(info->component_count <= COMPONENTS);
  uint8_t given = take_u8(b), odd = take_u8(b);
  sozai_batch batch = {.size = sizeof batch, .count = take_u8(b) % (POINTS + 1u), .out = w.list};
  for (int c = 0; c < 3; c++) {
    batch.point[c] = input(&w, b, c, 1);
    batch.normal[c] = input(&w, b, 3 + c, given & 1);
    batch.light[c] = input(&w, b, 6 + c, given & 2);
    batch.light_colour[c] = input(&w, b, 9 + c, given & 4);
    batch.view[c] = input(&w, b, 12 + c, given & 8);
  }
  batch.footprint = input(&w, b, 15, given & 16);
  if (odd == 1) batch.view[1] = NULL;
  if (odd == 2) batch.point[2] = NULL;
  if (odd == 3) batch.size = take_u8(b);
  if (odd == 3 && batch.size > sizeof batch) batch.size = 8;
  uint64_t mask = odd == 4 ? take_u32(b) * 0x100000001u : ~0ull;
  batch.out_count = odd == 5 ? take_u8(b) % COMPONENTS : info->component_count;
  for (uint32_t o = 0; o < COMPONENTS; o++) {
    fill(w.out[o]);
    w.list[o] = mask >> o & 1 ? w.out[o] : NULL;
  }
  if (given & 32) {
    for (int i = 0; i < POINTS; i++) w.active[i] = (uint8_t)(i * 7 % 3);
    batch.active = w.active;
  }
  int32_t r = textures->evaluate(t, &batch);
  CHECK(r == SOZAI_OK || (r == SOZAI_ERROR_ARGUMENT && *textures->last_error()));
  int whole = batch.size == sizeof batch;
  for (uint32_t o = 0; o < COMPONENTS; o++)
    for (uint32_t i = 0; i < POINTS; i++) {
      int asked = r == SOZAI_OK && whole && o < info->component_count && o < batch.out_count &&
                  w.list[o] && i < batch.count && (!batch.active || batch.active[i]);
      float x = w.out[o][i];
      if (asked)
        CHECK(isfinite(x));
      else if (whole || r != SOZAI_OK)
        CHECK(untouched(x));
    }
}
