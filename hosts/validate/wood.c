/* SPDX-License-Identifier: Apache-2.0
 * The table that only wood answers. */
#include <math.h>
#include <string.h>

#include "batch.h"
#include "groups.h"

static bool has_wood(subject *s) {
  if (!subject_start(s)) return false;
  if (!s->wood || !s->textures) skipped("it has no " SOZAI_WOOD_1);
  return s->wood && s->textures;
}

/* "ARGUMENT: NULL, or not a wood." */
static void arguments(subject *s) {
  if (!has_wood(s)) return;
  float x[2] = {1, 2}, out[2] = {7, 7}, other[2] = {7, 7};
  doing("ring_radius and pith of NULL");
  EXPECT(s->wood->ring_radius(NULL, 2, x, x, x, out) == SOZAI_ERROR_ARGUMENT,
         "ring_radius of no texture is taken");
  EXPECT(s->wood->pith(NULL, 2, x, out, other) == SOZAI_ERROR_ARGUMENT,
         "pith of no texture is taken");
  for (uint32_t i = 0; i < s->textures->count(); i++) {
    const sozai_texture_info *info = s->textures->info(i);
    sozai_texture *t = NULL;
    if (!subject_wants(s, info->id) ||
        s->textures->create(NULL, info->id, NULL, NULL, 0, &t) != SOZAI_OK)
      continue;
    doing("ring_radius and pith of %s", info->id);
    if (strcmp(info->id, "wood") != 0) {
      EXPECT(s->wood->ring_radius(t, 2, x, x, x, out) == SOZAI_ERROR_ARGUMENT,
             "ring_radius of %s is taken", info->id);
      EXPECT(s->wood->pith(t, 2, x, out, other) == SOZAI_ERROR_ARGUMENT, "pith of %s is taken",
             info->id);
    } else {
      EXPECT(s->wood->ring_radius(t, 2, NULL, x, x, out) == SOZAI_ERROR_ARGUMENT,
             "ring_radius without times is taken");
      EXPECT(s->wood->ring_radius(t, 2, x, x, x, NULL) == SOZAI_ERROR_ARGUMENT,
             "ring_radius without an output is taken");
      EXPECT(s->wood->pith(t, 2, x, NULL, out) == SOZAI_ERROR_ARGUMENT,
             "pith without an output is taken");
    }
    s->textures->destroy(t);
  }
  EXPECT(out[0] == 7 && out[1] == 7 && other[0] == 7, "a refused call wrote numbers");
}

/* "The inverse of the channel `time`, to 1e-5 of r." Where the texture's own space is the log's,
 * which `reference` and `time` at the pith tell. */
#define POINTS 200u

static void inverse_of(subject *s, const sozai_texture_info *info, const char *preset,
                       sozai_texture *t) {
  static float time[POINTS], theta[POINTS], y[POINTS], r[POINTS], px[POINTS], pz[POINTS];
  const sozai_channel *channel = NULL;
  for (uint32_t h = 0; h < info->channel_count; h++)
    if (strcmp(info->channels[h]->id, "time") == 0) channel = info->channels[h];
  if (!channel || strcmp(info->id, "wood") != 0) return;
  for (uint32_t i = 0; i < POINTS; i++) {
    time[i] = (float)chance_between(s, 5, 60);
    theta[i] = (float)chance_between(s, -3.1, 3.1);
    y[i] = (float)chance_between(s, -400, 400);
  }
  doing("ring_radius of %s", texture_name(info, preset));
  int32_t a = s->wood->ring_radius(t, POINTS, time, theta, y, r);
  int32_t p = s->wood->pith(t, POINTS, y, px, pz);
  if (!EXPECT(a == SOZAI_OK && p == SOZAI_OK, "%s: ring_radius gave %s, pith %s",
              texture_name(info, preset), result_name(a), result_name(p)))
    return;
  for (uint32_t i = 0; i < POINTS; i++)
    EXPECT(isfinite(r[i]) && r[i] >= 0 && isfinite(px[i]) && isfinite(pz[i]),
           "%s: ring_radius is %g, pith %g, %g", texture_name(info, preset), (double)r[i],
           (double)px[i], (double)pz[i]);
  batch *b = batch_new(s, info, preset, POINTS);
  for (uint32_t i = 0; b && i < POINTS; i++) {
    b->in[0][i] = px[i] + r[i] * cosf(theta[i]);
    b->in[1][i] = y[i];
    b->in[2][i] = pz[i] + r[i] * sinf(theta[i]);
    b->in[15][i] = 0;
  }
  if (b && batch_run(s, t, b, "at the rings")) {
    uint32_t off = 0;
    for (uint32_t i = 0; i < POINTS; i++) {
      float is = b->memory[batch_place(channel->first, i)];
      /* A year is some millimetres of radius: 1e-5 of r is well below 1e-2 of a year. */
      off += !(fabsf(is - time[i]) < 0.01f);
    }
    EXPECT(off == 0, "%s: `time` is not what ring_radius was asked at %u points of %u",
           texture_name(info, preset), off, POINTS);
  }
  batch_free(b);
}

static void inverse(subject *s) {
  if (has_wood(s)) each_texture(s, 0, inverse_of);
}

CHECKS(wood, //
       {"wood.arguments", "create.default", "NULL and what is not a wood are refused", arguments},
       {"wood.inverse", "evaluate.answers", "ring_radius is the inverse of the channel time",
        inverse});
