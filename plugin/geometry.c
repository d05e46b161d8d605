/* SPDX-License-Identifier: Apache-2.0
 *
 * The functions of sozai.geometry/1, for every generator alike.
 */
#include <string.h>

#include "core/float_mode.h"
#include "core/meter.h"
#include "core/status.h"
#include "fiber/generator.h"
#include "generator.h"
#include "material.h"
#include "tree/generator.h"

#define LEVEL_MAX 8u

static const generator *const generators[] = {&tree_generator, &fiber_generator};
#define GENERATORS ((uint32_t)(sizeof generators / sizeof generators[0]))

struct sozai_geometry {
  const generator *kind;
  const sozai_generator_info *info;
  sozai_host host;
  uint64_t ceilings[LIMITS]; /* as they were when it was grown */
  settings given;
  void *state;
};

void geometry_describe(void) {
  for (uint32_t i = 0; i < GENERATORS; i++) generators[i]->describe();
}

static uint32_t count(void) { return textures_ready() ? GENERATORS : 0; }

static const sozai_generator_info *info(uint32_t index) {
  return index < count() ? generators[index]->describe() : NULL;
}

static const generator *generator_of(const char *id) {
  for (uint32_t i = 0; id && i < count(); i++) {
    if (strcmp(generators[i]->describe()->id, id) == 0) return generators[i];
  }
  return NULL;
}

static const sozai_generator_info *find(const char *id) {
  const generator *g = generator_of(id);
  return g ? g->describe() : NULL;
}

sozai_texture_info generator_parameters(const sozai_generator_info *g) {
  return (sozai_texture_info){.size = sizeof(sozai_texture_info),
                              .id = g->id,
                              .parameters = g->parameters,
                              .presets = g->presets,
                              .parameter_count = g->parameter_count,
                              .preset_count = g->preset_count};
}

int32_t host_progress(const sozai_host *host, double fraction, const char *what) {
  if (!host->progress || host->progress(host->user, (float)fraction, what) == 0) return SOZAI_OK;
  return fail(SOZAI_ERROR_CANCELLED, "cancelled by the host: %s", what);
}

static void release(sozai_geometry *g) {
  if (!g) return;
  sozai_host host = g->host;
  if (g->state) g->kind->release(g->state, &host);
  host_free(&host, g->state, g->kind->state_bytes, 64);
  settings_free(&g->given, &host);
  host_free(&host, g, sizeof *g, 64);
}

/* Grows it, or rehearses that: then *out is NULL, and *memory what it would take. */
static int32_t make_in_mode(const sozai_host *host, const char *id, const char *preset,
                            const sozai_value *values, uint32_t value_count, sozai_geometry **out,
                            sozai_memory *memory) {
  if (!textures_ready()) return fail(SOZAI_ERROR_STATE, "grow: called before init");
  if (!id) return fail(SOZAI_ERROR_ARGUMENT, "grow: the generator's id is NULL");
  if (value_count && !values) return fail(SOZAI_ERROR_ARGUMENT, "grow: values is NULL");
  if (host && host->size < 8) {
    return fail(SOZAI_ERROR_ARGUMENT, "grow: host.size is %u: set it to sizeof(sozai_host)",
                host->size);
  }
  const generator *kind = generator_of(id);
  if (!kind) return fail(SOZAI_ERROR_UNKNOWN, "there is no generator \"%.80s\"", id);
  sozai_host own = host_copy(host), h;
  meter counted;
  int32_t r = meter_open(&counted, &own, LIMIT_GEOMETRY_BYTES, &h);
  if (r) return r;
  counted.rehearsing = memory != NULL;
  sozai_geometry *g = host_alloc(&h, sizeof *g, 64);
  if (!g) return meter_result(&counted, SOZAI_ERROR_MEMORY, id);
  g->kind = kind;
  g->info = kind->describe();
  g->host = own;
  memcpy(g->ceilings, counted.ceilings, sizeof g->ceilings);
  sozai_texture_info parameters = generator_parameters(g->info);
  r = settings_make(&g->given, &h, &parameters, preset, values, value_count);
  if (!r) {
    g->state = host_alloc(&h, kind->state_bytes, 64);
    r = g->state ? kind->grow(g->state, &h, &g->given) : SOZAI_ERROR_MEMORY;
  }
  if (!r && memory) {
    memory->held = atomic_load(&counted.held);
    memory->peak = atomic_load(&counted.peak);
  }
  if (r || memory) {
    release(g);
    return meter_result(&counted, r, id);
  }
  *out = g;
  return SOZAI_OK;
}

static int32_t make(const sozai_host *host, const char *id, const char *preset,
                    const sozai_value *values, uint32_t value_count, sozai_geometry **out,
                    sozai_memory *memory) {
  uint64_t mode = float_mode_enter();
  int32_t r = make_in_mode(host, id, preset, values, value_count, out, memory);
  float_mode_leave(mode);
  return r;
}

