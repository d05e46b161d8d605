/* SPDX-License-Identifier: Apache-2.0
 * Mean, covariance and third central moments of points of a few numbers each. */
#ifndef SOZAI_MATCH_MOMENTS_H
#define SOZAI_MATCH_MOMENTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "failure.h"

#define MOST_DIMENSIONS 10

typedef struct moments {
  size_t dimensions;
  uint64_t count;
  double mean[MOST_DIMENSIONS];
  double covariance[MOST_DIMENSIONS * MOST_DIMENSIONS];              /* i * dimensions + j */
  double third[MOST_DIMENSIONS * MOST_DIMENSIONS * MOST_DIMENSIONS]; /* (i * d + j) * d + k */
} moments;

/* points: `dimensions` numbers each. kept: count of them, those of `value`
 * count; NULL: all. */
void moments_take(moments *m, const float *points, size_t dimensions, uint64_t count,
                  const uint8_t *kept, uint8_t value);

/* Moments of the colours K^T u: K has as many rows as m dimensions, and three
 * columns. out has three dimensions. */
void moments_through(const moments *m, const double *k, moments *out);

#endif
