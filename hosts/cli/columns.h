/* SPDX-License-Identifier: Apache-2.0
 * The columns of eval's input: px,py,pz and so on. */
#ifndef SOZAI_CLI_COLUMNS_H
#define SOZAI_CLI_COLUMNS_H

#include "csv.h"

/* Three for each bit of SOZAI_INPUT_*, in its order, but one for the last. */
#define COLUMNS 16
extern const char *const column_names[COLUMNS];

/* The SOZAI_INPUT_* that a column belongs to. */
uint32_t column_bit(uint32_t column);

typedef struct columns {
  uint32_t input[COLUMNS]; /* which column of column_names each of the file's is */
  uint32_t count;
  uint32_t inputs; /* SOZAI_INPUT_* there are */
} columns;

/* Read the header, the first line that is not blank. */
bool columns_read(columns *c, csv_lines *lines, failure *why);

#endif
