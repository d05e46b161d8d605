/* SPDX-License-Identifier: Apache-2.0 */
#include "fit.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Solves in place: symmetric, positive. */
static void solve(double m[UNKNOWN_MAX][UNKNOWN_MAX], double x[UNKNOWN_MAX], int n) {
  for (int i = 0; i < n; i++) {
    for (int k = 0; k <= i; k++) {
      double sum = m[i][k];
      for (int j = 0; j < k; j++) sum -= m[i][j] * m[k][j];
      m[i][k] = i == k ? sqrt(sum) : sum / m[k][k];
    }
  }
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < i; k++) x[i] -= m[i][k] * x[k];
    x[i] /= m[i][i];
  }
  for (int i = n - 1; i >= 0; i--) {
    for (int k = i + 1; k < n; k++) x[i] -= m[k][i] * x[k];
    x[i] /= m[i][i];
  }
}

static void add_sample(const fit *f, int sample, double m[UNKNOWN_MAX][UNKNOWN_MAX], double *x,
                       double *sum) {
  static double slope[UNKNOWN_MAX][RESIDUALS_MAX], off[RESIDUALS_MAX], beside[RESIDUALS_MAX];
  f->off(sample, off);
  for (int r = 0; r < f->residuals; r++) *sum += off[r] * off[r];
  for (int i = 0; i < f->unknowns; i++) {
    const unknown *u = &f->list[i];
    const double was = *u->value, h = 0.02 * u->reach;
    *u->value = was + h;
    f->off(sample, beside);
    *u->value = was;
    for (int r = 0; r < f->residuals; r++) {
      slope[i][r] = (beside[r] - off[r]) / h;
      x[i] -= slope[i][r] * off[r];
    }
    for (int k = 0; k <= i; k++) {
      for (int r = 0; r < f->residuals; r++) m[i][k] += slope[i][r] * slope[k][r];
    }
  }
}

static double sum_of(const fit *f) {
  static double off[RESIDUALS_MAX];
  double sum = 0;
  for (int i = 0; i < f->unknowns; i++) {
    double x = (*f->list[i].value - f->list[i].at) / f->list[i].reach;
    sum += x * x;
  }
  for (int s = 0; s < f->samples; s++) {
    f->off(s, off);
    for (int r = 0; r < f->residuals; r++) sum += off[r] * off[r];
  }
  return sum;
}

/* From `was`, damped: as far as it is found to get better. Returns the sum it comes to. */
static double advance(const fit *f, double m[UNKNOWN_MAX][UNKNOWN_MAX], const double *x, double sum,
                      double *damped, double *moved) {
  static double left[UNKNOWN_MAX][UNKNOWN_MAX], by[UNKNOWN_MAX], was[UNKNOWN_MAX];
  for (int i = 0; i < f->unknowns; i++) was[i] = *f->list[i].value;
  for (int tried = 0; tried < 8; tried++) {
    memcpy(left, m, sizeof left);
    memcpy(by, x, sizeof by);
    for (int i = 0; i < f->unknowns; i++) left[i][i] *= 1 + *damped;
    solve(left, by, f->unknowns);
    /* far off it is no plane */
    *moved = 0;
    for (int i = 0; i < f->unknowns; i++) {
      double reach = f->list[i].reach;
      by[i] = fmin(fmax(by[i], -reach), reach);
      *moved = fmax(*moved, fabs(by[i]) / reach);
      *f->list[i].value = was[i] + by[i];
    }
    double now = sum_of(f);
    if (now < sum) {
      *damped *= 0.25;
      return now;
    }
    *damped *= 6;
  }
  for (int i = 0; i < f->unknowns; i++) *f->list[i].value = was[i];
  *moved = 0;
  return sum;
}

void fit_run(fit *f, int steps) {
  static double m[UNKNOWN_MAX][UNKNOWN_MAX], x[UNKNOWN_MAX];
  double moved = 1, damped = 0.01;
  for (int s = 0; s < steps && moved > 0.01; s++) {
    double sum = 0;
    memset(m, 0, sizeof m);
    memset(x, 0, sizeof x);
    for (int i = 0; i < f->unknowns; i++) {
      const unknown *u = &f->list[i];
      double held = 1 / (u->reach * u->reach), off = *u->value - u->at;
      m[i][i] = held;
      x[i] = -held * off;
      sum += held * off * off;
    }
    for (int i = 0; i < f->samples; i++) add_sample(f, i, m, x, &sum);
    double now = advance(f, m, x, sum, &damped, &moved);
    fprintf(stderr, "step %d: from %.1f to %.1f, by %.3f\n", s, sum, now, moved);
  }
}
