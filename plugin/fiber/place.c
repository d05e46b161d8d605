/* SPDX-License-Identifier: Apache-2.0
 *
 * Every strand made, placed and fitted (section 3.2), strand by strand on as
 * many threads as the host lends.
 */
#include <string.h>

#include "../core/meter.h"
#include "../core/status.h"
#include "../core/crew.h"
#include "fit.h"
#include "parameters.h"

#define STRANDS_JOB 32u

/* Uniform in the hull, by rejection: in its box as the paper does, or, which is
 * the same, in those cells of its field that may hold any of it. */
static int place_middle(const fiber *f, uint32_t strand, double out[3]) {
  const hull *h = &f->hull;
  int literal = f->plan.mode == MODE_LITERAL;
  for (uint32_t k = 0; k < f->plan.attempts; k++) {
    double r[3];
    float p[3];
    for (uint32_t a = 0; a < 3; a++)
      r[a] = strand_random(f->plan.shape.seed, strand, STRAND_PLACE, 4 * k + a);
    if (literal) {
      for (int a = 0; a < 3; a++)
        out[a] = (double)h->low[a] + r[a] * ((double)h->high[a] - (double)h->low[a]);
    } else {
      double which = strand_random(f->plan.shape.seed, strand, STRAND_PLACE, 4 * k + 3);
      uint32_t cell = f->grid.candidates[(uint32_t)(which * f->grid.candidate_count)], c[3];
      c[0] = cell % f->grid.cells[0];
      c[1] = cell / f->grid.cells[0] % f->grid.cells[1];
      c[2] = cell / f->grid.cells[0] / f->grid.cells[1];
      for (int a = 0; a < 3; a++)
        out[a] = (double)f->grid.origin[a] + (double)f->grid.spacing * (c[a] + r[a]);
    }
    for (int a = 0; a < 3; a++) p[a] = (float)out[a];
    if (literal ? hull_literal(h, p) > 0 : grid_inside(&f->grid, h, p)) return 1;
  }
  return 0;
}

static uint16_t count_inside(const fiber *f, const float *points) {
  uint16_t n = 0;
  for (uint32_t i = 0; i < f->vertices; i++) {
    const float *p = points + 3 * i;
    n = (uint16_t)(n + (f->plan.mode == MODE_LITERAL ? hull_literal(&f->hull, p) >= 0
                                                     : grid_inside(&f->grid, &f->hull, p)));
  }
  return n;
}

static void write_points(const fiber *f, const double *shape, const strand_pose *pose, float *out) {
  for (uint32_t i = 0; i < f->vertices; i++) {
    const double *v = shape + 3 * i, *t = pose->turn;
    for (int a = 0; a < 3; a++) {
      out[3 * i + (uint32_t)a] =
          (float)(pose->middle[a] + t[3 * a] * v[0] + t[3 * a + 1] * v[1] + t[3 * a + 2] * v[2]);
    }
  }
}

static void place_strand(fiber *f, uint32_t strand) {
  double shape[3 * STRAND_VERTICES_MAX], middle[3];
  uint32_t n = f->vertices;
  strand_result *result = &f->results[strand];
  float *out = f->points + 3 * (size_t)n * strand;
  strand_pose pose;
  if (!place_middle(f, strand, pose.middle)) {
    result->end = END_NOWHERE;
    return;
  }
  strand_make(&f->plan.shape, strand, shape);
  memcpy(middle, shape + 3 * (n / 2), sizeof middle);
  for (uint32_t i = 0; i < 3 * n; i++) shape[i] -= middle[i % 3];
  strand_rotation(f->plan.shape.seed, strand, pose.turn);
  write_points(f, shape, &pose, out);
  result->inside_first = count_inside(f, out);
  fit_strand(f, shape, &pose, result);
  write_points(f, shape, &pose, out);
  result->inside = count_inside(f, out);
  double spread = f->plan.diameter_spread, r = 0.5 * f->plan.diameter;
  if (spread > 0) r *= 1 + spread * strand_normal(f->plan.shape.seed, strand, STRAND_SIZE, 1);
  f->radii[strand] = (float)(r > 0.05 * f->plan.diameter ? r : 0.05 * f->plan.diameter);
}

static void place_job(void *context, uint32_t job) {
  fiber *f = context;
  uint32_t end = (job + 1) * STRANDS_JOB;
  for (uint32_t i = job * STRANDS_JOB; i < end && i < f->strands; i++) place_strand(f, i);
}

uint64_t fiber_strand_bytes(const fiber *f) {
  return ((uint64_t)f->strands * f->vertices * 3 + 1) * sizeof(float) +
         (f->strands + 1ull) * (sizeof(float) + sizeof *f->results);
}

int32_t fiber_place(fiber *f, const sozai_host *host) {
  if (f->plan.mode != MODE_LITERAL && !f->grid.candidate_count)
    return fail(SOZAI_ERROR_RANGE,
                "hull: its %u triangles enclose nothing that %u cells along its longest side show",
                f->hull.given, f->plan.cells);
  uint64_t bytes = fiber_strand_bytes(f);
  if (host_rehearses(host)) return host_claim(host, bytes);
  int32_t r = host_has_room(host, bytes);
  if (r) return r;
  f->points = host_alloc(host, ((size_t)f->strands * f->vertices * 3 + 1) * sizeof(float), 64);
  f->radii = host_alloc(host, (f->strands + 1ull) * sizeof(float), 64);
  f->results = host_alloc(host, (f->strands + 1ull) * sizeof *f->results, 64);
  if (!f->points || !f->radii || !f->results) return SOZAI_ERROR_MEMORY;
  uint32_t jobs = (f->strands + STRANDS_JOB - 1) / STRANDS_JOB;
  double end = f->plan.contact == CONTACT_OFF ? 1.0 : 0.6;
  r = crew_run(host, jobs, place_job, f, (crew_progress){"fitting strands", 0.2, end});
  for (uint32_t i = 0; !r && i < f->strands; i++) {
    if (f->results[i].end != END_NOWHERE) continue;
    r = fail(
        SOZAI_ERROR_RANGE,
        "hull: of %u places tried for strand %u none is inside: it encloses nothing, or hardly "
        "anything",
        f->plan.attempts, i);
  }
  return r;
}
