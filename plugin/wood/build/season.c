/* SPDX-License-Identifier: Apache-2.0
 *
 * How a ring goes from earlywood to latewood.
 */
#include "parts.h"

#include "../parameters.h"

void wood_build_season(wood_constants *w, const settings *s) {
  double fraction = number_at(s, P_LATE_FRACTION), gradual = 1.0 - number_at(s, P_LATE_ABRUPTNESS);
  double middle = 1.0 - fraction;
  double before = middle * (0.03 + 0.87 * gradual), after = fraction * (0.08 + 0.52 * gradual);
  w->late_middle = (float)middle;
  w->late_start = (float)(middle - before);
  w->inverse_late_before = (float)(1.0 / before);
  w->late_sixth = (float)(before / 6.0);
  w->late_after = (float)after;
  w->inverse_late_after = (float)(1.0 / after);
  w->late_deepening = (float)number_at(s, P_LATE_DEEPENING);
  w->inverse_late_full = (float)(1.0 / (1.0 - middle - after));
}
