/* SPDX-License-Identifier: Apache-2.0
 * What is grown, with a host's services: the same bits, and nothing left behind
 * where it is cancelled or memory fails. */
#include <string.h>

#include "geometry.h"
#include "make.h"
#include "memory.h"
#include "recorder.h"

static recorder rec;

/* ---- the same bits ---------------------------------------------------------- */

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

/* A digest of its curves, and of its mesh at a level that is quick; what failed is left out. */
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
  uint64_t was = digest_of(s, g->geometry);
  for (uint32_t way = PARALLEL_FORWARD; way < PARALLEL_WAYS && !enough(); way++) {
    grown other;
    recorder_init(&rec);
    rec.parallel = way;
    doing("grow of %s, tasks %s", info->id, parallel_words[way]);
    int32_t r = grow_plain(s, info, &rec.abi, &other);
    if (!EXPECT(r == SOZAI_OK, "%s: grow gave %s with a thread pool, tasks %s", info->id,
                result_name(r), parallel_words[way]))
      continue;
    EXPECT(digest_of(s, other.geometry) == was, "%s: other bits with tasks %s", info->id,
           parallel_words[way]);
    s->geometry->release(other.geometry);
    recorder_judge(&rec, info->id);
    recorder_empty(&rec, info->id, "after release");
  }
  EXPECT(digest_of(s, g->geometry) == was, "%s: other bits when asked again", info->id);
}

void geometry_same(subject *s) { each_grown(s, same_of); }

/* "Meshes and curves made of it stay." */
void geometry_outlives(subject *s) {
  if (!generators_start(s)) return;
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

/* ---- the host's services ---------------------------------------------------- */

/* Grows once, and lets it go: what was asked of the host is in the recorder. */
static bool grown_and_released(subject *s, const sozai_generator_info *info) {
  grown g;
  recorder_init(&rec);
  if (grow_plain(s, info, &rec.abi, &g) != SOZAI_OK) return false;
  s->geometry->release(g.geometry);
  return true;
}

/* "Calls host.progress"; "CANCELLED" */
void geometry_cancelled(subject *s) {
  if (!generators_start(s)) return;
  uint32_t reported = 0;
  for (uint32_t i = 0; i < s->geometry->count(); i++) {
    const sozai_generator_info *info = s->geometry->info(i);
    grown g;
    if (!subject_wants(s, info->id)) continue;
    if (!grown_and_released(s, info)) continue;
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
void geometry_allocator_fails(subject *s) {
  if (!generators_start(s)) return;
  for (uint32_t i = 0; i < s->geometry->count(); i++) {
    const sozai_generator_info *info = s->geometry->info(i);
    grown g;
    if (!subject_wants(s, info->id)) continue;
    if (!grown_and_released(s, info)) continue;
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
void geometry_values(subject *s) { each_grown(s, value_of); }

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

void geometry_leaks(subject *s) {
  if (!memory_watched()) return skipped("a sanitizer has the allocator");
  each_grown(s, leak_of);
}
