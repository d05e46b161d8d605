/* SPDX-License-Identifier: Apache-2.0
 * Meshes, curves and tables of what is grown, and their levels of detail. */
#include <math.h>
#include <stddef.h>

#include "geometry.h"

#define LEVEL_MOST 8u

/* ---- meshes --------------------------------------------------------------------- */

/* "of triangles, in order, without gaps" */
static void parts_cover(const char *id, const char *what, const sozai_part *parts, uint32_t count,
                        uint64_t items) {
  uint64_t at = 0;
  if (!EXPECT(parts || !count, "%s: the parts of its %s are NULL", id, what)) return;
  for (uint32_t i = 0; i < count; i++) {
    EXPECT(parts[i].id && *parts[i].id, "%s: part %u of its %s has no id", id, i, what);
    EXPECT(parts[i].first == at, "%s: part %u of its %s begins at %llu, not %llu", id, i, what,
           (unsigned long long)parts[i].first, (unsigned long long)at);
    for (int c = 0; c < 3; c++)
      EXPECT(parts[i].colour[c] >= 0 && parts[i].colour[c] <= 1,
             "%s: part %u of its %s has the colour %g", id, i, what, (double)parts[i].colour[c]);
    EXPECT((parts[i].flags & ~SOZAI_PART_CLOSED) == 0, "%s: part %u of its %s has unknown flags",
           id, i, what);
    at += parts[i].count;
  }
  EXPECT(at == items, "%s: the parts of its %s have %llu items of %llu", id, what,
         (unsigned long long)at, (unsigned long long)items);
}

static bool all_finite(const char *id, const char *what, const float *x, uint64_t n) {
  if (!EXPECT(x || !n, "%s: its %s are NULL", id, what)) return false;
  for (uint64_t i = 0; i < n; i++)
    if (!isfinite(x[i]))
      return EXPECT(false, "%s: number %llu of its %s is %g", id, (unsigned long long)i, what,
                    (double)x[i]);
  return true;
}

/* What a struct with colours has to reach; one of ABI 1.3 ends before them. */
static uint32_t least_size(const subject *s, size_t before, size_t whole) {
  return (uint32_t)(s->entry->abi_minor < 4 ? before : whole);
}

/* "r g b each, as sozai_part.colour, of each point" */
static void colours_of(const char *id, const char *what, const float *colours, uint64_t points) {
  if (!colours || !all_finite(id, what, colours, 3 * points)) return;
  uint64_t off = 0;
  for (uint64_t i = 0; i < 3 * points; i++) off += !(colours[i] >= 0 && colours[i] <= 1);
  EXPECT(!off, "%s: %llu numbers of its %s are not of 0 to 1", id, (unsigned long long)off, what);
}

static void mesh_of(subject *s, const sozai_generator_info *info, grown *g) {
  const sozai_mesh *m = POISON;
  doing("mesh of %s", info->id);
  int32_t r = s->geometry->mesh(g->geometry, NULL, &m);
  if (!EXPECT(r == SOZAI_OK && m && m != POISON, "%s: mesh gave %s", info->id, result_name(r)))
    return;
  EXPECT(m->size >= least_size(s, offsetof(sozai_mesh, colours), sizeof *m),
         "%s: the mesh has size %u", info->id, m->size);
  if (m->size >= sizeof *m) colours_of(info->id, "mesh's colours", m->colours, m->point_count);
  EXPECT(m->point_count < 1ull << 32, "%s: %llu points", info->id,
         (unsigned long long)m->point_count);
  all_finite(info->id, "mesh's points", m->points, 3 * m->point_count);
  all_finite(info->id, "mesh's uv", m->uv, 2 * m->point_count);
  EXPECT(m->owner || !m->point_count, "%s: the mesh's owners are NULL", info->id);
  if (all_finite(info->id, "mesh's normals", m->normals, 3 * m->point_count)) {
    uint64_t off = 0;
    for (uint64_t i = 0; i < m->point_count; i++) {
      const float *n = &m->normals[3 * i];
      float length = sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      off += !(fabsf(length - 1) < 1e-3f);
    }
    EXPECT(!off, "%s: %llu of %llu normals are not of unit length", info->id,
           (unsigned long long)off, (unsigned long long)m->point_count);
  }
  if (EXPECT(m->indices || !m->triangle_count, "%s: the mesh's indices are NULL", info->id)) {
    uint64_t past = 0;
    for (uint64_t i = 0; i < 3 * m->triangle_count; i++) past += m->indices[i] >= m->point_count;
    EXPECT(!past, "%s: %llu indices are not below the %llu points", info->id,
           (unsigned long long)past, (unsigned long long)m->point_count);
  }
  parts_cover(info->id, "mesh", m->parts, m->part_count, m->triangle_count);
  s->geometry->release_mesh(m);
}

void geometry_mesh(subject *s) { each_grown(s, mesh_of); }

/* ---- curves ------------------------------------------------------------------------ */

