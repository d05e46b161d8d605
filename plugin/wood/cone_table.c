/* SPDX-License-Identifier: Apache-2.0
 *
 * How much light the fibres' lobe reflects, as a table over the inclination of
 * the light and the dive angle. It is the integral of the lobe over the
 * directions above the surface, which meet the lobe by their inclination alone:
 * so the directions are sorted into bins of inclination first.
 */
#include "cone_table.h"

#include "../core/scalar.h"

#define BINS 256
#define RINGS 48  /* of directions, of equal projected solid angle */
#define SPOKES 48 /* over half the circle: the other is its mirror image */
#define MOST 0.85 /* the lobe reflects no more; the rest is room for the table's errors */

/* The angle of a sine, by Newton's method. */
static double angle_of(double sine) {
  if (sine <= -1.0) return -0.5 * PI;
  if (sine >= 1.0) return 0.5 * PI;
  double x = sine;
  for (int i = 0; i < 12; i++) {
    double c = scalar_cos(x), step = (scalar_sin(x) - sine) / (c > 1e-3 ? c : 1e-3);
    x -= step > 0.3 ? 0.3 : step < -0.3 ? -0.3 : step;
  }
  return x;
}

/* Projected solid angle of the directions by the sine of their refracted
 * inclination, for fibres that dive by the angle of that sine. */
static void sort_directions(double dive, double inverse_ior, double weight[BINS]) {
  double level = scalar_root(1.0 - dive * dive);
  for (int b = 0; b < BINS; b++) weight[b] = 0.0;
  for (int j = 0; j < SPOKES; j++) {
    double spoke = scalar_cos(PI * (j + 0.5) / SPOKES);
    for (int i = 0; i < RINGS; i++) {
      double sine = scalar_root((i + 0.5) / RINGS) * inverse_ior,
             z = scalar_root(1.0 - sine * sine);
      double x = (sine * spoke * level - z * dive + 1.0) * 0.5 * BINS - 0.5;
      /* shared between the two nearest bins, so that the grid leaves no gaps */
      int b = x < 0.0 ? 0 : x >= BINS - 1 ? BINS - 2 : (int)x;
      double part = x - b < 0.0 ? 0.0 : x - b > 1.0 ? 1.0 : x - b;
      weight[b] += (1.0 - part) * PI / (RINGS * SPOKES);
      weight[b + 1] += part * PI / (RINGS * SPOKES);
    }
  }
}

typedef struct {
  double sine[BINS], cosine[BINS], psi[BINS];
} inclinations;

/* The lobe of white fibres for light at psi, towards each inclination. */
static void lobe_towards(double width, double sine, double psi, const inclinations *to,
                         double out[BINS]) {
  double cosine = scalar_root(1.0 - sine * sine), height = 1.0 / (width * scalar_root(2.0 * PI));
  for (int b = 0; b < BINS; b++) {
    double across = (psi + to->psi[b]) / width;
    double half = 0.5 * (1.0 + cosine * to->cosine[b] + sine * to->sine[b]);
    if (half < (double)WOOD_CONE_LEAST) half = (double)WOOD_CONE_LEAST;
    int far = across > 6.0 || across < -6.0;
    out[b] = far ? 0.0 : scalar_exp(-0.5 * across * across) * height / half;
  }
}

/* Mean over all directions of a row, which runs over the sine of inclination. */
static double mean_of(const float *row, const inclinations *to, const double weight[BINS]) {
  double mean = 0.0;
  for (int b = 0; b < BINS; b++) {
    double x = (to->sine[b] + 1.0) * 0.5 * (WOOD_CONE_PSI - 1);
    int p = x >= WOOD_CONE_PSI - 1 ? WOOD_CONE_PSI - 2 : (int)x;
    mean += weight[b] / PI * ((double)row[p] + (x - p) * ((double)row[p + 1] - (double)row[p]));
  }
  return mean;
}

void cone_table_build(wood_constants *w, double ray_lustre) {
  inclinations to;
  double weight[WOOD_CONE_DIVE][BINS], lobe[BINS], brightest = (double)w->fibre_brightest;
  for (int b = 0; b < BINS; b++) {
    to.sine[b] = (b + 0.5) * 2.0 / BINS - 1.0;
    to.cosine[b] = scalar_root(1.0 - to.sine[b] * to.sine[b]);
    to.psi[b] = angle_of(to.sine[b]);
  }
  for (int d = 0; d < WOOD_CONE_DIVE; d++) {
    sort_directions((double)d / (WOOD_CONE_DIVE - 1), (double)w->inverse_ior, weight[d]);
  }
  for (int p = 0; p < WOOD_CONE_PSI; p++) {
    double sine = 2.0 * p / (WOOD_CONE_PSI - 1) - 1.0;
    lobe_towards((double)w->cone_width, sine, angle_of(sine), &to, lobe);
    for (int d = 0; d < WOOD_CONE_DIVE; d++) {
      double sum = 0.0;
      for (int b = 0; b < BINS; b++) sum += weight[d][b] * lobe[b];
      w->cone_table[d * WOOD_CONE_PSI + p] = (float)sum;
    }
  }
  for (int d = 0; d < WOOD_CONE_DIVE; d++) {
    float *row = w->cone_table + d * WOOD_CONE_PSI;
    double most = 0.0;
    for (int p = 0; p < WOOD_CONE_PSI; p++) most = (double)row[p] > most ? (double)row[p] : most;
    double k = brightest * most > MOST ? MOST / (brightest * most) : 1.0;
    for (int p = 0; p < WOOD_CONE_PSI; p++) row[p] = (float)((double)row[p] * k);
    w->cone_scale[d] = (float)k;
    w->cone_mean[d] = (float)mean_of(row, &to, weight[d]);
    double all = brightest * k * most;
    w->cone_ray[d] = (float)(ray_lustre * all > MOST ? MOST / all : ray_lustre);
  }
}