static int32_t grow(const sozai_host *host, const char *id, const char *preset,
                    const sozai_value *values, uint32_t value_count, sozai_geometry **out) {
  if (!out) return fail(SOZAI_ERROR_ARGUMENT, "grow: out is NULL");
  *out = NULL;
  return make(host, id, preset, values, value_count, out, NULL);
}

int32_t geometry_memory(const sozai_host *host, const char *id, const char *preset,
                        const sozai_value *values, uint32_t value_count, sozai_memory *out) {
  int32_t r = memory_clear(out, "geometry");
  sozai_geometry *none = NULL;
  return r ? r : make(host, id, preset, values, value_count, &none, out);
}

static int32_t level_of(const char *call, const sozai_detail *detail, uint32_t *level) {
  *level = 0;
  if (!detail) return SOZAI_OK;
  if (detail->size < SIZE_WITH(sozai_detail, level)) {
    return fail(SOZAI_ERROR_ARGUMENT, "%s: detail.size is %u: set it to sizeof(sozai_detail)", call,
                detail->size);
  }
  *level = detail->level;
  if (*level <= LEVEL_MAX) return SOZAI_OK;
  return fail(SOZAI_ERROR_RANGE, "%s: level %u is outside 0 to %u", call, *level, LEVEL_MAX);
}

/* Makes a mesh, or curves, or rehearses either. A rehearsal ends where the one
 * block would be taken: with MEMORY, and nothing refused. */
static int32_t make_blocks(const sozai_geometry *g, const char *call, const sozai_detail *detail,
                           mesh_block **m, curves_block **c, sozai_memory *memory) {
  uint32_t level;
  meter counted;
  sozai_host h;
  int32_t r = level_of(call, detail, &level);
  if (r) return r;
  meter_reopen(&counted, &g->host, g->ceilings, LIMIT_MESH_BYTES, &h);
  counted.rehearsing = memory != NULL;
  uint64_t mode = float_mode_enter();
  r = m ? g->kind->mesh(g->state, &h, level, m) : g->kind->curves(g->state, &h, level, c);
  float_mode_leave(mode);
  r = meter_result(&counted, r, g->info->id);
  if (!memory || r != SOZAI_ERROR_MEMORY || !atomic_load(&counted.held)) return r;
  memory->held = memory->peak = atomic_load(&counted.held);
  return SOZAI_OK;
}

static int32_t mesh(const sozai_geometry *g, const sozai_detail *detail, const sozai_mesh **out) {
  if (out) *out = NULL;
  if (!g || !out) return fail(SOZAI_ERROR_ARGUMENT, "mesh: geometry or out is NULL");
  mesh_block *m = NULL;
  int32_t r = make_blocks(g, "mesh", detail, &m, NULL, NULL);
  if (!r) *out = &m->out;
  return r;
}

int32_t geometry_mesh_memory(const sozai_geometry *g, const sozai_detail *detail,
                             sozai_memory *out) {
  int32_t r = memory_clear(out, "mesh");
  if (!r && !g) r = fail(SOZAI_ERROR_ARGUMENT, "memory: mesh: geometry is NULL");
  mesh_block *none = NULL;
  return r ? r : make_blocks(g, "mesh", detail, &none, NULL, out);
}

static void release_mesh(const sozai_mesh *m) {
  if (!m) return;
  mesh_block *b = (mesh_block *)(uintptr_t)m;
  sozai_host host = b->host;
  host_free(&host, b, b->bytes, 64);
}

static int32_t curves(const sozai_geometry *g, const sozai_detail *detail,
                      const sozai_curves **out) {
  if (out) *out = NULL;
  if (!g || !out) return fail(SOZAI_ERROR_ARGUMENT, "curves: geometry or out is NULL");
  curves_block *c = NULL;
  int32_t r = make_blocks(g, "curves", detail, NULL, &c, NULL);
  if (!r) *out = &c->out;
  return r;
}

int32_t geometry_curves_memory(const sozai_geometry *g, const sozai_detail *detail,
                               sozai_memory *out) {
  int32_t r = memory_clear(out, "curves");
  if (!r && !g) r = fail(SOZAI_ERROR_ARGUMENT, "memory: curves: geometry is NULL");
  curves_block *none = NULL;
  return r ? r : make_blocks(g, "curves", detail, NULL, &none, out);
}

static void release_curves(const sozai_curves *c) {
  if (!c) return;
  curves_block *b = (curves_block *)(uintptr_t)c;
  sozai_host host = b->host;
  host_free(&host, b, b->bytes, 64);
}

