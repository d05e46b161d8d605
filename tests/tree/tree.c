/* SPDX-License-Identifier: Apache-2.0 */
#include "tree.h"

#include <dlfcn.h>
#include <math.h>
#include <stdio.h>

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

int32_t grow_code(const sozai_host *host, const char *preset, const char *text, const char *field,
                  sozai_geometry **out) {
  char copy[1024];
  sozai_value values[32];
  uint32_t count = 0;
  snprintf(copy, sizeof copy, "%s", text);
  for (char *rest = copy, *word; (word = strtok_r(rest, " ", &rest));) {
    char *equals = strchr(word, '=');
    assert_non_null(equals);
    *equals = 0;
    values[count++] = (sozai_value){.id = word, .kind = SOZAI_KIND_STRING, .text = equals + 1};
  }
  if (field) values[count++] = (sozai_value){.id = "field", .kind = SOZAI_KIND_TEXT, .text = field};
  return geometry()->grow(host, "tree", preset, values, count, out);
}

sozai_geometry *grow(const char *preset, const char *values, const char *field) {
  sozai_geometry *g = NULL;
  int32_t r = grow_code(NULL, preset, values, field, &g);
  if (r) print_error("%s\n", geometry()->last_error());
  assert_int_equal(r, SOZAI_OK);
  assert_non_null(g);
  return g;
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

char *field_text(const sozai_geometry *g) {
  sozai_table t = table_of(g, "nodes");
  size_t room = 200 * (t.rows + 1) + 65536, used = 0;
  char *text = malloc(room);
  double last = -1;
  uint32_t branches = 0;
  assert_non_null(text);
  for (uint64_t i = 0; i < t.rows; i++) {
    double block = cell(&t, i, "block");
    if (block > last) {
      used += (size_t)(block > 0 ? snprintf(text + used, room - used, "B%u.0\n", ++branches)
                                 : snprintf(text + used, room - used, "trunk\n"));
      for (int n = (int)cell(&t, i, "node"); block > 0 && n > 0; n--)
        used += (size_t)snprintf(text + used, room - used, "0\n");
    }
    last = block;
    used +=
        (size_t)snprintf(text + used, room - used, "%.6f %.5f %.5f %.5f\n", cell(&t, i, "length"),
                         cell(&t, i, "azimuth"), cell(&t, i, "elevation"), cell(&t, i, "diameter"));
    assert_true(used + 4096 < room);
  }
  return text;
}

const sozai_curves *curves_of(const sozai_geometry *g, uint32_t level) {
  const sozai_detail detail = {.size = sizeof detail, .level = level};
  const sozai_curves *c = NULL;
  assert_int_equal(geometry()->curves(g, &detail, &c), SOZAI_OK);
  return c;
}

const sozai_mesh *mesh_of(const sozai_geometry *g, uint32_t level) {
  const sozai_detail detail = {.size = sizeof detail, .level = level};
  const sozai_mesh *m = NULL;
  assert_int_equal(geometry()->mesh(g, &detail, &m), SOZAI_OK);
  return m;
}

uint64_t fold(uint64_t hash, const void *data, size_t bytes) {
  const uint8_t *at = data;
  for (size_t i = 0; i < bytes; i++) hash = (hash ^ at[i]) * 0x100000001b3ull;
  return hash;
}
