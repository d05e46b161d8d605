/* SPDX-License-Identifier: Apache-2.0 */
#include "plan.h"

#include <math.h>

const char *const saw_plan_names[SAW_PLANS] = {"live", "quarter", "rift", "rotary"};

void saw_board_axes(const saw_board *b, double along[2], double out[2]) {
  double a = b->rotation * SAW_PI / 180;
  along[0] = cos(a);
  along[1] = sin(a);
  out[0] = -along[1];
  out[1] = along[0];
}

/* By the four directions of their sides: what separates them along one of these
 * separates them at least so far. */
double saw_gap(const saw_board *a, const saw_board *b) {
  double axes[4][2], most = -1e30;
  saw_board_axes(a, axes[0], axes[1]);
  saw_board_axes(b, axes[2], axes[3]);
  const double half[4] = {0.5 * a->width, 0.5 * a->thickness, 0.5 * b->width, 0.5 * b->thickness};
  double dx = b->centre[0] - a->centre[0], dz = b->centre[1] - a->centre[1];
  for (int i = 0; i < 4; i++) {
    double gap = fabs(dx * axes[i][0] + dz * axes[i][1]);
    for (int k = 0; k < 4; k++)
      gap -= half[k] * fabs(axes[k][0] * axes[i][0] + axes[k][1] * axes[i][1]);
    if (gap > most) most = gap;
  }
  return most;
}

double saw_area(const saw_plan *p) {
  double sum = 0;
  for (size_t i = 0; i < p->count; i++) sum += p->boards[i].width * p->boards[i].thickness;
  return sum;
}

double saw_least_width(const saw_job *job) {
  double least = fmax(25, job->thickness);
  return job->width > 0 ? fmin(least, job->width) : least;
}

double saw_half_chord(const saw_job *job, double q) {
  double square = job->radius * job->radius - q * q;
  return square > 0 ? sqrt(square) : 0;
}

bool saw_add(saw_plan *p, const saw_job *job, double rotation, double a0, double a1, double q,
             failure *why) {
  double whole = a1 - a0, n = 1;
  if (job->width > 0 && whole > job->width)
    n = ceil((whole + job->kerf) / (job->width + job->kerf) - 1e-9);
  if ((double)p->count + n > SAW_MOST_BOARDS)
    return fail(why, EXIT_BAD_INPUT,
                "--thickness: boards of %.9g mm are more than %d of a log of radius %.1f mm",
                job->thickness, SAW_MOST_BOARDS, job->radius);
  double width = (whole - (n - 1) * job->kerf) / n;
  saw_board b = {
      .plan = job->plan, .rotation = rotation, .width = width, .thickness = job->thickness};
  double along[2], out[2], middle = q + 0.5 * job->thickness;
  saw_board_axes(&b, along, out);
  for (int i = 0; i < (int)n; i++) {
    double a = a0 + 0.5 * width + i * (width + job->kerf);
    b.centre[0] = a * along[0] + middle * out[0];
    b.centre[1] = a * along[1] + middle * out[1];
    p->boards[p->count++] = b;
  }
  return true;
}

static bool in_range(const char *name, double value, double low, double high, failure *why) {
  return (value >= low && value <= high) || /* false of a NaN */
         fail(why, EXIT_BAD_INPUT, "--%s: %.9g mm is outside %.9g to %.9g mm", name, value, low,
              high);
}

bool saw_plan_make(saw_plan *p, const saw_job *job, failure *why) {
  static bool (*const plans[SAW_PLANS])(saw_plan *, const saw_job *,
                                        failure *) = {saw_live, saw_quarter, saw_rift, saw_rotary};
  p->count = 0;
  if (!(job->radius >= 10 && job->radius <= 20000))
    return fail(why, EXIT_BAD_INPUT, "the log's radius of %.9g mm is outside 10 to 20000 mm",
                job->radius);
  if (!in_range("thickness", job->thickness, 0.1, 1000, why) ||
      !in_range("kerf", job->kerf, 0, 100, why) ||
      (job->width != 0 && !in_range("width", job->width, 5, 1e6, why)))
    return false;
  /* of more turns too few digits are left for the boards' own directions */
  if (!(fabs(job->azimuth) <= 36000))
    return fail(why, EXIT_BAD_INPUT, "--azimuth: %.9g degrees is outside -36000 to 36000",
                job->azimuth);
  if (!plans[job->plan](p, job, why)) return false;
  if (p->count == 0)
    return fail(why, EXIT_BAD_INPUT,
                "--thickness: no board of %.9g mm and at least %.9g mm wide is in a %s-sawn log of "
                "radius %.1f mm",
                job->thickness, saw_least_width(job), saw_plan_names[job->plan], job->radius);
  return true;
}
