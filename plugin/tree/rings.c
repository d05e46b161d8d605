/* SPDX-License-Identifier: Apache-2.0 */
#include "rings.h"

#include "bark.h"

uint32_t rings_lay(const tree *t, const tree_branch *b, uint32_t stride, ring *out) {
  const tree_node *nodes = &t->nodes[b->first];
  float ages[RINGS_MOST];
  uint32_t n = 0;
  bark_ages(t, b, ages);
  for (uint32_t i = 0; i < b->nodes;
       i = i + 1 < b->nodes && i + stride >= b->nodes ? b->nodes - 1 : i + stride) {
    out[n] = (ring){.r = nodes[i].r, .age = ages[i], .way = -1.0f};
    for (int c = 0; c < 3; c++) out[n].p[c] = nodes[i].p[c];
    n++;
  }
  return n;
}

float rings_apart(const ring *a, const ring *b) {
  float sum = 0.0f;
  for (int c = 0; c < 3; c++) sum += (b->p[c] - a->p[c]) * (b->p[c] - a->p[c]);
  return __builtin_sqrtf(sum);
}

void rings_between(const ring *a, const ring *b, float share, ring *out) {
  for (int c = 0; c < 3; c++) out->p[c] = a->p[c] + share * (b->p[c] - a->p[c]);
  out->r = a->r + share * (b->r - a->r);
  out->age = a->age + share * (b->age - a->age);
  out->way = a->way < 0.0f || b->way < 0.0f ? -1.0f : a->way + share * (b->way - a->way);
  out->next = 0.0f;
}

static void direction(const ring *rings, uint32_t count, uint32_t i, float out[3]) {
  uint32_t a = i ? i - 1 : 0, b = i + 1 < count ? i + 1 : i;
  float sum = 0.0f;
  for (int c = 0; c < 3; c++) out[c] = rings[b].p[c] - rings[a].p[c], sum += out[c] * out[c];
  float s = sum > 0.0f ? 1.0f / __builtin_sqrtf(sum) : 0.0f;
  for (int c = 0; c < 3; c++) out[c] *= s;
  if (!(sum > 0.0f)) out[1] = 1.0f;
}

void rings_direction(const ring *rings, uint32_t count, uint32_t i, float share, float out[3]) {
  float next[3], sum = 0.0f;
  direction(rings, count, i, out);
  if (!(share > 0.0f)) return;
  direction(rings, count, i + 1, next);
  for (int c = 0; c < 3; c++) {
    out[c] += share * (next[c] - out[c]);
    sum += out[c] * out[c];
  }
  if (!(sum > 1e-6f)) return;
  sum = 1.0f / __builtin_sqrtf(sum);
  for (int c = 0; c < 3; c++) out[c] *= sum;
}

void rings_along(const ring *rings, uint32_t count, float s, ring *out, float along[3]) {
  uint32_t i = 0;
  float length = rings_apart(&rings[0], &rings[1]);
  while (i + 2 < count && s > length) {
    s -= length;
    i++;
    length = rings_apart(&rings[i], &rings[i + 1]);
  }
  float inverse = length > 0.0f ? 1.0f / length : 0.0f, share = s * inverse;
  rings_between(&rings[i], &rings[i + 1], share < 1.0f ? share : 1.0f, out);
  for (int c = 0; c < 3; c++) along[c] = inverse * (rings[i + 1].p[c] - rings[i].p[c]);
  if (!(length > 0.0f)) along[1] = 1.0f;
}
