/* SPDX-License-Identifier: Apache-2.0
 *
 * Fibre as a generator: the order in which an aggregate is made.
 */
#include "generator.h"

#include "../core/status.h"
#include "curves.h"
#include "fiber.h"
#include "parameters.h"

static const sozai_generator_info *describe(void) {
  static sozai_generator_info info = {
      .size = sizeof(sozai_generator_info),
      .revision = 2,
      .id = "fiber",
      .label = "Fibre aggregate",
      .doc =
          "Staple fibres, crimped each by its own, packed into a hull: cotton, wool, felt, dust.",
      .parameters = fiber_parameters,
      .tables = fiber_table_infos,
      .parameter_count = FIBER_PARAMETER_COUNT,
      .table_count = FIBER_TABLES,
  };
  if (!info.presets) info.presets = fiber_presets(&info.preset_count);
  return &info;
}

static int32_t read_hull(fiber *f, const sozai_host *host, const settings *s) {
  const sozai_buffer *mesh = s->list[F_HULL].buffer, *points = s->list[F_POINTS].buffer;
  int literal = f->plan.mode == MODE_LITERAL;
  if (points && !literal)
    return fail(SOZAI_ERROR_RANGE, "hull_points: goes with mode=literal; the others want a hull");
  if (points && mesh) return fail(SOZAI_ERROR_RANGE, "hull_points: and hull: one of them");
  if (!points && !mesh)
    return fail(SOZAI_ERROR_ARGUMENT, "hull: none is given: a mesh to fill, as a buffer");
  if (points) return hull_from_points(&f->hull, host, points);
  double spacing = f->plan.spacing;
  if (literal && !(spacing > 0)) {
    /* the box is known once it is read: a hundredth of its longest side */
    double low[3] = {1e30, 1e30, 1e30}, side = 0;
    double high[3] = {-1e30, -1e30, -1e30};
    for (uint64_t i = 0; i < 3 * mesh->dims[0]; i++) {
      double x = (double)mesh->points[i];
      low[i % 3] = x < low[i % 3] ? x : low[i % 3];
      high[i % 3] = x > high[i % 3] ? x : high[i % 3];
    }
    for (int a = 0; a < 3; a++) side = high[a] - low[a] > side ? high[a] - low[a] : side;
    spacing = side > 0 ? side / 100 : 1;
  }
  return hull_from_mesh(&f->hull, host, mesh, literal ? spacing : 0);
}

static int32_t grow(void *state, const sozai_host *host, const settings *s) {
  fiber *f = state;
  plan_fiber(&f->plan, s);
  int32_t r = host_progress(host, 0.0, "reading the hull");
  if (!r) r = read_hull(f, host, s);
  if (!r && f->plan.mode != MODE_LITERAL) r = grid_make(&f->grid, host, &f->hull, f->plan.cells);
  if (!r) r = plan_count(f, host);
  if (!r) r = fiber_place(f, host);
  if (!r && f->plan.contact != CONTACT_OFF) r = fiber_keep_apart(f, host);
  if (!r) r = fiber_report(f, host);
  return r;
}

static void release(void *state, const sozai_host *host) {
  fiber *f = state;
  hull_free(&f->hull, host);
  grid_free(&f->grid, host);
  host_free(host, f->points, ((size_t)f->strands * f->vertices * 3 + 1) * sizeof(float), 64);
  host_free(host, f->radii, (f->strands + 1ull) * sizeof(float), 64);
  host_free(host, f->results, (f->strands + 1ull) * sizeof *f->results, 64);
  for (int i = 0; i < FIBER_TABLES; i++)
    host_free(host, f->tables[i].data, (size_t)(f->tables[i].room + 1) * sizeof(float), 64);
}

static const float *table(const void *state, uint32_t index, uint64_t *rows) {
  const fiber *f = state;
  *rows = f->tables[index].rows;
  return f->tables[index].data;
}

static uint64_t bytes(const void *state) {
  const fiber *f = state;
  /* arrays that may be empty have an element more */
  uint64_t n = hull_bytes(&f->hull) + grid_bytes(&f->grid) +
               (f->grid.bricks ? sizeof(float) + 2 * sizeof(uint32_t) : 0) + fiber_strand_bytes(f);
  for (int i = 0; i < FIBER_TABLES; i++) n += (f->tables[i].room + 1) * sizeof(float);
  return n;
}

static int32_t mesh(const void *state, const sozai_host *host, uint32_t level, mesh_block **out) {
  return fiber_mesh(state, host, level, out);
}

static int32_t curves(const void *state, const sozai_host *host, uint32_t level,
                      curves_block **out) {
  return fiber_curves(state, host, level, out);
}

const generator fiber_generator = {describe, sizeof(fiber), grow,  release,
                                   mesh,     curves,        table, bytes};
