/* SPDX-License-Identifier: Apache-2.0
 *
 * Rotary-cut: a sheet peeled off the turning log from the bark to a core that
 * the lathe holds, and clipped where it is to be no longer than so much. */
#include "plan.h"

#include <math.h>

#define MOST 10.0 /* mm: as wood's veneer_thickness */
#define CORE 45.0 /* mm: the radius that is left, or a third of the log's */

double saw_sheet_length(double from, double to, double thickness) {
  return SAW_PI * (from * from - to * to) / thickness;
}

bool saw_rotary(saw_plan *p, const saw_job *job, failure *why) {
  double core = fmin(CORE, job->radius / 3), t = job->thickness;
  double length = saw_sheet_length(job->radius, core, t), n = 1;
  if (t > MOST)
    return fail(why, EXIT_BAD_INPUT, "--thickness: a veneer of %.9g mm; 0.1 to %.9g mm", t, MOST);
  if (job->width > 0) n = ceil(length / job->width - 1e-9);
  if (n > SAW_MOST_BOARDS)
    return fail(why, EXIT_BAD_INPUT,
                "--width: a veneer of %.0f m in sheets of %.9g mm is more than %d of them",
                length / 1000, job->width, SAW_MOST_BOARDS);
  for (int i = 0; i < (int)n; i++) {
    double share = length / n * t / SAW_PI, square = job->radius * job->radius;
    saw_board b = {.plan = SAW_ROTARY, .width = length / n, .thickness = t};
    b.from = sqrt(square - i * share);
    b.to = i + 1 < (int)n ? sqrt(square - (i + 1) * share) : core;
    /* its middle, where the recipe's x is 0 */
    double middle = sqrt(square - (i + 0.5) * share), turns = (job->radius - middle) / t;
    b.rotation = job->azimuth - 360 * fmod(turns, 1);
    double along[2], out[2];
    saw_board_axes(&b, along, out);
    b.centre[0] = middle * out[0];
    b.centre[1] = middle * out[1];
    p->boards[p->count++] = b;
  }
  return true;
}
