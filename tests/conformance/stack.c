/* SPDX-License-Identifier: Apache-2.0
 *
 * How much of the calling thread's stack create() and evaluate() take, at most, over every preset,
 * and over woods as they are laid, worn and lit and stones under moss, and grow(): on a stack that
 * has been painted.
 */
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "batch.h"

/* What the header promises, and what lies there for it. */
#define PROMISE (384u << 10)
#define ROOM (1u << 20)
#define PAINT 0xa5u

static plugin p;
static full_batch b;
static unsigned char *stack;

/* A call, and what came of it. */
typedef struct {
  const char *id, *preset;
  const sozai_value *values;
  uint32_t count;
  sozai_texture *texture;
  sozai_geometry *geometry;
  int32_t result;
} job;

static void *create(void *context) {
  job *j = context;
  j->result = p.textures->create(NULL, j->id, j->preset, j->values, j->count, &j->texture);
  return NULL;
}

static void *answer(void *context) {
  job *j = context;
  j->result = p.textures->evaluate(j->texture, &b.batch);
  return NULL;
}

static void *grow(void *context) {
  job *j = context;
  const sozai_geometry_1 *g = p.entry->get_factory(SOZAI_GEOMETRY_1);
  j->result = g->grow(NULL, j->id, j->preset, j->values, j->count, &j->geometry);
  return NULL;
}

/* Bytes from the deepest that was written to the stack's end. */
static size_t taken_by(void *(*call)(void *job), job *j) {
  pthread_attr_t attributes;
  pthread_t thread;
  memset(stack, PAINT, ROOM);
  pthread_attr_init(&attributes);
  assert_int_equal(pthread_attr_setstack(&attributes, stack, ROOM), 0);
  assert_int_equal(pthread_create(&thread, &attributes, call, j), 0);
  assert_int_equal(pthread_join(thread, NULL), 0);
  pthread_attr_destroy(&attributes);
  size_t clean = 0;
  while (clean < ROOM && stack[clean] == PAINT) clean++;
  return ROOM - clean;
}

/* Besides a texture's presets as they are. */
typedef struct {
  const char *id;
  sozai_value value[3];
} way_of;
static const way_of ways[] = {
    {"wood",
     {{.id = "layout", .kind = SOZAI_KIND_CHOICE, .text = "strip"},
      {.id = "surface", .kind = SOZAI_KIND_CHOICE, .text = "weathered"},
      {.id = "reflection", .kind = SOZAI_KIND_CHOICE, .text = "fibre_cone"}}},
    {"stone",
     {{.id = "moss", .kind = SOZAI_KIND_FLOAT, .number = {0.5}},
      {.id = "grime", .kind = SOZAI_KIND_FLOAT, .number = {0.4}},
      {.id = "wear", .kind = SOZAI_KIND_FLOAT, .number = {0.5}}}},
};

static const sozai_value *way_to(const char *id) {
  for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
    if (strcmp(ways[i].id, id) == 0) return ways[i].value;
  }
  return NULL;
}

/* The most so far, and whose. */
typedef struct {
  size_t most;
  const char *by;
} peak;

static void reach(peak *m, size_t taken, const char *by) {
  if (taken <= m->most) return;
  m->most = taken;
  m->by = by;
}

static void tell(const char *set, const char *call, const char *id, const peak *m) {
  print_message("%-7s %-8s %-6s %6zu B at most (%s)\n", set, call, id, m->most, m->by);
  assert_true(m->most <= PROMISE);
}

/* Whether there is such an instruction set. Of 1,021 points 681 are active: ten times 64, and more
 * than half a block over whole ones. */
static int measure_way(job *j, peak made[1], peak answered[1]) {
  static uint8_t active[BATCH_MAX];
  size_t taken = taken_by(create, j);
  if (j->result == SOZAI_ERROR_UNSUPPORTED) return 0;
  assert_int_equal(j->result, SOZAI_OK);
  reach(made, taken, j->preset);
  for (uint32_t i = 0; i < BATCH_MAX; i++) active[i] = i % 3u != 1;
  batch_make(&b, p.textures->info_of(j->texture), 1021); /* not whole blocks */
  for (int some = 0; some < 2; some++) {
    b.batch.active = some ? active : NULL;
    taken = taken_by(answer, j);
    assert_int_equal(j->result, SOZAI_OK);
    reach(answered, taken, j->preset);
  }
  p.textures->destroy(j->texture);
  return 1;
}

static void measure(const char *set) {
  setenv("SOZAI_CPU", set, 1);
  for (uint32_t i = 0; i < p.textures->count(); i++) {
    const sozai_texture_info *info = p.textures->info(i);
    peak made = {0, ""}, answered = made;
    const sozai_value *worn = way_to(info->id);
    for (uint32_t k = 0; k < info->preset_count; k++)
      for (uint32_t way = 0; way < (worn ? 2u : 1u); way++) {
        job j = {
            .id = info->id, .preset = info->presets[k]->id, .values = worn, .count = way ? 3 : 0};
        if (!measure_way(&j, &made, &answered)) return;
      }
    tell(set, "create", info->id, &made);
    tell(set, "evaluate", info->id, &answered);
  }
}

static void as_promised(void **state) {
  (void)state;
  static const char *const sets[] = {"scalar", "sse2", "avx2", "avx512", "neon"};
  for (size_t k = 0; k < sizeof sets / sizeof *sets; k++) measure(sets[k]);
}

/* What fiber fills: a cube of 10 mm. */
static const float corners[24] = {0, 0, 0,  10, 0, 0,  10, 10, 0,  0, 10, 0,
                                  0, 0, 10, 10, 0, 10, 10, 10, 10, 0, 10, 10};
static const uint32_t faces[36] = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                   2, 3, 7, 2, 7, 6, 1, 2, 6, 1, 6, 5, 0, 4, 7, 0, 7, 3};
static const sozai_buffer cube = {.size = sizeof cube,
                                  .kind = SOZAI_BUFFER_MESH,
                                  .dims = {8, 12},
                                  .points = corners,
                                  .indices = faces};

#define YOUNG 12.0 /* years; the first kind as old as it usually is */

static void grown(void **state) {
  (void)state;
  const sozai_value age = {.id = "age", .kind = SOZAI_KIND_FLOAT, .number = {YOUNG}},
                    hull = {.id = "hull", .kind = SOZAI_KIND_BUFFER, .buffer = &cube};
  const sozai_geometry_1 *g = p.entry->get_factory(SOZAI_GEOMETRY_1);
  for (uint32_t i = 0; i < g->count(); i++) {
    const sozai_generator_info *info = g->info(i);
    int tree = strcmp(info->id, "tree") == 0;
    peak m = {0, ""};
    for (uint32_t k = 0; k < info->preset_count; k++) {
      job j = {.id = info->id,
               .preset = info->presets[k]->id,
               .values = tree ? &age : &hull,
               .count = !tree || k};
      size_t taken = taken_by(grow, &j);
      assert_int_equal(j.result, SOZAI_OK);
      g->release(j.geometry);
      reach(&m, taken, j.preset);
    }
    tell("", "grow", info->id, &m);
  }
}

static int setup(void **state) {
  (void)state;
  return posix_memalign((void **)&stack, 1u << 16, ROOM) || plugin_start(&p, SOZAI_TEST_PLUGIN);
}

static int teardown(void **state) {
  (void)state;
  plugin_stop(&p);
  free(stack);
  return 0;
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(as_promised), cmocka_unit_test(grown)};
  return cmocka_run_group_tests(tests, setup, teardown);
}
