/* SPDX-License-Identifier: Apache-2.0
 * A material on a flat face of a photograph's size, through the plugin. */
#ifndef SOZAI_MATCH_BOARD_H
#define SOZAI_MATCH_BOARD_H

#include <stdint.h>
#include "host.h"
#include "recipe.h"

/* The face lies at z = 0 about the origin, x to the right and y up, as `sozai
 * render --shape plane --camera front` shows it. */
typedef struct board {
  const sozai_textures_1 *textures;
  const host *host;
  uint32_t width, height; /* the photograph's pixels */
  double pixel;           /* mm: the footprint */
  uint32_t step;          /* every how many-th pixel is evaluated, each way */
  uint32_t faces;         /* as large, side by side; none shows what another does */
} board;

/* The pixels are thinned out evenly to what a covariance needs. */
void board_init(board *b, const sozai_textures_1 *textures, const host *h, uint32_t width,
                uint32_t height, double pixel);
uint64_t board_points(const board *b);

/* A channel at every point, its components together, of the texture that a
 * recipe makes, face by face; to be freed. */
bool board_channel(const board *b, recipe *r, const char *channel, float **out, failure *why);

#endif
