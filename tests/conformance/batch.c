/* SPDX-License-Identifier: Apache-2.0 */
#include "batch.h"

#include <math.h>
#include <string.h>

#define MARK 0x7fa5a5a5u /* a NaN that no arithmetic makes */

static float uniform(uint64_t r, float lo, float hi) {
  return lo + (hi - lo) * (float)(mix64(r) >> 40) * 0x1p-24f;
}

void batch_make(full_batch *b, const sozai_texture_info *info, uint32_t count) {
  memset(b, 0, sizeof *b);
  for (uint64_t i = 0; i < BATCH_MAX; i++) {
    for (uint64_t k = 0; k < 15; k++) b->in[k][i] = uniform(i * 16 + k, -1.0f, 1.0f);
    for (uint64_t k = 0; k < 3; k++) b->in[k][i] *= i % 2 ? 300.0f : 20.0f;
    for (uint64_t k = 9; k < 12; k++) b->in[k][i] = fabsf(b->in[k][i]);
    b->in[15][i] = uniform(i * 16 + 15, 0.0f, 3.0f);
  }
  sozai_batch *s = &b->batch;
  s->size = sizeof *s;
  s->count = count;
  for (int c = 0; c < 3; c++) {
    s->point[c] = b->in[c];
    s->normal[c] = b->in[3 + c];
    s->light[c] = b->in[6 + c];
    s->light_colour[c] = b->in[9 + c];
    s->view[c] = b->in[12 + c];
  }
  s->footprint = b->in[15];
  b->components = info->component_count;
  for (uint32_t o = 0; o < b->components; o++) b->out[o] = b->memory[o] + GUARD;
  s->out = b->out;
  s->out_count = b->components;
  batch_mark(b);
}

void batch_mark(full_batch *b) {
  const uint32_t mark = MARK;
  for (uint32_t o = 0; o < COMPONENTS; o++) {
    for (uint32_t i = 0; i < GUARD + BATCH_MAX + GUARD; i++) memcpy(&b->memory[o][i], &mark, 4);
  }
}

static int is_mark(float x) {
  const uint32_t mark = MARK;
  return memcmp(&x, &mark, 4) == 0;
}

uint32_t batch_spilt(const full_batch *b, uint32_t count) {
  uint32_t spilt = 0;
  for (uint32_t o = 0; o < COMPONENTS; o++) {
    uint32_t to = o < b->components && b->out[o] ? GUARD + count : GUARD;
    for (uint32_t i = 0; i < GUARD + BATCH_MAX + GUARD; i++) {
      if (i < GUARD || i >= to) spilt += is_mark(b->memory[o][i]) ? 0 : 1;
    }
  }
  return spilt;
}

uint32_t batch_unfit(const full_batch *b, uint32_t count) {
  uint32_t unfit = 0;
  for (uint32_t o = 0; o < b->components; o++) {
    for (uint32_t i = 0; b->out[o] && i < count; i++) {
      unfit += isfinite(b->memory[o][GUARD + i]) ? 0 : 1;
    }
  }
  return unfit;
}
