/* SPDX-License-Identifier: Apache-2.0 */
#include "tables.h"

#include <dlfcn.h>
#include <stdlib.h>

const sozai_entry_v1 *entry;
const sozai_textures_1 *textures;
const sozai_geometry_1 *geometry;
const sozai_limits_1 *limits;
const sozai_memory_1 *memory;
static void *library;

int tables_open(void **unused) {
  (void)unused;
  library = dlopen(SOZAI_TEST_PLUGIN, RTLD_NOW | RTLD_LOCAL);
  entry = library ? dlsym(library, SOZAI_ENTRY_SYMBOL) : NULL;
  if (!entry || entry->init(SOZAI_TEST_PLUGIN) != SOZAI_OK) return 1;
  textures = entry->get_factory(SOZAI_TEXTURES_1);
  geometry = entry->get_factory(SOZAI_GEOMETRY_1);
  limits = entry->get_factory(SOZAI_LIMITS_1);
  memory = entry->get_factory(SOZAI_MEMORY_1);
  return !textures || !geometry || !limits || !memory;
}

int tables_close(void **unused) {
  (void)unused;
  entry->deinit();
  dlclose(library);
  return 0;
}

static void *take(void *user, size_t size, size_t align) {
  count *c = user;
  void *p = aligned_alloc(align, (size + align - 1) / align * align + align);
  if (!p) return NULL;
  c->live += size;
  if (c->live > c->peak) c->peak = c->live;
  return p;
}

static void give_back(void *user, void *block, size_t size, size_t align) {
  count *c = user;
  (void)align;
  c->live -= size;
  free(block);
}

sozai_host counting_host(count *c) {
  *c = (count){0, 0};
  return (sozai_host){.size = sizeof(sozai_host), .user = c, .alloc = take, .free = give_back};
}

sozai_buffer box_hull(void) {
  static const float corners[8][3] = {{0, 0, 0},  {20, 0, 0},  {20, 15, 0},  {0, 15, 0},
                                      {0, 0, 10}, {20, 0, 10}, {20, 15, 10}, {0, 15, 10}};
  static const uint32_t faces[36] = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                     1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
  return (sozai_buffer){.size = sizeof(sozai_buffer),
                        .kind = SOZAI_BUFFER_MESH,
                        .dims = {8, 12},
                        .points = &corners[0][0],
                        .indices = faces};
}

sozai_buffer section_picture(void) {
  enum { SIDE = 96 };
  static float pixels[SIDE][SIDE][3];
  uint64_t s = 1;
  for (int y = 0; y < SIDE; y++) {
    for (int x = 0; x < SIDE; x++) {
      double dx = x - 0.5 * SIDE, dy = y - 0.5 * SIDE, d = dx * dx + dy * dy;
      double ring = (double)((int)(d / 40) % 2) * 0.2 + (double)(next_random(&s) % 100) * 1e-4;
      double v = d < 0.2 * SIDE * SIDE ? 0.3 + ring : 1.0;
      for (int c = 0; c < 3; c++) pixels[y][x][c] = (float)(v * (c == 2 ? 0.7 : 1.0));
    }
  }
  return (sozai_buffer){.size = sizeof(sozai_buffer),
                        .kind = SOZAI_BUFFER_IMAGE,
                        .dims = {SIDE, SIDE, 3},
                        .data = &pixels[0][0][0]};
}

uint64_t next_random(uint64_t *state) {
  uint64_t z = *state += 0x9e3779b97f4a7c15ull;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ z >> 27) * 0x94d049bb133111ebull;
  return z ^ z >> 31;
}
