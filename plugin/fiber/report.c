/* SPDX-License-Identifier: Apache-2.0
 *
 * The tables that an aggregate answers with.
 */
#include "../core/meter.h"
#include "../core/status.h"
#include "../table.h"
#include "fiber.h"
#include "parameters.h"

static const sozai_column statistics_columns[] = {
    {"strands", "", "How many."},
    {"vertices", "", "Of each."},
    {"iterations", "", "Moves of the strand that moved most: what the paper counts."},
    {"mean_moves", "", "Of all strands."},
    {"moved", "", "Strands that moved."},
    {"inside_first", "", "Share of vertices inside the hull, as first placed."},
    {"inside", "", "Share of vertices inside, after."},
    {"whole_inside_first", "", "Share of strands with no vertex outside, as first placed."},
    {"whole_inside", "", "Share of strands with no vertex outside, after."},
    {"ended_inside", "", "Strands by how their fitting ended: none outside,"},
    {"ended_best", "", "no move a gain,"},
    {"ended_visited", "", "back at a pose that was,"},
    {"ended_bound", "", "at the most iterations."},
    {"distance_first", "mm", "Mean signed distance of vertices, as first placed; inside positive."},
    {"distance", "mm", "After."},
    {"packing", "", "Strands' volume over the hull's; literal: 0."},
    {"hull_volume", "mm3", "Literal: 0."},
    {"hull_area", "mm2", ""},
    {"hull_items", "", "Triangles with an area; literal: vertices."},
    {"hull_rule", "", "0: closed and turned one way; 1: closed; 2: open; 3: literal."},
    {"hull_x", "mm", "The middle of its box."},
    {"hull_y", "mm", ""},
    {"hull_z", "mm", ""},
    {"hull_side", "mm", "The longest side of its box."},
    {"contacts_first", "",
     "Pairs of segments of different strands that overlap, before; contact=off: 0."},
    {"contacts", "", "After."},
    {"deepest_first", "mm", "The deepest overlap, before."},
    {"deepest", "mm", "After."},
    {"contact_strands", "", "Strands that overlap another, after."},
    {"contact_rounds", "", ""},
    {"megabytes", "MB", "That it holds."}};

static const sozai_column strands_columns[] = {
    {"moves", "", "That its fitting made."},
    {"end", "", "0: inside; 1: no move a gain; 2: at a pose that was; 3: at the most iterations."},
    {"inside_first", "", "Vertices inside the hull, as first placed."},
    {"inside", "", "After."},
    {"sum_first", "mm", "C, the sum of its vertices' distances, as first placed."},
    {"sum", "mm", "After fitting."},
    {"length", "mm", "Along it."},
    {"radius", "mm", "Of its middle."}};

TABLE(statistics, "statistics", "One row.");
TABLE(strands, "strands", "One row a strand, by its id.");

const sozai_table_info *const fiber_table_infos[FIBER_TABLES] = {
    [TABLE_STATISTICS] = &statistics, [TABLE_STRANDS] = &strands};

static int32_t make_table(fiber *f, const sozai_host *host, int which, uint64_t rows) {
  fiber_table *t = &f->tables[which];
  uint64_t room = rows * fiber_table_infos[which]->column_count;
  if (host_rehearses(host)) return host_claim(host, (room + 1) * sizeof(float));
  t->room = room;
  t->rows = rows;
  t->data = host_alloc(host, (size_t)(t->room + 1) * sizeof(float), 64);
  return t->data ? SOZAI_OK : SOZAI_ERROR_MEMORY;
}

static void put_strands(const fiber *f, float *to) {
  for (uint32_t i = 0; i < f->strands; i++) {
    const strand_result *r = &f->results[i];
    *to++ = (float)r->moves;
    *to++ = (float)r->end;
    *to++ = (float)r->inside_first;
    *to++ = (float)r->inside;
    *to++ = r->first;
    *to++ = r->last;
    *to++ = (float)strand_length(&f->plan.shape, i);
    *to++ = f->radii[i];
  }
}

typedef struct {
  double moves, most, moved, inside_first, inside, whole_first, whole, ends[4], first, last, volume;
} sums;

static sums sum_up(const fiber *f) {
  sums s = {0};
  for (uint32_t i = 0; i < f->strands; i++) {
    const strand_result *r = &f->results[i];
    s.moves += r->moves;
    if (r->moves > s.most) s.most = r->moves;
    s.moved += r->moves > 0;
    s.inside_first += r->inside_first;
    s.inside += r->inside;
    s.whole_first += r->inside_first == f->vertices;
    s.whole += r->inside == f->vertices;
    s.ends[r->end & 3]++;
    s.first += (double)r->first;
    s.last += (double)r->last;
    s.volume +=
        fiber_strand_volume(&f->plan, strand_length(&f->plan.shape, i), (double)f->radii[i]);
  }
  return s;
}

static void put_statistics(const fiber *f, float *to, uint64_t bytes) {
  sums s = sum_up(f);
  double n = f->strands ? f->strands : 1, vertices = n * f->vertices, volume = f->grid.volume;
  const fiber_contacts *c = &f->contacts;
  const double row[COUNT(statistics_columns)] = {f->strands,
                                                 f->vertices,
                                                 s.most,
                                                 s.moves / n,
                                                 s.moved,
                                                 s.inside_first / vertices,
                                                 s.inside / vertices,
                                                 s.whole_first / n,
                                                 s.whole / n,
                                                 s.ends[END_INSIDE],
                                                 s.ends[END_BEST],
                                                 s.ends[END_VISITED],
                                                 s.ends[END_BOUND],
                                                 s.first / vertices,
                                                 s.last / vertices,
                                                 volume > 0 ? s.volume / volume : 0,
                                                 volume,
                                                 f->hull.area,
                                                 f->hull.items,
                                                 f->hull.rule,
                                                 f->hull.centre[0],
                                                 f->hull.centre[1],
                                                 f->hull.centre[2],
                                                 (double)f->hull.side,
                                                 c->first,
                                                 c->last,
                                                 c->deepest_first,
                                                 c->deepest,
                                                 c->strands,
                                                 c->rounds,
                                                 (double)bytes / 1e6};
  for (size_t i = 0; i < COUNT(row); i++) to[i] = (float)row[i];
}

int32_t fiber_report(fiber *f, const sozai_host *host) {
  int32_t r = make_table(f, host, TABLE_STATISTICS, 1);
  if (!r) r = make_table(f, host, TABLE_STRANDS, f->strands);
  if (r || host_rehearses(host)) return r;
  uint64_t bytes = hull_bytes(&f->hull) + grid_bytes(&f->grid) +
                   (uint64_t)f->strands * (f->vertices * 12ull + sizeof *f->results + 4);
  put_strands(f, f->tables[TABLE_STRANDS].data);
  put_statistics(f, f->tables[TABLE_STATISTICS].data, bytes);
  return SOZAI_OK;
}
