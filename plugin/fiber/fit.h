/* SPDX-License-Identifier: Apache-2.0
 *
 * The fitting of one strand (section 3.2.2): of twelve moves, a step either way
 * along three axes and a turn either way about them, the one with the highest
 * sum of distances, while that is a gain.
 */
#ifndef SOZAI_FIBER_FIT_H
#define SOZAI_FIBER_FIT_H

#include "fiber.h"

typedef struct strand_pose {
  double middle[3]; /* of its middle vertex */
  double turn[9];   /* row by row */
} strand_pose;

/* Signed distance as the mode takes it. */
float fit_distance(const fiber *f, const float p[3]);

/* shape: vertices about the middle one. Moves the pose, fills the result but
 * for what is inside. */
void fit_strand(const fiber *f, const double *shape, strand_pose *pose, strand_result *result);

/* Vertices of a shape turned by the pose, about its middle. */
void fit_turned(const double *shape, uint32_t vertices, const double turn[9], float *out);

#endif
