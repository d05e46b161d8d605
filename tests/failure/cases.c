/* SPDX-License-Identifier: Apache-2.0 */
#include "cases.h"

#include <dlfcn.h>
#include <string.h>

const sozai_entry_v1 *entry;
const sozai_textures_1 *textures;
const sozai_geometry_1 *geometry;
const sozai_memory_1 *memory;
static void *library;

#define COUNT(a) ((uint32_t)(sizeof(a) / sizeof(a)[0]))
#define TEXT(id_, t)                                                                               \
  { .id = id_, .kind = SOZAI_KIND_TEXT, .text = t }
#define PICK(id_, t)                                                                               \
  { .id = id_, .kind = SOZAI_KIND_CHOICE, .text = t }
#define WHOLE(id_, n)                                                                              \
  {                                                                                                \
    .id = id_, .kind = SOZAI_KIND_INT, .number = { n }                                             \
  }
#define GIVEN(id_, b)                                                                              \
  { .id = id_, .kind = SOZAI_KIND_BUFFER, .buffer = b }

static const char field[] = "trunk\n50 10 88 6\n40, 200, 85, 5.5\n30 0 90 -\nB100\n0\n35 45 20 2\n"
                            "25 50 30\nB110\n0\n0\n15 90 0 0.8\nB200\n0\n0\n28 300 -10\n"
                            "B300\n0\n0\n22 120 15\n";

static const float widths[5] = {1.0f, 2.0f, 1.5f, 0.5f, 2.5f};
static const sozai_buffer rings = {
    .size = sizeof rings, .kind = SOZAI_BUFFER_TABLE, .dims = {5, 1}, .data = widths};
enum { SIDE = 64 };
static float pixels[SIDE * SIDE * 3];
static const sozai_buffer picture = {
    .size = sizeof picture, .kind = SOZAI_BUFFER_IMAGE, .dims = {SIDE, SIDE, 3}, .data = pixels};
static sozai_buffer knots = {.size = sizeof knots, .kind = SOZAI_BUFFER_TABLE};
static sozai_buffer radii = {.size = sizeof radii, .kind = SOZAI_BUFFER_TABLE};
static sozai_geometry *knotted;

static const float corners[8][3] = {{0, 0, 0},  {20, 0, 0},  {20, 15, 0},  {0, 15, 0},
                                    {0, 0, 10}, {20, 0, 10}, {20, 15, 10}, {0, 15, 10}};
