/* SPDX-License-Identifier: Apache-2.0 */
#include "lenticels.h"

#include "../core/hash1.h"
#include "../core/scalar.h"
#include "../core/status.h"
#include "bark.h"

#define WIDE 1.25f   /* cells' side across, in lengths of the longest */
#define SHORTER 0.5f /* how much shorter than that one may be */

float lenticels_mark(const lenticels *l, const float p[3]) {
  int32_t layer = scalar_floor((double)(p[1] / l->layer));
  uint32_t h = hash1(l->seed + (uint32_t)layer * 0x85ebca77u);
  /* layers lie askew, each its own way */
  float inverse = 1.0f / (WIDE * l->length);
  float x = (0.8f * p[0] - 0.6f * p[2]) * inverse + (float)(h & 0xffffu) * (1.0f / 65536.0f);
  float z = (0.6f * p[0] + 0.8f * p[2]) * inverse + (float)(h >> 16) * (1.0f / 65536.0f);
  int32_t cx = scalar_floor((double)x), cz = scalar_floor((double)z);
  h = hash1(h + (uint32_t)cx * 0x9e3779b1u + (uint32_t)cz * 0xc2b2ae3du);
  float radius = 0.5f * l->length * (1.0f - SHORTER * (float)(h >> 27) * (1.0f / 31.0f));
  /* within the cell, and the layer */
  float side = WIDE * l->length, room = side - 2.0f * radius, high = l->layer - l->height;
  float dx = (x - (float)cx) * side - radius - room * (float)(h & 511u) * (1.0f / 511.0f);
  float dz = (z - (float)cz) * side - radius - room * (float)(h >> 9 & 511u) * (1.0f / 511.0f);
  float dy = p[1] - (float)layer * l->layer - 0.5f * l->height -
             high * (float)(h >> 18 & 511u) * (1.0f / 511.0f);
  float out = (dx * dx + dz * dz) / (radius * radius);
  float up = 4.0f * dy * dy / (l->height * l->height);
  /* pointed at both ends */
  float in = 1.0f - out - up;
  if (!(in > 0.0f)) return 0.0f;
  return in < 0.5f ? 2.0f * in : 1.0f;
}

float lenticels_seen(const lenticels *l, const tree_plan *p, float age, float y) {
  if (!(l->shade > 0.0f) || !(y < l->reach)) return 0.0f;
  float fade = 2.0f * (l->reach - y) / l->reach;
  float seen = bark_periderm(p, age);
  return fade < 1.0f ? fade * seen : seen;
}

void lenticels_steps(const lenticels *l, float out[2]) {
  out[0] = 0.22f * l->length;
  if (out[0] > 12.0f) out[0] = 12.0f;
  if (out[0] < 2.0f) out[0] = 2.0f;
  out[1] = 0.5f * l->height;
  if (out[1] < 1.5f) out[1] = 1.5f;
}

#define LEAST_LAYER 1.5f /* lenticels' heights */

/* mm: a surface cuts so many discs of a mean length of 1 - SHORTER / 2. */
static float layer_of(const tree_plan *p) {
  return 1e4f * (1.0f - 0.5f * SHORTER) / (WIDE * WIDE * p->lenticel_length * p->lenticel_density);
}

int32_t lenticels_check(const tree_plan *p) {
  if (!(p->lenticel_density > 0.0f)) return SOZAI_OK;
  float share = layer_of(p) / (LEAST_LAYER * p->lenticel_height);
  if (share > 0.9999f) return SOZAI_OK;
  return fail(SOZAI_ERROR_RANGE,
              "lenticel_density: %.9g/dm2 leaves no room for lenticels of %.9g mm by %.9g mm; 0 to "
              "%.9g",
              (double)p->lenticel_density, (double)p->lenticel_length, (double)p->lenticel_height,
              (double)(p->lenticel_density * share));
}

/* Places enough for the mean to be known to a thousandth. */
#define PLACES 65536u

lenticels lenticels_of(const tree_plan *p) {
  lenticels l = {.length = p->lenticel_length,
                 .height = p->lenticel_height,
                 .shade = p->lenticel_density > 0.0f ? p->lenticel_shade : 0.0f,
                 .reach = 0.4f * p->bark_reach,
                 .seed = hash1(p->seed ^ 0x846ca68bu)};
  if (!(l.shade > 0.0f)) return l;
  l.layer = layer_of(p);
  float sum = 0.0f;
  for (uint32_t i = 0; i < PLACES; i++) {
    uint32_t h = hash1(i), g = hash1(h);
    const float at[3] = {(float)(h & 0xffffu), (float)(h >> 16) * 0.5f, (float)(g >> 16)};
    sum += lenticels_mark(&l, at);
  }
  l.mean = sum * (1.0f / (float)PLACES);
  return l;
}
