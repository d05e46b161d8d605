/* SPDX-License-Identifier: Apache-2.0 */
#include "walk.h"

#include <stdlib.h>

#define ALIGNMENT 64
#define MOST_COMPONENTS 64

struct walk {
  walk_plan plan;
  sozai_batch batch;
  uint32_t row;      /* that y is filled with */
  float *x;          /* of every column of the board */
  float *y;          /* the same for a whole batch, as are: */
  float *zero, *one; /* the face's z and its normal */
  float *light[3], *footprint;
  float *out[MOST_COMPONENTS];
  float *memory;
  uint8_t active[LARGEST_BATCH];
};

static void fill(float *array, float value) {
  for (uint32_t i = 0; i < LARGEST_BATCH; i++) array[i] = value;
}

static void set_inputs(walk *w) {
  static const float light[3] = {0.36f, 0.48f, 0.8f};
  fill(w->zero, 0);
  fill(w->one, 1);
  fill(w->footprint, w->plan.footprint);
  for (int c = 0; c < 3; c++) fill(w->light[c], light[c]);
  for (uint32_t i = 0; i < w->plan.board->side; i++) w->x[i] = board_mm(w->plan.board, i);
  w->row = UINT32_MAX;
  w->batch = (sozai_batch){.size = sizeof w->batch,
                           .count = w->plan.batch,
                           .point = {w->x, w->y, w->zero},
                           .normal = {w->zero, w->zero, w->one},
                           .light = {w->light[0], w->light[1], w->light[2]},
                           .footprint = w->footprint,
                           .out = w->out};
  if (w->plan.masked) {
    for (uint32_t i = 0; i < LARGEST_BATCH; i++) /* 61: an order of its own */
      w->active[i] = i * 61 % 100 + 1 >= w->plan.masked;
    w->batch.active = w->active;
  }
  if (!w->plan.edge) return;
  for (int c = 0; c < 2; c++) {
    const float *swap = c ? w->batch.normal[1] : w->batch.point[1];
    const float **of = c ? w->batch.normal : w->batch.point;
    of[1] = of[2];
    of[2] = swap;
  }
}

walk *walk_open(const walk_plan *plan, failure *why) {
  uint32_t components = plan->textures->info_of(plan->texture)->component_count;
  if (components > MOST_COMPONENTS) {
    fail(why, EXIT_FAILURE, "more components than this program knows: %u", components);
    return NULL;
  }
  size_t arrays = 7 + components;
  size_t floats = plan->board->side + arrays * LARGEST_BATCH;
  walk *w = calloc(1, sizeof *w);
  float *memory = aligned_alloc(ALIGNMENT, floats * sizeof *memory);
  if (!w || !memory) {
    free(w);
    free(memory);
    fail(why, EXIT_FAILURE, "out of memory");
    return NULL;
  }
  w->plan = *plan;
  w->memory = w->x = memory;
  float *next = memory + plan->board->side;
  float **inputs[] = {&w->y,        &w->zero,     &w->one,      &w->light[0],
                      &w->light[1], &w->light[2], &w->footprint};
  for (size_t i = 0; i < sizeof inputs / sizeof *inputs; i++, next += LARGEST_BATCH)
    *inputs[i] = next;
  uint32_t first = plan->channel ? plan->channel->first : 0;
  uint32_t count = plan->channel ? plan->channel->components : plan->components;
  for (uint32_t i = first; i < first + count; i++, next += LARGEST_BATCH) w->out[i] = next;
  set_inputs(w);
  w->batch.out_count = components;
  return w;
}

void walk_close(walk *w) {
  if (w) free(w->memory);
  free(w);
}

bool walk_batch(walk *w, uint32_t column, uint32_t row) {
  if (row != w->row) {
    w->row = row;
    float y = board_mm(w->plan.board, row);
    for (uint32_t i = 0; i < w->plan.batch; i++) w->y[i] = y;
  }
  w->batch.point[0] = w->x + column;
  return w->plan.textures->evaluate(w->plan.texture, &w->batch) == SOZAI_OK;
}

const float *walk_output(const walk *w, uint32_t component) { return w->out[component]; }

bool walk_rows(walk *w, uint32_t first, uint32_t end) {
  const board *b = w->plan.board;
  for (uint32_t row = first; row < end; row++)
    for (uint32_t column = 0; column < b->columns; column += w->plan.batch)
      if (!walk_batch(w, b->column + column, b->row + row)) return false;
  return true;
}
