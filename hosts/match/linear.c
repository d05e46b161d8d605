/* SPDX-License-Identifier: Apache-2.0 */
#include "linear.h"

#include <math.h>
#include <string.h>

static void rotate(double *a, double *v, int p, int q) {
  if (a[3 * p + q] == 0) return;
  double theta = (a[3 * q + q] - a[3 * p + p]) / (2 * a[3 * p + q]);
  double t = (theta < 0 ? -1 : 1) / (fabs(theta) + sqrt(theta * theta + 1));
  double c = 1 / sqrt(t * t + 1), s = t * c;
  for (int k = 0; k < 3; k++) {
    double kp = a[3 * k + p], kq = a[3 * k + q];
    a[3 * k + p] = c * kp - s * kq;
    a[3 * k + q] = s * kp + c * kq;
  }
  for (int k = 0; k < 3; k++) {
    double pk = a[3 * p + k], qk = a[3 * q + k];
    a[3 * p + k] = c * pk - s * qk;
    a[3 * q + k] = s * pk + c * qk;
    double vp = v[3 * k + p], vq = v[3 * k + q];
    v[3 * k + p] = c * vp - s * vq;
    v[3 * k + q] = s * vp + c * vq;
  }
}

static void swap_columns(double *values, double *v, int p, int q) {
  double t = values[p];
  values[p] = values[q];
  values[q] = t;
  for (int k = 0; k < 3; k++) {
    t = v[3 * k + p];
    v[3 * k + p] = v[3 * k + q];
    v[3 * k + q] = t;
  }
}

/* Jacobi's rotations: six sweeps are more than a 3x3 in doubles needs. */
void symmetric_eigen(const double a[9], double values[3], double vectors[9]) {
  static const double one[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  double w[9];
  memcpy(w, a, sizeof w);
  memcpy(vectors, one, sizeof one);
  for (int sweep = 0; sweep < 12; sweep++) {
    rotate(w, vectors, 0, 1);
    rotate(w, vectors, 0, 2);
    rotate(w, vectors, 1, 2);
  }
  for (int i = 0; i < 3; i++) values[i] = w[4 * i];
  if (values[0] < values[1]) swap_columns(values, vectors, 0, 1);
  if (values[1] < values[2]) swap_columns(values, vectors, 1, 2);
  if (values[0] < values[1]) swap_columns(values, vectors, 0, 1);
}

void symmetric_power(const double a[9], double power, double least, double out[9]) {
  double values[3], v[9];
  symmetric_eigen(a, values, v);
  for (int i = 0; i < 3; i++) values[i] = pow(fmax(values[i], least), power);
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      out[3 * i + j] = 0;
      for (int k = 0; k < 3; k++) out[3 * i + j] += v[3 * i + k] * values[k] * v[3 * j + k];
    }
}

void multiply(const double a[9], const double b[9], double out[9]) {
  double product[9];
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      product[3 * i + j] = 0;
      for (int k = 0; k < 3; k++) product[3 * i + j] += a[3 * i + k] * b[3 * k + j];
    }
  memcpy(out, product, sizeof product);
}

double frobenius(const double a[9]) {
  double sum = 0;
  for (int i = 0; i < 9; i++) sum += a[i] * a[i];
  return sqrt(sum);
}

/* Cholesky's factor in the lower triangle, then two substitutions. */
bool solve_positive(double *a, double *b, size_t n) {
  for (size_t j = 0; j < n; j++) {
    for (size_t i = j; i < n; i++) {
      double sum = a[i * n + j];
      for (size_t k = 0; k < j; k++) sum -= a[i * n + k] * a[j * n + k];
      if (i == j) {
        if (!(sum > 0)) return false;
        a[j * n + j] = sqrt(sum);
      } else
        a[i * n + j] = sum / a[j * n + j];
    }
  }
  for (size_t i = 0; i < n; i++) {
    for (size_t k = 0; k < i; k++) b[i] -= a[i * n + k] * b[k];
    b[i] /= a[i * n + i];
  }
  for (size_t i = n; i-- > 0;) {
    for (size_t k = i + 1; k < n; k++) b[i] -= a[k * n + i] * b[k];
    b[i] /= a[i * n + i];
  }
  return true;
}
