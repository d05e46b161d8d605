/* SPDX-License-Identifier: Apache-2.0
 *
 * docs/match.md says what is minimised and why. */
#include "fit.h"

#include <math.h>
#include <string.h>
#include "linear.h"

#define FREE_MOST (3 * MOST_ROLES + 1)
#define RESIDUALS_MOST (3 + 6 + 10 + 3 * MOST_ROLES + MOST_ROLES)
#define ROUNDS 200

/* Weights of the terms. */
#define MEAN 2.0
#define THIRD 0.1
#define NEAR 0.01
#define ORDER 0.3
#define AXIS_LEAST 0.02 /* of the first axis's variance: below it lies noise */

typedef struct solver {
  const fit_problem *q;
  double whiten[9]; /* by the photograph's covariance */
  double third[27]; /* of the photograph, whitened */
  double scale;     /* root of the photograph's total variance */
  palette near;     /* the preset's palette as the photograph would have it */
  int role_of[FREE_MOST], channel_of[FREE_MOST]; /* role -1: the brightness */
  size_t count;
} solver;

void fit_moments(const fit_problem *q, const palette colour, double brightness, moments *out) {
  double k[3 * MOST_DIMENSIONS] = {0};
  for (size_t i = 0; i < q->roles; i++)
    for (size_t c = 0; c < 3; c++) {
      k[3 * i + c] = colour[i][c];
      if (q->has_brightness) k[3 * (q->roles + i) + c] = brightness * colour[i][c];
    }
  moments_through(q->weights, k, out);
}

/* ---- what is minimised ---------------------------------------------------------- */

static void whiten_third(const double *w, const double *t, double *out) {
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++)
      for (int c = 0; c < 3; c++) {
        double sum = 0;
        for (int i = 0; i < 3; i++)
          for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++)
              sum += w[3 * a + i] * w[3 * b + j] * w[3 * c + k] * t[(i * 3 + j) * 3 + k];
        out[(a * 3 + b) * 3 + c] = sum;
      }
}

static double grey(const double *rgb) { return (rgb[0] + rgb[1] + rgb[2]) / 3; }

/* Of two roles, the one that is lighter in the preset should stay it. */
static size_t order_residuals(const solver *s, const palette colour, double *out) {
  size_t n = 0;
  for (size_t i = 0; i + 1 < s->q->roles; i++) {
    size_t lighter = i, darker = i + 1;
    if (grey(s->q->reference[lighter]) < grey(s->q->reference[darker])) {
      lighter = i + 1;
      darker = i;
    }
    out[n++] = ORDER * fmax(0, grey(colour[darker]) - grey(colour[lighter])) / s->scale;
  }
  return n;
}

static size_t residuals(const solver *s, const palette colour, double brightness, double *out) {
  const moments *target = s->q->target;
  moments m;
  fit_moments(s->q, colour, brightness, &m);
  size_t n = 0;
  double d[9], third[27];
  for (int a = 0; a < 3; a++) {
    out[n] = 0;
    for (int b = 0; b < 3; b++) out[n] += s->whiten[3 * a + b] * (m.mean[b] - target->mean[b]);
    out[n++] *= MEAN;
  }
  for (int i = 0; i < 9; i++) d[i] = m.covariance[i] - target->covariance[i];
  multiply(s->whiten, d, d);
  multiply(d, s->whiten, d);
  for (int a = 0; a < 3; a++)
    for (int b = a; b < 3; b++) out[n++] = (a == b ? 1 : sqrt(2)) * d[3 * a + b];
  whiten_third(s->whiten, m.third, third);
  for (int a = 0; a < 3; a++)
    for (int b = a; b < 3; b++)
      for (int c = b; c < 3; c++) {
        double times = a == c ? 1 : a == b || b == c ? 3 : 6;
        int i = (a * 3 + b) * 3 + c;
        out[n++] = THIRD * sqrt(times) * (third[i] - s->third[i]);
      }
  for (size_t i = 0; i < s->q->roles; i++)
    for (size_t c = 0; c < 3; c++) out[n++] = NEAR * (colour[i][c] - s->near[i][c]) / s->scale;
  return n + order_residuals(s, colour, out + n);
}

