/* SPDX-License-Identifier: Apache-2.0 */
#include "batch.h"

#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MARK 0x7fa5a5a5u /* a NaN that no arithmetic makes */
#define STRIDE (BATCH_GUARD + BATCH_MOST + BATCH_GUARD)

const struct batch_input batch_inputs[6] = {
    {SOZAI_INPUT_POINT, 0, 3},        {SOZAI_INPUT_NORMAL, 3, 3}, {SOZAI_INPUT_LIGHT, 6, 3},
    {SOZAI_INPUT_LIGHT_COLOUR, 9, 3}, {SOZAI_INPUT_VIEW, 12, 3},  {SOZAI_INPUT_FOOTPRINT, 15, 1}};

const char *input_name(uint32_t bit) {
  static const char *const names[] = {"point",        "normal", "light",
                                      "light_colour", "view",   "footprint"};
  for (uint32_t i = 0; i < 6; i++)
    if (bit & batch_inputs[i].bit) return names[i];
  return "an unknown input";
}

const sozai_channel *channel_of(const sozai_texture_info *info, uint32_t c) {
  for (uint32_t i = 0; i < info->channel_count; i++) {
    const sozai_channel *h = info->channels[i];
    if (c >= h->first && c - h->first < h->components) return h;
  }
  return NULL;
}

const char *component_name(const sozai_texture_info *info, uint32_t c) {
  static _Thread_local char text[120];
  const sozai_channel *h = channel_of(info, c);
  if (!h)
    snprintf(text, sizeof text, "component %u", c);
  else if (h->components == 1)
    snprintf(text, sizeof text, "%s", h->id);
  else
    snprintf(text, sizeof text, "%s.%c", h->id,
             strlen(h->suffixes) > c - h->first ? h->suffixes[c - h->first] : '?');
  return text;
}

/* ---- making ------------------------------------------------------------- */

static void fill_inputs(subject *s, batch *b) {
  for (uint32_t i = 0; i < BATCH_MOST; i++) {
    double reach = i % 2 ? 300.0 : 20.0;
    for (uint32_t k = 0; k < 15; k++) b->in[k][i] = (float)chance_between(s, -1.0, 1.0);
    for (uint32_t k = 0; k < 3; k++) b->in[k][i] *= (float)reach;
    for (uint32_t k = 9; k < 12; k++) b->in[k][i] = fabsf(b->in[k][i]);
    b->in[15][i] = (float)chance_between(s, 0.0, 3.0);
  }
}

batch *batch_new(subject *s, const sozai_texture_info *info, const char *preset, uint32_t count) {
  batch *b = calloc(1, sizeof *b);
  uint32_t n = info->component_count;
  if (!b) return failed("out of memory"), NULL;
  float *inputs = calloc(BATCH_INPUTS * BATCH_MOST, sizeof *inputs);
  char *name = strdup(texture_name(info, preset));
  b->info = info;
  b->out = calloc(n ? n : 1, sizeof *b->out);
  b->memory = calloc(n ? n : 1, STRIDE * sizeof *b->memory);
  b->name = name;
  b->in[0] = inputs;
  if (!inputs || !b->out || !b->memory || !name) {
    failed("out of memory");
    batch_free(b);
    return NULL;
  }
  for (uint32_t k = 0; k < BATCH_INPUTS; k++) b->in[k] = inputs + (size_t)k * BATCH_MOST;
  fill_inputs(s, b);
  b->abi = (sozai_batch){.size = sizeof b->abi, .out = b->out, .out_count = n};
  batch_from(b, 0, count);
  batch_mark(b);
  return b;
}

void batch_free(batch *b) {
  if (!b) return;
  free(b->in[0]);
  free(b->out);
  free(b->memory);
  free((char *)(uintptr_t)b->name);
  free(b);
}

void batch_from(batch *b, uint32_t first, uint32_t count) {
  b->abi.count = count;
  for (uint32_t c = 0; c < 3; c++) {
    b->abi.point[c] = b->in[c] + first;
    b->abi.normal[c] = b->in[3 + c] + first;
    b->abi.light[c] = b->in[6 + c] + first;
    b->abi.light_colour[c] = b->in[9 + c] + first;
    b->abi.view[c] = b->in[12 + c] + first;
  }
  b->abi.footprint = b->in[15] + first;
  for (uint32_t c = 0; c < b->info->component_count; c++)
    b->out[c] = b->memory + batch_place(c, first);
}

