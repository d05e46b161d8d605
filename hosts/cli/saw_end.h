/* SPDX-License-Identifier: Apache-2.0
 * The log's lower end with bark and cuts, drawn into a picture. */
#ifndef SOZAI_CLI_SAW_END_H
#define SOZAI_CLI_SAW_END_H

#include "saw.h"

typedef struct saw_canvas {
  uint32_t width, height;
  float *rgb; /* the display's 0 to 1 */
} saw_canvas;

/* Mixes `share` of a colour into a pixel; outside the canvas nothing. */
void saw_blend(saw_canvas *c, long x, long y, const float rgb[3], double share);
/* A number on a pale disc, its middle at x, y; size of the letters in pixels. */
void saw_number(saw_canvas *c, double x, double y, uint32_t size, size_t number);

/* In the square of `side` pixels whose corner is at x, y. */
bool saw_draw_end(saw_canvas *c, const saw_work *w, uint32_t x, uint32_t y, uint32_t side,
                  failure *why);

#endif
