/* SPDX-License-Identifier: Apache-2.0
 *
 * Reading a field table. A heading names a block, "trunk" first and then the
 * branches, each after its parent; below it stands a line for each node from
 * the ground: 0 where the branch is not yet there, then
 *   length cm, azimuth deg, elevation deg[, diameter cm]
 * of each of its segments. # begins a comment.
 */
#include "field.h"

#include <string.h>

#include "../core/status.h"

#define ORDERS_MOST 3
#define ROWS_MOST 400u /* in a block */

typedef struct {
  tree_field *field;
  const char *line, *end; /* of the present line */
  uint32_t number;        /* of it, from 1 */
} reader;

static uint32_t column(const reader *r, const char *at) { return (uint32_t)(at - r->line) + 1; }

__attribute__((format(printf, 3, 4))) static int32_t refuse(const reader *r, const char *at,
                                                            const char *format, ...) {
  char text[256];
  __builtin_va_list list;
  __builtin_va_start(list, format);
  __builtin_vsnprintf(text, sizeof text, format, list);
  __builtin_va_end(list);
  return fail(SOZAI_ERROR_FILE, "field: line %u, column %u: %s", r->number, column(r, at), text);
}

static int is_blank(char c) { return c == ' ' || c == '\t' || c == ',' || c == '\r'; }

static const char *skip(const reader *r, const char *s) {
  while (s < r->end && is_blank(*s)) s++;
  return s;
}

static const char *word(const reader *r, const char *s) {
  while (s < r->end && !is_blank(*s)) s++;
  return s;
}

/* ---- headings ---------------------------------------------------------- */

/* "B110" by digits, or "B12.3" by numbers, into numbers from 1 up. */
static int32_t read_name(const reader *r, const char *s, const char *e, uint32_t path[ORDERS_MOST],
                         uint32_t *order) {
  const char *begin = s++;
  int dotted = memchr(s, '.', (size_t)(e - s)) != NULL;
  uint32_t n = 0, zeros = 0;
  *order = 0;
  if (s == e) return refuse(r, begin, "a branch is named as in B100, B110 or B12.3");
  while (s < e) {
    uint32_t value = 0;
    const char *from = s;
    do {
      if (*s < '0' || *s > '9' || value > 99999) {
        return refuse(r, s, "\"%.*s\" is no branch's name: B and digits, as in B110 or B12.3",
                      (int)(e - begin > 30 ? 30 : e - begin), begin);
      }
      value = value * 10 + (uint32_t)(*s++ - '0');
    } while (dotted && s < e && *s != '.');
    if (dotted && s < e && ++s == e) return refuse(r, s - 1, "a number is missing after the dot");
    n++;
    if (value == 0) {
      zeros++;
      continue;
    }
    if (zeros) return refuse(r, from, "%u after a 0: the order before it has no number", value);
    if (n > ORDERS_MOST) {
      return refuse(r, from, "order %u is beyond %d, the highest that is read", n, ORDERS_MOST);
    }
    path[(*order)++] = value;
  }
  return *order ? SOZAI_OK : refuse(r, begin, "all its numbers are 0: trunk, or B100, B200 ...");
}

static int same_name(const field_block *b, const char *name) { return strcmp(b->name, name) == 0; }

static void print_name(char out[24], const uint32_t *path, uint32_t order) {
  static const char digits[] = "0123456789";
  char *at = out;
  if (order == 0) {
    memcpy(out, "trunk", 6);
    return;
  }
  *at++ = 'B';
  for (uint32_t i = 0; i < order; i++) {
    char back[8];
    int n = 0;
    for (uint32_t v = path[i]; v; v /= 10) back[n++] = digits[v % 10];
    if (i) *at++ = '.';
    while (n) *at++ = back[--n];
  }
  *at = 0;
}

static int32_t read_heading(reader *r, const char *s, const char *e) {
  tree_field *f = r->field;
  field_block *b = &f->blocks[f->block_count];
  uint32_t path[ORDERS_MOST], order = 0;
  const char *after = skip(r, e);
  if (after < r->end) {
    return refuse(r, after, "nothing follows a heading, but here is \"%.*s\"",
                  (int)(word(r, after) - after > 30 ? 30 : word(r, after) - after), after);
  }
  if (*s == 'B') {
    int32_t code = read_name(r, s, e, path, &order);
    if (code) return code;
  }
  memset(b, 0, sizeof *b);
  print_name(b->name, path, order);
  b->order = order;
  b->first = f->row_count;
  b->parent = TREE_NONE;
  for (uint32_t i = 0; i < f->block_count; i++) {
    if (same_name(&f->blocks[i], b->name)) return refuse(r, s, "%s stands twice", b->name);
  }
  if (order == 0 && f->block_count) return refuse(r, s, "the trunk comes first");
  if (order && !f->block_count)
    return refuse(r, s, "%s before the trunk, which comes first", b->name);
  if (order) {
    char name[24];
    print_name(name, path, order - 1);
    for (uint32_t i = 0; i < f->block_count; i++) {
      if (same_name(&f->blocks[i], name)) b->parent = i;
    }
    if (b->parent == TREE_NONE) {
      return refuse(r, s, "%s before its parent %s", b->name, name);
    }
  }
  f->block_count++;
  return SOZAI_OK;
}

