/* SPDX-License-Identifier: Apache-2.0 */
#include "textured.h"

#include <dlfcn.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fiber.h"

const sozai_textures_1 *textures_of(void) {
  geometry(); /* makes the plugin ready */
  void *library = dlopen(SOZAI_TEST_PLUGIN, RTLD_NOW | RTLD_LOCAL);
  const sozai_entry_v1 *entry = library ? dlsym(library, SOZAI_ENTRY_SYMBOL) : NULL;
  assert_non_null(entry);
  return entry->get_factory(SOZAI_TEXTURES_1);
}

static float *room_for(uint32_t count) {
  float *p = calloc(count, sizeof *p);
  assert_non_null(p);
  return p;
}

ground ground_of(uint32_t count, int lit) {
  ground g = {.count = count, .lit = lit};
  for (int c = 0; c < 2; c++) g.at[c] = room_for(count);
  for (int c = 0; c < 3; c++) {
    g.view[c] = room_for(count);
    g.light[c] = room_for(count);
  }
  for (int k = 0; k < COMPONENTS; k++) {
    if (lit || k < RADIANCE || k >= RADIANCE + 3) g.out[k] = room_for(count);
  }
  return g;
}

void ground_free(ground *g) {
  for (int c = 0; c < 2; c++) free(g->at[c]);
  for (int c = 0; c < 3; c++) {
    free(g->view[c]);
    free(g->light[c]);
  }
  for (int k = 0; k < COMPONENTS; k++) free(g->out[k]);
  memset(g, 0, sizeof *g);
}

void ground_ask(ground *g, const sozai_textures_1 *textures, const sozai_texture *t,
                double footprint) {
  float *none = room_for(g->count), *up = room_for(g->count), *size = room_for(g->count);
  for (uint32_t i = 0; i < g->count; i++) {
    up[i] = 1;
    size[i] = (float)footprint;
  }
  sozai_batch b = {.size = sizeof b,
                   .count = g->count,
                   .point = {g->at[0], g->at[1], none},
                   .normal = {none, none, up},
                   .footprint = size,
                   .out = g->out,
                   .out_count = COMPONENTS};
  for (int c = 0; g->lit && c < 3; c++) {
    b.view[c] = g->view[c];
    b.light[c] = g->light[c];
  }
  assert_int_equal(textures->evaluate(t, &b), SOZAI_OK);
  free(none);
  free(up);
  free(size);
}

double ground_mean(const ground *g, int component) {
  double sum = 0;
  for (uint32_t i = 0; i < g->count; i++) sum += (double)g->out[component][i] / g->count;
  return sum;
}

double random_of(uint32_t *state) {
  *state = *state * 1664525u + 1013904223u;
  return (double)(*state >> 8) / 16777216.0;
}

double encoded(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055; }
