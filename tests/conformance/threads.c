/* SPDX-License-Identifier: Apache-2.0
 *
 * Sixteen threads on one texture while others make and destroy their own: the
 * answers are those of one thread alone, and the thread sanitizer has nothing
 * to say.
 */
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "batch.h"

#define READERS 16
#define MAKERS 4

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ROUNDS 60u
#else
#define ROUNDS 3000u
#endif

static plugin p;
static const sozai_texture_info *info;
static sozai_texture *shared;
static full_batch serial;
static atomic_int wrong, reading;

static void *reader(void *number) {
  uint64_t r = (uint64_t)(uintptr_t)number;
  full_batch *b = malloc(sizeof *b);
  batch_make(b, info, BATCH_MAX);
  for (uint32_t round = 0; round < ROUNDS; round++) {
    r = mix64(r);
    /* a part of the batch, from a random place on */
    uint32_t from = (uint32_t)(r % (BATCH_MAX - 1)), count = 1u + (uint32_t)(r >> 32) % 200u;
    if (count > BATCH_MAX - from) count = BATCH_MAX - from;
    sozai_batch part = b->batch;
    float *out[COMPONENTS];
    for (int c = 0; c < 3; c++) {
      part.point[c] += from, part.normal[c] += from, part.light[c] += from;
      part.light_colour[c] += from, part.view[c] += from;
    }
    part.footprint += from;
    for (uint32_t o = 0; o < b->components; o++) out[o] = b->out[o] + from;
    part.out = out;
    part.count = count;
    if (p.textures->evaluate(shared, &part) != SOZAI_OK) atomic_fetch_add(&wrong, 1);
    for (uint32_t o = 0; o < b->components; o++) {
      if (memcmp(out[o], serial.out[o] + from, count * sizeof(float)) != 0) {
        atomic_fetch_add(&wrong, 1);
      }
    }
    /* a failure of this thread's own: its message is not another's */
    sozai_batch bad = {.size = (uint32_t)(uintptr_t)number % 8u};
    char expected[32];
    snprintf(expected, sizeof expected, "batch.size is %u:", bad.size);
    if (p.textures->evaluate(shared, &bad) != SOZAI_ERROR_ARGUMENT ||
        !strstr(p.textures->last_error(), expected)) {
      atomic_fetch_add(&wrong, 1);
    }
  }
  free(b);
  atomic_fetch_sub(&reading, 1);
  return NULL;
}

/* Makes, asks and destroys; and inits and deinits, as a second host would. */
static void *maker(void *number) {
  uint32_t k = (uint32_t)(uintptr_t)number;
  float out[COMPONENTS], *list[COMPONENTS], one[16] = {1, 2, 3, 0, 0, 1, 0, 1, 1, 1, 1, 1, 0, 0, 1};
  for (uint32_t o = 0; o < COMPONENTS; o++) list[o] = &out[o];
  while (atomic_load(&reading)) {
    if (p.entry->init(ALONE) != SOZAI_OK) atomic_fetch_add(&wrong, 1);
    sozai_texture *t = plugin_wood(&p, info->presets[k++ % info->preset_count]->id, NULL);
    sozai_batch b = {.size = sizeof b,
                     .count = 1,
                     .point = {one, one + 1, one + 2},
                     .normal = {one + 3, one + 4, one + 5},
                     .light = {one + 6, one + 7, one + 8},
                     .out = list,
                     .out_count = info->component_count};
    if (!t || p.textures->evaluate(t, &b) != SOZAI_OK) atomic_fetch_add(&wrong, 1);
    sozai_value v;
    if (p.textures->value(t, "seed", &v) != SOZAI_OK) atomic_fetch_add(&wrong, 1);
    p.textures->destroy(t);
    p.entry->deinit();
  }
  return NULL;
}

static void together(void **unused) {
  (void)unused;
  assert_int_equal(plugin_start(&p, SOZAI_TEST_PLUGIN), 0);
  info = p.textures->find("wood");
  shared = plugin_wood(&p, "harunire", "compound");
  assert_non_null(shared);
  batch_make(&serial, info, BATCH_MAX);
  assert_int_equal(p.textures->evaluate(shared, &serial.batch), SOZAI_OK);
  pthread_t threads[READERS + MAKERS];
  atomic_store(&reading, READERS);
  for (uintptr_t i = 0; i < READERS + MAKERS; i++) {
    assert_int_equal(
        pthread_create(&threads[i], NULL, i < READERS ? reader : maker, (void *)(i + 1)), 0);
  }
  for (int i = 0; i < READERS + MAKERS; i++) pthread_join(threads[i], NULL);
  assert_int_equal(atomic_load(&wrong), 0);
  p.textures->destroy(shared);
  plugin_stop(&p);
}

/* The first init of all, by many at once. */
static pthread_barrier_t gate;

static void *first(void *unused) {
  (void)unused;
  pthread_barrier_wait(&gate);
  if (p.entry->init(ALONE) != SOZAI_OK) atomic_fetch_add(&wrong, 1);
  const sozai_textures_1 *t = p.entry->get_factory(SOZAI_TEXTURES_1);
  if (!t || !t->find("wood") || t->find("wood")->preset_count == 0) atomic_fetch_add(&wrong, 1);
  p.entry->deinit();
  return NULL;
}

static void racing_init(void **unused) {
  (void)unused;
  pthread_barrier_init(&gate, NULL, READERS);
  for (int round = 0; round < 20; round++) {
    assert_int_equal(plugin_open(&p, SOZAI_TEST_PLUGIN), 0);
    pthread_t threads[READERS];
    for (int i = 0; i < READERS; i++) pthread_create(&threads[i], NULL, first, NULL);
    for (int i = 0; i < READERS; i++) pthread_join(threads[i], NULL);
    assert_null(p.entry->get_factory(SOZAI_TEXTURES_1));
  }
  assert_int_equal(atomic_load(&wrong), 0);
  pthread_barrier_destroy(&gate);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(racing_init), cmocka_unit_test(together)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
