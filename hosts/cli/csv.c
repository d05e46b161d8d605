/* SPDX-License-Identifier: Apache-2.0 */
#include "csv.h"

#include <stdlib.h>
#include <string.h>
#include "cancel.h"

#define CHUNK 65536
/* A block ends early at this size, however few its lines. */
#define BLOCK_BYTES ((size_t)8 << 20)

bool csv_open(csv_lines *lines, FILE *file, const char *name, uint32_t most, failure *why) {
  *lines = (csv_lines){.file = file, .name = name, .size = 2 * CHUNK, .room = most, .next_line = 1};
  lines->text = malloc(lines->size);
  lines->starts = malloc(most * sizeof *lines->starts);
  lines->numbers = malloc(most * sizeof *lines->numbers);
  if (lines->text && lines->starts && lines->numbers) return true;
  csv_close(lines);
  return fail(why, EXIT_FAILURE, "out of memory");
}

void csv_close(csv_lines *lines) {
  free(lines->text);
  free(lines->starts);
  free(lines->numbers);
  memset(lines, 0, sizeof *lines);
}

/* Read another chunk behind what there is. */
static bool read_more(csv_lines *lines, failure *why) {
  if (lines->size - lines->used < CHUNK + 1) {
    size_t size = 2 * lines->size + 2 * CHUNK;
    char *text = realloc(lines->text, size);
    if (!text) return fail(why, EXIT_FAILURE, "out of memory");
    lines->text = text;
    lines->size = size;
  }
  size_t got = fread(lines->text + lines->used, 1, CHUNK, lines->file);
  lines->used += got;
  if (got == CHUNK) return true;
  if (cancel_requested()) return fail(why, EXIT_FAILURE, "cancelled");
  if (ferror(lines->file)) return fail(why, EXIT_BAD_INPUT, "cannot read %s", lines->name);
  lines->ended = feof(lines->file) != 0;
  return true;
}

static bool is_space(char c) { return c == ' ' || c == '\t'; }

static bool is_blank(const char *line) {
  while (is_space(*line)) line++;
  return !*line;
}

/* Keep the line from lines->done of that length, if there is anything on it; `whole` counts its
 * newline. */
static bool keep_line(csv_lines *lines, size_t length, size_t whole, failure *why) {
  char *line = lines->text + lines->done;
  if (memchr(line, '\0', length))
    return fail(why, EXIT_BAD_INPUT, "%s:%llu: a zero byte: not text", lines->name,
                (unsigned long long)lines->next_line);
  line[length] = '\0';
  if (length > 0 && line[length - 1] == '\r') line[length - 1] = '\0';
  if (!is_blank(line)) {
    lines->starts[lines->count] = lines->done;
    lines->numbers[lines->count++] = lines->next_line;
  }
  lines->next_line++;
  lines->done += whole;
  return true;
}

static bool next_block(csv_lines *lines, uint32_t most, failure *why) {
  lines->used -= lines->done;
  if (lines->done) memmove(lines->text, lines->text + lines->done, lines->used);
  lines->done = 0;
  size_t searched = 0; /* bytes beyond `done` known to hold no newline */
  while (lines->count < most && lines->done < BLOCK_BYTES) {
    size_t left = lines->used - lines->done;
    char *start = lines->text + lines->done;
    char *end = left > searched ? memchr(start + searched, '\n', left - searched) : NULL;
    size_t length = end ? (size_t)(end - start) : left;
    if (length > CSV_LONGEST_LINE)
      return fail(why, EXIT_BAD_INPUT, "%s:%llu: longer than %d characters", lines->name,
                  (unsigned long long)lines->next_line, CSV_LONGEST_LINE);
    if (end) {
      if (!keep_line(lines, length, length + 1, why)) return false;
      searched = 0;
    } else if (lines->ended) {
      return left == 0 || keep_line(lines, left, left, why);
    } else {
      searched = left;
      if (!read_more(lines, why)) return false;
    }
  }
  return true;
}

bool csv_next(csv_lines *lines, uint32_t most, failure *why) {
  lines->count = 0;
  do { /* a block may be blank lines alone */
    if (!next_block(lines, most < lines->room ? most : lines->room, why)) return false;
  } while (lines->count == 0 && !(lines->ended && lines->done == lines->used));
  return true;
}

const char *csv_line(const csv_lines *lines, uint32_t index) {
  return lines->text + lines->starts[index];
}

bool csv_numbers(const char *line, float *out, uint32_t count, int *bad_field, uint32_t *fields) {
  uint32_t found = 1;
  for (const char *c = line; *c; c++) found += *c == ',';
  *fields = found;
  *bad_field = -1;
  if (found != count) return false;
  for (uint32_t i = 0; i < count; i++) {
    char *end;
    while (is_space(*line)) line++;
    out[i] = strtof(line, &end);
    bool none = end == line;
    while (is_space(*end)) end++;
    if (none || *end != (i + 1 < count ? ',' : '\0')) {
      *bad_field = (int)i;
      return false;
    }
    line = end + 1;
  }
  return true;
}
