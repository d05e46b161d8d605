/* SPDX-License-Identifier: Apache-2.0 */
#include "growth.h"
#include "ceilings.h"

#include <errno.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

const sozai_geometry_1 *growth_table(const sozai_entry_v1 *entry, failure *why) {
  const sozai_geometry_1 *table = entry->get_factory(SOZAI_GEOMETRY_1);
  if (!table) fail(why, EXIT_FAILURE, "the plugin has no factory %s", SOZAI_GEOMETRY_1);
  return table;
}

bool growth_failed(const sozai_geometry_1 *table, int32_t code, failure *why) {
  bool mend = code == SOZAI_ERROR_UNKNOWN || code == SOZAI_ERROR_KIND ||
              code == SOZAI_ERROR_RANGE || code == SOZAI_ERROR_FILE || code == SOZAI_ERROR_LIMIT;
  return fail(why, mend ? EXIT_BAD_INPUT : EXIT_FAILURE, "%s", table->last_error());
}

bool growth_grow_with(const sozai_geometry_1 *table, const sozai_host *host, const char *id,
                      const char *preset, const char *const *pairs, size_t pair_count,
                      const sozai_value *more, size_t more_count, sozai_geometry **out,
                      failure *why) {
  sozai_value *values = calloc(pair_count + more_count + 1, sizeof *values);
  char **names = calloc(pair_count + 1, sizeof *names);
  bool ok = (values && names) || fail(why, EXIT_FAILURE, "out of memory");
  uint32_t count = 0;
  for (size_t i = 0; ok && i < pair_count; i++) {
    const char *equals = strchr(pairs[i], '=');
    if (!equals || equals == pairs[i]) {
      ok = fail(why, EXIT_BAD_INPUT, "-p %s: not NAME=VALUE", pairs[i]);
      break;
    }
    names[i] = strndup(pairs[i], (size_t)(equals - pairs[i]));
    ok = names[i] || fail(why, EXIT_FAILURE, "out of memory");
    values[count++] = (sozai_value){.id = names[i], .kind = SOZAI_KIND_STRING, .text = equals + 1};
  }
  for (size_t i = 0; ok && i < more_count; i++) values[count++] = more[i];
  if (ok) {
    int32_t code = table->grow(host, id, preset, values, count, out);
    ok = code == SOZAI_OK || growth_failed(table, code, why);
  }
  for (size_t i = 0; names && i < pair_count; i++) free(names[i]);
  free(names);
  free(values);
  return ok;
}

bool growth_grow(const sozai_geometry_1 *table, const sozai_host *host, const char *id,
                 const char *preset, const char *const *pairs, size_t pair_count, const char *field,
                 sozai_geometry **out, failure *why) {
  const sozai_value text = {.id = "field", .kind = SOZAI_KIND_TEXT, .text = field};
  return growth_grow_with(table, host, id, preset, pairs, pair_count, &text, field ? 1 : 0, out,
                          why);
}

bool growth_read_text(const char *path, char **out, failure *why) {
  *out = NULL;
  FILE *f = fopen(path, "rb");
  if (!f) return fail(why, EXIT_BAD_INPUT, "cannot read '%s': %s", path, strerror(errno));
  char *text = malloc(FIELD_MOST + 2);
  size_t n = text ? fread(text, 1, FIELD_MOST + 1, f) : 0;
  bool failed = ferror(f) != 0;
  fclose(f);
  bool ok = text || fail(why, EXIT_FAILURE, "out of memory");
  if (ok && failed) ok = fail(why, EXIT_BAD_INPUT, "cannot read '%s': not a file of text", path);
  if (ok && n > FIELD_MOST)
    ok = fail(why, EXIT_BAD_INPUT, "'%s' is longer than %d B, the ceiling field_bytes", path,
              FIELD_MOST);
  if (ok && memchr(text, 0, n))
    ok = fail(why, EXIT_BAD_INPUT, "'%s' holds a zero byte: not a file of text", path);
  if (!ok) {
    free(text);
    return false;
  }
  text[n] = '\0';
  *out = text;
  return true;
}

bool growth_name_field(const char *path, failure *why) {
  static const char of_text[] = "field: line ";
  if (!path || strncmp(why->text, of_text, sizeof of_text - 1) != 0) return false;
  char text[sizeof why->text];
  memcpy(text, why->text, sizeof text);
  return fail(why, why->exit_code, "--field: %s: %s", path, text + strlen("field: "));
}

bool growth_rows(const sozai_geometry_1 *table, const sozai_geometry *g, const char *id,
                 sozai_table *out, failure *why) {
  *out = (sozai_table){.size = sizeof *out};
  int32_t code = table->table(g, id, out);
  return code == SOZAI_OK || growth_failed(table, code, why);
}

double growth_number(const sozai_table *t, uint64_t row, const char *column) {
  const sozai_table_info *info = t->info;
  for (uint32_t i = 0; row < t->rows && i < info->column_count; i++)
    if (strcmp(info->columns[i].id, column) == 0)
      return (double)t->data[row * info->column_count + i];
  return NAN;
}

/* A struct of another time is read as far as it goes. */
#define REACHES(s, type, member)                                                                   \
  ((s)->size >= offsetof(type, member) + sizeof((const type *)0)->member)

const float *growth_mesh_colours(const sozai_mesh *m) {
  return REACHES(m, sozai_mesh, colours) ? m->colours : NULL;
}

const float *growth_curves_colours(const sozai_curves *c) {
  return REACHES(c, sozai_curves, colours) ? c->colours : NULL;
}

bool growth_part_varies(const sozai_mesh *m, uint32_t part) {
  const float *colours = growth_mesh_colours(m);
  const sozai_part *p = &m->parts[part];
  for (uint64_t i = 3 * p->first; colours && i < 3 * (p->first + p->count); i++)
    for (uint64_t c = 0; c < 3; c++)
      if (fabsf(colours[3 * (uint64_t)m->indices[i] + c] - p->colour[c]) > 1e-6f) return true;
  return false;
}
