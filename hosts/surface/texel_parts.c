/* SPDX-License-Identifier: Apache-2.0 */
#include "texel_parts.h"

#include <math.h>
#include <string.h>
#include "blend.h"
#include "channel.h"
#include "wanted.h"

typedef struct task {
  const texel_parts *parts;
  const surface_material *material;
  wanted means; /* the channels that are means of parts */
  float one[SURFACE_ROOM], sum[SURFACE_ROOM];
} task;

static int32_t evaluate(const task *t, const sozai_batch *b) {
  const surface_material *m = t->material;
  return t->parts->repeat ? blend_evaluate(t->parts->repeat, m, b)
                          : m->textures->evaluate(m->texture, b);
}

static bool is_one_of(const char *id, const char *const *list) {
  while (*list && strcmp(id, *list) != 0) list++;
  return *list != NULL;
}

/* Colours, directions, shares and heights. A number of a thing, a place or an age may leap
 * within a texel, and its mean be nothing's. */
static bool is_mean(const sozai_channel *c) {
  static const char *const heights[] = {"height", "depth", NULL};
  static const char *const whole[] = {"roughness", "strand_id", "board_id", NULL};
  bool share = c->components == 1 && *c->unit == '\0';
  return wanted_filtered(c) && !is_one_of(c->id, whole) &&
         (c->components == 3 || share || is_one_of(c->id, heights));
}

static bool has_sides(const sozai_channel *c) { return strcmp(c->id, "normal") == 0; }

/* What is no mean, of whole texels; what is, is left over for the parts. */
static int32_t evaluate_whole(task *t, const sozai_batch *b) {
  float *out[SURFACE_COMPONENTS] = {NULL};
  wanted all;
  wanted_find(&all, t->material, b);
  t->means.channel_count = t->means.components = 0;
  for (uint32_t i = 0; i < all.channel_count; i++) {
    const sozai_channel *c = all.channels[i];
    if (is_mean(c)) {
      t->means.channels[t->means.channel_count++] = c;
      t->means.components += c->components;
    } else
      memcpy(out + c->first, b->out + c->first, c->components * sizeof *out);
  }
  t->means.most = surface_fit(t->means.components, WANTED_PART);
  if (all.channel_count == t->means.channel_count) return SOZAI_OK;
  sozai_batch whole = *b;
  whole.out = out;
  return evaluate(t, &whole);
}

/* Of each of the batch's texels the part k[0] across and k[1] down. */
static int32_t evaluate_parts(task *t, const sozai_batch *b, uint32_t first, const uint32_t k[2]) {
  const texel_parts *s = t->parts;
  float point[3][SURFACE_BLOCK], footprint[SURFACE_BLOCK], *out[SURFACE_COMPONENTS];
  float side = (float)s->side, x = ((float)k[0] + 0.5f) / side - 0.5f,
        y = ((float)k[1] + 0.5f) / side - 0.5f;
  sozai_batch parts = *b;
  for (int c = 0; c < 3; c++) {
    const float *across = s->across[c] + first, *down = s->down[c] + first;
    for (uint32_t i = 0; i < b->count; i++)
      point[c][i] = b->point[c][i] + (x * across[i] + y * down[i]);
    parts.point[c] = point[c];
  }
  for (uint32_t i = 0; i < b->count; i++) footprint[i] = b->footprint[i] / side;
  parts.footprint = footprint;
  wanted_place(&t->means, t->one, out);
  parts.out = out;
  parts.out_count = SURFACE_COMPONENTS;
  return evaluate(t, &parts);
}

/* A fibre has two ends, and either may be the one that is told: the one on the
 * sum's side counts. */
static void turn(const task *t, float *part, const float *sum, uint32_t count) {
  const size_t next = t->means.most;
  for (uint32_t i = 0; i < count; i++) {
    float along = 0;
    for (size_t c = 0; c < 3; c++) along += part[c * next + i] * sum[c * next + i];
    for (size_t c = 0; along < 0 && c < 3; c++) part[c * next + i] = -part[c * next + i];
  }
}

static void add_parts(task *t, uint32_t count) {
  size_t at = 0;
  for (uint32_t i = 0; i < t->means.channel_count; i++) {
    const sozai_channel *ch = t->means.channels[i];
    if (channel_is_vector(ch) && !has_sides(ch)) turn(t, t->one + at, t->sum + at, count);
    for (uint32_t c = 0; c < ch->components; c++, at += t->means.most)
      for (uint32_t k = 0; k < count; k++) t->sum[at + k] += t->one[at + k];
  }
}

static void finish(const task *t, const sozai_batch *b) {
  const float *sum = t->sum, share = 1 / (float)(t->parts->side * t->parts->side);
  const size_t next = t->means.most;
  for (uint32_t i = 0; i < t->means.channel_count; i++) {
    const sozai_channel *ch = t->means.channels[i];
    for (uint32_t k = 0; k < b->count; k++) {
      float length = 0;
      for (size_t c = 0; channel_is_direction(ch) && c < 3; c++)
        length += sum[c * next + k] * sum[c * next + k];
      float scale = length > 0 ? 1 / sqrtf(length) : share;
      for (size_t c = 0; c < ch->components; c++)
        if (b->out[ch->first + c]) b->out[ch->first + c][k] = scale * sum[c * next + k];
    }
    sum += ch->components * next;
  }
}

int32_t texel_parts_evaluate(const texel_parts *s, const surface_material *m,
                             const sozai_batch *batch) {
  task t;
  t.parts = s;
  t.material = m;
  int32_t result = evaluate_whole(&t, batch);
  if (t.means.channel_count == 0) return result;
  for (uint32_t first = 0; result == SOZAI_OK && first < batch->count; first += t.means.most) {
    float *out[SURFACE_COMPONENTS];
    sozai_batch b = wanted_part(batch, first, t.means.most, out);
    memset(t.sum, 0, sizeof *t.sum * t.means.components * t.means.most);
    for (uint32_t k = 0; result == SOZAI_OK && k < s->side * s->side; k++) {
      result = evaluate_parts(&t, &b, first, (uint32_t[2]){k % s->side, k / s->side});
      if (result == SOZAI_OK) add_parts(&t, b.count);
    }
    if (result == SOZAI_OK) finish(&t, &b);
  }
  return result;
}
