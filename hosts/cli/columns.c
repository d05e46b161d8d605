/* SPDX-License-Identifier: Apache-2.0 */
#include "columns.h"

#include <stdlib.h>
#include <string.h>

const char *const column_names[COLUMNS] = {"px", "py", "pz", "nx", "ny", "nz", "lx", "ly",
                                           "lz", "lr", "lg", "lb", "vx", "vy", "vz", "footprint"};
#define FOOTPRINT 15

uint32_t column_bit(uint32_t column) { return 1u << column / 3; }

static unsigned long long header_line(const csv_lines *lines) { return lines->numbers[0]; }

static bool take(columns *c, const csv_lines *lines, char *name, failure *why) {
  while (*name == ' ' || *name == '\t') name++;
  size_t length = strlen(name);
  while (length > 0 && (name[length - 1] == ' ' || name[length - 1] == '\t')) name[--length] = 0;
  uint32_t column = 0;
  while (column < COLUMNS && strcmp(column_names[column], name) != 0) column++;
  if (column == COLUMNS)
    return fail(why, EXIT_BAD_INPUT,
                "%s:%llu: unknown column '%.40s'; there is px,py,pz,nx,ny,nz,lx,ly,lz,lr,lg,lb,"
                "vx,vy,vz,footprint",
                lines->name, header_line(lines), name);
  for (uint32_t i = 0; i < c->count; i++)
    if (c->input[i] == column)
      return fail(why, EXIT_BAD_INPUT, "%s:%llu: column '%s' stands twice", lines->name,
                  header_line(lines), name);
  c->input[c->count++] = column;
  return true;
}

/* A vector needs all its three columns, and the point must be there. */
static bool check(columns *c, const csv_lines *lines, failure *why) {
  bool have[COLUMNS] = {false};
  for (uint32_t i = 0; i < c->count; i++) {
    have[c->input[i]] = true;
    c->inputs |= column_bit(c->input[i]);
  }
  for (uint32_t i = 0; i < FOOTPRINT; i++)
    if (!have[i] && (i < 3 || (c->inputs & column_bit(i))))
      return fail(why, EXIT_BAD_INPUT, "%s:%llu: column '%s' is missing", lines->name,
                  header_line(lines), column_names[i]);
  return true;
}

bool columns_read(columns *c, csv_lines *lines, failure *why) {
  memset(c, 0, sizeof *c);
  if (!csv_next(lines, 1, why)) return false;
  if (lines->count == 0)
    return fail(why, EXIT_BAD_INPUT, "%s: empty input; it begins with a header: px,py,pz,...",
                lines->name);
  char *copy = strdup(csv_line(lines, 0));
  if (!copy) return fail(why, EXIT_FAILURE, "out of memory");
  char *rest = copy;
  if (strncmp(rest, "\xef\xbb\xbf", 3) == 0) rest += 3; /* spreadsheets write a byte-order mark */
  bool ok = true;
  for (char *name; ok && (name = strsep(&rest, ","));) ok = take(c, lines, name, why);
  free(copy);
  return ok && check(c, lines, why);
}
