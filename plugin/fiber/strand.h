/* SPDX-License-Identifier: Apache-2.0
 *
 * One staple fibre: a polyline of equal segments whose joints are turned at
 * random within a range (Sakurai & Miyata, section 3.1).
 *
 * The paper's equation (1) prints a sum of rotations where it means their
 * product, and lays the first segment along y with theta about y, under which
 * several rows of its table 1 stay straight. Read here so that the figures come
 * out: the first segment lies along x, phi turns about the segment (the twist),
 * theta about the y axis it carries along (the bend).
 */
#ifndef SOZAI_FIBER_STRAND_H
#define SOZAI_FIBER_STRAND_H

#include <stdint.h>

#define STRAND_VERTICES_MAX 1024

typedef struct strand_shape {
  uint32_t vertices; /* 2 to STRAND_VERTICES_MAX */
  uint32_t seed;
  double length;               /* mm, of all segments together: the mean */
  double length_spread;        /* standard deviation over mean */
  double phi_min, phi_max;     /* degrees at each joint: the twist */
  double theta_min, theta_max; /* degrees at each joint: the bend */
} strand_shape;

/* Uniform in [0, 1): the k-th random number of a strand for that purpose. */
double strand_random(uint32_t seed, uint32_t strand, uint32_t purpose, uint32_t k);

#define STRAND_JOINTS 0x01u /* purposes */
#define STRAND_SIZE 0x02u
#define STRAND_PLACE 0x03u
#define STRAND_TURN 0x04u
#define STRAND_LOOK 0x05u

/* About normal with mean 0 and sd 1, within +-3.47: the sum of twelve. */
double strand_normal(uint32_t seed, uint32_t strand, uint32_t purpose, uint32_t k);

/* The length of a strand: at least a tenth of the mean. */
double strand_length(const strand_shape *s, uint32_t strand);

/* Its vertices as x y z each, mm, the first at the origin, the first segment
 * along +x. out: 3 * vertices. */
void strand_make(const strand_shape *s, uint32_t strand, double *out);

/* A uniformly random rotation, row by row. */
void strand_rotation(uint32_t seed, uint32_t strand, double out[9]);

/* Sine and cosine, |x| < 1e6, to 1e-15: fast enough for every joint of a million
 * strands, which scalar.h is not. */
void strand_sine_cosine(double x, double *sine, double *cosine);

#endif
