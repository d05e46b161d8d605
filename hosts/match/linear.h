/* SPDX-License-Identifier: Apache-2.0
 * Small matrices, row by row. */
#ifndef SOZAI_MATCH_LINEAR_H
#define SOZAI_MATCH_LINEAR_H

#include <stdbool.h>
#include <stddef.h>

/* Eigenvalues of a symmetric 3x3, falling, and unit vectors as columns. */
void symmetric_eigen(const double a[9], double values[3], double vectors[9]);
/* V diag(max(lambda, least)^power) V^T. */
void symmetric_power(const double a[9], double power, double least, double out[9]);
void multiply(const double a[9], const double b[9], double out[9]);
double frobenius(const double a[9]);

/* Solve a x = b for a symmetric and positive definite; a and b are spent, and
 * x is left in b. */
bool solve_positive(double *a, double *b, size_t n);

#endif
