/* SPDX-License-Identifier: Apache-2.0
 *
 * What is reported before anything is made, against what the host's allocator
 * then handed out: held to the byte, and the peak too.
 */
#include "tables.h"

#include <stdio.h>
#include <string.h>

static uint32_t compared, refusals;
static uint64_t largest;

/* What planning may hold, over what making holds. */
static void check_peak(const char *id, const char *preset, uint64_t said, uint64_t had) {
  if (said != had)
    print_message("%s %s: peak said %llu, had %llu\n", id, preset ? preset : "",
                  (unsigned long long)said, (unsigned long long)had);
  assert_true(said >= had);
  assert_true(said <= 2 * had);
}

static void texture(const char *id, const char *preset, const sozai_value *values, uint32_t n) {
  count c;
  sozai_host host = counting_host(&c);
  sozai_memory said = {.size = sizeof said};
  int32_t r = memory->texture(&host, id, preset, values, n, &said);
  assert_int_equal(c.live, 0);
  uint64_t planned = c.peak;
  sozai_texture *t = NULL;
  host = counting_host(&c);
  int32_t made = textures->create(&host, id, preset, values, n, &t);
  if (r != made)
    print_message("%s %s: %d and %d: %s\n", id, preset ? preset : "", r, made,
                  textures->last_error());
  assert_int_equal(r, made);
  if (r) {
    assert_int_equal(said.held, 0);
    refusals++;
    return;
  }
  assert_int_equal(said.held, c.live);
  assert_int_equal(said.held, textures->bytes(t));
  check_peak(id, preset, said.peak, c.peak);
  assert_true(planned <= said.peak);
  if (said.held > largest) largest = said.held;
  textures->destroy(t);
  assert_int_equal(c.live, 0);
  compared++;
}

static double value_in(const sozai_parameter *p, uint64_t *s) {
  double u = (double)(next_random(s) >> 11) * 0x1p-53;
  double x = p->soft_min + u * (p->soft_max - p->soft_min);
  return p->kind == SOZAI_KIND_FLOAT ? x : (double)(int64_t)x;
}

static void all_presets(void **unused) {
  (void)unused;
  for (uint32_t i = 0; i < textures->count(); i++) {
    const sozai_texture_info *info = textures->info(i);
    texture(info->id, NULL, NULL, 0);
    for (uint32_t k = 0; k < info->preset_count; k++)
      texture(info->id, info->presets[k]->id, NULL, 0);
  }
  print_message("%u textures compared, %u refused alike, the largest of %llu B\n", compared,
                refusals, (unsigned long long)largest);
}

/* Random values of random parameters, text and tables among them. */
static void many_values(void **unused) {
  (void)unused;
  enum { TRIES = 400, MOST = 10 };
  static const char *const trees[] = {"sugi", "hinoki", "karamatsu"};
  static const float widths[7] = {1.0f, 2.0f, 1.5f, 0.5f, 2.5f, 3.0f, 1.0f};
  const sozai_buffer table = {
      .size = sizeof table, .kind = SOZAI_BUFFER_TABLE, .dims = {7, 1}, .data = widths};
  const sozai_buffer picture = section_picture();
  uint64_t s = 9;
  for (int k = 0; k < TRIES; k++) {
    const sozai_texture_info *info =
        textures->info((uint32_t)(next_random(&s) % textures->count()));
    sozai_value list[MOST];
    uint32_t n = 0;
    for (uint32_t i = (uint32_t)(next_random(&s) % MOST); i; i--) {
      const sozai_parameter *p = info->parameters[next_random(&s) % info->parameter_count];
      sozai_value v = {.id = p->id, .kind = p->kind};
      if (p->kind == SOZAI_KIND_FLOAT || p->kind == SOZAI_KIND_INT) {
        v.number[0] = value_in(p, &s);
      } else if (p->kind == SOZAI_KIND_CHOICE) {
        v.text = p->choices[next_random(&s) % p->choice_count];
      } else if (p->kind == SOZAI_KIND_TEXT && strcmp(p->id, "tree") == 0) {
        v.text = trees[next_random(&s) % 3];
      } else if (p->kind == SOZAI_KIND_BUFFER && strcmp(p->id, "ring_widths") == 0) {
        v.buffer = &table;
      } else if (p->kind == SOZAI_KIND_IMAGE) {
        v.buffer = &picture;
      } else {
        continue;
      }
      list[n++] = v;
    }
    texture(info->id, info->presets[next_random(&s) % info->preset_count]->id, list, n);
  }
  print_message("%u textures compared, %u refused alike, the largest of %llu B\n", compared,
                refusals, (unsigned long long)largest);
  assert_true(compared > TRIES / 2);
}

static void knotted_wood(void **unused) {
  (void)unused;
  for (uint32_t age = 5; age <= 120; age += 23) {
    const sozai_value values[] = {
        {.id = "tree", .kind = SOZAI_KIND_TEXT, .text = age % 2 ? "sugi" : "akamatsu"},
        {.id = "tree_age", .kind = SOZAI_KIND_FLOAT, .number = {age}}};
    texture("wood", NULL, values, 2);
  }
}

