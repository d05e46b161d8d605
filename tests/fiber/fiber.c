/* SPDX-License-Identifier: Apache-2.0 */
#include "fiber.h"

#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include "parallel.h"

const sozai_geometry_1 *geometry(void) {
  static const sozai_geometry_1 *table;
  if (table) return table;
  void *library = dlopen(SOZAI_TEST_PLUGIN, RTLD_NOW | RTLD_LOCAL);
  assert_non_null(library);
  const sozai_entry_v1 *entry = dlsym(library, SOZAI_ENTRY_SYMBOL);
  assert_int_equal(entry->init("/nonexistent/sozai.so"), SOZAI_OK);
  table = entry->get_factory(SOZAI_GEOMETRY_1);
  assert_non_null(table);
  return table;
}

sozai_buffer buffer_of(const mesh *m) {
  return (sozai_buffer){.size = sizeof(sozai_buffer),
                        .kind = SOZAI_BUFFER_MESH,
                        .dims = {m->point_count, m->triangle_count},
                        .points = m->points,
                        .indices = m->indices};
}

int32_t grow_buffer(const sozai_host *host, const char *preset, const sozai_buffer *hull,
                    const char *text, sozai_geometry **out) {
  char copy[1024];
  sozai_value values[48];
  uint32_t count = 0;
  snprintf(copy, sizeof copy, "%s", text);
  for (char *rest = copy, *word; (word = strtok_r(rest, " ", &rest));) {
    char *equals = strchr(word, '=');
    assert_non_null(equals);
    *equals = 0;
    values[count++] = (sozai_value){.id = word, .kind = SOZAI_KIND_STRING, .text = equals + 1};
  }
  const char *id = hull && hull->kind == SOZAI_BUFFER_POINTS ? "hull_points" : "hull";
  if (hull) values[count++] = (sozai_value){.id = id, .kind = SOZAI_KIND_BUFFER, .buffer = hull};
  return geometry()->grow(host, "fiber", preset, values, count, out);
}

int32_t grow_code(const sozai_host *host, const mesh *hull, const char *values,
                  sozai_geometry **out) {
  sozai_buffer b = buffer_of(hull);
  return grow_buffer(host, NULL, &b, values, out);
}

static int32_t run_parallel(void *user, uint32_t count, void (*task)(void *context, uint32_t i),
                            void *context) {
  (void)user;
  parallel_for(2, count, task, context);
  return 0;
}

sozai_host two_threads(void) {
  return (sozai_host){.size = sizeof(sozai_host), .parallel = run_parallel};
}

sozai_geometry *grow(const mesh *hull, const char *values) {
  sozai_geometry *g = NULL;
  sozai_host host = two_threads();
  int32_t r = grow_code(&host, hull, values, &g);
  if (r) print_error("%s\n", geometry()->last_error());
  assert_int_equal(r, SOZAI_OK);
  assert_non_null(g);
  return g;
}

mesh hull_of(const char *name) {
  mesh m;
  failure why;
  assert_true(hull_make_named(&m, name, &why));
  return m;
}

mesh box_of(double x, double y, double z) {
  mesh m;
  failure why;
  const double size[3] = {x, y, z};
  assert_true(hull_make_box(&m, size, 1, &why));
  return m;
}

sozai_table table_of(const sozai_geometry *g, const char *id) {
  sozai_table t = {.size = sizeof t};
  assert_int_equal(geometry()->table(g, id, &t), SOZAI_OK);
  return t;
}

double cell(const sozai_table *t, uint64_t row, const char *column) {
  assert_true(row < t->rows);
  for (uint32_t i = 0; i < t->info->column_count; i++)
    if (strcmp(t->info->columns[i].id, column) == 0)
      return (double)t->data[row * t->info->column_count + i];
  fail_msg("no column %s", column);
  return NAN;
}

double statistic(const sozai_geometry *g, const char *column) {
  sozai_table t = table_of(g, "statistics");
  return cell(&t, 0, column);
}

const sozai_curves *curves_of(const sozai_geometry *g) {
  const sozai_curves *c = NULL;
  assert_int_equal(geometry()->curves(g, NULL, &c), SOZAI_OK);
  return c;
}

uint64_t fold(uint64_t hash, const void *data, size_t bytes) {
  const uint8_t *at = data;
  for (size_t i = 0; i < bytes; i++) hash = (hash ^ at[i]) * 0x100000001b3ull;
  return hash;
}
