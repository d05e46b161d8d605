/* SPDX-License-Identifier: Apache-2.0 */
#include "moments.h"

#include <string.h>

static bool is_kept(const uint8_t *kept, uint8_t value, uint64_t i) {
  return !kept || kept[i] == value;
}

static void take_mean(moments *m, const float *points, uint64_t count, const uint8_t *kept,
                      uint8_t value) {
  for (uint64_t i = 0; i < count; i++) {
    if (!is_kept(kept, value, i)) continue;
    m->count++;
    for (size_t a = 0; a < m->dimensions; a++) m->mean[a] += (double)points[i * m->dimensions + a];
  }
  for (size_t a = 0; m->count && a < m->dimensions; a++) m->mean[a] /= (double)m->count;
}

/* About the mean, each product once; the rest by symmetry. */
static void add_products(moments *m, const double *x) {
  size_t d = m->dimensions;
  for (size_t a = 0; a < d; a++)
    for (size_t b = a; b < d; b++) {
      double ab = x[a] * x[b];
      m->covariance[a * d + b] += ab;
      for (size_t c = b; c < d; c++) m->third[(a * d + b) * d + c] += ab * x[c];
    }
}

static void spread(moments *m) {
  size_t d = m->dimensions;
  double n = m->count ? (double)m->count : 1;
  for (size_t a = 0; a < d; a++)
    for (size_t b = a; b < d; b++) {
      m->covariance[b * d + a] = m->covariance[a * d + b] /= n;
      for (size_t c = b; c < d; c++) {
        double t = m->third[(a * d + b) * d + c] / n;
        m->third[(a * d + b) * d + c] = m->third[(a * d + c) * d + b] = t;
        m->third[(b * d + a) * d + c] = m->third[(b * d + c) * d + a] = t;
        m->third[(c * d + a) * d + b] = m->third[(c * d + b) * d + a] = t;
      }
    }
}

void moments_take(moments *m, const float *points, size_t dimensions, uint64_t count,
                  const uint8_t *kept, uint8_t value) {
  memset(m, 0, sizeof *m);
  m->dimensions = dimensions;
  take_mean(m, points, count, kept, value);
  double x[MOST_DIMENSIONS];
  for (uint64_t i = 0; i < count; i++) {
    if (!is_kept(kept, value, i)) continue;
    for (size_t a = 0; a < dimensions; a++) x[a] = (double)points[i * dimensions + a] - m->mean[a];
    add_products(m, x);
  }
  spread(m);
}

void moments_through(const moments *m, const double *k, moments *out) {
  size_t d = m->dimensions;
  memset(out, 0, sizeof *out);
  out->dimensions = 3;
  out->count = m->count;
  double half[3 * MOST_DIMENSIONS], first[3 * MOST_DIMENSIONS * MOST_DIMENSIONS];
  double second[9 * MOST_DIMENSIONS];
  for (size_t a = 0; a < 3; a++) {
    for (size_t i = 0; i < d; i++) out->mean[a] += m->mean[i] * k[3 * i + a];
    for (size_t j = 0; j < d; j++) {
      half[a * d + j] = 0;
      for (size_t i = 0; i < d; i++) half[a * d + j] += k[3 * i + a] * m->covariance[i * d + j];
      for (size_t l = 0; l < d; l++) {
        double sum = 0;
        for (size_t i = 0; i < d; i++) sum += k[3 * i + a] * m->third[(i * d + j) * d + l];
        first[(a * d + j) * d + l] = sum;
      }
    }
  }
  for (size_t a = 0; a < 3; a++)
    for (size_t b = 0; b < 3; b++) {
      for (size_t j = 0; j < d; j++) out->covariance[3 * a + b] += half[a * d + j] * k[3 * j + b];
      for (size_t l = 0; l < d; l++) {
        double sum = 0;
        for (size_t j = 0; j < d; j++) sum += k[3 * j + b] * first[(a * d + j) * d + l];
        second[(3 * a + b) * d + l] = sum;
      }
      for (size_t c = 0; c < 3; c++)
        for (size_t l = 0; l < d; l++)
          out->third[(3 * a + b) * 3 + c] += second[(3 * a + b) * d + l] * k[3 * l + c];
    }
}
