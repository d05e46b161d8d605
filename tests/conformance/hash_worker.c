/* SPDX-License-Identifier: Apache-2.0
 *
 * hash_worker PLUGIN [EVERY]: prints a line "kind name hash" for every texture's presets and
 * features and for every generator's, and "kind revision N": the hash of all channels at 768
 * points, or of all that was grown. EVERY: one in so many of the lines, for processors that are
 * emulated. Exits 1 when something is wrong, 77 when the machine lacks what SOZAI_CPU asks for.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hash_sets.h"
#include "hashing.h"
#include "identity_points.h"
#include "values.h"

#define SHARE 256u /* points of each kind of place that identity_points.c has */
#define KINDS 3u
#define POINTS (KINDS * SHARE)
#define VALUES 16u

static plugin host;
static const sozai_geometry_1 *geometry;
static float in[IN_COUNT][POINTS];
static uint32_t every = 1, turn;

static int wrong(const char *what, const char *kind, const char *name, const char *why) {
  fprintf(stderr, "%s of %s %s: %s\n", what, kind, name, why);
  return 1;
}

/* ---- textures -------------------------------------------------------------- */

static void make_points(void) {
  static float block[IN_COUNT][BLOCK];
  uint64_t number = 0;
  for (uint32_t kind = 0; kind < KINDS; kind++) {
    while (mix64(number) % KINDS != kind) number++;
    points_make(number, block);
    for (uint32_t k = 0; k < IN_COUNT; k++)
      memcpy(in[k] + kind * SHARE, block[k], SHARE * sizeof in[0][0]);
  }
}

static uint64_t hash_texture(const sozai_texture *t, int *failed) {
  static float out[COMPONENTS][POINTS];
  const sozai_texture_info *info = host.textures->info_of(t);
  float *list[COMPONENTS];
  for (uint32_t k = 0; k < COMPONENTS; k++) list[k] = out[k];
  sozai_batch b = {.size = sizeof b,
                   .count = POINTS,
                   .footprint = in[IN_FOOTPRINT],
                   .out = list,
                   .out_count = info->component_count};
  for (int c = 0; c < 3; c++) {
    b.point[c] = in[IN_POINT + c];
    b.normal[c] = in[IN_NORMAL + c];
    b.light[c] = in[IN_LIGHT + c];
    b.light_colour[c] = in[IN_LIGHT_COLOUR + c];
    b.view[c] = in[IN_VIEW + c];
  }
  *failed = info->component_count > COMPONENTS || host.textures->evaluate(t, &b) != SOZAI_OK;
  uint64_t h = info->component_count;
  for (uint32_t k = 0; !*failed && k < info->component_count; k++)
    h = hash_words(h, out[k], POINTS);
  return h;
}

static int texture(const char *kind, const char *name, const char *preset, const char *text) {
  if (turn++ % every) return 0;
  char copy[512];
  sozai_value values[VALUES];
  snprintf(copy, sizeof copy, "%s", text);
  uint32_t count = values_split(copy, values, VALUES);
  sozai_texture *t = NULL;
  int32_t r = host.textures->create(NULL, kind, preset, values, count, &t);
  if (r == SOZAI_ERROR_UNSUPPORTED) return 77;
  if (r) return wrong("create", kind, name, host.textures->last_error());
  int failed;
  uint64_t h = hash_texture(t, &failed);
  if (failed) return wrong("evaluate", kind, name, host.textures->last_error());
  printf("texture %s %s %016llx\n", kind, name, (unsigned long long)h);
  host.textures->destroy(t);
  return 0;
}

static int textures(void) {
  int r = 0;
  for (uint32_t i = 0; !r && i < host.textures->count(); i++) {
    const sozai_texture_info *info = host.textures->info(i);
    printf("texture %s revision %u\n", info->id, info->revision);
    for (uint32_t k = 0; !r && k < info->preset_count; k++)
      r = texture(info->id, info->presets[k]->id, info->presets[k]->id, "");
  }
  for (size_t i = 0; !r && i < sizeof texture_sets / sizeof *texture_sets; i++) {
    const hash_set *s = &texture_sets[i];
    char name[64];
    snprintf(name, sizeof name, "+%s", s->name);
    r = texture(s->kind, name, s->preset, s->values);
  }
  return r;
}

/* ---- geometry --------------------------------------------------------------- */