/* ---- what is grown ------------------------------------------------------ */

static void blocks(const sozai_geometry *g, count *c) {
  for (uint32_t level = 0; level < 5; level += 2) {
    const sozai_detail detail = {.size = sizeof detail, .level = level};
    sozai_memory said = {.size = sizeof said};
    uint64_t before = c->live;
    const sozai_mesh *m = NULL;
    assert_int_equal(memory->mesh(g, &detail, &said), SOZAI_OK);
    assert_int_equal(c->live, before);
    assert_int_equal(geometry->mesh(g, &detail, &m), SOZAI_OK);
    assert_int_equal(said.held, c->live - before);
    assert_int_equal(said.peak, said.held);
    geometry->release_mesh(m);
    const sozai_curves *curves = NULL;
    said = (sozai_memory){.size = sizeof said};
    assert_int_equal(memory->curves(g, &detail, &said), SOZAI_OK);
    assert_int_equal(geometry->curves(g, &detail, &curves), SOZAI_OK);
    assert_int_equal(said.held, c->live - before);
    geometry->release_curves(curves);
    assert_int_equal(c->live, before);
  }
}

static void grown(const char *id, const char *preset, const sozai_value *values, uint32_t n) {
  count c;
  sozai_host host = counting_host(&c);
  sozai_memory said = {.size = sizeof said};
  int32_t r = memory->geometry(&host, id, preset, values, n, &said);
  if (r) print_message("%s %s: %s\n", id, preset, memory->last_error());
  assert_int_equal(r, SOZAI_OK);
  assert_int_equal(c.live, 0);
  uint64_t planned = c.peak;
  sozai_geometry *g = NULL;
  host = counting_host(&c);
  assert_int_equal(geometry->grow(&host, id, preset, values, n, &g), SOZAI_OK);
  assert_int_equal(said.held, c.live);
  assert_int_equal(said.held, geometry->bytes(g));
  check_peak(id, preset, said.peak, c.peak);
  blocks(g, &c);
  geometry->release(g);
  assert_int_equal(c.live, 0);
  print_message("%s %s: %llu B, %llu at most, said before; planning held %llu\n", id,
                preset ? preset : "", (unsigned long long)said.held, (unsigned long long)said.peak,
                (unsigned long long)planned);
  compared++;
}

static void trees(void **unused) {
  (void)unused;
  const sozai_generator_info *info = geometry->find("tree");
  for (uint32_t i = 0; i < info->preset_count; i++) {
    const sozai_value values[] = {
        {.id = "age", .kind = SOZAI_KIND_FLOAT, .number = {3 + 5.0 * (i % 4)}},
        {.id = "orders", .kind = SOZAI_KIND_INT, .number = {i % 4}}};
    grown("tree", info->presets[i]->id, values, 2);
  }
  static const char field[] =
      "trunk\n100 0 90\n100 20 80\n100 10 85\nB1 1 trunk\n50 90 20\n40 95 30\n";
  const sozai_value measured[] = {{.id = "field", .kind = SOZAI_KIND_TEXT, .text = field}};
  count c;
  sozai_host host = counting_host(&c);
  sozai_memory said = {.size = sizeof said};
  if (memory->geometry(&host, "tree", NULL, measured, 1, &said) != SOZAI_OK)
    print_message("field: %s\n", memory->last_error());
  else
    grown("tree", NULL, measured, 1);
}

static void fibers(void **unused) {
  (void)unused;
  static const char *const contacts[] = {"off", "rigid", "bend"};
  const sozai_generator_info *info = geometry->find("fiber");
  const sozai_buffer box = box_hull();
  for (uint32_t i = 0; i < info->preset_count; i++) {
    const sozai_value values[] = {
        {.id = "hull", .kind = SOZAI_KIND_BUFFER, .buffer = &box},
        {.id = "count", .kind = SOZAI_KIND_INT, .number = {50 + 40 * (i % 3)}},
        {.id = "cells", .kind = SOZAI_KIND_INT, .number = {16 + 8 * (i % 3)}},
        {.id = "rounds", .kind = SOZAI_KIND_INT, .number = {2}},
        {.id = "contact", .kind = SOZAI_KIND_CHOICE, .text = contacts[i % 3]}};
    grown("fiber", info->presets[i]->id, values, 5);
  }
  const sozai_value literal[] = {{.id = "hull", .kind = SOZAI_KIND_BUFFER, .buffer = &box},
                                 {.id = "count", .kind = SOZAI_KIND_INT, .number = {20}},
                                 {.id = "mode", .kind = SOZAI_KIND_CHOICE, .text = "literal"}};
  grown("fiber", NULL, literal, 3);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(all_presets), cmocka_unit_test(many_values),
                                     cmocka_unit_test(knotted_wood), cmocka_unit_test(trees),
                                     cmocka_unit_test(fibers)};
  return cmocka_run_group_tests(tests, tables_open, tables_close);
}
