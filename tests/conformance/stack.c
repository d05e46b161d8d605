/* SPDX-License-Identifier: Apache-2.0
 *
 * How much of the calling thread's stack evaluate() takes, at most, over every preset, and
 * over woods as they are laid, worn and lit and stones under moss: on a stack that has been
 * painted.
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

static void *answer(void *texture) {
  return (void *)(intptr_t)p.textures->evaluate(texture, &b.batch);
}

/* Bytes from the deepest that was written to the stack's end. */
static size_t taken_by(sozai_texture *t) {
  pthread_attr_t attributes;
  pthread_t thread;
  void *result = NULL;
  memset(stack, PAINT, ROOM);
  pthread_attr_init(&attributes);
  assert_int_equal(pthread_attr_setstack(&attributes, stack, ROOM), 0);
  assert_int_equal(pthread_create(&thread, &attributes, answer, t), 0);
  assert_int_equal(pthread_join(thread, &result), 0);
  pthread_attr_destroy(&attributes);
  assert_int_equal((intptr_t)result, SOZAI_OK);
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

static void measure(const char *set) {
  setenv("SOZAI_CPU", set, 1);
  for (uint32_t i = 0; i < p.textures->count(); i++) {
    const sozai_texture_info *info = p.textures->info(i);
    size_t most = 0;
    const char *by = "";
    const sozai_value *worn = way_to(info->id);
    for (uint32_t k = 0; k < info->preset_count; k++)
      for (uint32_t way = 0; way < (worn ? 2u : 1u); way++) {
        sozai_texture *t = NULL;
        int32_t r = p.textures->create(NULL, info->id, info->presets[k]->id, worn, way ? 3 : 0, &t);
        if (r == SOZAI_ERROR_UNSUPPORTED) return;
        assert_int_equal(r, SOZAI_OK);
        batch_make(&b, info, 1021); /* not whole blocks */
        size_t taken = taken_by(t);
        p.textures->destroy(t);
        if (taken > most) by = info->presets[k]->id;
        most = taken > most ? taken : most;
      }
    print_message("%-7s %-6s %6zu B at most (%s)\n", set, info->id, most, by);
    assert_true(most <= PROMISE);
  }
}

static void as_promised(void **state) {
  (void)state;
  static const char *const sets[] = {"scalar", "sse2", "avx2", "avx512", "neon"};
  for (size_t k = 0; k < sizeof sets / sizeof *sets; k++) measure(sets[k]);
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
  const struct CMUnitTest tests[] = {cmocka_unit_test(as_promised)};
  return cmocka_run_group_tests(tests, setup, teardown);
}
