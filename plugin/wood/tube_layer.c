/* SPDX-License-Identifier: Apache-2.0 */
#include "tube_layer.h"

#include "../core/scalar.h"

/* Over the section, of sizes g = a + (1 - a) u^2 and t = 4 f (1 - f), u and f
 * uniform: the means of g t and of (g t)^4. */
static double mean_size(double a) { return (a + (1.0 - a) / 3.0) * 2.0 / 3.0; }
static double mean_fourth(double a) {
  double b = 1.0 - a, aa = a * a, bb = b * b;
  double g4 =
      aa * aa + 4.0 / 3.0 * aa * a * b + 1.2 * aa * bb + 4.0 / 7.0 * a * b * bb + bb * bb / 9.0;
  return g4 * 256.0 / 630.0;
}

/* density: tubes to a mm^2. */
static void layer(wood_tubes *m, double radius, double length, double least, double density) {
  /* every other cell has one; a tube keeps within half a cell, blurred a little */
  double share = 0.5, cell = __builtin_sqrt(share / density), narrow = 2.5 * radius;
  if (cell < narrow) {
    share = density * narrow * narrow;
    cell = narrow;
  }
  if (share > 1.0) share = 1.0;
  m->cell = (float)cell;
  m->inverse_cell = (float)(1.0 / cell);
  m->share = (float)share;
  m->radius = (float)radius;
  m->least = (float)least;
  m->inverse_length = (float)(1.0 / length);
  /* as vessels': the blurred disc's half length is sqrt(1.25 (R^2 + e^2 / (12 * 0.2552))) */
  double clear = 0.5 * cell, r2 = radius * radius;
  double e2 = (clear * clear / 1.25 - r2) * 12.0 * 0.2552;
  m->reach = (float)__builtin_sqrt(e2 > r2 ? e2 : r2);
  double fourth = share / (cell * cell) * mean_fourth(least);
  m->mean = (float)(fourth * PI * r2);
  m->slope2 = (float)(fourth * 2.0 * PI * 1.6 * 1.6);
}

void tubes_met(wood_tubes *m, double radius, double length, double least, double count) {
  layer(m, radius, length, least, count / (2.0 * radius * mean_size(least)));
}

void tubes_filling(wood_tubes *m, double radius, double length, double least, double mean) {
  layer(m, radius, length, least, mean / (PI * radius * radius * mean_fourth(least)));
}
