/* SPDX-License-Identifier: Apache-2.0
 * Curves, meshes and tables that are grown. */
#include "geometry.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "groups.h"
#include "make.h"
#include "memory.h"
#include "recorder.h"

#define POISON ((void *)(uintptr_t)0x10)
#define LEVEL_MOST 8u

static recorder rec;

/* Run for every generator that is judged, on what it grows of its defaults. */
typedef void grown_test(subject *s, const sozai_generator_info *info, grown *g);

static void each_grown(subject *s, grown_test *test) {
  if (!subject_start(s)) return;
  if (!s->geometry) return skipped("it has no " SOZAI_GEOMETRY_1);
  for (uint32_t i = 0; i < s->geometry->count() && !enough(); i++) {
    const sozai_generator_info *info = s->geometry->info(i);
    grown g;
    if (!info || !subject_wants(s, info->id) || grow_plain(s, info, NULL, &g) != SOZAI_OK) continue;
    doing("%s", info->id);
    test(s, info, &g);
    doing("release of %s", info->id);
    s->geometry->release(g.geometry);
  }
}

/* "Grow one": with no values, or refused for want of one that has no default. */
static void grows(subject *s) {
  if (!subject_start(s)) return;
  if (!s->geometry) return skipped("it has no " SOZAI_GEOMETRY_1);
  for (uint32_t i = 0; i < s->geometry->count(); i++) {
    const sozai_generator_info *info = s->geometry->info(i);
    grown g;
    if (!subject_wants(s, info->id)) continue;
    int32_t r = grow_plain(s, info, NULL, &g);
    if (!EXPECT(r == SOZAI_OK, "%s: grow gave %s: %s", info->id, result_name(r),
                s->geometry->last_error()))
      continue;
    if (!EXPECT(g.geometry, "%s: grow gave SOZAI_OK and nothing", info->id)) continue;
    EXPECT(s->geometry->info_of(g.geometry) == info, "%s: info_of is another", info->id);
    EXPECT(s->geometry->bytes(g.geometry) > 0, "%s: bytes() is 0", info->id);
    s->geometry->release(g.geometry);
  }
}

/* "NULL is allowed." of all three */
static void release_null(subject *s) {
  if (!subject_start(s)) return;
  if (!s->geometry) return skipped("it has no " SOZAI_GEOMETRY_1);
  doing("release, release_mesh and release_curves of NULL");
  s->geometry->release(NULL);
  s->geometry->release_mesh(NULL);
  s->geometry->release_curves(NULL);
  asked();
}

static void refuses(subject *s) {
  if (!subject_start(s)) return;
  if (!s->geometry) return skipped("it has no " SOZAI_GEOMETRY_1);
  for (uint32_t i = 0; i < s->geometry->count(); i++) {
    const char *id = s->geometry->info(i)->id;
    static const sozai_host no_size;
    const struct {
      const char *what;
      const sozai_host *host;
      const char *id, *preset;
      uint32_t count;
      int32_t wanted;
    } calls[] = {{"without an id", NULL, NULL, NULL, 0, SOZAI_ERROR_ARGUMENT},
                 {"of an unknown generator", NULL, "validate: none", NULL, 0, SOZAI_ERROR_UNKNOWN},
                 {"of an unknown preset", NULL, id, "validate: none", 0, SOZAI_ERROR_UNKNOWN},
                 {"of 3 values at NULL", NULL, id, NULL, 3, SOZAI_ERROR_ARGUMENT},
                 {"with a host of size 0", &no_size, id, NULL, 0, SOZAI_ERROR_ARGUMENT}};
    for (uint32_t c = 0; c < COUNT_OF(calls); c++) {
      sozai_geometry *g = POISON;
      doing("grow of %s, %s", id, calls[c].what);
      int32_t r =
          s->geometry->grow(calls[c].host, calls[c].id, calls[c].preset, NULL, calls[c].count, &g);
      EXPECT(r == calls[c].wanted, "grow %s (%s) gave %s, not %s", calls[c].what, id,
             result_name(r), result_name(calls[c].wanted));
      EXPECT(r == SOZAI_OK || !g, "grow %s (%s) failed and left *out as it was", calls[c].what, id);
      if (r == SOZAI_OK) s->geometry->release(g);
    }
    doing("grow with out NULL");
    int32_t r = s->geometry->grow(NULL, id, NULL, NULL, 0, NULL);
    EXPECT(r == SOZAI_ERROR_ARGUMENT, "grow of %s with out NULL gave %s", id, result_name(r));
  }
}

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

