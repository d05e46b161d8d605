/* SPDX-License-Identifier: Apache-2.0
 *
 * A thread that rounds otherwise than to nearest, and whose floating-point
 * traps are on: the same answers, no signal, and both are as they were.
 */
#define _GNU_SOURCE /* feenableexcept */
#include <fenv.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "batch.h"

#define TRAPS (FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW)

static plugin p;
static full_batch ours, theirs;

static sozai_texture *make(const char *id, const char *preset) {
  sozai_texture *t = NULL;
  if (p.textures->create(NULL, id, preset, NULL, 0, &t))
    print_error("create %s: %s\n", id, p.textures->last_error());
  assert_non_null(t);
  return t;
}

/* Ordinary places, every third a point, and in every seventh a number that is none. */
static void fill(full_batch *b, const sozai_texture_info *info) {
  static const float nasty[] = {NAN, INFINITY, -INFINITY, 3e38f, -1e30f};
  batch_make(b, info, BATCH_MAX);
  for (uint32_t i = 0; i < BATCH_MAX; i++) {
    b->in[15][i] = i % 3 ? 0.01f * (float)(i % 301) : 0.0f;
    if (i % 7 == 0) b->in[i / 7 % 16][i] = nasty[i / 112 % 5];
  }
}

static void answers(const char *id, const char *preset, int mode) {
  const sozai_texture_info *info = p.textures->find(id);
  sozai_texture *t = make(id, preset);
  fill(&ours, info);
  fill(&theirs, info);
  assert_int_equal(p.textures->evaluate(t, &ours.batch), SOZAI_OK);
  p.textures->destroy(t);

  assert_int_equal(fesetround(mode), 0);
  int traps = feenableexcept(TRAPS);
  t = make(id, preset);
  int32_t result = p.textures->evaluate(t, &theirs.batch);
  int mode_after = fegetround(), traps_after = fegetexcept();
  p.textures->destroy(t);
  fedisableexcept(FE_ALL_EXCEPT);
  feenableexcept(traps);
  feclearexcept(FE_ALL_EXCEPT);
  fesetround(FE_TONEAREST);
  assert_int_equal(result, SOZAI_OK);
  assert_int_equal(mode_after, mode);
  assert_int_equal(traps_after & TRAPS, TRAPS);
  for (uint32_t c = 0; c < info->component_count; c++) {
    if (memcmp(ours.out[c], theirs.out[c], BATCH_MAX * sizeof(float)) != 0)
      fail_msg("%s %s: component %u depends on how the thread rounds", id, preset, c);
  }
}

static void textures_answer_alike(void **state) {
  (void)state;
  static const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
  static const char *const of[][2] = {{"wood", "keyaki"},       {"wood", "oak"},
                                      {"wood", "curly_maple"},  {"wood", "birch_plywood"},
                                      {"stone", "inada"},       {"stone", "travertino"},
                                      {"stone", "granite_fan"}, {"stone", "terrazzo"},
                                      {"fiber", "felt"},        {"fiber", "denim"}};
  for (size_t k = 0; k < sizeof of / sizeof *of; k++) answers(of[k][0], of[k][1], modes[k % 3]);
}

/* Values at the ends of their ranges, as text: no rounding puts them outside, and they are read and
 * told as ever. */
static void texts_are_read_alike(void **state) {
  (void)state;
  static const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
  static const char *const given[][2] = {
      {"ring_width", "0.2"}, {"ring_variation", "0.6"}, {"ring_width", "1.1"}, {"coat", "0.1"}};
  for (size_t k = 0; k < sizeof given / sizeof *given; k++) {
    double read[4];
    for (int m = 0; m < 4; m++) {
      const sozai_value value = {.id = given[k][0], .kind = SOZAI_KIND_STRING, .text = given[k][1]};
      sozai_texture *t = NULL;
      sozai_value told;
      fesetround(modes[m]);
      int32_t r = p.textures->create(NULL, "wood", NULL, &value, 1, &t);
      fesetround(FE_TONEAREST);
      if (r) fail_msg("%s=%s: %s", given[k][0], given[k][1], p.textures->last_error());
      assert_int_equal(p.textures->value(t, given[k][0], &told), SOZAI_OK);
      read[m] = told.number[0];
      p.textures->destroy(t);
      assert_true(read[m] == read[0]);
    }
  }
  const sozai_value wrong = {.id = "ring_width", .kind = SOZAI_KIND_STRING, .text = "0.1"};
  char first[1024] = "";
  for (int m = 0; m < 4; m++) {
    sozai_texture *t = NULL;
    fesetround(modes[m]);
    int32_t r = p.textures->create(NULL, "wood", NULL, &wrong, 1, &t);
    fesetround(FE_TONEAREST);
    assert_int_equal(r, SOZAI_ERROR_RANGE);
    if (m == 0) snprintf(first, sizeof first, "%s", p.textures->last_error());
    assert_string_equal(p.textures->last_error(), first);
  }
}

static void trees_grow_alike(void **state) {
  (void)state;
  const sozai_value age = {.id = "age", .kind = SOZAI_KIND_INT, .number = {6}};
  const sozai_mesh *mesh[2];
  sozai_geometry *g[2];
  const sozai_detail detail = {.size = sizeof detail};
  const sozai_geometry_1 *geometry = p.entry->get_factory(SOZAI_GEOMETRY_1);
  const sozai_memory_1 *memory = p.entry->get_factory(SOZAI_MEMORY_1);
  for (int k = 0; k < 2; k++) {
    if (k) fesetround(FE_UPWARD);
    if (k) feenableexcept(TRAPS);
    sozai_memory told = {.size = sizeof told};
    int32_t r = memory->geometry(NULL, "tree", "sugi", &age, 1, &told);
    if (!r) r = geometry->grow(NULL, "tree", "sugi", &age, 1, &g[k]);
    if (!r) r = geometry->mesh(g[k], &detail, &mesh[k]);
    fedisableexcept(FE_ALL_EXCEPT);
    fesetround(FE_TONEAREST);
    assert_int_equal(r, SOZAI_OK);
  }
  assert_int_equal(mesh[0]->point_count, mesh[1]->point_count);
  assert_memory_equal(mesh[0]->points, mesh[1]->points,
                      3 * sizeof(float) * (size_t)mesh[0]->point_count);
  for (int k = 0; k < 2; k++) {
    geometry->release_mesh(mesh[k]);
    geometry->release(g[k]);
  }
}

static int start(void **unused) {
  (void)unused;
  return plugin_start(&p, SOZAI_TEST_PLUGIN);
}

static int stop(void **unused) {
  (void)unused;
  plugin_stop(&p);
  return 0;
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(textures_answer_alike),
      cmocka_unit_test(texts_are_read_alike),
      cmocka_unit_test(trees_grow_alike),
  };
  return cmocka_run_group_tests(tests, start, stop);
}
