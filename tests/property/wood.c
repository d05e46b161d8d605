/* SPDX-License-Identifier: Apache-2.0 */
#include "wood.h"

#include "cmocka_all.h"

#include <dlfcn.h>
#include <limits.h>
#include <malloc.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const sozai_textures_1 *textures;
const sozai_wood_1 *woods;
static void *library;
static const sozai_entry_v1 *entry;

static void stop(const char *what, const char *why) {
  fprintf(stderr, "%s: %s\n", what, why ? why : "?");
  exit(1);
}

/* Arrays of points grow, and go: memory that is given back each time has to be mapped anew, which
 * took longer than the points. */
static void keep_memory(void) {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, INT_MAX);
  mallopt(M_TOP_PAD, 1 << 24);
}

int wood_setup(void **state) {
  (void)state;
  keep_memory();
  library = dlopen(SOZAI_TEST_PLUGIN, RTLD_NOW | RTLD_LOCAL);
  if (!library) stop(SOZAI_TEST_PLUGIN, dlerror());
  entry = dlsym(library, SOZAI_ENTRY_SYMBOL);
  if (!entry || entry->abi_major != SOZAI_ABI_MAJOR) stop(SOZAI_TEST_PLUGIN, "wrong ABI");
  if (entry->init(SOZAI_TEST_PLUGIN) != SOZAI_OK) stop("init", "failed");
  textures = entry->get_factory(SOZAI_TEXTURES_1);
  woods = entry->get_factory(SOZAI_WOOD_1);
  return textures && woods ? 0 : 1;
}

const void *wood_factory(const char *id) { return entry->get_factory(id); }

int wood_teardown(void **state) {
  (void)state;
  entry->deinit();
  dlclose(library);
  return 0;
}

static sozai_texture *make(const char *material, const char *preset, const char *parameters) {
  char text[1024];
  sozai_value values[32];
  unsigned n = 0;
  snprintf(text, sizeof text, "%s", parameters);
  for (char *save, *one = strtok_r(text, ";", &save); one; one = strtok_r(NULL, ";", &save)) {
    while (*one == ' ') one++;
    char *equals = strchr(one, '=');
    if (!equals || n == 32) stop("parameters", parameters);
    *equals = 0;
    memset(&values[n], 0, sizeof values[n]);
    values[n].id = one;
    values[n].kind = SOZAI_KIND_STRING;
    values[n++].text = equals + 1;
  }
  sozai_texture *t;
  return textures->create(NULL, material, preset, values, n, &t) ? NULL : t;
}

sozai_texture *wood_make(const char *preset, const char *parameters) {
  sozai_texture *t = make("wood", preset, parameters);
  if (!t) stop("create", textures->last_error());
  return t;
}

sozai_texture *stone_make(const char *preset, const char *parameters) {
  sozai_texture *t = make("stone", preset, parameters);
  if (!t) stop("create", textures->last_error());
  return t;
}

static const char *refused(const char *material, const char *parameters) {
  sozai_texture *t = make(material, NULL, parameters);
  textures->destroy(t);
  return t ? NULL : textures->last_error();
}
const char *wood_refused(const char *parameters) { return refused("wood", parameters); }
const char *stone_refused(const char *parameters) { return refused("stone", parameters); }

unsigned wood_presets(void) { return textures->find("wood")->preset_count; }
const char *wood_preset(unsigned i) { return textures->find("wood")->presets[i]->id; }

static float **array_of(points *p, unsigned k) {
  if (k < 3) return &p->point[k];
  if (k < 6) return &p->normal[k - 3];
  if (k < 9) return &p->light[k - 6];
  if (k < 12) return &p->view[k - 9];
  return k == 12 ? &p->footprint : &p->out[k - 13];
}

int wood_is_panel(const char *preset) {
  return strstr(preset, "plywood") || strstr(preset, "_lvl") || strstr(preset, "blockboard");
}
#define OUTS 42
#define ARRAYS (13 + OUTS)

void points_clear(points *p) { p->count = 0; }

void points_free(points *p) {
  for (unsigned k = 0; k < ARRAYS; k++) free(*array_of(p, k));
  memset(p, 0, sizeof *p);
}

unsigned points_add(points *p, double x, double y, double z, double footprint) {
  if (p->count == p->room) {
    p->room = p->room ? 2 * p->room : 1024;
    for (unsigned k = 0; k < ARRAYS; k++) {
      float **a = array_of(p, k);
      *a = realloc(*a, p->room * sizeof **a);
      if (!*a) stop("memory", "none");
    }
  }
  unsigned i = p->count++;
  p->point[0][i] = (float)x;
  p->point[1][i] = (float)y;
  p->point[2][i] = (float)z;
  for (int c = 0; c < 3; c++) p->normal[c][i] = p->light[c][i] = p->view[c][i] = c == 2 ? 1 : 0;
  p->footprint[i] = (float)footprint;
  return i;
}

double points_value(const points *p, int what, unsigned point) {
  return (double)p->out[what][point];
}

void points_along_fibre(const points *p, float step, points *to) {
  for (unsigned i = 0; i < p->count; i++) {
    points_add(to, (double)(p->point[0][i] + step * p->out[FIBER][i]),
               (double)(p->point[1][i] + step * p->out[FIBER + 1][i]),
               (double)(p->point[2][i] + step * p->out[FIBER + 2][i]), 0);
  }
}

void points_round_pith(const points *p, double step, points *to) {
  for (unsigned i = 0; i < p->count; i++) {
    double x = (double)p->point[0][i], z = (double)p->point[2][i], r = hypot(x, z);
    points_add(to, x - step * z / r, (double)p->point[1][i], z + step * x / r, 0);
  }
}

void points_add_anywhere(points *p, int count, double r, double deep, double height) {
  for (int i = 0; i < count; i++) {
    double angle = 6.2831853 * uniform(), at = r + deep * uniform();
    points_add(p, at * cos(angle), height * uniform(), at * sin(angle), 0);
  }
}

void points_ask_only(points *p, const sozai_texture *t, unsigned long long components) {
  float *out[OUTS];
  for (unsigned o = 0; o < OUTS; o++) out[o] = components >> o & 1 ? p->out[o] : NULL;
  sozai_batch b;
  memset(&b, 0, sizeof b);
  b.size = sizeof b;
  b.count = p->count;
  for (int c = 0; c < 3; c++) {
    b.point[c] = p->point[c];
    b.normal[c] = p->normal[c];
    b.light[c] = p->light[c];
    b.view[c] = p->view[c];
  }
  b.footprint = p->footprint;
  b.out = out;
  b.out_count = OUTS;
  if (textures->evaluate(t, &b)) stop("evaluate", textures->last_error());
}

void points_ask(points *p, const sozai_texture *t) { points_ask_only(p, t, ~0ull); }

static unsigned long long stream = 1;
void uniform_seed(unsigned seed) { stream = seed * 2654435761ull + 1; }
double uniform(void) {
  stream = stream * 6364136223846793005ull + 1442695040888963407ull;
  return (double)(stream >> 11) / 9007199254740992.0;
}