static void mesh_of(subject *s, const sozai_generator_info *info, grown *g) {
  const sozai_mesh *m = POISON;
  doing("mesh of %s", info->id);
  int32_t r = s->geometry->mesh(g->geometry, NULL, &m);
  if (!EXPECT(r == SOZAI_OK && m && m != POISON, "%s: mesh gave %s", info->id, result_name(r)))
    return;
  EXPECT(m->size >= sizeof *m, "%s: the mesh has size %u", info->id, m->size);
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

static void mesh(subject *s) { each_grown(s, mesh_of); }

/* ---- curves ------------------------------------------------------------------------ */

static void curves_of(subject *s, const sozai_generator_info *info, grown *g) {
  const sozai_curves *c = POISON;
  doing("curves of %s", info->id);
  int32_t r = s->geometry->curves(g->geometry, NULL, &c);
  if (!EXPECT(r == SOZAI_OK && c && c != POISON, "%s: curves gave %s", info->id, result_name(r)))
    return;
  EXPECT(c->size >= sizeof *c, "%s: the curves have size %u", info->id, c->size);
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

static void curves(subject *s) { each_grown(s, curves_of); }

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

static void tables(subject *s) { each_grown(s, tables_of); }

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

static void levels(subject *s) { each_grown(s, levels_of); }

/* ---- the same bits --------------------------------------------------------------------------- */

static uint64_t digest(uint64_t h, const void *bytes, uint64_t n) {
  const unsigned char *at = bytes;
  for (; n >= 8; n -= 8, at += 8) {
    uint64_t w;
    memcpy(&w, at, 8);
    h = (h ^ w) * 0x9e3779b97f4a7c15u;
    h ^= h >> 29;
  }
  for (; n; n--, at++) h = (h ^ *at) * 0x100000001b3u;
  return h;
}

/* A digest of its curves, and of its mesh at a level that is quick. 0: failed. */
static uint64_t digest_of(subject *s, const sozai_geometry *g) {
  const sozai_detail d = {.size = sizeof d, .level = 2};
  const sozai_curves *c = NULL;
  const sozai_mesh *m = NULL;
  uint64_t h = 1;
  if (s->geometry->curves(g, NULL, &c) == SOZAI_OK) {
    h = digest(h, c->points, 12 * c->point_count);
    h = digest(h, c->radii, 4 * c->point_count);
    h = digest(h, c->first, 8 * (c->curve_count + 1));
  }
  s->geometry->release_curves(c);
  if (s->geometry->mesh(g, &d, &m) == SOZAI_OK) {
    h = digest(h, m->points, 12 * m->point_count);
    h = digest(h, m->indices, 12 * m->triangle_count);
    h = digest(h, m->normals, 12 * m->point_count);
  }
  s->geometry->release_mesh(m);
  return h;
}

/* "The same values give the same bits on every machine, with or without the host's thread pool." */
static void same_of(subject *s, const sozai_generator_info *info, grown *g) {
  static const char *const ways[] = {"in order", "backwards", "on three threads", "refused"};
  uint64_t was = digest_of(s, g->geometry);
  for (uint32_t way = PARALLEL_FORWARD; way <= PARALLEL_REFUSED && !enough(); way++) {
    grown other;
    recorder_init(&rec);
    rec.parallel = way;
    doing("grow of %s, tasks %s", info->id, ways[way]);
    int32_t r = grow_plain(s, info, &rec.abi, &other);
    if (!EXPECT(r == SOZAI_OK, "%s: grow gave %s with a thread pool, tasks %s", info->id,
                result_name(r), ways[way]))
      continue;
    EXPECT(digest_of(s, other.geometry) == was, "%s: other bits with tasks %s", info->id,
           ways[way]);
    s->geometry->release(other.geometry);
    recorder_judge(&rec, info->id);
    recorder_empty(&rec, info->id, "after release");
  }
  EXPECT(digest_of(s, g->geometry) == was, "%s: other bits when asked again", info->id);
}

static void same(subject *s) { each_grown(s, same_of); }

/* "Meshes and curves made of it stay." */
static void outlives(subject *s) {
  if (!subject_start(s)) return;
  if (!s->geometry) return skipped("it has no " SOZAI_GEOMETRY_1);
  for (uint32_t i = 0; i < s->geometry->count(); i++) {
    const sozai_generator_info *info = s->geometry->info(i);
    const sozai_detail d = {.size = sizeof d, .level = 2};
    const sozai_curves *c = NULL;
    const sozai_mesh *m = NULL;
    grown g;
    if (!subject_wants(s, info->id) || grow_plain(s, info, NULL, &g) != SOZAI_OK) continue;
    int32_t r = s->geometry->curves(g.geometry, NULL, &c);
    int32_t q = s->geometry->mesh(g.geometry, &d, &m);
    uint64_t was = c ? digest(1, c->points, 12 * c->point_count) : 0;
    uint64_t mesh_was = m ? digest(1, m->points, 12 * m->point_count) : 0;
    doing("release of %s, its curves and mesh kept", info->id);
    s->geometry->release(g.geometry);
    if (r == SOZAI_OK)
      EXPECT(digest(1, c->points, 12 * c->point_count) == was, "%s: curves changed by release",
             info->id);
    if (q == SOZAI_OK)
      EXPECT(digest(1, m->points, 12 * m->point_count) == mesh_was, "%s: a mesh changed by release",
             info->id);
    s->geometry->release_curves(c);
    s->geometry->release_mesh(m);
  }
}

/* ---- the host's services ------------------------------------------------------------------------
 */

/* "Calls host.progress"; "CANCELLED" */
static void cancelled(subject *s) {
  if (!subject_start(s)) return;
  if (!s->geometry) return skipped("it has no " SOZAI_GEOMETRY_1);
  uint32_t reported = 0;
  for (uint32_t i = 0; i < s->geometry->count(); i++) {
    const sozai_generator_info *info = s->geometry->info(i);
    grown g;
    if (!subject_wants(s, info->id)) continue;
    recorder_init(&rec);
    if (grow_plain(s, info, &rec.abi, &g) != SOZAI_OK) continue;
    s->geometry->release(g.geometry);
    uint64_t all = atomic_load(&rec.progress_calls);
    reported += all > 0;
    for (uint32_t round = 0; all && round < 6 && !enough(); round++) {
      uint64_t at = round == 0 ? 1 : round == 1 ? all : 1 + chance_below(s, (uint32_t)all);
      recorder_init(&rec);
      rec.cancel_at = at;
      rec.parallel = round % 2 ? PARALLEL_FORWARD : PARALLEL_THREADS;
      g.geometry = POISON;
      int32_t r = grow_plain(s, info, &rec.abi, &g);
      EXPECT(r == SOZAI_ERROR_CANCELLED && !g.geometry,
             "%s: grow gave %s where call %llu of %llu of progress cancelled it", info->id,
             result_name(r), (unsigned long long)at, (unsigned long long)all);
      if (r == SOZAI_OK) s->geometry->release(g.geometry);
      recorder_empty(&rec, info->id, "after it was cancelled");
    }
  }
  EXPECT(reported || s->texture, "no generator calls progress");
}

/* "On failure *out is NULL and nothing is kept."; "MEMORY" */
static void allocator_fails(subject *s) {
  if (!subject_start(s)) return;
  if (!s->geometry) return skipped("it has no " SOZAI_GEOMETRY_1);
  for (uint32_t i = 0; i < s->geometry->count(); i++) {
    const sozai_generator_info *info = s->geometry->info(i);
    grown g;
    if (!subject_wants(s, info->id)) continue;
    recorder_init(&rec);
    if (grow_plain(s, info, &rec.abi, &g) != SOZAI_OK) continue;
    s->geometry->release(g.geometry);
    recorder_judge(&rec, info->id);
    recorder_empty(&rec, info->id, "after release");
    uint64_t all = atomic_load(&rec.allocations);
    for (uint32_t round = 0; all && round < 12 && !enough(); round++) {
      recorder_init(&rec);
      rec.fail_at = round < 4 ? round + 1 : 1 + chance_below(s, (uint32_t)all);
      if (rec.fail_at > all) continue;
      int32_t r = grow_plain(s, info, &rec.abi, &g);
      EXPECT(r == SOZAI_ERROR_MEMORY || r == SOZAI_OK,
             "%s: grow gave %s where allocation %llu of %llu failed", info->id, result_name(r),
             (unsigned long long)rec.fail_at, (unsigned long long)all);
      EXPECT(r == SOZAI_OK || !g.geometry, "%s: something grown though memory failed", info->id);
      if (r == SOZAI_OK) s->geometry->release(g.geometry);
      recorder_empty(&rec, info->id, "after a failed allocation");
    }
  }
}

static void value_of(subject *s, const sozai_generator_info *info, grown *g) {
  for (uint32_t p = 0; p < info->parameter_count; p++) {
    sozai_value wanted, v;
    if (!make_default(info->parameters[p], &wanted)) continue;
    int32_t r = s->geometry->value(g->geometry, wanted.id, &v);
    if (EXPECT(r == SOZAI_OK, "%s: value(%s) gave %s", info->id, wanted.id, result_name(r)))
      EXPECT(value_same(&v, &wanted), "%s: value(%s) is %s, not %s", info->id, wanted.id,
             value_shown(&v), value_shown(&wanted));
  }
  sozai_value v;
  int32_t r = s->geometry->value(g->geometry, "validate_none", &v);
  EXPECT(r == SOZAI_ERROR_UNKNOWN, "%s: value of an unknown parameter gave %s", info->id,
         result_name(r));
}

/* "The value of one parameter as it was grown with. UNKNOWN." */
static void values(subject *s) { each_grown(s, value_of); }

static void leak_of(subject *s, const sozai_generator_info *info, grown *g) {
  int64_t before = 0;
  for (uint32_t round = 0; round < 6; round++) {
    const sozai_curves *c = NULL;
    grown other;
    if (round == 2) before = memory_live();
    if (grow_plain(s, info, NULL, &other) == SOZAI_OK) s->geometry->release(other.geometry);
    if (s->geometry->curves(g->geometry, NULL, &c) == SOZAI_OK) s->geometry->release_curves(c);
  }
  EXPECT(memory_live() - before < 4096, "%s: %lld bytes more after four rounds of grow and release",
         info->id, (long long)(memory_live() - before));
}

static void leaks(subject *s) {
  if (!memory_watched()) return skipped("a sanitizer has the allocator");
  each_grown(s, leak_of);
}

CHECKS(geometry, //
       {"geometry.grows", "describe.unique", "every generator grows of its defaults, or in a box",
        grows},
       {"geometry.release-null", "geometry.grows", "NULL may be released", release_null},
       {"geometry.refuses", "geometry.grows",
        "what is missing or unknown is refused, and *out set to NULL", refuses},
       {"geometry.mesh", "geometry.grows",
        "meshes: finite, unit normals, indices in range, parts without gaps", mesh},
       {"geometry.curves", "geometry.grows",
        "curves: finite, radii not negative, points and parts without gaps", curves},
       {"geometry.tables", "geometry.grows",
        "tables: finite, of their info; an unknown one is refused", tables},
       {"geometry.levels", "geometry.grows",
        "levels 0 to 8, none more than the one before; others refused", levels},
       {"geometry.same", "geometry.grows",
        "the same bits again, and with tasks in any order or refused", same},
       {"geometry.outlives", "geometry.grows", "meshes and curves outlive what they are of",
        outlives},
       {"geometry.cancelled", "geometry.grows", "growing stops where progress says so, cleanly",
        cancelled},
       {"geometry.allocator-fails", "geometry.grows",
        "where an allocation fails growing does, cleanly", allocator_fails},
       {"geometry.values", "geometry.grows", "value() gives what it was grown with", values},
       {"geometry.leaks", "geometry.grows", "what is grown and released leaves no memory behind",
        leaks});
