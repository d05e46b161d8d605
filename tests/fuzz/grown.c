/* SPDX-License-Identifier: Apache-2.0 */
#include "grown.h"

#include <math.h>
#include <string.h>
#include "bounded.h"
#include "core/status.h"
#include "fuzz.h"

/* geometry.c asks; there is no entry here that would have made it ready. */
int textures_ready(void) { return 1; }

static void check_finite(const float *list, uint64_t count) {
  for (uint64_t i = 0; i < count; i++) CHECK(isfinite(list[i]));
}

static void check_parts(const sozai_part *parts, uint32_t count, uint64_t items) {
  uint64_t next = 0;
  for (uint32_t i = 0; i < count; i++) {
    CHECK(parts[i].first == next && parts[i].id);
    next += parts[i].count;
  }
  CHECK(next == items);
}

static void look_at_mesh(const generator *kind, const void *state, uint32_t level) {
  mesh_block *m = NULL;
  if (kind->mesh(state, &bounded_host, level, &m)) {
    CHECK(*fail_message());
    return;
  }
  check_finite(m->out.points, 3 * m->out.point_count);
  check_finite(m->out.normals, 3 * m->out.point_count);
  check_finite(m->out.uv, 2 * m->out.point_count);
  for (uint64_t i = 0; i < 3 * m->out.triangle_count; i++)
    CHECK(m->out.indices[i] < m->out.point_count);
  check_parts(m->out.parts, m->out.part_count, m->out.triangle_count);
  sozai_host host = m->host;
  host_free(&host, m, m->bytes, 64);
}

static void look_at_curves(const generator *kind, const void *state, uint32_t level) {
  curves_block *c = NULL;
  if (kind->curves(state, &bounded_host, level, &c)) {
    CHECK(*fail_message());
    return;
  }
  check_finite(c->out.points, 3 * c->out.point_count);
  check_finite(c->out.radii, c->out.point_count);
  for (uint64_t i = 0; i < c->out.curve_count; i++) CHECK(c->out.first[i] <= c->out.first[i + 1]);
  CHECK(c->out.first[c->out.curve_count] == c->out.point_count);
  check_parts(c->out.parts, c->out.part_count, c->out.curve_count);
  sozai_host host = c->host;
  host_free(&host, c, c->bytes, 64);
}

static void look_at_tables(const generator *kind, const void *state) {
  const sozai_generator_info *info = kind->describe();
  for (uint32_t i = 0; i < info->table_count; i++) {
    uint64_t rows = 0;
    const float *data = kind->table(state, i, &rows);
    CHECK(rows == 0 || data);
    check_finite(data, rows * info->tables[i]->column_count);
  }
}

void grown_try(const generator *kind, const char *preset, const sozai_value *values,
               uint32_t count) {
  const sozai_generator_info *g = kind->describe();
  const sozai_texture_info info = {.size = sizeof info,
                                   .id = g->id,
                                   .parameters = g->parameters,
                                   .presets = g->presets,
                                   .parameter_count = g->parameter_count,
                                   .preset_count = g->preset_count};
  settings given;
  if (settings_make(&given, &bounded_host, &info, preset, values, count)) {
    CHECK(*fail_message() && !strchr(fail_message(), '\n'));
    return;
  }
  void *state = host_alloc(&bounded_host, kind->state_bytes, 64);
  CHECK(state);
  if (kind->grow(state, &bounded_host, &given)) {
    CHECK(*fail_message());
  } else {
    for (uint32_t level = 0; level <= 8; level += 4) {
      look_at_mesh(kind, state, level);
      look_at_curves(kind, state, level);
    }
    look_at_tables(kind, state);
    CHECK(kind->bytes(state) < (uint64_t)1 << 40);
  }
  kind->release(state, &bounded_host);
  host_free(&bounded_host, state, kind->state_bytes, 64);
  settings_free(&given, &bounded_host);
}
