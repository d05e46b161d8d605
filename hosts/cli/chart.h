/* SPDX-License-Identifier: Apache-2.0
 * Lines and dots in one panel of a plate: how much of each pixel they cover. */
#ifndef SOZAI_CLI_CHART_H
#define SOZAI_CLI_CHART_H

#include "plate.h"

typedef struct chart {
  uint32_t width, height;
  double low[2], high[2]; /* what the panel's edges stand for; [1] is up */
  float *share;
} chart;

bool chart_init(chart *c, uint32_t width, uint32_t height, failure *why);
void chart_free(chart *c);
/* width and radius in pixels; ink: 0 to 1 */
void chart_line(chart *c, double x0, double y0, double x1, double y1, double width, double ink);
void chart_dot(chart *c, double x, double y, double radius, double ink);

#endif