void batch_give(batch *b, uint32_t given) {
  for (uint32_t c = 0; c < 3; c++) {
    if (!(given & SOZAI_INPUT_POINT)) b->abi.point[c] = NULL;
    if (!(given & SOZAI_INPUT_NORMAL)) b->abi.normal[c] = NULL;
    if (!(given & SOZAI_INPUT_LIGHT)) b->abi.light[c] = NULL;
    if (!(given & SOZAI_INPUT_LIGHT_COLOUR)) b->abi.light_colour[c] = NULL;
    if (!(given & SOZAI_INPUT_VIEW)) b->abi.view[c] = NULL;
  }
  if (!(given & SOZAI_INPUT_FOOTPRINT)) b->abi.footprint = NULL;
}

void batch_want(batch *b, const sozai_channel *h) {
  for (uint32_t c = 0; c < b->info->component_count; c++) {
    bool wanted = !h || (c >= h->first && c - h->first < h->components);
    b->out[c] = wanted ? b->memory + batch_place(c, 0) : NULL;
  }
}

void batch_mark(batch *b) {
  const uint32_t mark = MARK;
  size_t n = (size_t)b->info->component_count * STRIDE;
  for (size_t i = 0; i < n; i++) memcpy(&b->memory[i], &mark, sizeof mark);
}

bool batch_run(subject *s, sozai_texture *t, batch *b, const char *what) {
  doing("evaluate of %s, %s", b->name, what);
  int rounding = fegetround();
  int32_t r = s->textures->evaluate(t, &b->abi);
  /* What else is asked of it is asked in the mode that it was made in. */
  if (fegetround() != rounding) fesetround(rounding);
  return EXPECT(r == SOZAI_OK, "%s: evaluate, %s, gave %s: %s", b->name, what, result_name(r),
                last_error(s));
}

/* ---- asking ------------------------------------------------------------- */

float *batch_answers(const batch *b) {
  size_t n = (size_t)b->info->component_count * STRIDE * sizeof(float);
  float *copy = malloc(n ? n : 1);
  if (copy)
    memcpy(copy, b->memory, n);
  else
    failed("out of memory");
  return copy;
}

static bool is_mark(float x) {
  const uint32_t mark = MARK;
  return memcmp(&x, &mark, sizeof x) == 0;
}

bool batch_same(const batch *b, const float *wanted, uint32_t c, uint32_t first, uint32_t count,
                const char *what) {
  asked();
  const float *is = b->memory + batch_place(c, first), *was = wanted + batch_place(c, first);
  if (memcmp(is, was, count * sizeof *is) == 0) return true;
  uint32_t i = 0;
  while (memcmp(&is[i], &was[i], sizeof *is) == 0) i++;
  failed("%s: %s of point %u is %.9g, %s %.9g", b->name, component_name(b->info, c), first + i,
         (double)was[i], what, (double)is[i]);
  return false;
}

bool batch_all_same(const batch *b, const float *wanted, uint32_t first, uint32_t count,
                    const char *what) {
  bool same = true;
  for (uint32_t c = 0; c < b->info->component_count; c++)
    same &= batch_same(b, wanted, c, first, count, what);
  return same;
}

bool batch_written(const batch *b, uint32_t c, uint32_t first, uint32_t count, const char *what) {
  asked();
  for (uint32_t i = first; i < first + count; i++) {
    float x = b->memory[batch_place(c, i)];
    if (isfinite(x)) continue;
    if (is_mark(x))
      failed("%s: %s of point %u was not written, %s", b->name, component_name(b->info, c), i,
             what);
    else
      failed("%s: %s of point %u is %g, %s", b->name, component_name(b->info, c), i, (double)x,
             what);
    return false;
  }
  return true;
}

bool batch_untouched(const batch *b, uint32_t c, uint32_t first, uint32_t count, const char *what) {
  asked();
  const float *row = b->memory + (size_t)c * STRIDE;
  for (uint32_t i = 0; i < STRIDE; i++) {
    if (i >= BATCH_GUARD + first && i < BATCH_GUARD + first + count) continue;
    if (is_mark(row[i])) continue;
    failed("%s: %s at %d was written, %s", b->name, component_name(b->info, c),
           (int)i - (int)BATCH_GUARD, what);
    return false;
  }
  return true;
}
