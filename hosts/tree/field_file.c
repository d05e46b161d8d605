/* SPDX-License-Identifier: Apache-2.0
 * Tables as text: field tables (docs/tree.md), and any table as CSV. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "ceilings.h"
#include "growth.h"
#include "text_file.h"

/* A block's name from those before it: trunk, B7, B7.2, ... */
static void name_blocks(const sozai_table *nodes, char (*names)[40], uint32_t *children,
                        int64_t blocks) {
  int64_t last = -1;
  for (uint64_t i = 0; i < nodes->rows; i++) {
    int64_t block = (int64_t)growth_number(nodes, i, "block");
    int64_t parent = (int64_t)growth_number(nodes, i, "parent");
    if (block == last || block < 0 || block >= blocks) continue;
    last = block;
    if (parent < 0)
      snprintf(names[block], sizeof names[block], "trunk");
    else if (parent == 0)
      snprintf(names[block], sizeof names[block], "B%u.0", ++children[0]);
    else {
      /* the parent's, without its last ".0" */
      char from[24];
      memcpy(from, names[parent], sizeof from - 1);
      from[sizeof from - 1] = 0;
      size_t length = strlen(from);
      if (length > 2 && strcmp(from + length - 2, ".0") == 0) from[length - 2] = 0;
      snprintf(names[block], sizeof names[block], "%s.%u", from, ++children[parent]);
    }
  }
}

bool write_field(const sozai_table *nodes, const char *path, failure *why) {
  int64_t blocks = 1;
  for (uint64_t i = 0; i < nodes->rows; i++) {
    int64_t block = (int64_t)growth_number(nodes, i, "block");
    if (block >= blocks) blocks = block + 1;
  }
  char(*names)[40] = calloc((size_t)blocks, sizeof *names);
  uint32_t *children = calloc((size_t)blocks, sizeof *children);
  text_file t;
  bool ok = (names && children) || fail(why, EXIT_FAILURE, "out of memory");
  ok = ok && text_open(&t, path, why);
  if (!ok) {
    free(names);
    free(children);
    return false;
  }
  name_blocks(nodes, names, children, blocks);
  text_put(&t, "# length cm, azimuth deg, elevation deg, diameter cm\n");
  int64_t last = -1;
  for (uint64_t i = 0; i < nodes->rows && t.put <= FIELD_MOST; i++) {
    int64_t block = (int64_t)growth_number(nodes, i, "block");
    if (block != last) {
      text_put(&t, names[block]);
      text_put(&t, "\n");
      for (int64_t n = (int64_t)growth_number(nodes, i, "node"); block && n > 0; n--)
        text_put(&t, "0\n");
    }
    last = block;
    static const char *const columns[] = {"length", "azimuth", "elevation", "diameter"};
    for (int c = 0; c < 4; c++) {
      if (c) text_put(&t, " ");
      text_fine(&t, growth_number(nodes, i, columns[c]));
    }
    text_put(&t, "\n");
  }
  free(names);
  free(children);
  bool fits = t.put <= FIELD_MOST;
  if (!text_close(&t, why)) return false;
  return fits ||
         fail(why, EXIT_BAD_INPUT,
              "--output: the tree's field table is longer than %d B, the ceiling field_bytes "
              "of what reads one: grow a younger tree",
              FIELD_MOST);
}

bool write_csv(const sozai_table *table, const char *path, failure *why) {
  text_file t;
  if (!text_open(&t, path, why)) return false;
  uint32_t columns = table->info->column_count;
  for (uint32_t c = 0; c < columns; c++) {
    if (c) text_put(&t, ",");
    text_put(&t, table->info->columns[c].id);
  }
  text_put(&t, "\n");
  for (uint64_t i = 0; i < table->rows; i++)
    for (uint32_t c = 0; c < columns; c++) {
      text_fine(&t, (double)table->data[i * columns + c]);
      text_put(&t, c + 1 < columns ? "," : "\n");
    }
  return text_close(&t, why);
}
