/* SPDX-License-Identifier: Apache-2.0 */
#include "growing.h"

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

uint32_t values_of(const char *text, char copy[1024], sozai_value *out, uint32_t most) {
  uint32_t count = 0;
  assert_true(snprintf(copy, 1024, "%s", text) < 1024);
  for (char *rest = copy, *word; (word = strtok_r(rest, " ", &rest));) {
    char *equals = strchr(word, '=');
    assert_non_null(equals);
    assert_true(count < most);
    *equals = 0;
    out[count++] = (sozai_value){.id = word, .kind = SOZAI_KIND_STRING, .text = equals + 1};
  }
  return count;
}

sozai_geometry *expect_grown(int32_t code, sozai_geometry *g) {
  if (code) print_error("%s\n", geometry()->last_error());
  assert_int_equal(code, SOZAI_OK);
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

uint64_t fold(uint64_t hash, const void *data, size_t bytes) {
  const uint8_t *at = data;
  for (size_t i = 0; i < bytes; i++) hash = (hash ^ at[i]) * 0x100000001b3ull;
  return hash;
}

int32_t backwards(void *user, uint32_t count, void (*task)(void *context, uint32_t i),
                  void *context) {
  (void)user;
  for (uint32_t i = count; i > 0; i--) task(context, i - 1);
  return 0;
}

int32_t refuse(void *user, uint32_t count, void (*task)(void *context, uint32_t i), void *context) {
  (void)user, (void)count, (void)task, (void)context;
  return 1;
}

int32_t give_up(void *user, uint32_t count, void (*task)(void *context, uint32_t i),
                void *context) {
  (void)user;
  for (uint32_t i = 0; i < (count + 1) / 2; i++) task(context, i);
  return 1;
}

int32_t drop(void *user, uint32_t count, void (*task)(void *context, uint32_t i), void *context) {
  (void)user;
  for (uint32_t i = 0; i < count; i += 2) task(context, i);
  return 0;
}

float furthest;
int32_t told(void *user, float fraction, const char *what) {
  (void)user, (void)what;
  furthest = fmaxf(furthest, fraction);
  return 0;
}
