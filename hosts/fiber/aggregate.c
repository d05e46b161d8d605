/* SPDX-License-Identifier: Apache-2.0 */
#include "aggregate.h"

#include <string.h>
#include "hulls.h"

bool aggregate_grow(const sozai_geometry_1 *table, const sozai_host *host, const char *preset,
                    const char *const *pairs, size_t pair_count, const mesh *hull,
                    sozai_geometry **out, failure *why) {
  const sozai_buffer b = {.size = sizeof b,
                          .kind = SOZAI_BUFFER_MESH,
                          .dims = {hull->point_count, hull->triangle_count},
                          .points = hull->points,
                          .indices = hull->indices};
  const sozai_value value = {.id = "hull", .kind = SOZAI_KIND_BUFFER, .buffer = &b};
  return growth_grow_with(table, host, "fiber", preset, pairs, pair_count, &value, 1, out, why);
}

bool aggregate_hull_is_file(const char *name) {
  /* a file's name has a dot or a slash in it; sizes have a colon first */
  const char *mark = strpbrk(name, "./:");
  return mark && *mark != ':';
}

bool aggregate_hull(mesh *m, const char *name, double scale, failure *why) {
  memset(m, 0, sizeof *m);
  if (aggregate_hull_is_file(name)) return mesh_read(m, name, scale, why);
  return hull_make_named(m, name, why);
}