/* ---- Levenberg and Marquardt, within bounds ---------------------------------------- */

static double *slot(const solver *s, palette colour, double *brightness, size_t i) {
  return s->role_of[i] < 0 ? brightness : &colour[s->role_of[i]][s->channel_of[i]];
}

static double most_of(const solver *s, size_t i) {
  return s->role_of[i] < 0 ? s->q->most_brightness : 1;
}

static double square_sum(const double *r, size_t n) {
  double sum = 0;
  for (size_t i = 0; i < n; i++) sum += r[i] * r[i];
  return sum;
}

/* J^T J and J^T r by differences. A number at its bound that would leave it is
 * held: its row is the unit's. */
static void linearise(const solver *s, palette colour, double *brightness, const double *r,
                      size_t n, double *a, double *b) {
  double j[FREE_MOST][RESIDUALS_MOST], moved[RESIDUALS_MOST];
  bool held[FREE_MOST];
  for (size_t i = 0; i < s->count; i++) {
    double *x = slot(s, colour, brightness, i), at = *x, step = at > 0.5 ? -1e-6 : 1e-6;
    *x = at + step;
    residuals(s, (const double(*)[3])colour, *brightness, moved);
    *x = at;
    b[i] = 0;
    for (size_t k = 0; k < n; k++) {
      j[i][k] = (moved[k] - r[k]) / step;
      b[i] -= j[i][k] * r[k];
    }
    held[i] = (at <= 0 && b[i] < 0) || (at >= most_of(s, i) && b[i] > 0);
    if (held[i]) b[i] = 0;
  }
  for (size_t i = 0; i < s->count; i++)
    for (size_t k = 0; k < s->count; k++) {
      double sum = 0;
      for (size_t l = 0; l < n; l++) sum += j[i][l] * j[k][l];
      a[i * s->count + k] = held[i] || held[k] ? (i == k) : sum;
    }
}

static double descend(const solver *s, palette colour, double *brightness) {
  double r[RESIDUALS_MOST], a[FREE_MOST * FREE_MOST], b[FREE_MOST], damping = 1e-2;
  size_t n = residuals(s, (const double(*)[3])colour, *brightness, r);
  double cost = square_sum(r, n);
  for (int round = 0; round < ROUNDS && damping < 1e8; round++) {
    linearise(s, colour, brightness, r, n, a, b);
    for (size_t i = 0; i < s->count; i++) a[i * s->count + i] *= 1 + damping;
    for (size_t i = 0; i < s->count; i++) a[i * s->count + i] += 1e-12;
    damping *= 4;
    if (!solve_positive(a, b, s->count)) continue;
    palette next;
    double next_brightness = *brightness, moved[RESIDUALS_MOST];
    memcpy(next, colour, sizeof next);
    for (size_t i = 0; i < s->count; i++) {
      double *x = slot(s, next, &next_brightness, i);
      *x = fmin(fmax(*x + b[i], 0), most_of(s, i));
    }
    residuals(s, (const double(*)[3])next, next_brightness, moved);
    double next_cost = square_sum(moved, n);
    if (!(next_cost < cost)) continue;
    bool done = cost - next_cost < 1e-12 * cost;
    cost = next_cost;
    memcpy(colour, next, sizeof next);
    *brightness = next_brightness;
    memcpy(r, moved, sizeof r);
    damping /= 20;
    if (done) break;
  }
  return cost;
}

/* ---- where to begin ------------------------------------------------------------------ */

/* The linear map between two Gaussian distributions that moves colours the
 * least: whiten, turn by Procrustes' rotation, colour. */
static void least_map(const double *from, const double *to, double *map) {
  double values[3], ignored[9], root[9], inverse[9], middle[9];
  symmetric_eigen(from, values, ignored);
  double least = fmax(AXIS_LEAST * values[0], 1e-12);
  symmetric_power(from, 0.5, least, root);
  symmetric_power(from, -0.5, least, inverse);
  multiply(root, to, middle);
  multiply(middle, root, middle);
  symmetric_power(middle, 0.5, 0, middle);
  multiply(inverse, middle, map);
  multiply(map, inverse, map);
}

