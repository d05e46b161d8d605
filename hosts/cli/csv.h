/* SPDX-License-Identifier: Apache-2.0
 * Comma-separated numbers, read in blocks of lines so that a file of any
 * length takes the same memory. */
#ifndef SOZAI_CLI_CSV_H
#define SOZAI_CLI_CSV_H

#include <stdint.h>
#include <stdio.h>
#include "failure.h"
#include "ceilings.h"

typedef struct csv_lines {
  FILE *file;
  const char *name; /* for messages */
  char *text;       /* the block's lines, each zero-terminated, then what was read beyond them */
  size_t size, used, done;
  size_t *starts;    /* of the block's lines in text */
  uint64_t *numbers; /* of those lines in the file, from 1 */
  uint32_t room;
  uint32_t count;     /* lines in this block; 0 at the end of the file */
  uint64_t next_line; /* number of the first one behind them */
  bool ended;
} csv_lines;

/* most: lines to a block. */
bool csv_open(csv_lines *lines, FILE *file, const char *name, uint32_t most, failure *why);
void csv_close(csv_lines *lines);

/* The next `most` lines, or what is left of them; those without anything on them are left out. */
bool csv_next(csv_lines *lines, uint32_t most, failure *why);
const char *csv_line(const csv_lines *lines, uint32_t index);

/* Exactly `count` numbers, "nan" and "inf" among them. On failure *bad_field is
 * the field's index, or -1 when there are too few or many, and *fields how
 * many there are. */
bool csv_numbers(const char *line, float *out, uint32_t count, int *bad_field, uint32_t *fields);

#endif
