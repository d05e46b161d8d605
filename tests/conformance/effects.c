/* SPDX-License-Identifier: Apache-2.0
 *
 * Nothing that an artist can turn is without effect: of every parameter, any two of the values that
 * are tried (the ends and the middle of its usual range; every choice) give other answers in at
 * least one setting. And the order in which values are given is without one.
 *
 * effects [TEXTURE]: of that one alone, with the setting in which each was told apart.
 */
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
#include "effects_settings.h"
#include "hashing.h"
#include "values.h"

#define VALUES 8u /* of a setting */
#define ROOM 512u /* for the text of one */
#define ROUNDS 4u
#define TRIED 32u /* of one parameter */

/* Beside tables and pictures of the host's, what works on such pictures alone. They have tests of
 * their own. */
static const char *const left_out[] = {"section_width",  "section_pith", "section_pith_s",
                                       "section_pith_t", "section_rim",  "section_radius",
                                       "section_detail", "tree_field",   "section_detail_size"};

/* Texts that can be tried. */
static const struct {
  const char *parameter, *values[3];
} texts[] = {{"object", {"", "chair", "table"}}, {"tree", {"", "sugi", "keyaki"}}};

static plugin p;
static full_batch batches[ROUNDS];

static int is_left_out(const sozai_parameter *q) {
  int is = q->kind == SOZAI_KIND_BUFFER || q->kind == SOZAI_KIND_IMAGE;
  for (size_t k = 0; k < sizeof left_out / sizeof *left_out; k++)
    is |= strcmp(q->id, left_out[k]) == 0;
  return is;
}

/* The ends and the middle of the usual range, where that is another whole number. */
static uint32_t numbers_to_try(const sozai_parameter *q, sozai_value *to) {
  uint32_t n = 0;
  for (int k = 0; k < 3; k++) {
    /* below 0 of a size means that something else tells it */
    double least = k && q->soft_min < 0 && q->default_number[0] == q->soft_min ? 0 : q->soft_min;
    double x = least + 0.5 * k * (q->soft_max - least);
    if (q->soft_max - least >= 360.0 && strcmp(q->unit, "deg") == 0) x *= 0.7; /* not round */
    if (q->kind == SOZAI_KIND_INT) x = floor(x);
    if (n && x == to[n - 1].number[0]) n--;
    to[n++].number[0] = x;
  }
  return n;
}

/* Three alike; and each of them higher. */
static uint32_t triples_to_try(double low, double high, sozai_value *to) {
  for (uint32_t n = 0; n < 4; n++)
    for (uint32_t c = 0; c < 3; c++) to[n].number[c] = n == c + 1 ? 0.6 * low + 0.4 * high : low;
  return 4;
}

static uint32_t texts_to_try(const sozai_parameter *q, sozai_value *to) {
  for (size_t k = 0; k < sizeof texts / sizeof *texts; k++) {
    if (strcmp(q->id, texts[k].parameter)) continue;
    for (uint32_t n = 0; n < 3; n++) to[n].text = texts[k].values[n];
    return 3;
  }
  return 0;
}

/* Values of a parameter, as unlike as may be. How many. */
static uint32_t values_to_try(const sozai_parameter *q, sozai_value *to) {
  for (uint32_t k = 0; k < TRIED; k++) to[k] = (sozai_value){.id = q->id, .kind = q->kind};
  switch (q->kind) {
  case SOZAI_KIND_FLOAT:
  case SOZAI_KIND_INT:
    return numbers_to_try(q, to);
  case SOZAI_KIND_BOOL:
    to[1].number[0] = 1;
    return 2;
  case SOZAI_KIND_COLOUR:
    return triples_to_try(0.5, 0.9, to);
  case SOZAI_KIND_FLOAT3:
    return triples_to_try(q->soft_min, q->soft_max, to);
  case SOZAI_KIND_CHOICE:
    assert_true(q->choice_count <= TRIED);
    for (uint32_t n = 0; n < q->choice_count; n++) to[n].text = q->choices[n];
    return q->choice_count;
  default:
    return texts_to_try(q, to);
  }
}

/* Faces square to the three axes, from fine footprints to coarse ones, near the axis and far. */
static void places_of_round(const sozai_texture_info *info, uint32_t round) {
  full_batch *b = &batches[round];
  batch_make(b, info, BATCH_MAX);
  float near = 1.0f / (1.0f + 0.7f * (float)round);
  for (uint32_t i = 0; i < BATCH_MAX; i++) {
    uint32_t axis = i % 4 < 3 ? i % 4 : 2; /* +z, a board's face, twice as often */
    for (uint32_t c = 0; c < 3; c++) {
      b->in[c][i] *= i % 2 ? 0.3f * near : near; /* within 90 mm, or 20 */
      b->in[3 + c][i] = c == axis;
      if (c == axis) b->in[c][i] = (float)(i / 4 % 5) * 7.0f;
    }
    b->in[15][i] = exp2f((float)(i / 20 % 8) - 6.0f);
    b->in[6 + axis][i] = fabsf(b->in[6 + axis][i]) + 0.3f;
    b->in[12 + axis][i] = fabsf(b->in[12 + axis][i]) + 0.3f;
  }
}

static void places(const sozai_texture_info *info) {
  for (uint32_t round = 0; round < ROUNDS; round++) places_of_round(info, round);
}

