/* SPDX-License-Identifier: Apache-2.0
 *
 * The angle of a direction, the same bits everywhere.
 */
#ifndef SOZAI_TREE_ANGLE_H
#define SOZAI_TREE_ANGLE_H

#include "../core/scalar.h"

/* Of the direction (right, ahead) from ahead towards right: degrees, -180 to
 * 180; 0 of no direction. Off by less than 1e-10. */
static inline double angle_of(double right, double ahead) {
  double r = right < 0.0 ? -right : right, a = ahead < 0.0 ? -ahead : ahead;
  if (!(r > 0.0 || a > 0.0)) return 0.0;
  double low = r < a ? r : a, high = r < a ? a : r, x = low / high;
  /* halved twice: tan(pi/4) becomes tan(pi/16) */
  x = x / (1.0 + scalar_root(1.0 + x * x));
  x = x / (1.0 + scalar_root(1.0 + x * x));
  double z = -x * x, term = x, sum = x;
  for (int k = 3; k <= 25; k += 2) {
    term *= z;
    sum += term / k;
  }
  double degrees = 4.0 * sum * (180.0 / 3.14159265358979323846);
  if (r > a) degrees = 90.0 - degrees;
  if (ahead < 0.0) degrees = 180.0 - degrees;
  return right < 0.0 ? -degrees : degrees;
}

#endif
