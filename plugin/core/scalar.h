/* SPDX-License-Identifier: Apache-2.0
 *
 * Elementary functions in double for use at creation. The C library's differ
 * between machines and versions in the last bit, and a texture must not.
 * Absolute errors are below 1e-12 over the ranges used.
 */
#ifndef SOZAI_CORE_SCALAR_H
#define SOZAI_CORE_SCALAR_H

#include <stdint.h>

#define PI 3.14159265358979323846
#define RADIANS (PI / 180.0) /* of a degree */

double scalar_sin(double x);
double scalar_cos(double x);
/* x > 0 */
double scalar_log(double x);
double scalar_exp(double x);
static inline double scalar_least(double a, double b) { return a < b ? a : b; }
static inline double scalar_most(double a, double b) { return a > b ? a : b; }
/* Of what fits. */
static inline int32_t scalar_floor(double x) {
  int32_t i = (int32_t)x;
  return (double)i > x ? i - 1 : i;
}
/* Of what rounding may have made negative: 0. */
static inline double scalar_root(double x) { return x > 0.0 ? __builtin_sqrt(x) : 0.0; }
/* out[i] = the x at which a normal distribution of mean 0 and sd 1 reaches
 * (i + 1/2) / count; count even. Below 1e-10 off. */
void scalar_normal_quantiles(double *out, int count);

#endif
