/* SPDX-License-Identifier: Apache-2.0
 * A plane's picture that fits itself: what lies beyond its left edge is what
 * lies at its right edge, and below likewise.
 *
 * Along its left edge, and its lower one, the picture shows the material one
 * width, or height, further on, which is what it goes on into beyond its right
 * edge, or upper one. A ragged line parts the two. So every texel is the
 * material's own, with its crystals, contrast and colours; only along the line
 * are crystals cut through, veins ended and beds shifted. Fading the one into
 * the other instead would show crystals through one another and weaken the
 * contrast. */
#ifndef SOZAI_SURFACE_PERIODIC_H
#define SOZAI_SURFACE_PERIODIC_H

#include <stdbool.h>
#include <stdint.h>

#define PERIODIC_COPIES 4 /* at: here, + width, + height, + both */

/* Whether such a picture of the material would be honest: whether it is the
 * same everywhere but for chance. */
bool periodic_fits(const char *material);

typedef struct periodic {
  double size[2]; /* mm, the periods */
  double margin;  /* mm */
} periodic;

periodic periodic_make(const double size[2]);
/* How much of each copy there is in a texel at x, y (mm, the picture's middle
 * is 0), in sum 1: more than one only where the line runs through the texel.
 * false: all of the first. */
bool periodic_weights(const periodic *p, double x, double y, double footprint,
                      float share[PERIODIC_COPIES]);

#endif