/* ---- rows -------------------------------------------------------------- */

static const struct {
  const char *name, *unit;
  double least, most;
} measures[4] = {{"length", "cm", 0.01, 20000.0},
                 {"azimuth", "deg", 0.0, 360.0},
                 {"elevation", "deg", -90.0, 90.0},
                 {"diameter", "cm", 0.0, 2000.0}};

static int32_t read_measures(reader *r, const char *s, field_row *out) {
  double value[4] = {0, 0, 0, 0};
  const char *row = s;
  int n = 0;
  for (; s < r->end; n++) {
    const char *e = word(r, s);
    if (n == 4)
      return refuse(r, s, "a fifth value: length, azimuth, elevation and diameter are all");
    int missing = n == 3 && e - s == 1 && *s == '-';
    if (!missing && !read_number(s, e, &value[n])) {
      return refuse(r, s, "\"%.*s\" is no number, wanted is %s in %s",
                    (int)(e - s > 30 ? 30 : e - s), s, measures[n].name, measures[n].unit);
    }
    /* so that NaN fails */
    if (!missing && !(value[n] >= measures[n].least && value[n] <= measures[n].most)) {
      return refuse(r, s, "%s %.9g is outside %g to %g %s", measures[n].name, value[n],
                    measures[n].least, measures[n].most, measures[n].unit);
    }
    s = skip(r, e);
  }
  if (n < 3) {
    return refuse(r, row, "%d value%s: length, azimuth and elevation are wanted, or 0", n,
                  n == 1 ? "" : "s");
  }
  *out = (field_row){value[0], value[1], value[2], value[3]};
  return SOZAI_OK;
}

static int32_t read_row(reader *r, const char *s, const char *e) {
  tree_field *f = r->field;
  if (!f->block_count) return refuse(r, s, "values before the heading \"trunk\"");
  field_block *b = &f->blocks[f->block_count - 1];
  if (b->rows >= ROWS_MOST || b->node > 100 * ROWS_MOST) {
    return refuse(r, s, "%s has more than %u nodes", b->name, ROWS_MOST);
  }
  if (e - s == 1 && *s == '0' && skip(r, e) == r->end) {
    if (b->order == 0) return refuse(r, s, "0: the trunk has no empty node");
    if (b->rows) return refuse(r, s, "0 within %s: its segments follow one another", b->name);
    b->node++;
    return SOZAI_OK;
  }
  int32_t code = read_measures(r, s, &f->lines[f->row_count]);
  if (code) return code;
  const field_block *parent = b->order ? &f->blocks[b->parent] : NULL;
  uint32_t low = parent ? parent->node + (parent->order != 0) : 0;
  if (parent && !b->rows && (b->node < low || b->node > parent->node + parent->rows)) {
    return refuse(r, s, "%s begins at node %u, but %s has the nodes %u to %u", b->name, b->node,
                  parent->name, low, parent->node + parent->rows);
  }
  f->row_count++;
  b->rows++;
  return SOZAI_OK;
}

/* ---- the whole --------------------------------------------------------- */

/* A block is done when the next begins, and at the end. */
static int32_t check_block(const reader *r, const char *at) {
  const tree_field *f = r->field;
  if (!f->block_count || f->blocks[f->block_count - 1].rows) return SOZAI_OK;
  return refuse(r, at, "%s above has no segment", f->blocks[f->block_count - 1].name);
}

static int32_t read_line(reader *r) {
  const char *comment = memchr(r->line, '#', (size_t)(r->end - r->line));
  const char *end = r->end;
  if (comment) r->end = comment;
  const char *s = skip(r, r->line);
  int32_t code = SOZAI_OK;
  if (s < r->end) {
    const char *e = word(r, s);
    int heading = *s == 'B' || (e - s == 5 && memcmp(s, "trunk", 5) == 0);
    if (heading) code = check_block(r, s);
    if (!code) code = heading ? read_heading(r, s, e) : read_row(r, s, e);
  }
  r->end = end;
  return code;
}

int32_t field_read(tree_field *f, const sozai_host *host, const char *text) {
  uint32_t lines = 1;
  for (const char *s = text; *s; s++) lines += *s == '\n';
  f->block_room = f->row_room = lines + 1;
  f->blocks = host_alloc(host, f->block_room * sizeof *f->blocks, 64);
  f->lines = f->blocks ? host_alloc(host, f->row_room * sizeof *f->lines, 64) : NULL;
  if (!f->lines) return SOZAI_ERROR_MEMORY;
  reader r = {.field = f, .line = text};
  for (;;) {
    r.number++;
    const char *newline = strchr(r.line, '\n');
    r.end = newline ? newline : r.line + strlen(r.line);
    int32_t code = read_line(&r);
    if (code) return code;
    if (!newline) break;
    r.line = newline + 1;
  }
  if (!f->block_count) return refuse(&r, r.line, "there is no trunk");
  return check_block(&r, r.line);
}

void field_free(tree_field *f, const sozai_host *host) {
  host_free(host, f->blocks, f->block_room * sizeof *f->blocks, 64);
  host_free(host, f->lines, f->row_room * sizeof *f->lines, 64);
  memset(f, 0, sizeof *f);
}
