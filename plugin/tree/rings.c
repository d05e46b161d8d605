/* SPDX-License-Identifier: Apache-2.0 */
#include "rings.h"

#include "bark.h"

#define ROUNDED_FROM 25.0f /* mm of radius */
#define ROUNDED_NODES 120u

/* Cosines of angles between pieces of an axis: more acute ones are cut into 2, 3 and 4. */
#define PARTS 4u
static const float bent[PARTS - 1] = {0.9995f, 0.9962f, 0.9877f};

uint32_t rings_stride(const tree_branch *b, uint32_t level) {
  if (b->order == 0 && level == 1) return 2;
  return level < 2 ? 1 : level < 4 ? 2 : 4;
}

/* Of an axis at its i-th node. */
static float bend_at(const ring *at, uint32_t count, uint32_t i) {
  if (i == 0 || i + 1 >= count) return 1.0f;
  float sum = 0.0f, a = rings_apart(&at[i - 1], &at[i]), b = rings_apart(&at[i], &at[i + 1]);
  for (int c = 0; c < 3; c++) sum += (at[i].p[c] - at[i - 1].p[c]) * (at[i + 1].p[c] - at[i].p[c]);
  return a * b > 0.0f ? sum / (a * b) : 1.0f;
}

/* What is off the line between two nodes of one that goes through all of them (Catmull and Rom
 * 1974, in Computer Aided Geometric Design). Its ends are straight. */
static void round_off(const ring *at, uint32_t count, uint32_t i, float t, ring *out) {
  float square = t * t, cube = t * square;
  float from = cube - 2.0f * square + t, to = cube - square;
  for (int c = 0; c < 3; c++) {
    float line = at[i + 1].p[c] - at[i].p[c];
    float begin = i ? 0.5f * (at[i + 1].p[c] - at[i - 1].p[c]) : line;
    float end = i + 2 < count ? 0.5f * (at[i + 2].p[c] - at[i].p[c]) : line;
    out->p[c] += from * (begin - line) + to * (end - line);
  }
}

static uint32_t round_bends(ring *at, uint32_t count, uint32_t most) {
  ring nodes[ROUNDED_NODES];
  uint32_t n = 0;
  for (uint32_t i = 0; i < count; i++) nodes[i] = at[i];
  for (uint32_t i = 0; i < count; i++) {
    at[n++] = nodes[i];
    if (i + 1 == count) break;
    float a = bend_at(nodes, count, i), b = bend_at(nodes, count, i + 1), bends = a < b ? a : b;
    uint32_t parts = 1;
    while (parts < most && bends < bent[parts - 1]) parts++;
    for (uint32_t k = 1; k < parts; k++) {
      float share = (float)k / (float)parts;
      rings_between(&nodes[i], &nodes[i + 1], share, &at[n]);
      round_off(nodes, count, i, share, &at[n++]);
    }
  }
  return n;
}

uint32_t rings_lay(const tree *t, const tree_branch *b, uint32_t level, ring *out) {
  const tree_node *nodes = &t->nodes[b->first];
  float ages[RINGS_MOST];
  uint32_t n = 0, stride = rings_stride(b, level);
  bark_ages(t, b, ages);
  for (uint32_t i = 0; i < b->nodes;
       i = i + 1 < b->nodes && i + stride >= b->nodes ? b->nodes - 1 : i + stride) {
    out[n] = (ring){.r = nodes[i].r, .age = ages[i], .way = -1.0f};
    for (int c = 0; c < 3; c++) out[n].p[c] = nodes[i].p[c];
    n++;
  }
  int rounded = level < 2 && b->order == 1 && b->radius >= ROUNDED_FROM && n <= ROUNDED_NODES;
  return rounded ? round_bends(out, n, level ? 2 : PARTS) : n;
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

uint32_t rings_nearest(const ring *rings, uint32_t count, const float p[3], float *share) {
  uint32_t at = 0;
  float least = 1e30f;
  *share = 0.0f;
  for (uint32_t i = 0; i + 1 < count; i++) {
    const float *a = rings[i].p, *b = rings[i + 1].p;
    float d[3], q[3], square = 0.0f, dot = 0.0f, off = 0.0f;
    for (int c = 0; c < 3; c++) {
      d[c] = b[c] - a[c], q[c] = p[c] - a[c];
      square += d[c] * d[c], dot += d[c] * q[c];
    }
    float t = square > 0.0f ? dot / square : 0.0f;
    t = t > 0.0f ? t < 1.0f ? t : 1.0f : 0.0f;
    for (int c = 0; c < 3; c++) off += (q[c] - t * d[c]) * (q[c] - t * d[c]);
    if (!(off < least)) continue;
    least = off;
    *share = t;
    at = i;
  }
  return at;
}
