/* SPDX-License-Identifier: Apache-2.0 */
#include "blend.h"

#include <math.h>
#include <string.h>
#include "channel.h"
#include "wanted.h"

typedef struct weights {
  float share[PERIODIC_COPIES][SURFACE_BLOCK];
  uint8_t most[SURFACE_BLOCK]; /* the copy of the largest share, of equal ones the first */
  bool any[PERIODIC_COPIES];
} weights;

typedef struct task {
  const periodic *period;
  const surface_material *material;
  wanted wanted;
  weights weights;
  float copy[SURFACE_ROOM], sum[SURFACE_ROOM]; /* placed as wanted_place does */
} task;

/* ---- a part of the batch ---------------------------------------------- */

/* false: all is the first copy's. */
static bool find_weights(task *t, const sozai_batch *b) {
  weights *w = &t->weights;
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

/* The channels asked for, of one copy, where there is any of it. */
static int32_t evaluate_copy(task *t, const sozai_batch *part, uint32_t k) {
  float x[SURFACE_BLOCK], y[SURFACE_BLOCK];
  uint8_t active[SURFACE_BLOCK];
  float *out[SURFACE_COMPONENTS];
  sozai_batch b = *part;
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
  wanted_place(&t->wanted, t->copy, out);
  return t->material->textures->evaluate(t->material->texture, &b);
}

/* Where one copy has all, the numbers are its own to the bit, so that they do
 * not depend on what else lies in the part. And what is not filtered is no
 * quantity but a name, and nothing lies between two: there the largest share
 * has all. */
static bool has_all(const weights *w, uint32_t i, bool filtered) {
  return !filtered || !(w->share[w->most[i]][i] < 1);
}

static void add_channel(task *t, const sozai_channel *ch, uint32_t k, uint32_t count,
                        const float *copy, float *sum) {
  const weights *w = &t->weights;
  bool filtered = wanted_filtered(ch);
  for (uint32_t c = 0; c < ch->components; c++, copy += t->wanted.most, sum += t->wanted.most)
    for (uint32_t i = 0; i < count; i++) {
      if (!(w->share[k][i] > 0)) continue; /* not evaluated */
      if (!has_all(w, i, filtered))
        sum[i] += w->share[k][i] * copy[i];
      else if (w->most[i] == k)
        sum[i] = copy[i];
    }
}

static int32_t add_copy(task *t, const sozai_batch *part, uint32_t k) {
  int32_t result = evaluate_copy(t, part, k);
  size_t at = 0;
  for (uint32_t i = 0; result == SOZAI_OK && i < t->wanted.channel_count; i++) {
    add_channel(t, t->wanted.channels[i], k, part->count, t->copy + at, t->sum + at);
    at += (size_t)t->wanted.channels[i]->components * t->wanted.most;
  }
  return result;
}

/* Directions stay of length 1. */
static void finish(const task *t, const sozai_batch *part, const sozai_channel *ch,
                   const float *sum) {
  bool direction = channel_is_direction(ch);
  for (uint32_t i = 0; i < part->count; i++) {
    float length = 0;
    if (direction && !has_all(&t->weights, i, true))
      for (uint32_t c = 0; c < ch->components; c++)
        length += sum[c * t->wanted.most + i] * sum[c * t->wanted.most + i];
    float scale = length > 0 ? 1 / sqrtf(length) : 1;
    for (uint32_t c = 0; c < ch->components; c++)
      if (part->out[ch->first + c])
        part->out[ch->first + c][i] = scale * sum[c * t->wanted.most + i];
  }
}

static int32_t evaluate_part(task *t, const sozai_batch *part) {
  if (!find_weights(t, part)) return t->material->textures->evaluate(t->material->texture, part);
  int32_t result = SOZAI_OK;
  memset(t->sum, 0, sizeof *t->sum * t->wanted.components * t->wanted.most);
  for (uint32_t k = 0; result == SOZAI_OK && k < PERIODIC_COPIES; k++)
    if (t->weights.any[k]) result = add_copy(t, part, k);
  const float *sum = t->sum;
  for (uint32_t i = 0; result == SOZAI_OK && i < t->wanted.channel_count; i++) {
    finish(t, part, t->wanted.channels[i], sum);
    sum += (size_t)t->wanted.channels[i]->components * t->wanted.most;
  }
  return result;
}

/* ---- all of it -------------------------------------------------------- */

int32_t blend_evaluate(const periodic *p, const surface_material *m, const sozai_batch *batch) {
  task t;
  t.period = p;
  t.material = m;
  wanted_find(&t.wanted, m, batch);
  int32_t result = SOZAI_OK;
  for (uint32_t first = 0; result == SOZAI_OK && first < batch->count; first += t.wanted.most) {
    float *out[SURFACE_COMPONENTS];
    sozai_batch part = wanted_part(batch, first, t.wanted.most, out);
    result = evaluate_part(&t, &part);
  }
  return result;
}
