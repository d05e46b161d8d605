/* SPDX-License-Identifier: Apache-2.0 */
#include "chart.h"

#include <math.h>
#include <stdlib.h>

bool chart_init(chart *c, uint32_t width, uint32_t height, failure *why) {
  c->width = width;
  c->height = height;
  c->share = calloc((size_t)width * height, sizeof *c->share);
  return c->share || fail(why, EXIT_FAILURE, "out of memory");
}

void chart_free(chart *c) {
  free(c->share);
  c->share = NULL;
}

static void to_pixels(const chart *c, double x, double y, double out[2]) {
  out[0] = (x - c->low[0]) / (c->high[0] - c->low[0]) * c->width;
  out[1] = (1 - (y - c->low[1]) / (c->high[1] - c->low[1])) * c->height;
}

/* Every pixel by its distance from the segment: a round pen of that radius. */
static void stroke(chart *c, const double a[2], const double b[2], double radius, double ink) {
  double dx = b[0] - a[0], dy = b[1] - a[1], length2 = dx * dx + dy * dy;
  double left = fmin(a[0], b[0]) - radius - 1, right = fmax(a[0], b[0]) + radius + 1;
  double top = fmin(a[1], b[1]) - radius - 1, bottom = fmax(a[1], b[1]) + radius + 1;
  for (double y = fmax(0, floor(top)); y < fmin(c->height, bottom); y++)
    for (double x = fmax(0, floor(left)); x < fmin(c->width, right); x++) {
      double px = x + 0.5 - a[0], py = y + 0.5 - a[1];
      double t = length2 > 0 ? fmin(1, fmax(0, (px * dx + py * dy) / length2)) : 0;
      double off = hypot(px - t * dx, py - t * dy);
      float cover = (float)(ink * fmin(1, fmax(0, radius + 0.5 - off)));
      float *at = &c->share[(size_t)y * c->width + (size_t)x];
      if (cover > *at) *at = cover;
    }
}

void chart_line(chart *c, double x0, double y0, double x1, double y1, double width, double ink) {
  double a[2], b[2];
  to_pixels(c, x0, y0, a);
  to_pixels(c, x1, y1, b);
  stroke(c, a, b, width / 2, ink);
}

void chart_dot(chart *c, double x, double y, double radius, double ink) {
  double a[2];
  to_pixels(c, x, y, a);
  stroke(c, a, a, radius, ink);
}