static uint64_t hash_mesh(uint64_t h, const sozai_mesh *m) {
  h = hash_words(h, m->points, 3 * m->point_count);
  h = hash_words(h, m->normals, 3 * m->point_count);
  h = hash_words(h, m->uv, 2 * m->point_count);
  h = hash_words(h, m->owner, m->point_count);
  return hash_words(h, m->indices, 3 * m->triangle_count);
}

static uint64_t hash_curves(uint64_t h, const sozai_curves *c) {
  h = hash_words(h, c->points, 3 * c->point_count);
  h = hash_words(h, c->radii, c->point_count);
  for (uint64_t i = 0; i <= c->curve_count; i++) h = hash_word(h, (uint32_t)c->first[i]);
  return hash_words(h, c->ids, c->curve_count);
}

static uint64_t hash_geometry(const sozai_geometry *g, int *failed) {
  const sozai_generator_info *info = geometry->info_of(g);
  uint64_t h = 0;
  for (uint32_t level = 0; level <= 3; level += 3) {
    const sozai_detail detail = {sizeof detail, level};
    const sozai_mesh *m = NULL;
    const sozai_curves *c = NULL;
    *failed |= geometry->mesh(g, &detail, &m) != SOZAI_OK;
    *failed |= geometry->curves(g, &detail, &c) != SOZAI_OK;
    if (m) h = hash_mesh(h, m);
    if (c) h = hash_curves(h, c);
    geometry->release_mesh(m);
    geometry->release_curves(c);
  }
  for (uint32_t i = 0; i < info->table_count; i++) {
    sozai_table t = {.size = sizeof t};
    *failed |= geometry->table(g, info->tables[i]->id, &t) != SOZAI_OK;
    if (!*failed) h = hash_words(h, t.data, t.rows * t.info->column_count);
  }
  return h;
}

/* A box of 20 mm is the hull of what wants one. */
static int grown(const char *kind, const char *name, const char *preset, const char *text) {
  static const float points[24] = {-10, -10, -10, 10, -10, -10, -10, 10, -10, 10, 10, -10,
                                   -10, -10, 10,  10, -10, 10,  -10, 10, 10,  10, 10, 10};
  static const uint32_t indices[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                       2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  const sozai_buffer box = {.size = sizeof box,
                            .kind = SOZAI_BUFFER_MESH,
                            .dims = {8, 12},
                            .points = points,
                            .indices = indices};
  if (turn++ % every) return 0;
  char copy[512];
  sozai_value values[VALUES + 1];
  snprintf(copy, sizeof copy, "%s", text);
  uint32_t count = values_split(copy, values, VALUES);
  if (strcmp(kind, "fiber") == 0)
    values[count++] = (sozai_value){.id = "hull", .kind = SOZAI_KIND_BUFFER, .buffer = &box};
  sozai_geometry *g = NULL;
  if (geometry->grow(NULL, kind, preset, values, count, &g))
    return wrong("grow", kind, name, geometry->last_error());
  int failed = 0;
  uint64_t h = hash_geometry(g, &failed);
  if (failed) return wrong("mesh, curves or tables", kind, name, geometry->last_error());
  printf("geometry %s %s %016llx\n", kind, name, (unsigned long long)h);
  geometry->release(g);
  return 0;
}

static int geometries(void) {
  int r = 0;
  for (uint32_t i = 0; !r && i < geometry->count(); i++) {
    const sozai_generator_info *info = geometry->info(i);
    int tree = strcmp(info->id, "tree") == 0;
    printf("geometry %s revision %u\n", info->id, info->revision);
    for (uint32_t k = 0; !r && k < info->preset_count; k++)
      r = grown(info->id, info->presets[k]->id, info->presets[k]->id,
                tree ? "age=7; leaves_most=2000" : "count=6; length=8; iterations=20; cells=16");
  }
  for (size_t i = 0; !r && i < sizeof geometry_sets / sizeof *geometry_sets; i++) {
    const hash_set *s = &geometry_sets[i];
    char name[64];
    snprintf(name, sizeof name, "+%s", s->name);
    r = grown(s->kind, name, s->preset, s->values);
  }
  return r;
}

int main(int argc, char **argv) {
  if (argc < 2 || plugin_start(&host, argv[1])) return 1;
  if (argc > 2) every = (uint32_t)strtoul(argv[2], NULL, 10);
  geometry = host.entry->get_factory(SOZAI_GEOMETRY_1);
  if (!geometry || !every) return 1;
  make_points();
  int r = textures();
  if (!r) r = geometries();
  plugin_stop(&host);
  return r;
}
