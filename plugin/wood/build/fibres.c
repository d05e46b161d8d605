/* SPDX-License-Identifier: Apache-2.0
 *
 * Fibres: the brightness of bundles, and how they move the growth front.
 */
#include "parts.h"

#include "../parameters.h"

#define DRIFT_RADIAL 2.5 /* times as far along the stem as along its radius */

static void build_drift(wood_constants *w, const settings *s) {
  const double sd = 0.42885; /* of the noise, over its bound: the root of FIBRE_VARIANCE */
  double length = number_at(s, P_DRIFT_LENGTH);
  w->drift = (float)(number_at(s, P_DRIFT) / sd / NOISE_BOUND);
  w->drift_length = (float)length;
  w->drift_frequency = (float)(1.0 / length);
  w->drift_frequency_radial = (float)(DRIFT_RADIAL / length);
}

void wood_build_fibres(wood_constants *w, const settings *s) {
  static const double size[WOOD_FIBRE_OCTAVES] = {1.0, WOOD_BUNDLE, 60.0};
  static const double weight[WOOD_FIBRE_OCTAVES] = {0.34, 0.33, 0.33};
  /* of the growth front: a cell more or less in a radial file of them, and bundles */
  static const double bundle[WOOD_FIBRE_OCTAVES] = {0.25, 0.4, 0.35};
  build_drift(w, s);
  double most = 0.25 * number_at(s, P_RING_WIDTH), stray = number_at(s, P_LATE_STRAY);
  if (stray > most) stray = most;
  w->has_front = stray > 0.0;
  for (int o = 0; o < WOOD_FIBRE_OCTAVES; o++) {
    double l = number_at(s, P_FIBRE_WIDTH) * size[o];
    w->fibre_scale[o] = (float)(number_at(s, P_FIBRE_BRIGHTNESS) * weight[o] / NOISE_BOUND);
    w->fibre_frequency[o] = (float)(1.0 / l);
    w->fibre_blur[o] = (float)(0.125 / (l * l));
    double front = stray * bundle[o];
    w->fibre_front[o] = (float)(front / NOISE_BOUND);
    w->fibre_variance[o] = (float)(front * front * FIBRE_VARIANCE);
  }
}
