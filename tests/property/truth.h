/* SPDX-License-Identifier: Apache-2.0
 *
 * What filtering is judged by: 1,024 points of the square that a footprint
 * stands for.
 */
#ifndef SOZAI_TEST_TRUTH_H
#define SOZAI_TEST_TRUTH_H

#include "wood.h"

enum { TRUTH_SIDE = 32, TRUTH_SAMPLES = TRUTH_SIDE * TRUTH_SIDE };

/* Fill p with the points, one in each of 32 x 32 parts of a square of `size` mm
 * about (x, y, 0) that is turned by `turn` radians, and last of all the
 * footprint of that size; and ask for those components. */
void truth_ask(points *p, const sozai_texture *t, unsigned long long components, double x, double y,
               double turn, double size);

/* The footprint's answer, the last point's, less the points' mean. */
double truth_error(const points *p, int component);

/* Mean radiance (green) of footprints of that size under a light and towards a view, over that of
 * 1,024 points in each; at so many places of the plane x, y. */
double truth_lit_at(points *p, const sozai_texture *t, const double light[3], const double view[3],
                    double size, int places);
/* At 24. */
double truth_lit(points *p, const sozai_texture *t, const double light[3], const double view[3],
                 double size);

/* Errors of albedo, summed. */
typedef struct {
  double square, mean;
  unsigned n;
} truth_errors;

void truth_add(truth_errors *e, const points *p);
double truth_rms(const truth_errors *e);
double truth_mean(const truth_errors *e);

#endif
