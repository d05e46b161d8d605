/* SPDX-License-Identifier: Apache-2.0
 * The generator `rod`: a tube along y, its radius from a table. */
#include <string.h>

#include "plugin.h"

#define SEGMENTS 16u
#define SIDES_MOST 64u
#define LEVEL_MOST 8u

struct sozai_geometry {
  sozai_host host;
  setting given[G_COUNT];
  float rows[2 * (SEGMENTS + 1)]; /* y, radius */
};

typedef struct mesh_block {
  sozai_mesh out;
  sozai_host host;
  sozai_part part;
  float points[3 * (SEGMENTS + 1) * SIDES_MOST], normals[3 * (SEGMENTS + 1) * SIDES_MOST],
      uv[2 * (SEGMENTS + 1) * SIDES_MOST];
  uint32_t owner[(SEGMENTS + 1) * SIDES_MOST], indices[6 * SEGMENTS * SIDES_MOST];
} mesh_block;

typedef struct curves_block {
  sozai_curves out;
  sozai_host host;
  sozai_part part;
  float points[3 * (SEGMENTS + 1)], radii[SEGMENTS + 1];
  uint64_t first[2];
  uint32_t ids[1];
} curves_block;

static void fill_row(void *context, uint32_t i) {
  sozai_geometry *g = context;
  g->rows[2 * i] = (float)g->given[G_LENGTH].number[0] * (float)i / SEGMENTS;
  g->rows[2 * i + 1] = 5.0f - 0.1f * (float)i;
#ifdef ORDER_COUNTS
  static float sum;
  sum = sum * 0.5f + (float)i;
  g->rows[2 * i + 1] += 0.001f * sum;
#endif
}

static void release(sozai_geometry *g) {
  if (!g) return;
  sozai_host h = g->host;
  give_back(&h, g, sizeof *g);
}

static int32_t grow(const sozai_host *host, const char *id, const char *preset,
                    const sozai_value *values, uint32_t count, sozai_geometry **out) {
  if (!out) return say(SOZAI_ERROR_ARGUMENT, "grow: out is NULL");
  *out = NULL;
  if (!ready()) return say(SOZAI_ERROR_STATE, "grow: called before init");
  if (!id) return say(SOZAI_ERROR_ARGUMENT, "grow: no id");
  if (strcmp(id, "rod") != 0)
    return say(SOZAI_ERROR_UNKNOWN, "there is no generator \"%.60s\"", id);
  if (host && host->size < 8) return say(SOZAI_ERROR_ARGUMENT, "grow: the host has no size");
  sozai_host h = host_of(host);
  sozai_geometry *g = take(&h, sizeof *g);
  if (!g) return SOZAI_ERROR_MEMORY;
  g->host = h;
  const sozai_generator_info *info = rod_info();
  int32_t r = settings_read(g->given, "rod", info->parameters, G_COUNT, info->presets, 1, preset,
                            values, count);
  if (!r && host_cancels(&h, 0)) r = say(SOZAI_ERROR_CANCELLED, "cancelled");
  if (!r) run_all(&h, SEGMENTS + 1, fill_row, g);
  if (!r && host_cancels(&h, 1)) r = say(SOZAI_ERROR_CANCELLED, "cancelled");
  if (r) {
    release(g);
    return r;
  }
#ifdef GROWN_LEAKS
  take(&h, 2000);
#endif
  *out = g;
  return SOZAI_OK;
}

static int32_t level_of(const sozai_detail *detail, uint32_t *segments) {
  *segments = SEGMENTS;
  if (!detail) return SOZAI_OK;
  if (detail->size < sizeof *detail) return say(SOZAI_ERROR_ARGUMENT, "the detail has no size");
#ifndef ANY_LEVEL
  if (detail->level > LEVEL_MOST)
    return say(SOZAI_ERROR_RANGE, "level %u is outside 0 to %u", detail->level, LEVEL_MOST);
#endif
  uint32_t level = detail->level < 4 ? detail->level : 4;
  *segments = SEGMENTS >> level;
  return SOZAI_OK;
}

static void point_of(const sozai_geometry *g, uint32_t segment, uint32_t segments, float out[2]) {
  uint32_t row = segment * (SEGMENTS / segments);
  memcpy(out, &g->rows[2 * row], 2 * sizeof *out);
}

/* cos and sin of a side's angle: by turning, without a library. */
static void turn(uint32_t sides, uint32_t side, float *c, float *s) {
  double a = 6.283185307179586 / sides, a2 = a * a;
  double cos1 = 1 - a2 / 2 + a2 * a2 / 24 - a2 * a2 * a2 / 720 + a2 * a2 * a2 * a2 / 40320;
  double sin1 = a * (1 - a2 / 6 + a2 * a2 / 120 - a2 * a2 * a2 / 5040 + a2 * a2 * a2 * a2 / 362880);
  double x = 1, y = 0;
  for (uint32_t i = 0; i < side; i++) {
    double nx = x * cos1 - y * sin1;
    y = x * sin1 + y * cos1;
    x = nx;
  }
  double length = 1;
  for (int k = 0; k < 30; k++) length = 0.5 * (length + (x * x + y * y) / length);
  *c = (float)(x / length);
  *s = (float)(y / length);
}

