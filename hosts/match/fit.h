/* SPDX-License-Identifier: Apache-2.0
 * The palette whose material has a given mean and covariance of colour. */
#ifndef SOZAI_MATCH_FIT_H
#define SOZAI_MATCH_FIT_H

#include "moments.h"
#include "roles.h"

typedef double palette[MOST_ROLES][3];

typedef struct fit_problem {
  size_t roles;
  /* Of the weights of every role, then, with a brightness, of what one unit of
   * it adds to each: the albedo is the sum of weight times colour. */
  const moments *weights;
  const moments *target; /* of the photograph's colours */
  bool has_brightness, free_brightness;
  double brightness, most_brightness; /* the preset's, and the range's end */
  palette reference;                  /* the preset's */
  bool fixed[MOST_ROLES];             /* taken from fixed_colour */
  palette fixed_colour;
} fit_problem;

typedef struct fit {
  palette colour;
  double brightness;
  double residual; /* the relative Frobenius difference, and of the mean in standard deviations */
  double cost;     /* what was minimised: the above, and the third moments */
  moments result;  /* of the colours the palette gives */
} fit;

void fit_palette(const fit_problem *q, fit *out);

/* The moments of a palette's colours. */
void fit_moments(const fit_problem *q, const palette colour, double brightness, moments *out);

#endif
