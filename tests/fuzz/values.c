/* SPDX-License-Identifier: Apache-2.0 */
#include "values.h"

#include <string.h>

static void *keep(values *v, void *memory) {
  if (memory) {
    CHECK(v->memory_count < sizeof v->memory / sizeof *v->memory);
    v->memory[v->memory_count++] = memory;
  }
  return memory;
}

float *values_floats(bytes *b, size_t count, double low, double high) {
  float *list = malloc(count ? count * sizeof *list : 1);
  CHECK(list);
  uint8_t way = take_u8(b);
  for (size_t i = 0; i < count; i++) {
    /* past the input's end, something that is not the same everywhere */
    double share = b->left ? take_u8(b) / 255.0 : (double)(i * 37 % 101) / 100;
    list[i] = (float)(low + share * (high - low));
    if (way > 250 && b->left && share > 0.9) list[i] = take_float(b);
  }
  return list;
}

static uint32_t *indices(bytes *b, size_t count, uint64_t points, int loose) {
  uint32_t *list = malloc(count ? count * sizeof *list : 1);
  CHECK(list);
  uint32_t below = points > 0 && points < 65536 ? (uint32_t)points : 1;
  for (size_t i = 0; i < count; i++)
    list[i] = b->left ? take_u8(b) % (below + (uint32_t)loose) : (uint32_t)i % below;
  return list;
}

/* ---- buffers --------------------------------------------------------------- */

static uint64_t dimension(bytes *b, uint32_t usual) {
  static const uint64_t special[] = {0, 1, 1u << 30, 1ull << 31, 1ull << 32, ~0ull, 1ull << 62, 3};
  uint8_t n = take_u8(b);
  return n >= 248 ? special[n - 248] : n % usual;
}

/* Numbers in an array of a x b x c; 1 where that is more than anybody has: the plugin must not
 * look at the memory then. */
static size_t room_for(uint64_t a, uint64_t b, uint64_t c) {
  if (a == 0 || b == 0 || c == 0) return 0;
  return a > 4096 || b > 4096 || c > 64 ? 1 : (size_t)(a * b * c);
}

static sozai_buffer *take_buffer(values *v, bytes *b, const sozai_parameter *p) {
  sozai_buffer *s = &v->buffers[v->count];
  uint8_t odd = take_u8(b); /* 255: anything may be wrong */
  memset(s, 0, sizeof *s);
  s->size = odd >= 240 ? take_u8(b) : (uint32_t)sizeof *s;
  s->kind = odd >= 240 ? take_below(b, 7) : p->buffer_kind;
  s->wrap = take_below(b, odd >= 240 ? 256 : 5);
  s->first_channel = odd >= 240 ? take_u32(b) : take_u8(b) % 4u;
  for (int i = 0; i < 3; i++) s->dims[i] = dimension(b, i == 2 ? 6 : 24);
  const uint64_t *d = s->dims;
  if (s->kind == SOZAI_BUFFER_TABLE)
    s->data = keep(v, values_floats(b, room_for(d[0], d[1], 1), -3, 60));
  if (s->kind == SOZAI_BUFFER_IMAGE)
    s->data = keep(v, values_floats(b, room_for(d[0], d[1], d[2]), 0, 1));
  if (s->kind == SOZAI_BUFFER_MESH || s->kind == SOZAI_BUFFER_POINTS) {
    s->points = keep(v, values_floats(b, room_for(d[0], 3, 1), -20, 20));
    if (odd & 1) s->normals = keep(v, values_floats(b, room_for(d[0], 3, 1), -1, 1));
  }
  if (s->kind == SOZAI_BUFFER_MESH)
    s->indices = keep(v, indices(b, room_for(d[1], 3, 1), d[0], odd == 250));
  if (odd >= 240 && odd < 248) s->colour_space = keep(v, take_text(b, 40));
  if (odd == 249) s->path = keep(v, take_text(b, 40));
  if (odd == 255) s->data = NULL, s->points = NULL;
  return s;
}

/* ---- values ---------------------------------------------------------------- */

static const char *take_choice(values *v, bytes *b, const sozai_parameter *p) {
  uint8_t n = take_u8(b);
  return n < 250 && p->choice_count ? p->choices[n % p->choice_count] : keep(v, take_text(b, 255));
}

static void take_own(values *v, bytes *b, const sozai_parameter *p, sozai_value *to) {
  to->kind = p->kind;
  switch (p->kind) {
  case SOZAI_KIND_INT:
  case SOZAI_KIND_FLOAT:
  case SOZAI_KIND_BOOL:
    to->number[0] = take_number(b, p->hard_min, p->hard_max);
    break;
  case SOZAI_KIND_FLOAT3:
  case SOZAI_KIND_COLOUR:
    for (int i = 0; i < 3; i++) to->number[i] = take_number(b, p->hard_min, p->hard_max);
    if (p->kind == SOZAI_KIND_COLOUR && take_u8(b) > 200) to->text = keep(v, take_text(b, 60));
    break;
  case SOZAI_KIND_CHOICE:
    to->text = take_choice(v, b, p);
    break;
  case SOZAI_KIND_BUFFER:
    to->buffer = take_buffer(v, b, p);
    break;
  case SOZAI_KIND_IMAGE:
    if (take_u8(b) & 1)
      to->text = keep(v, take_text(b, 80));
    else
      to->buffer = take_buffer(v, b, p);
    break;
  default:
    to->text = keep(v, take_text(b, 255));
  }
}

static void take_one(values *v, bytes *b, const sozai_parameter *p) {
  sozai_value *to = &v->list[v->count];
  uint8_t way = take_u8(b);
  *to = (sozai_value){.id = p->id};
  if (way < 176)
    take_own(v, b, p, to);
  else if (way < 232) {
    to->kind = SOZAI_KIND_STRING;
    to->text = keep(v, take_text(b, 255));
  } else {
    take_own(v, b, p, to);
    to->kind = take_below(b, 13);
    if (way == 255) to->id = NULL;
    if (way == 254) to->id = keep(v, take_text(b, 90));
    if (way == 253) to->text = NULL, to->buffer = NULL;
  }
  v->count++;
}

void values_take(values *v, bytes *b, const sozai_parameter *const *parameters, uint32_t count) {
  memset(v, 0, sizeof *v);
  uint32_t wanted = take_u8(b) % (VALUES_MOST + 1);
  while (v->count < wanted && b->left) take_one(v, b, parameters[take_below(b, count)]);
}

void values_free(values *v) {
  for (uint32_t i = 0; i < v->memory_count; i++) free(v->memory[i]);
  memset(v, 0, sizeof *v);
}
