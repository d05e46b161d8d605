/* SPDX-License-Identifier: Apache-2.0
 *
 * Quarter-sawn: the log in four, and each quarter by turns from its two faces,
 * for as long as the rings stand at 45 degrees or more to the face in its middle. */
#include "plan.h"

#include <math.h>

/* In a quarter, u and v from the pith along its faces; what has been sawn off:
 * a across u, b across v. */
static bool saw_one(saw_plan *p, const saw_job *job, double azimuth, failure *why) {
  double a = 0.5 * job->kerf, b = a, step = job->thickness + job->kerf;
  for (int failed = 0, side = 0; failed < 2; side ^= 1) {
    double inner = side ? b : a, under = side ? a : b;
    double outer = saw_half_chord(job, under + job->thickness);
    bool flat = under + 0.5 * job->thickness > 0.5 * (inner + outer);
    if (flat || outer - inner < saw_least_width(job)) {
      failed++;
      continue;
    }
    failed = 0;
    bool ok = side ? saw_add(p, job, azimuth - 90, -outer, -inner, a, why)
                   : saw_add(p, job, azimuth, inner, outer, b, why);
    if (!ok) return false;
    *(side ? &a : &b) += step;
  }
  return true;
}

bool saw_quarter(saw_plan *p, const saw_job *job, failure *why) {
  for (int i = 0; i < 4; i++)
    if (!saw_one(p, job, job->azimuth + 90 * i, why)) return false;
  return true;
}
