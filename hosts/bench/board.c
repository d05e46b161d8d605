/* SPDX-License-Identifier: Apache-2.0 */
#include "board.h"

board board_make(bool quick) {
  if (quick) return (board){.side = 1024, .column = 0, .row = 496, .columns = 1024, .rows = 32};
  return (board){.side = 4096, .column = 1024, .row = 1920, .columns = 2048, .rows = 256};
}

float board_mm(const board *b, uint32_t index) {
  return ((float)index + 0.5f - 0.5f * (float)b->side) * TEXEL_MM;
}

uint64_t board_points(const board *b) { return (uint64_t)b->columns * b->rows; }
