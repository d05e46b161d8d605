/* SPDX-License-Identifier: Apache-2.0
 * eval's table: its header, and lines of numbers in blocks whose size the first byte says. */
#include "fuzz.h"

#include <string.h>
#include "columns.h"

bool cancel_requested(void) { return false; }

static void read_lines(csv_lines *lines, const columns *c, uint32_t block) {
  failure why;
  uint64_t line = lines->numbers[0]; /* the header's */
  while (csv_next(lines, block, &why) && lines->count > 0) {
    CHECK(lines->count <= block && lines->numbers[0] > line);
    line = lines->numbers[lines->count - 1];
    CHECK(line < lines->next_line);
    for (uint32_t i = 0; i < lines->count; i++) {
      float out[COLUMNS];
      int bad_field;
      uint32_t fields;
      const char *text = csv_line(lines, i);
      CHECK(strlen(text) <= CSV_LONGEST_LINE);
      if (!csv_numbers(text, out, c->count, &bad_field, &fields))
        CHECK(bad_field < (int)c->count && (bad_field >= 0 || fields != c->count));
    }
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (size < 2) return 0;
  uint32_t block = 1 + data[0] % 64u;
  FILE *file = fmemopen((void *)(uintptr_t)(data + 1), size - 1, "rb");
  CHECK(file);
  csv_lines lines;
  columns c;
  failure why = {0, ""};
  CHECK(csv_open(&lines, file, "table.csv", block, &why));
  if (columns_read(&c, &lines, &why)) {
    CHECK(c.count >= 3 && c.count <= COLUMNS);
    read_lines(&lines, &c, block);
  } else
    CHECK(*why.text && !strchr(why.text, '\n'));
  csv_close(&lines);
  fclose(file);
  return 0;
}