static void clamp_palette(const fit_problem *q, palette colour) {
  for (size_t i = 0; i < q->roles; i++)
    for (size_t c = 0; c < 3; c++)
      colour[i][c] = q->fixed[i] ? q->fixed_colour[i][c] : fmin(fmax(colour[i][c], 0.001), 0.999);
}

static void begin(solver *s, const fit_problem *q) {
  memset(s, 0, sizeof *s);
  s->q = q;
  const double *covariance = q->target->covariance;
  double values[3], ignored[9], map[9];
  symmetric_eigen(covariance, values, ignored);
  double lift[9];
  memcpy(lift, covariance, sizeof lift);
  for (int i = 0; i < 3; i++) lift[4 * i] += AXIS_LEAST * values[0];
  symmetric_power(lift, -0.5, 1e-12, s->whiten);
  whiten_third(s->whiten, q->target->third, s->third);
  s->scale = sqrt(fmax(values[0] + values[1] + values[2], 1e-12));
  moments preset;
  fit_moments(q, q->reference, q->brightness, &preset);
  least_map(preset.covariance, covariance, map);
  for (size_t i = 0; i < q->roles; i++)
    for (size_t c = 0; c < 3; c++) {
      s->near[i][c] = q->target->mean[c];
      for (size_t k = 0; k < 3; k++)
        s->near[i][c] += map[3 * c + k] * (q->reference[i][k] - preset.mean[k]);
    }
  clamp_palette(q, s->near);
  for (size_t i = 0; i < q->roles; i++)
    for (int c = 0; c < 3 && !q->fixed[i]; c++) {
      s->role_of[s->count] = (int)i;
      s->channel_of[s->count++] = c;
    }
  if (q->has_brightness && q->free_brightness) s->role_of[s->count++] = -1;
}

/* Starts: the mapped palette; the preset's scaled to the mean; and the mapped
 * with its first roles drawn together or apart, since a turn by half about the
 * mean has the same covariance. */
#define STARTS 5

static void start(const solver *s, int which, palette colour) {
  static const double apart[STARTS] = {1, 1, 0.3, 2, -1};
  const fit_problem *q = s->q;
  moments preset;
  fit_moments(q, q->reference, q->brightness, &preset);
  for (size_t i = 0; i < q->roles; i++)
    for (size_t c = 0; c < 3; c++) {
      double mean = q->target->mean[c];
      colour[i][c] = which == 1 ? q->reference[i][c] * mean / fmax(preset.mean[c], 1e-6)
                                : mean + apart[which] * (s->near[i][c] - mean);
    }
  clamp_palette(q, colour);
}

static double residual_of(const fit_problem *q, const moments *m) {
  double d[9], mean = 0, scale = 0;
  for (int i = 0; i < 9; i++) d[i] = m->covariance[i] - q->target->covariance[i];
  for (int k = 0; k < 3; k++) {
    mean += (m->mean[k] - q->target->mean[k]) * (m->mean[k] - q->target->mean[k]);
    scale += q->target->covariance[4 * k];
  }
  return frobenius(d) / fmax(frobenius(q->target->covariance), 1e-18) +
         sqrt(mean / fmax(scale, 1e-18));
}

void fit_palette(const fit_problem *q, fit *out) {
  solver s;
  begin(&s, q);
  double best = INFINITY;
  for (int i = 0; i < STARTS; i++) {
    palette colour = {{0}};
    double brightness = q->brightness;
    start(&s, i, colour);
    double cost = descend(&s, colour, &brightness);
    if (!(cost < best)) continue;
    best = cost;
    memcpy(out->colour, colour, sizeof colour);
    out->brightness = brightness;
    out->cost = cost;
  }
  fit_moments(q, (const double(*)[3])out->colour, out->brightness, &out->result);
  out->residual = residual_of(q, &out->result);
}
