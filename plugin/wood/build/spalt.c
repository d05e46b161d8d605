/* SPDX-License-Identifier: Apache-2.0
 *
 * Spalting: where colonies lie, and what a wide footprint is to expect of them.
 */
#include "parts.h"

#include "../../core/scalar.h"
#include "../parameters.h"

/* how bleached the first's and the second's shares are, measured (property.filter) */
#define SPALT_BLEACH 0.524
#define SPALT_BLEACH_SECOND 0.395

/* Of a colony whose edge is at `level` of a noise with the first octave at `scale`: the
 * share of wood within, and mm of edge to a mm^2 of wood, times the colonies' size; returns
 * the noise's variance. The noise is nearly normal, and its slope does not depend on it: a level
 * set's area is the density times the mean slope (S. O. Rice, 1944). */
static double spalt_expect(double level, double scale, double *within, double *edge) {
  double variance = (double)SPALT_VARIANCE, slope = (double)SPALT_SLOPE * scale * scale;
  for (int o = 1; o < SPALT_OCTAVES; o++) {
    double weight = (double)spalt_weight[o], steep = weight * (double)spalt_scale[o];
    variance += (double)SPALT_VARIANCE * weight * weight;
    slope += (double)SPALT_SLOPE * steep * steep;
  }
  double density = scalar_exp(-0.5 * level * level / variance) * 0.39894228;
  /* the mean length of a normal gradient that is 2.5 times flatter along the fibre */
  *edge = density * scalar_root(slope / variance) * 1.30;
  double z = level / scalar_root(variance), t = 1.0 / (1.0 + 0.33267 * z);
  *within = density * t * (0.4361836 + t * (-0.1201676 + 0.937298 * t));
  return variance;
}

void wood_build_spalt(wood_constants *w, const settings *s) {
  double amount = number_at(s, P_SPALT), size = number_at(s, P_SPALT_SIZE);
  double width = number_at(s, P_SPALT_WIDTH), within[2], edge[2];
  w->has_spalt = amount > 0.0;
  for (int c = 0; c < 3; c++) w->spalt_pale[c] = 0.8f;
  w->spalt_frequency = (float)(1.0 / size);
  w->spalt_width = (float)width;
  double level = 0.46 - 0.42 * amount, other = 0.5 - 0.42 * amount;
  w->spalt_level = (float)level;
  w->spalt_other = (float)other;
  double variance = spalt_expect(level, 1.0, &within[0], &edge[0]);
  spalt_expect(other, (double)SPALT_SECOND, &within[1], &edge[1]);
  double left = 1.0 - within[0], outside = left * (1.0 - within[1]);
  /* beyond the first colonies their own octave is low, which thins the second's lines and
   * bleaching: the mean of a normal number below a level */
  double spread = scalar_root(variance);
  double low = (double)SPALT_DEVIATION / spread * 0.39894228 *
               scalar_exp(-0.5 * level * level / variance) / left;
  double longest = edge[0] + left * edge[1];
  double lines = (edge[0] + left * edge[1] * (1.0 - (double)SPALT_SWELL * low)) * width / size;
  w->spalt_line_mean = (float)(lines < 1.0 ? lines : 1.0);
  w->spalt_bleach_mean = (float)(SPALT_BLEACH * within[0] +
                                 SPALT_BLEACH_SECOND * left * within[1] * (1.0 - 0.3 * low));
  /* how stains lie between colonies: measured */
  w->spalt_stain_mean = (float)(longest * (double)SPALT_STAIN * (0.046 + 0.51 * outside));
}
