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

#define VALUES 24u /* to a texture */
#define ROUNDS 4u
#define TRIED 32u /* of one parameter */

/* Whose values are tables or pictures of the host's; and what works on such pictures alone. They
 * have tests of their own. */
static const char *const left_out[] = {"section_width",  "section_pith", "section_pith_s",
                                       "section_pith_t", "section_rim",  "section_radius",
                                       "section_detail", "tree_field",   "section_detail_size"};

/* Texts that can be tried. */
static const struct {
  const char *parameter, *values[3];
} texts[] = {{"object", {"", "chair", "table"}}, {"tree", {"", "sugi", "keyaki"}}};

static plugin p;
static full_batch batches[ROUNDS];

static const sozai_parameter *parameter_of(const sozai_texture_info *info, const char *id,
                                           size_t length) {
  for (uint32_t k = 0; k < info->parameter_count; k++) {
    const char *is = info->parameters[k]->id;
    if (strlen(is) == length && strncmp(is, id, length) == 0) return info->parameters[k];
  }
  fail_msg("%s has no parameter %.*s", info->id, (int)length, id);
  return NULL;
}

/* "id=value id=value": into values, the texts into room. How many. */
static uint32_t parse(const sozai_texture_info *info, const char *from, sozai_value *values,
                      char *room) {
  uint32_t count = 0;
  strcpy(room, from);
  for (char *rest = NULL, *word = strtok_r(room, " ", &rest); word;
       word = strtok_r(NULL, " ", &rest)) {
    char *is = strchr(word, '=');
    assert_non_null(is);
    const sozai_parameter *q = parameter_of(info, word, (size_t)(is - word));
    sozai_value *v = &values[count++];
    *v = (sozai_value){.id = q->id, .kind = q->kind};
    if (q->kind == SOZAI_KIND_CHOICE || q->kind == SOZAI_KIND_TEXT)
      v->text = is + 1;
    else /* one number, or three with commas between them */
      sscanf(is + 1, "%lf,%lf,%lf", &v->number[0], &v->number[1], &v->number[2]);
  }
  return count;
}

/* Values of a parameter, as unlike as may be. How many: 0 where none can be tried. */
static uint32_t values_to_try(const sozai_parameter *q, sozai_value *to) {
  uint32_t n = 0;
  for (size_t k = 0; k < sizeof left_out / sizeof *left_out; k++)
    if (strcmp(q->id, left_out[k]) == 0) return 0;
  for (uint32_t k = 0; k < TRIED; k++) to[k] = (sozai_value){.id = q->id, .kind = q->kind};
  switch (q->kind) {
  case SOZAI_KIND_FLOAT:
  case SOZAI_KIND_INT:
    for (; n < 3; n++) {
      /* below 0 of a size means that something else tells it */
      double least = n && q->soft_min < 0 && q->default_number[0] == q->soft_min ? 0 : q->soft_min;
      double x = least + 0.5 * n * (q->soft_max - least);
      if (q->soft_max - least >= 360.0 && strcmp(q->unit, "deg") == 0) x *= 0.7; /* not round */
      to[n].number[0] = q->kind == SOZAI_KIND_INT ? floor(x) : x;
      if (n && to[n].number[0] <= to[n - 1].number[0]) break;
    }
    return n;
  case SOZAI_KIND_BOOL:
    to[1].number[0] = 1;
    return 2;
  case SOZAI_KIND_COLOUR:
  case SOZAI_KIND_FLOAT3: /* one component changed at a time, too */
    for (; n < 4; n++) {
      for (uint32_t c = 0; c < 3; c++) {
        double low = q->kind == SOZAI_KIND_COLOUR ? 0.5 : q->soft_min,
               high = q->kind == SOZAI_KIND_COLOUR ? 0.9 : q->soft_max;
        to[n].number[c] = n == c + 1 ? low + 0.4 * (high - low) : low;
      }
    }
    return n;
  case SOZAI_KIND_CHOICE:
    assert_true(q->choice_count <= TRIED);
    for (; n < q->choice_count; n++) to[n].text = q->choices[n];
    return n;
  case SOZAI_KIND_TEXT:
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++)
      for (; strcmp(q->id, texts[k].parameter) == 0 && n < 3; n++) to[n].text = texts[k].values[n];
    return n;
  default:
    return 0;
  }
}

/* Faces square to the three axes, from fine footprints to coarse ones, near the axis and far; of
 * each round other places. */
static void places(const sozai_texture_info *info, uint32_t round) {
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

/* A number that answers share only where they are the same. 0: the values do not go together. */
static uint64_t answers(const sozai_texture_info *info, const char *preset,
                        const sozai_value *values, uint32_t count) {
  sozai_texture *t = NULL;
  if (p.textures->create(NULL, info->id, preset, values, count, &t) != SOZAI_OK) return 0;
  uint64_t h = 1;
  for (uint32_t round = 0; round < ROUNDS; round++) {
    full_batch *b = &batches[round];
    assert_int_equal(p.textures->evaluate(t, &b->batch), SOZAI_OK);
    for (uint32_t o = 0; o < b->components; o++) {
      for (uint32_t i = 0; i < BATCH_MAX; i++) {
        uint32_t bits;
        memcpy(&bits, &b->out[o][i], sizeof bits);
        h = (h ^ bits) * 0x9e3779b97f4a7c15u;
        h ^= h >> 32;
      }
    }
  }
  p.textures->destroy(t);
  return h | 1;
}

/* One setting: which pairs of the values it tells apart, added to `apart`. How many are left. */
static uint32_t tell_apart(const sozai_texture_info *info, const char *preset, const char *text,
                           const sozai_value *tried, uint32_t n, uint8_t apart[TRIED][TRIED]) {
  char room[1024];
  sozai_value values[VALUES];
  uint64_t h[TRIED];
  uint32_t count = parse(info, text, values, room), left = 0;
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
        print_error("%s: %s is as %s everywhere\n", q->id, tried[k].text, tried[j].text);
      else
        print_error("%s: %g %g %g is as %g %g %g everywhere\n", q->id, tried[k].number[0],
                    tried[k].number[1], tried[k].number[2], tried[j].number[0], tried[j].number[1],
                    tried[j].number[2]);
    }
  }
}

/* 1: some two of its values are alike in all settings. */
static int without_effect(const sozai_texture_info *info, const sozai_parameter *q, int loud) {
  sozai_value tried[TRIED];
  uint8_t apart[TRIED][TRIED] = {{0}};
  uint32_t n = values_to_try(q, tried), left = n;
  if (!n) return 0;
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
  for (uint32_t round = 0; round < ROUNDS; round++) places(info, round);
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
    char room[1024];
    sozai_value values[VALUES], turned[VALUES];
    uint32_t count = parse(info, s->values, values, room);
    for (uint32_t i = 0; i < count; i++) turned[i] = values[count - 1 - i];
    for (uint32_t r = 0; r < ROUNDS; r++) places(info, r);
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
