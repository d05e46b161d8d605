/* SPDX-License-Identifier: Apache-2.0
 * Bad input gets one line that names the parameter, the value and the range. */
#include "tree.h"

static void values(void **unused) {
  (void)unused;
  static const struct {
    const char *preset, *values;
    int32_t code;
    const char *words;
  } wrong[] = {
      {"sugi", "age=0", SOZAI_ERROR_RANGE, "age: 0 is outside 1 to 300 years"},
      {"sugi", "age=nan", SOZAI_ERROR_RANGE, "age: nan is outside"},
      {"sugi", "age=inf", SOZAI_ERROR_RANGE, "age: inf is outside"},
      {"sugi", "age=1e30", SOZAI_ERROR_RANGE, "age: 1e+30 is outside"},
      {"sugi", "age=old", SOZAI_ERROR_KIND, "age: cannot read \"old\""},
      {"sugi", "orders=2.5", SOZAI_ERROR_KIND, "orders"},
      {"sugi", "orders=9", SOZAI_ERROR_RANGE, "orders: 9 is outside 0 to 4"},
      {"sugi", "leaf=round", SOZAI_ERROR_RANGE, "leaf: \"round\" is none of: needle"},
      {"sugi", "height=3", SOZAI_ERROR_UNKNOWN, "tree has no parameter \"height\""},
      {"sugi", "bark_depth=-1", SOZAI_ERROR_RANGE, "bark_depth: -1 is outside 0 to 200 mm"},
      {"sugi", "bark_turning=2", SOZAI_ERROR_RANGE, "bark_turning: 2 is outside -1 to 1"},
      {"sugi", "age=30 lenticel_density=50", SOZAI_ERROR_RANGE,
       "lenticel_density: 50/dm2 leaves no room for lenticels of 25 mm by 4 mm; 0 to 32"},
      {"baobab", "age=3", SOZAI_ERROR_UNKNOWN, "baobab"}};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    sozai_geometry *g = (sozai_geometry *)(uintptr_t)1;
    int32_t r = grow_code(NULL, wrong[i].preset, wrong[i].values, NULL, &g);
    if (r != wrong[i].code || !strstr(geometry()->last_error(), wrong[i].words))
      fail_msg("%s: %d, %s", wrong[i].values, r, geometry()->last_error());
    assert_null(g);
  }
}

static void arguments(void **unused) {
  (void)unused;
  const sozai_geometry_1 *t = geometry();
  sozai_geometry *g = grow("sugi", "age=3 orders=2", NULL);
  const sozai_mesh *m = (const sozai_mesh *)(uintptr_t)1;
  sozai_detail detail = {.size = sizeof detail, .level = 9};
  assert_int_equal(t->mesh(g, &detail, &m), SOZAI_ERROR_RANGE);
  assert_non_null(strstr(t->last_error(), "level 9 is outside 0 to 8"));
  assert_null(m);
  detail.size = 4;
  assert_int_equal(t->mesh(g, &detail, &m), SOZAI_ERROR_ARGUMENT);
  assert_int_equal(t->mesh(NULL, NULL, &m), SOZAI_ERROR_ARGUMENT);
  assert_int_equal(t->mesh(g, NULL, NULL), SOZAI_ERROR_ARGUMENT);
  assert_int_equal(t->curves(NULL, NULL, NULL), SOZAI_ERROR_ARGUMENT);
  sozai_table rows = {.size = sizeof rows};
  assert_int_equal(t->table(g, "roots", &rows), SOZAI_ERROR_UNKNOWN);
  rows.size = 0;
  assert_int_equal(t->table(g, "knots", &rows), SOZAI_ERROR_ARGUMENT);
  sozai_value v;
  assert_int_equal(t->value(g, "girth", &v), SOZAI_ERROR_UNKNOWN);
  assert_int_equal(t->value(g, "age", &v), SOZAI_OK);
  assert_true(v.number[0] == 3);
  t->release(g);
  assert_int_equal(t->grow(NULL, "bush", NULL, NULL, 0, &g), SOZAI_ERROR_UNKNOWN);
  assert_null(g);
  assert_int_equal(t->grow(NULL, "tree", NULL, NULL, 1, &g), SOZAI_ERROR_ARGUMENT);
  assert_int_equal(t->grow(NULL, NULL, NULL, NULL, 0, &g), SOZAI_ERROR_ARGUMENT);
  assert_null(t->info(2));
  assert_null(t->find("sapling"));
  assert_int_equal(t->count(), 2);
  t->release(NULL);
  t->release_mesh(NULL);
  t->release_curves(NULL);
}

/* Every parameter at both ends of its hard range grows a sound tree or is
 * refused in a line: no hang, no crash. */
static void both_ends(void **unused) {
  (void)unused;
  const sozai_generator_info *info = geometry()->find("tree");
  uint32_t grown = 0, refused = 0;
  for (uint32_t i = 0; i < info->parameter_count; i++) {
    const sozai_parameter *p = info->parameters[i];
    uint32_t ends = p->kind == SOZAI_KIND_CHOICE ? p->choice_count : 2;
    if (p->kind == SOZAI_KIND_TEXT || p->kind == SOZAI_KIND_FLOAT3) continue;
    for (uint32_t k = 0; k < ends; k++) {
      sozai_value v[3] = {
          {.id = "age", .kind = SOZAI_KIND_FLOAT, .number = {3}},
          {.id = "orders", .kind = SOZAI_KIND_INT, .number = {3}},
          {.id = p->id, .kind = p->kind, .number = {k ? p->hard_max : p->hard_min}}};
      if (p->kind == SOZAI_KIND_CHOICE) v[2].text = p->choices[k];
      sozai_geometry *g = NULL;
      int32_t r = geometry()->grow(NULL, "tree", "akamatsu", v, 3, &g);
      if (r == SOZAI_OK) {
        const sozai_mesh *m = mesh_of(g, 0);
        for (uint64_t n = 0; n < 3 * m->point_count; n++) {
          if (!(m->points[n] > -1e7f && m->points[n] < 1e7f))
            fail_msg("%s=%g: a point at %g", p->id, v[2].number[0], (double)m->points[n]);
        }
        geometry()->release_mesh(m);
        geometry()->release(g);
        grown++;
      } else {
        assert_true(strlen(geometry()->last_error()) > 10);
        refused++;
      }
    }
  }
  print_message("%u grown, %u refused\n", grown, refused);
  assert_true(grown > 100);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(values), cmocka_unit_test(arguments),
                                     cmocka_unit_test(both_ends)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