static void curves_of(subject *s, const sozai_generator_info *info, grown *g) {
  const sozai_curves *c = POISON;
  doing("curves of %s", info->id);
  int32_t r = s->geometry->curves(g->geometry, NULL, &c);
  if (!EXPECT(r == SOZAI_OK && c && c != POISON, "%s: curves gave %s", info->id, result_name(r)))
    return;
  EXPECT(c->size >= least_size(s, offsetof(sozai_curves, colours), sizeof *c),
         "%s: the curves have size %u", info->id, c->size);
  if (c->size >= sizeof *c) colours_of(info->id, "curves' colours", c->colours, c->point_count);
  all_finite(info->id, "curves' points", c->points, 3 * c->point_count);
  if (all_finite(info->id, "curves' radii", c->radii, c->point_count)) {
    uint64_t negative = 0;
    for (uint64_t i = 0; i < c->point_count; i++) negative += c->radii[i] < 0;
    EXPECT(!negative, "%s: %llu radii are negative", info->id, (unsigned long long)negative);
  }
  /* "curve i has points first[i] up to first[i + 1]" */
  if (EXPECT(c->first && (c->ids || !c->curve_count), "%s: the curves' first or ids are NULL",
             info->id)) {
    uint64_t back = c->first[0] != 0;
    for (uint64_t i = 0; i < c->curve_count; i++) back += c->first[i + 1] < c->first[i];
    EXPECT(!back, "%s: first[] of the curves does not go up from 0", info->id);
    EXPECT(c->first[c->curve_count] == c->point_count, "%s: first[] ends at %llu of %llu points",
           info->id, (unsigned long long)c->first[c->curve_count],
           (unsigned long long)c->point_count);
  }
  parts_cover(info->id, "curves", c->parts, c->part_count, c->curve_count);
  s->geometry->release_curves(c);
}

void geometry_curves(subject *s) { each_grown(s, curves_of); }

/* ---- tables --------------------------------------------------------------------------- */

static void tables_of(subject *s, const sozai_generator_info *info, grown *g) {
  for (uint32_t i = 0; i < info->table_count; i++) {
    sozai_table t = {.size = sizeof t};
    doing("table %s of %s", info->tables[i]->id, info->id);
    int32_t r = s->geometry->table(g->geometry, info->tables[i]->id, &t);
    if (!EXPECT(r == SOZAI_OK, "%s: table %s gave %s", info->id, info->tables[i]->id,
                result_name(r)))
      continue;
    EXPECT(t.info == info->tables[i], "%s: table %s has another info", info->id,
           info->tables[i]->id);
    all_finite(info->id, info->tables[i]->id, t.data, t.rows * info->tables[i]->column_count);
  }
  sozai_table t = {.size = sizeof t};
  int32_t r = s->geometry->table(g->geometry, "validate: none", &t);
  EXPECT(r == SOZAI_ERROR_UNKNOWN, "%s: an unknown table gave %s", info->id, result_name(r));
  r = s->geometry->table(g->geometry, NULL, &t);
  EXPECT(r == SOZAI_ERROR_ARGUMENT, "%s: a table without an id gave %s", info->id, result_name(r));
  if (info->table_count) {
    t.size = 0;
    r = s->geometry->table(g->geometry, info->tables[0]->id, &t);
    EXPECT(r == SOZAI_ERROR_ARGUMENT, "%s: a table of size 0 gave %s", info->id, result_name(r));
  }
}

void geometry_tables(subject *s) { each_grown(s, tables_of); }

/* ---- detail ------------------------------------------------------------------------------- */

/* "0: all there is; each level more is about half of it; at most 8" */
static void levels_of(subject *s, const sozai_generator_info *info, grown *g) {
  uint64_t before = UINT64_MAX;
  for (uint32_t level = 0; level <= LEVEL_MOST; level++) {
    const sozai_detail d = {.size = sizeof d, .level = level};
    const sozai_curves *c = NULL;
    const sozai_mesh *m = NULL;
    doing("level %u of %s", level, info->id);
    int32_t r = s->geometry->curves(g->geometry, &d, &c);
    if (EXPECT(r == SOZAI_OK && c, "%s: curves of level %u gave %s", info->id, level,
               result_name(r)))
      EXPECT(c->point_count <= before, "%s: curves of level %u have %llu points, more than before",
             info->id, level, (unsigned long long)c->point_count);
    before = c ? c->point_count : before;
    s->geometry->release_curves(c);
    if (level != 2 && level != LEVEL_MOST) continue;
    r = s->geometry->mesh(g->geometry, &d, &m);
    EXPECT(r == SOZAI_OK && m, "%s: mesh of level %u gave %s", info->id, level, result_name(r));
    s->geometry->release_mesh(m);
  }
  static const sozai_detail wrong[] = {
      {sizeof(sozai_detail), LEVEL_MOST + 1}, {sizeof(sozai_detail), UINT32_MAX}, {0, 0}};
  for (uint32_t i = 0; i < COUNT_OF(wrong); i++) {
    const sozai_curves *c = POISON;
    const sozai_mesh *m = POISON;
    int32_t wanted = wrong[i].size ? SOZAI_ERROR_RANGE : SOZAI_ERROR_ARGUMENT;
    int32_t r = s->geometry->curves(g->geometry, &wrong[i], &c);
    EXPECT(r == wanted && !c, "%s: curves of level %u, size %u gave %s", info->id, wrong[i].level,
           wrong[i].size, result_name(r));
    r = s->geometry->mesh(g->geometry, &wrong[i], &m);
    EXPECT(r == wanted && !m, "%s: mesh of level %u, size %u gave %s", info->id, wrong[i].level,
           wrong[i].size, result_name(r));
  }
  EXPECT(s->geometry->mesh(g->geometry, NULL, NULL) == SOZAI_ERROR_ARGUMENT,
         "%s: mesh with out NULL is taken", info->id);
  EXPECT(s->geometry->curves(g->geometry, NULL, NULL) == SOZAI_ERROR_ARGUMENT,
         "%s: curves with out NULL are taken", info->id);
}

void geometry_levels(subject *s) { each_grown(s, levels_of); }
