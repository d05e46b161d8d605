/* SPDX-License-Identifier: Apache-2.0 */
#include "blend.h"

#include <math.h>
#include <string.h>

#define MOST_COMPONENTS 3 /* of a channel; those of more are left out */

typedef struct weights {
  float share[PERIODIC_COPIES][SURFACE_BLOCK];
  uint8_t most[SURFACE_BLOCK]; /* the copy of the largest share, of equal ones the first */
  bool any[PERIODIC_COPIES];
} weights;

typedef struct task {
  const periodic *period;
  const surface_material *material;
  const sozai_batch *batch;
  const sozai_channel *channel;
  weights weights;
  float copy[MOST_COMPONENTS][SURFACE_BLOCK]; /* the channel of the copy at hand */
  float sum[MOST_COMPONENTS][SURFACE_BLOCK];
} task;

/* false: all is the first copy's. */
static bool find_weights(task *t) {
  weights *w = &t->weights;
  const sozai_batch *b = t->batch;
  bool more = false;
  memset(w->any, 0, sizeof w->any);
  for (uint32_t i = 0; i < b->count; i++) {
    float share[PERIODIC_COPIES];
    more |= periodic_weights(t->period, (double)b->point[0][i], (double)b->point[1][i],
                             (double)b->footprint[i], share);
    w->most[i] = 0;
    for (uint8_t k = 0; k < PERIODIC_COPIES; k++) {
      w->share[k][i] = share[k];
      w->any[k] |= share[k] > 0;
      if (share[k] > share[w->most[i]]) w->most[i] = k;
    }
  }
  return more;
}

/* The channel alone, of one copy, where there is any of it. */
static int32_t evaluate_copy(task *t, uint32_t k) {
  float x[SURFACE_BLOCK], y[SURFACE_BLOCK];
  uint8_t active[SURFACE_BLOCK];
  float *out[SURFACE_COMPONENTS] = {NULL};
  sozai_batch b = *t->batch;
  for (uint32_t i = 0; i < b.count; i++) {
    x[i] = b.point[0][i] + (k & 1 ? (float)t->period->size[0] : 0);
    y[i] = b.point[1][i] + (k & 2 ? (float)t->period->size[1] : 0);
    active[i] = t->weights.share[k][i] > 0;
  }
  b.point[0] = x;
  b.point[1] = y;
  b.active = active;
  b.out = out;
  b.out_count = SURFACE_COMPONENTS;
  for (uint32_t c = 0; c < t->channel->components; c++) out[t->channel->first + c] = t->copy[c];
  return t->material->textures->evaluate(t->material->texture, &b);
}

/* What is not filtered is no quantity but a name, and nothing lies between two:
 * there the largest share has all. */
static float share_of(const task *t, uint32_t k, uint32_t i, bool filtered) {
  return filtered ? t->weights.share[k][i] : t->weights.most[i] == k ? 1.0f : 0.0f;
}

static int32_t add_copy(task *t, uint32_t k, bool filtered) {
  int32_t result = evaluate_copy(t, k);
  for (uint32_t i = 0; result == SOZAI_OK && i < t->batch->count; i++) {
    if (!(t->weights.share[k][i] > 0)) continue; /* not evaluated */
    float share = share_of(t, k, i, filtered);
    for (uint32_t c = 0; c < t->channel->components; c++) t->sum[c][i] += share * t->copy[c][i];
  }
  return result;
}

/* Vectors stay of length 1. */
static void finish(const task *t) {
  const sozai_channel *ch = t->channel;
  bool vector = strcmp(ch->suffixes, "xyz") == 0;
  for (uint32_t i = 0; i < t->batch->count; i++) {
    float length = 0;
    for (uint32_t c = 0; vector && c < ch->components; c++) length += t->sum[c][i] * t->sum[c][i];
    float scale = length > 0 ? 1 / sqrtf(length) : 1;
    for (uint32_t c = 0; c < ch->components; c++)
      if (t->batch->out[ch->first + c]) t->batch->out[ch->first + c][i] = scale * t->sum[c][i];
  }
}

static bool is_wanted(const sozai_channel *c, const sozai_batch *b) {
  if (c->components > MOST_COMPONENTS || c->first + c->components > b->out_count) return false;
  for (uint32_t k = c->first; k < c->first + c->components; k++)
    if (b->out[k]) return true;
  return false;
}

int32_t blend_evaluate(const periodic *p, const surface_material *m, const sozai_batch *batch) {
  task t;
  t.period = p;
  t.material = m;
  t.batch = batch;
  if (!find_weights(&t)) return m->textures->evaluate(m->texture, batch);
  const sozai_texture_info *info = m->textures->info_of(m->texture);
  int32_t result = SOZAI_OK;
  for (uint32_t i = 0; result == SOZAI_OK && i < info->channel_count; i++) {
    t.channel = info->channels[i];
    if (!is_wanted(t.channel, batch)) continue;
    bool filtered = (t.channel->uses | t.channel->needs) & SOZAI_INPUT_FOOTPRINT;
    memset(t.sum, 0, sizeof t.sum);
    for (uint32_t k = 0; result == SOZAI_OK && k < PERIODIC_COPIES; k++)
      if (t.weights.any[k]) result = add_copy(&t, k, filtered);
    if (result == SOZAI_OK) finish(&t);
  }
  return result;
}
