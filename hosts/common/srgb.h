/* SPDX-License-Identifier: Apache-2.0
 * sRGB's curve (IEC 61966-2-1), for where there is no colour service. */
#ifndef SOZAI_HOSTS_SRGB_H
#define SOZAI_HOSTS_SRGB_H

#include <math.h>

/* Encoded to linear, 0 to 1. */
static inline double srgb_to_linear(double x) {
  return x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4);
}

#endif
