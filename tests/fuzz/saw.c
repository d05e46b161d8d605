/* SPDX-License-Identifier: Apache-2.0
 * Sawing plans of any numbers: refused, or boards that lie as plan.h says. */
#include <math.h>
#include <string.h>

#include "fuzz.h"
#include "plan.h"

/* The farthest corner's distance from the pith. */
static double reach(const saw_board *b) {
  double along[2], out[2];
  saw_board_axes(b, along, out);
  double a = fabs(b->centre[0] * along[0] + b->centre[1] * along[1]) + 0.5 * b->width;
  double q = fabs(b->centre[0] * out[0] + b->centre[1] * out[1]) + 0.5 * b->thickness;
  return hypot(a, q);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static saw_plan p;
  bytes b = {data, size};
  saw_job job = {.plan = (int)take_below(&b, SAW_PLANS)};
  double *const numbers[] = {&job.radius, &job.thickness, &job.kerf, &job.width, &job.azimuth};
  static const double most[] = {1000, 100, 10, 300, 360};
  for (int i = 0; i < 5; i++) *numbers[i] = take_number(&b, 0, most[i]);
  /* hundreds of boards take their time to be fitted into a log */
  if (job.plan == SAW_RIFT && job.thickness < job.radius / 40) job.thickness = job.radius / 30;
  failure why = {0, ""};
  if (!saw_plan_make(&p, &job, &why)) {
    CHECK(*why.text && !strchr(why.text, '\n'));
    return 0;
  }
  CHECK(p.count > 0 && p.count <= SAW_MOST_BOARDS && isfinite(saw_area(&p)));
  for (size_t i = 0; i < p.count; i++) {
    CHECK(isfinite(p.boards[i].width) && isfinite(p.boards[i].thickness));
    if (job.plan != SAW_ROTARY) CHECK(reach(&p.boards[i]) <= job.radius * (1 + 1e-9));
  }
  if (job.plan != SAW_ROTARY && p.count < 60)
    for (size_t i = 0; i < p.count; i++)
      for (size_t k = 0; k < i; k++)
        CHECK(saw_gap(&p.boards[i], &p.boards[k]) >= job.kerf - 1e-9 * job.radius);
  return 0;
}
