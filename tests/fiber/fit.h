/* SPDX-License-Identifier: Apache-2.0
 * Least squares after Levenberg and Marquardt, slopes by differences. */
#ifndef SOZAI_TESTS_FIT_H
#define SOZAI_TESTS_FIT_H

enum { UNKNOWN_MAX = 128, RESIDUALS_MAX = 512 };

typedef struct {
  double *value, at; /* held near `at`, */
  double reach;      /* within about this */
} unknown;

typedef struct {
  unknown list[UNKNOWN_MAX];
  int unknowns, samples, residuals;
  /* Of one sample, over how sure each is. */
  void (*off)(int sample, double *out);
} fit;

/* Until it no longer moves, or for so many steps; tells of each on stderr. */
void fit_run(fit *f, int steps);

#endif