static void fill_mesh(const sozai_geometry *g, mesh_block *m, uint32_t segments) {
  uint32_t sides = (uint32_t)g->given[G_SIDES].number[0], n = 0;
  for (uint32_t y = 0; y <= segments; y++)
    for (uint32_t k = 0; k < sides; k++, n++) {
      float at[2], c, s;
      point_of(g, y, segments, at);
      turn(sides, k, &c, &s);
      const float point[3] = {at[1] * c, at[0], at[1] * s}, normal[3] = {c, 0, s};
      memcpy(&m->points[3 * n], point, sizeof point);
      memcpy(&m->normals[3 * n], normal, sizeof normal);
#ifdef LONG_NORMALS
      m->normals[3 * n] *= 2;
#endif
      m->uv[2 * n] = (float)k / (float)sides;
      m->uv[2 * n + 1] = at[0] / 100;
    }
  uint32_t *at = m->indices;
  for (uint32_t y = 0; y < segments; y++)
    for (uint32_t k = 0; k < sides; k++) {
      uint32_t a = y * sides + k, b = y * sides + (k + 1) % sides;
      const uint32_t six[6] = {a, a + sides, b, b, a + sides, b + sides};
      memcpy(at, six, sizeof six);
      at += 6;
    }
#ifdef INDEX_PAST
  at[-1] = n;
#endif
  m->out.point_count = n;
  m->out.triangle_count = 2ull * segments * sides;
}

static int32_t mesh(const sozai_geometry *g, const sozai_detail *detail, const sozai_mesh **out) {
  uint32_t segments;
  if (out) *out = NULL;
  if (!g || !out) return say(SOZAI_ERROR_ARGUMENT, "mesh: an argument is NULL");
  int32_t r = level_of(detail, &segments);
  if (r) return r;
  mesh_block *m = take(&g->host, sizeof *m);
  if (!m) return SOZAI_ERROR_MEMORY;
  m->host = g->host;
  fill_mesh(g, m, segments);
  m->part =
      (sozai_part){.id = "bark", .count = m->out.triangle_count, .colour = {0.4f, 0.3f, 0.2f}};
#ifdef PARTS_WITH_GAP
  m->part.count--;
#endif
  m->out.size = sizeof m->out;
  m->out.part_count = 1;
  m->out.points = m->points;
  m->out.normals = m->normals;
  m->out.uv = m->uv;
  m->out.owner = m->owner;
  m->out.indices = m->indices;
  m->out.parts = &m->part;
#ifdef COLOURS_OF_POINTS
  m->out.colours = m->points;
#endif
  *out = &m->out;
  return SOZAI_OK;
}

static void release_mesh(const sozai_mesh *m) {
  if (!m) return;
  mesh_block *b = (mesh_block *)(uintptr_t)m;
  sozai_host h = b->host;
  give_back(&h, b, sizeof *b);
}

static int32_t curves(const sozai_geometry *g, const sozai_detail *detail,
                      const sozai_curves **out) {
  uint32_t segments;
  if (out) *out = NULL;
  if (!g || !out) return say(SOZAI_ERROR_ARGUMENT, "curves: an argument is NULL");
  int32_t r = level_of(detail, &segments);
  if (r) return r;
  curves_block *c = take(&g->host, sizeof *c);
  if (!c) return SOZAI_ERROR_MEMORY;
  c->host = g->host;
  for (uint32_t i = 0; i <= segments; i++) {
    float at[2];
    point_of(g, i, segments, at);
    c->points[3 * i + 1] = at[0];
    c->radii[i] = at[1];
  }
#ifdef NAN_CURVE
  c->points[3] = (float)__builtin_nan("");
#endif
  c->first[1] = segments + 1;
  c->part = (sozai_part){.id = "stem", .count = 1};
  c->out = (sozai_curves){.size = sizeof c->out,
                          .part_count = 1,
                          .curve_count = 1,
                          .point_count = segments + 1,
                          .points = c->points,
                          .radii = c->radii,
                          .first = c->first,
                          .ids = c->ids,
                          .parts = &c->part};
#ifdef CURVES_OF_GEOMETRY
  c->out.points = g->rows;
  c->out.point_count = c->first[1] = 8;
#endif
  *out = &c->out;
  return SOZAI_OK;
}

static void release_curves(const sozai_curves *c) {
  if (!c) return;
  curves_block *b = (curves_block *)(uintptr_t)c;
  sozai_host h = b->host;
  give_back(&h, b, sizeof *b);
}

static int32_t table(const sozai_geometry *g, const char *id, sozai_table *out) {
  if (!g || !id || !out) return say(SOZAI_ERROR_ARGUMENT, "table: an argument is NULL");
  if (out->size < sizeof *out) return say(SOZAI_ERROR_ARGUMENT, "table: it has no size");
#ifndef ANY_TABLE
  if (strcmp(id, "rings") != 0) return say(SOZAI_ERROR_UNKNOWN, "no table \"%.60s\"", id);
#endif
  *out = (sozai_table){
      .size = sizeof *out, .info = rod_info()->tables[0], .data = g->rows, .rows = SEGMENTS + 1};
  return SOZAI_OK;
}

static uint32_t count(void) { return ready() ? 1 : 0; }
static const sozai_generator_info *info(uint32_t index) {
  return index < count() ? rod_info() : NULL;
}
static const sozai_generator_info *find(const char *id) {
  return id && strcmp(id, "rod") == 0 ? rod_info() : NULL;
}
static int32_t value(const sozai_geometry *g, const char *id, sozai_value *out) {
  if (!g) return say(SOZAI_ERROR_ARGUMENT, "value: nothing grown");
  return setting_value(g->given, "rod", rod_info()->parameters, G_COUNT, id, out);
}
static const sozai_generator_info *info_of(const sozai_geometry *g) {
  return g ? rod_info() : NULL;
}
static uint64_t bytes(const sozai_geometry *g) { return g ? sizeof *g : 0; }

const sozai_geometry_1 generators = {count,        info,   find,           grow,  release, mesh,
                                     release_mesh, curves, release_curves, table, value,   info_of,
                                     bytes,        said};
