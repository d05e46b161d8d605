/* SPDX-License-Identifier: Apache-2.0
 * Texels of a rectangle in another order: patches of 4 x 4, each row by row.
 * What a processor takes side by side then lies close together both ways, and
 * has more in common: the cells of a noise, the vessels near by. Answers do not
 * depend on the order. */
#ifndef SOZAI_SURFACE_PATCHES_H
#define SOZAI_SURFACE_PATCHES_H

#include <stdint.h>

/* In place, numbers of w*h texels from rows to patches, and back. At most
 * SURFACE_BLOCK of them. Rows past the last whole four stay as they are, and all
 * do where w is no multiple of four. */
void patches_of_rows(float *numbers, uint32_t w, uint32_t h);
void rows_of_patches(float *numbers, uint32_t w, uint32_t h);

#endif
