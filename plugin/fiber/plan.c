/* SPDX-License-Identifier: Apache-2.0
 *
 * From settings to what is to be done.
 */
#include "../core/limits.h"
#include "../core/scalar.h"
#include "../core/status.h"
#include "fiber.h"
#include "parameters.h"

#define TIP 0.25 /* of the length, over which an end tapers */

static void take_colour(float to[3], const setting *s) {
  for (int c = 0; c < 3; c++) to[c] = (float)s->number[c];
}

void plan_fiber(fiber_plan *p, const settings *s) {
  p->shape = (strand_shape){.vertices = (uint32_t)number_at(s, F_VERTICES),
                            .seed = (uint32_t)number_at(s, F_SEED),
                            .length = number_at(s, F_LENGTH),
                            .length_spread = number_at(s, F_LENGTH_SPREAD),
                            .phi_min = number_at(s, F_PHI_MIN),
                            .phi_max = number_at(s, F_PHI_MAX),
                            .theta_min = number_at(s, F_THETA_MIN),
                            .theta_max = number_at(s, F_THETA_MAX)};
  p->mode = choice_at(s, F_MODE);
  p->contact = choice_at(s, F_CONTACT);
  p->count = (uint32_t)number_at(s, F_COUNT);
  p->packing = number_at(s, F_PACKING);
  p->diameter = number_at(s, F_DIAMETER) * 1e-3;
  p->diameter_spread = number_at(s, F_DIAMETER_SPREAD);
  p->taper = number_at(s, F_TAPER);
  p->cells = (uint32_t)number_at(s, F_CELLS);
  p->spacing = number_at(s, F_SPACING);
  int literal = p->mode == MODE_LITERAL;
  p->halvings = literal ? 0 : (uint32_t)number_at(s, F_HALVINGS);
  p->iterations = (uint32_t)number_at(s, F_ITERATIONS);
  p->attempts = (uint32_t)number_at(s, F_ATTEMPTS);
  p->rounds = (uint32_t)number_at(s, F_ROUNDS);
  p->clearance = number_at(s, F_CLEARANCE) * p->diameter;
  p->step = number_at(s, F_STEP);
  if (!(p->step > 0)) p->step = p->shape.length / (literal ? 40 : 10);
  p->turn = number_at(s, F_TURN) * (PI / 180);
  if (!(p->turn > 0)) p->turn = 2 * p->step / p->shape.length;
  if (p->turn > 0.5 * PI) p->turn = 0.5 * PI;
  p->share_2 = number_at(s, F_SHARE_2);
  take_colour(p->colour[0], &s->list[F_COLOUR]);
  take_colour(p->colour[1], &s->list[F_COLOUR_2]);
}

double fiber_profile(const fiber_plan *p, double t) {
  double u = (t < 0.5 ? t : 1 - t) / TIP;
  if (u >= 1) return 1;
  return p->taper + (1 - p->taper) * u * (2 - u);
}

double fiber_strand_volume(const fiber_plan *p, double length, double radius) {
  double sum = 0;
  for (int i = 0; i < 64; i++) {
    double w = fiber_profile(p, (i + 0.5) / 64);
    sum += w * w / 64;
  }
  return PI * radius * radius * length * sum;
}

int32_t plan_count(fiber *f, const sozai_host *host) {
  const fiber_plan *p = &f->plan;
  double n = p->count;
  if (!p->count) {
    if (p->mode == MODE_LITERAL)
      return fail(SOZAI_ERROR_RANGE,
                  "count: 0, the packing's, goes with mode=field or exact: the literal "
                  "one has no volume");
    double one = fiber_strand_volume(p, p->shape.length, 0.5 * p->diameter) *
                 (1 + p->diameter_spread * p->diameter_spread);
    n = p->packing * f->grid.volume / one;
    n = n < 1 ? 1 : n + 0.5;
  }
  const char *from = p->count ? "count" : "packing, as strands";
  uint64_t strands = n < 1e18 ? (uint64_t)n : (uint64_t)1e18;
  uint64_t most = limit_of(host, LIMIT_STRAND_POINTS);
  int32_t r = limit_check(host, LIMIT_STRANDS, strands, from);
  if (r) return r;
  if (strands > most / p->shape.vertices)
    return fail(SOZAI_ERROR_LIMIT,
                "%s: %llu strands of %u vertices are above the ceiling strand_points, %llu", from,
                (unsigned long long)strands, p->shape.vertices, (unsigned long long)most);
  f->strands = (uint32_t)strands;
  f->vertices = p->shape.vertices;
  return SOZAI_OK;
}