/* A number that answers share only where they are the same. 0: the values do not go together. */
static uint64_t answers(const sozai_texture_info *info, const char *preset,
                        const sozai_value *values, uint32_t count) {
  sozai_texture *t = NULL;
  if (p.textures->create(NULL, info->id, preset, values, count, &t) != SOZAI_OK) return 0;
  uint64_t h = 1;
  for (uint32_t round = 0; round < ROUNDS; round++) {
    full_batch *b = &batches[round];
    assert_int_equal(p.textures->evaluate(t, &b->batch), SOZAI_OK);
    for (uint32_t o = 0; o < b->components; o++) h = hash_words(h, b->out[o], BATCH_MAX);
  }
  p.textures->destroy(t);
  return h | 1;
}

static uint32_t values_of(const char *text, char *room, sozai_value *values) {
  assert_true(snprintf(room, ROOM, "%s", text) < (int)ROOM);
  uint32_t count = values_split(room, values, VALUES);
  assert_true(count < VALUES); /* none was left behind */
  return count;
}

/* One setting: which pairs of the values it tells apart, added to `apart`. How many are left. */
static uint32_t tell_apart(const sozai_texture_info *info, const char *preset, const char *text,
                           const sozai_value *tried, uint32_t n, uint8_t apart[TRIED][TRIED]) {
  char room[ROOM];
  sozai_value values[VALUES + 1];
  uint64_t h[TRIED];
  uint32_t count = values_of(text, room, values), left = 0;
  for (uint32_t k = 0; k < n; k++) {
    values[count] = tried[k];
    h[k] = answers(info, preset, values, count + 1);
  }
  for (uint32_t k = 0; k < n; k++) {
    for (uint32_t j = k + 1; j < n; j++) {
      if (h[k] && h[j] && h[k] != h[j]) apart[k][j] = 1;
      left += !apart[k][j];
    }
  }
  return left;
}

static void say_left(const sozai_parameter *q, const sozai_value *tried, uint32_t n,
                     uint8_t apart[TRIED][TRIED]) {
  for (uint32_t k = 0; k < n; k++) {
    for (uint32_t j = k + 1; j < n; j++) {
      if (apart[k][j]) continue;
      if (tried[k].text)
        print_error("%s: %s is as %s everywhere, or refused\n", q->id, tried[k].text,
                    tried[j].text);
      else
        print_error("%s: %g %g %g is as %g %g %g everywhere, or refused\n", q->id,
                    tried[k].number[0], tried[k].number[1], tried[k].number[2], tried[j].number[0],
                    tried[j].number[1], tried[j].number[2]);
    }
  }
}

/* 1: some two of its values are alike in all settings. */
static int without_effect(const sozai_texture_info *info, const sozai_parameter *q, int loud) {
  sozai_value tried[TRIED];
  uint8_t apart[TRIED][TRIED] = {{0}};
  if (is_left_out(q)) return 0;
  uint32_t n = values_to_try(q, tried), left = n;
  if (n < 2) fail_msg("%s: what can be tried of it?", q->id);
  for (size_t k = 0; left && k < sizeof settings / sizeof *settings; k++) {
    const setting *s = &settings[k];
    if (strcmp(s->texture, info->id)) continue;
    left = tell_apart(info, s->preset, s->values, tried, n, apart);
    if (loud && !left) printf("%s: %s %s\n", q->id, s->preset ? s->preset : "", s->values);
  }
  for (uint32_t k = 0; left && k < info->preset_count; k++) {
    left = tell_apart(info, info->presets[k]->id, "", tried, n, apart);
    if (loud && !left) printf("%s: preset %s\n", q->id, info->presets[k]->id);
  }
  if (left) say_left(q, tried, n, apart);
  return left > 0;
}

static void effects_of(const char *id, int loud) {
  const sozai_texture_info *info = p.textures->find(id);
  assert_non_null(info);
  places(info);
  int without = 0;
  for (uint32_t k = 0; k < info->parameter_count; k++)
    without += without_effect(info, info->parameters[k], loud);
  assert_int_equal(without, 0);
}

static void wood(void **state) {
  (void)state;
  effects_of("wood", 0);
}
static void stone(void **state) {
  (void)state;
  effects_of("stone", 0);
}
static void fiber(void **state) {
  (void)state;
  effects_of("fiber", 0);
}

/* All values of a setting from the last to the first. */
static void in_any_order(void **state) {
  (void)state;
  for (size_t k = 0; k < sizeof settings / sizeof *settings; k++) {
    const setting *s = &settings[k];
    const sozai_texture_info *info = p.textures->find(s->texture);
    char room[ROOM];
    sozai_value values[VALUES], turned[VALUES];
    uint32_t count = values_of(s->values, room, values);
    for (uint32_t i = 0; i < count; i++) turned[i] = values[count - 1 - i];
    places(info);
    uint64_t h = answers(info, s->preset, values, count);
    if (!h) fail_msg("%s, %s: %s", s->texture, s->values, p.textures->last_error());
    if (answers(info, s->preset, turned, count) != h)
      fail_msg("%s, %s: the order of its values matters", s->texture, s->values);
  }
}

static int start(void **state) {
  (void)state;
  return plugin_start(&p, SOZAI_TEST_PLUGIN);
}
static int stop(void **state) {
  (void)state;
  plugin_stop(&p);
  return 0;
}

int main(int argc, char **argv) {
  if (argc > 1) {
    if (start(NULL)) return 1;
    effects_of(argv[1], 1);
    return stop(NULL);
  }
  const struct CMUnitTest tests[] = {cmocka_unit_test(wood), cmocka_unit_test(stone),
                                     cmocka_unit_test(fiber), cmocka_unit_test(in_any_order)};
  return cmocka_run_group_tests(tests, start, stop);
}
