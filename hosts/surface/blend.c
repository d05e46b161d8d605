/* SPDX-License-Identifier: Apache-2.0
 *
 * A batch is cut into parts that have room for all the channels asked for, so
 * that each copy is evaluated once, whatever is asked. */
#include "blend.h"

#include <math.h>
#include <string.h>

#define PART 64u /* points, at least */

typedef struct weights {
  float share[PERIODIC_COPIES][SURFACE_BLOCK];
  uint8_t most[SURFACE_BLOCK]; /* the copy of the largest share, of equal ones the first */
  bool any[PERIODIC_COPIES];
} weights;

typedef struct task {
  const periodic *period;
  const surface_material *material;
  const sozai_batch *batch;
  const sozai_channel *channels[SURFACE_COMPONENTS]; /* of which something is asked for */
  uint32_t channel_count, components, most;          /* of theirs; points in a part */
  weights weights;
  float copy[SURFACE_ROOM], sum[SURFACE_ROOM]; /* `most` of each component, channel after channel */
} task;

/* ---- what is asked for ------------------------------------------------ */

static bool is_wanted(const sozai_channel *c, const sozai_batch *b) {
  if (c->first + c->components > b->out_count) return false;
  for (uint32_t k = c->first; k < c->first + c->components; k++)
    if (b->out[k]) return true;
  return false;
}

static void find_wanted(task *t) {
  const sozai_texture_info *info = t->material->textures->info_of(t->material->texture);
  t->channel_count = t->components = 0;
  for (uint32_t i = 0; i < info->channel_count; i++) {
    const sozai_channel *c = info->channels[i];
    if (!is_wanted(c, t->batch) || t->components + c->components > SURFACE_COMPONENTS) continue;
    t->channels[t->channel_count++] = c;
    t->components += c->components;
  }
  t->most = surface_fit(t->components, PART);
}

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
  float *out[SURFACE_COMPONENTS] = {NULL};
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
  float *next = t->copy;
  for (uint32_t i = 0; i < t->channel_count; i++)
    for (uint32_t c = 0; c < t->channels[i]->components; c++, next += t->most)
      out[t->channels[i]->first + c] = next;
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
  bool filtered = (ch->uses | ch->needs) & SOZAI_INPUT_FOOTPRINT;
  for (uint32_t c = 0; c < ch->components; c++, copy += t->most, sum += t->most)
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
  for (uint32_t i = 0; result == SOZAI_OK && i < t->channel_count; i++) {
    add_channel(t, t->channels[i], k, part->count, t->copy + at, t->sum + at);
    at += (size_t)t->channels[i]->components * t->most;
  }
  return result;
}

/* Vectors stay of length 1. */
static void finish(const task *t, const sozai_batch *part, const sozai_channel *ch,
                   const float *sum) {
  bool vector = strcmp(ch->suffixes, "xyz") == 0;
  for (uint32_t i = 0; i < part->count; i++) {
    float length = 0;
    if (vector && !has_all(&t->weights, i, true))
      for (uint32_t c = 0; c < ch->components; c++)
        length += sum[c * t->most + i] * sum[c * t->most + i];
    float scale = length > 0 ? 1 / sqrtf(length) : 1;
    for (uint32_t c = 0; c < ch->components; c++)
      if (part->out[ch->first + c]) part->out[ch->first + c][i] = scale * sum[c * t->most + i];
  }
}

static int32_t evaluate_part(task *t, const sozai_batch *part) {
  if (!find_weights(t, part)) return t->material->textures->evaluate(t->material->texture, part);
  int32_t result = SOZAI_OK;
  memset(t->sum, 0, sizeof *t->sum * t->components * t->most);
  for (uint32_t k = 0; result == SOZAI_OK && k < PERIODIC_COPIES; k++)
    if (t->weights.any[k]) result = add_copy(t, part, k);
  const float *sum = t->sum;
  for (uint32_t i = 0; result == SOZAI_OK && i < t->channel_count; i++) {
    finish(t, part, t->channels[i], sum);
    sum += (size_t)t->channels[i]->components * t->most;
  }
  return result;
}

/* ---- all of it -------------------------------------------------------- */

static sozai_batch part_of(const sozai_batch *b, uint32_t first, uint32_t most, float **out) {
  sozai_batch part = *b;
  part.count = b->count - first < most ? b->count - first : most;
  for (int c = 0; c < 3; c++) {
    part.point[c] += first;
    if (part.normal[c]) part.normal[c] += first;
  }
  part.footprint += first;
  for (uint32_t k = 0; k < b->out_count; k++) out[k] = b->out[k] ? b->out[k] + first : NULL;
  part.out = out;
  return part;
}

int32_t blend_evaluate(const periodic *p, const surface_material *m, const sozai_batch *batch) {
  task t;
  t.period = p;
  t.material = m;
  t.batch = batch;
  find_wanted(&t);
  int32_t result = SOZAI_OK;
  for (uint32_t first = 0; result == SOZAI_OK && first < batch->count; first += t.most) {
    float *out[SURFACE_COMPONENTS];
    sozai_batch part = part_of(batch, first, t.most, out);
    result = evaluate_part(&t, &part);
  }
  return result;
}