static const float outward[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                    {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
static const uint32_t faces[36] = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                   1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
static const sozai_buffer box = {.size = sizeof box,
                                 .kind = SOZAI_BUFFER_MESH,
                                 .dims = {8, 12},
                                 .points = &corners[0][0],
                                 .indices = faces};
static const sozai_buffer open_box = {.size = sizeof open_box,
                                      .kind = SOZAI_BUFFER_MESH,
                                      .dims = {8, 10},
                                      .points = &corners[0][0],
                                      .indices = faces};
static const sozai_buffer cloud = {.size = sizeof cloud,
                                   .kind = SOZAI_BUFFER_POINTS,
                                   .dims = {8},
                                   .points = &corners[0][0],
                                   .normals = &outward[0][0]};

static const sozai_value named[] = {TEXT("object", "table top"), GIVEN("ring_widths", &rings)};
static const sozai_value with_tree[] = {TEXT("tree", "sugi"), WHOLE("tree_age", 8)};
static const sozai_value with_field[] = {TEXT("tree_field", field), WHOLE("tree_age", 20)};
static const sozai_value with_tables[] = {GIVEN("knots", &knots), GIVEN("knot_radii", &radii)};
static const sozai_value with_picture[] = {
    {.id = "section", .kind = SOZAI_KIND_IMAGE, .buffer = &picture}};
static const sozai_value with_both[] = {
    {.id = "section", .kind = SOZAI_KIND_IMAGE, .buffer = &picture},
    TEXT("tree", "sugi"),
    WHOLE("tree_age", 8)};
static const sozai_value stem[] = {WHOLE("age", 12), WHOLE("orders", 0)};
static const sozai_value branches[] = {WHOLE("age", 7), WHOLE("orders", 1)};
static const sozai_value leaves[] = {WHOLE("age", 5), WHOLE("orders", 3)};
static const sozai_value measured[] = {TEXT("field", field), WHOLE("orders", 2)};
static const sozai_value sibling[] = {TEXT("field", field), PICK("resample", "sibling"),
                                      WHOLE("age", 8), WHOLE("orders", 1)};
static const sozai_value packed[] = {GIVEN("hull", &box), WHOLE("count", 70), WHOLE("cells", 16)};
static const sozai_value exact[] = {GIVEN("hull", &box),      WHOLE("count", 40),
                                    WHOLE("cells", 16),       PICK("mode", "exact"),
                                    PICK("contact", "rigid"), WHOLE("rounds", 3)};
static const sozai_value bent[] = {GIVEN("hull", &open_box), WHOLE("count", 40), WHOLE("cells", 16),
                                   PICK("contact", "bend"), WHOLE("rounds", 3)};
static const sozai_value literal[] = {GIVEN("hull", &box),
                                      WHOLE("count", 10),
                                      PICK("mode", "literal"),
                                      {.id = "spacing", .kind = SOZAI_KIND_FLOAT, .number = {5}}};
static const sozai_value points[] = {GIVEN("hull_points", &cloud), WHOLE("count", 5),
                                     PICK("mode", "literal")};

#define OF(list) list, COUNT(list)
made cases[64] = {
    {"wood", "wood", NULL, NULL, OF(named)},
    {"wood of a tree", "wood", NULL, "sugi", OF(with_tree)},
    {"wood of a measured tree", "wood", NULL, "hinoki", OF(with_field)},
    {"wood of tables of knots", "wood", NULL, NULL, OF(with_tables)},
    {"wood of a picture", "wood", NULL, NULL, OF(with_picture)},
    {"wood of a picture and a tree", "wood", NULL, NULL, OF(with_both)},
    {"stone", "stone", NULL, NULL, NULL, 0},
    {"a stem", NULL, "tree", NULL, OF(stem)},
    {"a tree", NULL, "tree", "sugi", OF(branches)},
    {"a tree in leaf", NULL, "tree", "cherry", OF(leaves)},
    {"a measured tree", NULL, "tree", NULL, OF(measured)},
    {"its sibling", NULL, "tree", NULL, OF(sibling)},
    {"fibre", NULL, "fiber", "cotton", OF(packed)},
    {"fibre, exact", NULL, "fiber", "wool_merino", OF(exact)},
    {"fibre, bent, in an open hull", NULL, "fiber", "felt", OF(bent)},
    {"fibre, literal", NULL, "fiber", NULL, OF(literal)},
    {"fibre, in points", NULL, "fiber", NULL, OF(points)},
};

static void add_presets(void) {
  uint32_t n = 0;
  while (cases[n].name) n++;
  for (uint32_t i = 0; i < textures->count(); i++) {
    const sozai_texture_info *info = textures->info(i);
    for (uint32_t k = 0; k < info->preset_count && n + 1 < COUNT(cases); k += 11)
      cases[n++] = (made){info->presets[k]->id, info->id, NULL, info->presets[k]->id, NULL, 0};
  }
}

static int take_table(const char *id, sozai_buffer *out) {
  sozai_table t = {.size = sizeof t};
  if (geometry->table(knotted, id, &t) != SOZAI_OK) return 0;
  out->dims[0] = t.rows;
  out->dims[1] = t.info->column_count;
  out->data = t.data;
  return 1;
}

int cases_open(void **unused) {
  (void)unused;
  library = dlopen(SOZAI_TEST_PLUGIN, RTLD_NOW | RTLD_LOCAL);
  entry = library ? dlsym(library, SOZAI_ENTRY_SYMBOL) : NULL;
  if (!entry || entry->init(SOZAI_TEST_PLUGIN) != SOZAI_OK) return 1;
  textures = entry->get_factory(SOZAI_TEXTURES_1);
  geometry = entry->get_factory(SOZAI_GEOMETRY_1);
  memory = entry->get_factory(SOZAI_MEMORY_1);
  if (geometry->grow(NULL, "tree", "sugi", stem, 1, &knotted) != SOZAI_OK) return 1;
  for (uint32_t y = 0; y < SIDE; y++)
    for (uint32_t x = 0; x < SIDE * 3; x++) {
      uint32_t dx = x / 3 > 32 ? x / 3 - 32 : 32 - x / 3, dy = y > 32 ? y - 32 : 32 - y;
      uint32_t d = dx * dx + dy * dy;
      pixels[y * SIDE * 3 + x] = d > 800 ? 1.0f : 0.3f + 0.2f * (float)(d / 40 % 2);
    }
  add_presets();
  return !take_table("knots", &knots) || !take_table("knot_radii", &radii);
}

int cases_close(void **unused) {
  (void)unused;
  geometry->release(knotted);
  entry->deinit();
  dlclose(library);
  return 0;
}

int32_t case_make(const made *c, const sozai_host *host, thing *out) {
  /* what must be NULL after a failure */
  out->texture = (sozai_texture *)(uintptr_t)1;
  out->geometry = (sozai_geometry *)(uintptr_t)1;
  int32_t r =
      c->texture
          ? textures->create(host, c->texture, c->preset, c->values, c->count, &out->texture)
          : geometry->grow(host, c->generator, c->preset, c->values, c->count, &out->geometry);
  if (c->texture) out->geometry = NULL;
  if (!c->texture) out->texture = NULL;
  return r;
}

void case_free(thing *t) {
  textures->destroy(t->texture);
  geometry->release(t->geometry);
}
