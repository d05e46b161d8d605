/* SPDX-License-Identifier: Apache-2.0 */
#include "geometry.h"

#include <string.h>

static const float corners[] = {-10, -10, -10, 10, -10, -10, 10, 10, -10, -10, 10, -10,
                                -10, -10, 10,  10, -10, 10,  10, 10, 10,  -10, 10, 10};
static const uint32_t sides[] = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
static const sozai_buffer box = {.size = sizeof box,
                                 .kind = SOZAI_BUFFER_MESH,
                                 .dims = {8, 12},
                                 .points = corners,
                                 .indices = sides};

int32_t grow_plain(subject *s, const sozai_generator_info *info, const sozai_host *host,
                   grown *out) {
  memset(out, 0, sizeof *out);
  doing("grow of %s", info->id);
  int32_t r = s->geometry->grow(host, info->id, NULL, NULL, 0, &out->geometry);
  if (r != SOZAI_ERROR_ARGUMENT) return r;
  for (uint32_t p = 0; p < info->parameter_count && out->value_count < 4; p++)
    if (info->parameters[p]->kind == SOZAI_KIND_BUFFER &&
        info->parameters[p]->buffer_kind == SOZAI_BUFFER_MESH)
      out->values[out->value_count++] =
          (sozai_value){.id = info->parameters[p]->id, .kind = SOZAI_KIND_BUFFER, .buffer = &box};
  if (!out->value_count) return r;
  doing("grow of %s, in a box", info->id);
  return s->geometry->grow(host, info->id, NULL, out->values, out->value_count, &out->geometry);
}

bool generators_start(subject *s) {
  if (!subject_start(s)) return false;
  if (!s->geometry) skipped("it has no " SOZAI_GEOMETRY_1);
  return s->geometry;
}

void each_grown(subject *s, grown_test *test) {
  if (!generators_start(s)) return;
  for (uint32_t i = 0; i < s->geometry->count() && !enough(); i++) {
    const sozai_generator_info *info = s->geometry->info(i);
    grown g;
    if (!info || !subject_wants(s, info->id) || grow_plain(s, info, NULL, &g) != SOZAI_OK) continue;
    doing("%s", info->id);
    test(s, info, &g);
    doing("release of %s", info->id);
    s->geometry->release(g.geometry);
  }
}
