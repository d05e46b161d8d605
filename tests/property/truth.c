/* SPDX-License-Identifier: Apache-2.0 */
#include "truth.h"

#include <math.h>

void truth_ask(points *p, const sozai_texture *t, unsigned long long components, double x, double y,
               double turn, double size) {
  double co = cos(turn), si = sin(turn);
  points_clear(p);
  for (int i = 0; i < TRUTH_SAMPLES; i++) {
    double u = ((i % TRUTH_SIDE + uniform()) / TRUTH_SIDE - 0.5) * size;
    double v = ((i / TRUTH_SIDE + uniform()) / TRUTH_SIDE - 0.5) * size;
    points_add(p, x + u * co - v * si, y + u * si + v * co, 0, 0);
  }
  points_add(p, x, y, 0, size);
  points_ask_only(p, t, components);
}

double truth_error(const points *p, int component) {
  const float *out = p->out[component];
  double truth = 0;
  for (int i = 0; i < TRUTH_SAMPLES; i++) truth += (double)out[i] / TRUTH_SAMPLES;
  return (double)out[TRUTH_SAMPLES] - truth;
}

double truth_lit_at(points *p, const sozai_texture *t, const double light[3], const double view[3],
                    double size, int places) {
  double near = 0, far = 0;
  uniform_seed(5);
  for (int place = 0; place < places; place++) {
    double x = 160 * (uniform() - 0.5), y = 800 * (uniform() - 0.5), turn = 6.2831853 * uniform();
    double co = cos(turn), si = sin(turn);
    points_clear(p);
    for (int i = 0; i <= TRUTH_SAMPLES; i++) {
      double u = ((i % TRUTH_SIDE + uniform()) / TRUTH_SIDE - 0.5) * size;
      double v = ((i / TRUTH_SIDE + uniform()) / TRUTH_SIDE - 0.5) * size;
      if (i == TRUTH_SAMPLES) u = v = 0;
      unsigned q =
          points_add(p, x + u * co - v * si, y + u * si + v * co, 0, i == TRUTH_SAMPLES ? size : 0);
      for (int c = 0; c < 3; c++) {
        p->light[c][q] = (float)light[c];
        p->view[c][q] = (float)view[c];
      }
    }
    points_ask_only(p, t, ONLY3(RADIANCE));
    for (int i = 0; i < TRUTH_SAMPLES; i++) {
      near += (double)p->out[RADIANCE + 1][i] / TRUTH_SAMPLES;
    }
    far += (double)p->out[RADIANCE + 1][TRUTH_SAMPLES];
  }
  return far / near;
}

double truth_lit(points *p, const sozai_texture *t, const double light[3], const double view[3],
                 double size) {
  return truth_lit_at(p, t, light, view, size, 24);
}

void truth_add(truth_errors *e, const points *p) {
  for (int ch = 0; ch < 3; ch++) {
    double error = truth_error(p, ALBEDO + ch);
    e->square += error * error;
    e->mean += error;
    e->n++;
  }
}

double truth_rms(const truth_errors *e) { return sqrt(e->square / e->n); }

double truth_mean(const truth_errors *e) { return e->mean / e->n; }
