/* SPDX-License-Identifier: Apache-2.0 */
#include "tree.h"

#include <stdio.h>

int32_t grow_code(const sozai_host *host, const char *preset, const char *text, const char *field,
                  sozai_geometry **out) {
  char copy[1024];
  sozai_value values[32];
  uint32_t count = values_of(text, copy, values, 31);
  if (field) values[count++] = (sozai_value){.id = "field", .kind = SOZAI_KIND_TEXT, .text = field};
  return geometry()->grow(host, "tree", preset, values, count, out);
}

sozai_geometry *grow(const char *preset, const char *values, const char *field) {
  sozai_geometry *g = NULL;
  int32_t r = grow_code(NULL, preset, values, field, &g);
  return expect_grown(r, g);
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
