/* SPDX-License-Identifier: Apache-2.0 */
#include "bake.h"

#include <stdatomic.h>
#include <stdlib.h>
#include "parallel.h"
#include "walk.h"
#include "wood.h"

#define BAND 64 /* rows that a thread takes at a time */

typedef struct baking {
  walk_plan plan;
  float *rgb;
  atomic_bool failed;
} baking;

static bool bake_row(baking *b, walk *w, uint32_t row) {
  uint32_t side = b->plan.board->side, first = b->plan.channel->first;
  for (uint32_t column = 0; column < side; column += b->plan.batch) {
    if (!walk_batch(w, column, row)) return false;
    float *to = b->rgb + 3 * ((size_t)row * side + column);
    for (uint32_t c = 0; c < 3; c++) {
      const float *from = walk_output(w, first + c);
      for (size_t i = 0; i < b->plan.batch; i++) to[3 * i + c] = from[i];
    }
  }
  return true;
}

static void bake_band(void *context, uint32_t band) {
  baking *b = context;
  failure why;
  walk *w = walk_open(&b->plan, &why);
  bool ok = w != NULL;
  for (uint32_t row = band * BAND; ok && row < (band + 1) * BAND; row++) ok = bake_row(b, w, row);
  walk_close(w);
  if (!ok) atomic_store(&b->failed, true);
}

static bool bake_with(sozai_texture *texture, const plugin *p, const board *on, float *rgb,
                      failure *why) {
  baking b = {.plan = {.textures = p->textures,
                       .texture = texture,
                       .channel = wood_channel(p, "albedo"),
                       .board = on,
                       .batch = LARGEST_BATCH,
                       .footprint = TEXEL_MM},
              .rgb = rgb};
  atomic_init(&b.failed, false);
  if (!b.plan.channel || b.plan.channel->components != 3)
    return fail(why, EXIT_FAILURE, "wood has no channel albedo of three components");
  parallel_for(parallel_default_threads(), on->side / BAND, bake_band, &b);
  return !atomic_load(&b.failed) || fail(why, EXIT_FAILURE, "the board could not be baked");
}

float *bake_board(const plugin *p, const board *b, failure *why) {
  float *rgb = malloc((size_t)b->side * b->side * 3 * sizeof *rgb);
  if (!rgb) {
    fail(why, EXIT_FAILURE, "out of memory");
    return NULL;
  }
  sozai_texture *texture = NULL;
  bool ok = wood_create(&(wood){0}, NULL, p, &texture, why) && bake_with(texture, p, b, rgb, why);
  p->textures->destroy(texture);
  if (ok) return rgb;
  free(rgb);
  return NULL;
}
