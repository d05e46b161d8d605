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
