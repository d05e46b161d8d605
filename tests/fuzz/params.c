/* SPDX-License-Identifier: Apache-2.0
 * Values of every kind into settings, and back. */
#include <string.h>

#include "bounded.h"
#include "core/params.h"
#include "core/status.h"
#include "every_kind.h"
#include "values.h"

static void read_back(const settings *s) {
  for (uint32_t i = 0; i < every_kind.parameter_count; i++) {
    const sozai_parameter *p = every_kind.parameters[i];
    sozai_value out;
    CHECK(settings_value(s, &every_kind, p->id, &out) == SOZAI_OK && out.kind == p->kind);
    if (p->kind == SOZAI_KIND_FLOAT || p->kind == SOZAI_KIND_INT)
      CHECK(out.number[0] >= p->hard_min && out.number[0] <= p->hard_max);
    if (out.text) CHECK(strlen(out.text) <= 65536);
    const sozai_buffer *b = out.buffer;
    if (!b) continue;
    CHECK(b->size == sizeof *b && b->kind == p->buffer_kind);
    uint64_t numbers = b->dims[0] * (b->kind == SOZAI_BUFFER_TABLE ? b->dims[1] : 0);
    float sum = 0;
    for (uint64_t k = 0; k < numbers; k++) sum += b->data[k];
    for (uint64_t k = 0; b->points && k < 3 * b->dims[0]; k++) sum += b->points[k];
    for (uint64_t k = 0; b->indices && k < 3 * b->dims[1]; k++) CHECK(b->indices[k] < b->dims[0]);
    CHECK(sum <= 0 || sum >= 0 || sum != sum);
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const char *const presets[] = {NULL, NULL, "small", "broken", "none of these"};
  bytes b = {data, size};
  const char *preset = presets[take_below(&b, 5)];
  values v;
  values_take(&v, &b, every_kind.parameters, every_kind.parameter_count);
  settings s;
  bounded_begin(&(bounded_limits){.bytes = 8 << 20});
  if (settings_make(&s, &bounded_host, &every_kind, preset, v.list, v.count) == SOZAI_OK) {
    values_free(&v); /* what was taken is a copy */
    read_back(&s);
    settings_free(&s, &bounded_host);
  } else {
    CHECK(*fail_message() && !s.list);
    values_free(&v);
  }
  bounded_end();
  return 0;
}