static int32_t table(const sozai_geometry *g, const char *id, sozai_table *out) {
  if (!g || !id || !out) return fail(SOZAI_ERROR_ARGUMENT, "table: an argument is NULL");
  if (out->size < SIZE_WITH(sozai_table, rows)) {
    return fail(SOZAI_ERROR_ARGUMENT, "table: out.size is %u: set it to sizeof(sozai_table)",
                out->size);
  }
  for (uint32_t i = 0; i < g->info->table_count; i++) {
    if (strcmp(g->info->tables[i]->id, id) != 0) continue;
    uint64_t rows = 0;
    const float *data = g->kind->table(g->state, i, &rows);
    const sozai_table whole = {.size = out->size < sizeof whole ? out->size : sizeof whole,
                               .info = g->info->tables[i],
                               .data = data,
                               .rows = rows};
    memcpy(out, &whole, whole.size);
    return SOZAI_OK;
  }
  return fail(SOZAI_ERROR_UNKNOWN, "%s has no table \"%.80s\"", g->info->id, id);
}

static int32_t value(const sozai_geometry *g, const char *id, sozai_value *out) {
  if (!g || !id || !out) return fail(SOZAI_ERROR_ARGUMENT, "value: an argument is NULL");
  sozai_texture_info parameters = generator_parameters(g->info);
  return settings_value(&g->given, &parameters, id, out);
}

static const sozai_generator_info *info_of(const sozai_geometry *g) { return g ? g->info : NULL; }

static uint64_t bytes(const sozai_geometry *g) {
  return g ? sizeof *g + g->given.bytes + g->kind->state_bytes + g->kind->bytes(g->state) : 0;
}

/* ---- blocks ----------------------------------------------------------- */

static size_t rounded(uint64_t n) { return (size_t)((n + 63) & ~63ull); }

static void *take_block(const sozai_host *host, size_t size) {
  if (!host_rehearses(host)) return host_alloc(host, size, 64);
  host_claim(host, size);
  return NULL;
}

mesh_block *mesh_block_make(const sozai_host *host, uint64_t points, uint64_t triangles,
                            int coloured) {
  if (points >> 32 || triangles > (1ull << 33)) {
    fail(SOZAI_ERROR_UNSUPPORTED, "mesh: %llu points do not fit into one mesh",
         (unsigned long long)points);
    return NULL;
  }
  size_t head = rounded(sizeof(mesh_block)), p3 = rounded(points * 12), p2 = rounded(points * 8),
         p1 = rounded(points * 4), t3 = rounded(triangles * 12);
  size_t size = head + (coloured ? 3 : 2) * p3 + p2 + p1 + t3;
  mesh_block *m = take_block(host, size);
  if (!m) return NULL;
  char *at = (char *)m + head;
  m->host = meter_real(host);
  m->bytes = size;
  m->points = (float *)(void *)at;
  m->normals = (float *)(void *)(at += p3);
  m->uv = (float *)(void *)(at += p3);
  m->owner = (uint32_t *)(void *)(at += p2);
  m->indices = (uint32_t *)(void *)(at += p1);
  m->colours = coloured ? (float *)(void *)(at + t3) : NULL;
  m->out = (sozai_mesh){.size = sizeof(sozai_mesh),
                        .point_count = points,
                        .triangle_count = triangles,
                        .points = m->points,
                        .normals = m->normals,
                        .uv = m->uv,
                        .owner = m->owner,
                        .indices = m->indices,
                        .parts = m->parts,
                        .colours = m->colours};
  return m;
}

curves_block *curves_block_make(const sozai_host *host, uint64_t curve_count, uint64_t points,
                                int coloured) {
  size_t head = rounded(sizeof(curves_block)), p3 = rounded(points * 12), p1 = rounded(points * 4),
         c8 = rounded((curve_count + 1) * 8), c4 = rounded(curve_count * 4);
  size_t size = head + (coloured ? 2 : 1) * p3 + p1 + c8 + c4;
  curves_block *c = take_block(host, size);
  if (!c) return NULL;
  char *at = (char *)c + head;
  c->host = meter_real(host);
  c->bytes = size;
  c->points = (float *)(void *)at;
  c->radii = (float *)(void *)(at += p3);
  c->first = (uint64_t *)(void *)(at += p1);
  c->ids = (uint32_t *)(void *)(at += c8);
  c->colours = coloured ? (float *)(void *)(at + c4) : NULL;
  c->out = (sozai_curves){.size = sizeof(sozai_curves),
                          .curve_count = curve_count,
                          .point_count = points,
                          .points = c->points,
                          .radii = c->radii,
                          .first = c->first,
                          .ids = c->ids,
                          .parts = c->parts,
                          .colours = c->colours};
  return c;
}

const sozai_geometry_1 geometry_table = {count, info,         find,   grow,           release,
                                         mesh,  release_mesh, curves, release_curves, table,
                                         value, info_of,      bytes,  fail_message};
