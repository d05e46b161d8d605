/* SPDX-License-Identifier: Apache-2.0
 *
 * How much latewood a part of a ring has. Inline, since creation asks about a thousand times.
 */
#ifndef SOZAI_WOOD_BUILD_LATE_H
#define SOZAI_WOOD_BUILD_LATE_H

#include "../wood.h"

static inline double within01(double x) { return x < 0.0 ? 0.0 : x > 1.0 ? 1.0 : x; }

/* From the ring's start to phase f, as the kernel's late_integral; after season.c. */
static inline double late_profile_integral(const wood_constants *w, double f) {
  double before = 6.0 * (double)w->late_sixth, after = (double)w->late_after;
  double past = f - (double)w->late_middle;
  double a = within01((f - (double)w->late_start) / before), b = 1.0 - within01(past / after);
  double full = past > after ? past - after : 0.0;
  double missing = after * (2.0 / 3.0 - b + b * b * b / 3.0) +
                   full * (1.0 - 0.5 * full * (double)w->inverse_late_full);
  return before / 6.0 * a * a * a + after * (5.0 / 6.0 - b + b * b * b / 6.0) + full -
         (double)w->late_deepening * missing;
}

#endif
