/* SPDX-License-Identifier: Apache-2.0 */
#include "patches.h"

#include <stddef.h>
#include <string.h>
#include "evaluate.h"

#define SIDE 4u

typedef float run[SIDE]; /* texels that stay beside each other */

/* Four rows of w texels are w/4 by 4 runs, row by row, or patch by patch. */
static void turn(float *numbers, uint32_t w, uint32_t h, int back) {
  run turned[SURFACE_BLOCK / SIDE];
  uint32_t across = w / SIDE;
  if (w % SIDE != 0 || (size_t)w * h > SURFACE_BLOCK) return;
  for (uint32_t y = 0; y + SIDE <= h; y += SIDE) {
    float *band = numbers + (size_t)y * w;
    for (uint32_t x = 0; x < across; x++)
      for (uint32_t row = 0; row < SIDE; row++) {
        uint32_t in_rows = row * across + x, in_patches = x * SIDE + row;
        memcpy(turned[back ? in_rows : in_patches],
               band + (size_t)SIDE * (back ? in_patches : in_rows), sizeof(run));
      }
    memcpy(band, turned, sizeof(run) * w);
  }
}

void patches_of_rows(float *numbers, uint32_t w, uint32_t h) { turn(numbers, w, h, 0); }

void rows_of_patches(float *numbers, uint32_t w, uint32_t h) { turn(numbers, w, h, 1); }
