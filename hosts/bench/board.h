/* SPDX-License-Identifier: Apache-2.0
 * The board that everything is measured on: flat-sawn, its face towards +z,
 * 1/16 mm to a texel, the origin in its middle. */
#ifndef SOZAI_BENCH_BOARD_H
#define SOZAI_BENCH_BOARD_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TEXEL_MM 0.0625f
#define LARGEST_BATCH 1024u

typedef struct board {
  uint32_t side; /* texels of the baked picture, both ways */
  /* The part that a repetition goes over; whole batches to a row. */
  uint32_t column, row, columns, rows;
} board;

board board_make(bool quick);
/* Where a column's or a row's texel has its centre. */
float board_mm(const board *b, uint32_t index);
uint64_t board_points(const board *b);

#ifdef __cplusplus
}
#endif

#endif
