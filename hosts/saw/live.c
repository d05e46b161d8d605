/* SPDX-License-Identifier: Apache-2.0
 *
 * Live-sawn, through and through: parallel planes, and of each slab what is
 * free of wane on both faces, turned so that its face looks to the bark. */
#include "plan.h"

#include <math.h>

/* Width of the board whose middle is `q` from the pith. */
static double board_width(const saw_job *job, double q) {
  return 2 * saw_half_chord(job, fabs(q) + 0.5 * job->thickness);
}

/* How many boards lie beyond the first on a side. */
static int boards_beyond(const saw_job *job, double first) {
  double step = job->thickness + job->kerf;
  int n = 0;
  while (n <= SAW_MOST_BOARDS && board_width(job, first + (n + 1) * step) >= saw_least_width(job))
    n++;
  return n;
}

/* The stack with a board or a saw cut about the pith, whichever gives more. */
static double area_of(const saw_job *job, double first) {
  double step = job->thickness + job->kerf, sum = 0;
  int n = boards_beyond(job, first);
  for (int i = first > 0 ? 0 : -n; i <= n; i++) {
    double width = board_width(job, first + i * step);
    if (width >= saw_least_width(job)) sum += first > 0 ? 2 * width : width;
  }
  return sum;
}

bool saw_live(saw_plan *p, const saw_job *job, failure *why) {
  double step = job->thickness + job->kerf;
  double first = area_of(job, 0) >= area_of(job, 0.5 * step) ? 0 : 0.5 * step;
  int n = boards_beyond(job, first);
  for (int i = n; i >= (first > 0 ? -n - 1 : -n); i--) {
    double q = first + i * step, width = board_width(job, q);
    if (width < saw_least_width(job)) continue;
    if (!saw_add(p, job, job->azimuth + (q < 0 ? 180 : 0), -0.5 * width, 0.5 * width,
                 fabs(q) - 0.5 * job->thickness, why))
      return false;
  }
  return true;
}
