/* SPDX-License-Identifier: Apache-2.0
 *
 * For each batch: trace the camera's rays, gather the points where they meet
 * the shape, evaluate the texture once for all of them, and add up. A pixel's
 * samples are always added in the same order. */
#include "tile.h"

#include <stdlib.h>
#include <string.h>
#include "cancel.h"
#include "samples.h"

#define BATCH ((size_t)TILE_SIDE * TILE_SIDE * 16)
#define INPUTS 16 /* arrays of a batch: five vectors and the footprint */
#define NEUTRAL 0.5f

typedef struct tile {
  const tile_context *c;
  uint32_t x, y, width, height; /* in the picture */
  uint32_t count;               /* points in the batch */
  float *input[INPUTS];
  float **out; /* the texture's components, NULL where not wanted */
  float *key;  /* how much of the key light each point gets */
  vec *fill;
  uint32_t *pixel; /* of the tile, that each point belongs to */
  uint32_t hits[TILE_SIDE * TILE_SIDE];
  float *memory;
} tile;

uint32_t tile_count(const film *f) {
  uint32_t across = (f->width + TILE_SIDE - 1) / TILE_SIDE;
  uint32_t down = (f->height + TILE_SIDE - 1) / TILE_SIDE;
  return across * down;
}

/* ---- memory ----------------------------------------------------------- */

static uint32_t wanted_components(const tile_context *c, bool *wanted) {
  uint32_t count = 0;
  for (uint32_t k = 0; k < 3; k++) {
    if (c->albedo >= 0) wanted[(uint32_t)c->albedo + k] = true;
    if (c->radiance >= 0) wanted[(uint32_t)c->radiance + k] = true;
  }
  if (c->occlusion >= 0) {
    wanted[c->occlusion] = wanted[c->roughness] = wanted[c->specular] = true;
    for (int32_t k = 0; k < 3; k++) wanted[c->normal + k] = true;
  }
  if (c->coverage >= 0) wanted[c->coverage] = true;
  for (uint32_t i = 0; i < c->film->components; i++)
    wanted[c->film->channel_of[i]->first + c->film->component_of[i]] = true;
  for (uint32_t i = 0; i < c->info->component_count; i++) count += wanted[i];
  return count;
}

static bool allocate(tile *t, size_t room) {
  const tile_context *c = t->c;
  bool *wanted = calloc(c->info->component_count + 1, sizeof *wanted);
  t->out = calloc(c->info->component_count + 1, sizeof *t->out);
  if (!wanted || !t->out) {
    free(wanted);
    return false;
  }
  uint32_t outputs = wanted_components(c, wanted);
  t->memory = malloc(room * (INPUTS + outputs + 1) * sizeof *t->memory);
  t->fill = malloc(room * sizeof *t->fill);
  t->pixel = malloc(room * sizeof *t->pixel);
  bool ok = t->memory && t->fill && t->pixel;
  if (ok) {
    float *next = t->memory;
    for (uint32_t i = 0; i < INPUTS; i++, next += room) t->input[i] = next;
    t->key = next;
    for (uint32_t i = 0; i < c->info->component_count; i++)
      if (wanted[i]) t->out[i] = next += room;
  }
  free(wanted);
  return ok;
}

static void release(tile *t) {
  free(t->memory);
  free(t->fill);
  free(t->pixel);
  free(t->out);
}

/* ---- one sample ------------------------------------------------------- */

static float *beauty_of(const tile *t, uint32_t pixel) {
  const film *f = t->c->film;
  size_t at = (size_t)(t->y + pixel / t->width) * f->width + t->x + pixel % t->width;
  return f->beauty + 3 * at;
}

static void add(float *rgb, vec colour) {
  rgb[0] += colour.x;
  rgb[1] += colour.y;
  rgb[2] += colour.z;
}

static void put(float *const *arrays, uint32_t at, vec v) {
  arrays[0][at] = v.x;
  arrays[1][at] = v.y;
  arrays[2][at] = v.z;
}

/* The side of the square on the surface that one sample stands for: a pixel's
 * share among its samples, stretched at grazing angles as its area is. */
static float footprint(const tile_context *c, const hit *h, vec direction) {
  float depth = c->camera->parallel ? 1 : h->distance * vec_dot(direction, c->camera->forward);
  float slope = fmaxf(0.05f, -vec_dot(h->normal, direction));
  return depth * c->camera->pixel / sqrtf(slope * (float)c->job->spp);
}

static void gather(tile *t, const hit *h, vec direction, uint32_t pixel, uint32_t seed,
                   uint32_t sample) {
  const tile_context *c = t->c;
  uint32_t at = t->count++;
  put(t->input, at, h->point);
  put(t->input + 3, at, h->normal);
  put(t->input + 6, at, c->studio->light);
  put(t->input + 9, at, c->studio->light_colour);
  put(t->input + 12, at, vec_scale(-1, direction));
  t->input[15][at] = footprint(c, h, direction);
  t->key[at] = studio_key(c->studio, c->scene, h, seed, sample);
  t->fill[at] = studio_fill(c->studio, c->scene, h, seed, sample);
  t->pixel[at] = pixel;
  t->hits[pixel]++;
}

static void trace_sample(tile *t, uint32_t pixel, uint32_t sample) {
  const tile_context *c = t->c;
  uint32_t x = t->x + pixel % t->width, y = t->y + pixel / t->width;
  uint32_t seed = sample_hash(y * c->film->width + x);
  float u, v;
  vec origin, direction;
  sample_pair(seed, sample, PAIR_PIXEL, &u, &v);
  camera_ray(c->camera, (float)x + u, (float)y + v, c->film->width, c->film->height, &origin,
             &direction);
  hit h = scene_trace(c->scene, origin, direction);
  if (h.what == HIT_SHAPE)
    gather(t, &h, direction, pixel, seed, sample);
  else if (h.what == HIT_FLOOR)
    add(beauty_of(t, pixel), studio_floor(c->studio, c->scene, &h, seed, sample));
  else
    add(beauty_of(t, pixel), studio_backdrop(c->studio, c->scene, direction));
}

/* ---- one batch -------------------------------------------------------- */

static vec output(const tile *t, int32_t first, uint32_t at) {
  if (first < 0) return (vec){NEUTRAL, NEUTRAL, NEUTRAL};
  float **out = t->out + first;
  return (vec){out[0][at], out[1][at], out[2][at]};
}

/* What the surface shows of the sky: below it what of the sky reaches the place,
 * and above it the sky mirrored, by Schlick's Fresnel term as rough as it is. */
static vec sky_light(const tile *t, uint32_t at, vec albedo) {
  const tile_context *c = t->c;
  vec below = vec_mul(albedo, t->fill[at]);
  if (c->occlusion < 0) return below;
  float occlusion = t->out[c->occlusion][at], alpha = t->out[c->roughness][at];
  float f0 = t->out[c->specular][at];
  vec n = output(t, c->normal, at);
  vec view = {t->input[12][at], t->input[13][at], t->input[14][at]};
  float cosine = fminf(fmaxf(vec_dot(n, view), 0), 1), away = 1 - cosine;
  float edge = fmaxf(1 - alpha, f0), a2 = away * away;
  float f = f0 + (edge - f0) * a2 * a2 * away;
  vec mirror = vec_along(vec_scale(2 * vec_dot(n, view), n), -1, view);
  vec sum = vec_scale(occlusion * (1 - f), below);
  return vec_along(sum, f * occlusion, studio_mirrored(c->studio, c->scene, mirror));
}

/* A matt card under what does not cover all: strands over nothing were strands over black. */
static vec card(const tile *t, uint32_t at) {
  const tile_context *c = t->c;
  float bare = NEUTRAL * c->gaps * (1 - t->out[c->coverage][at]);
  vec n = {t->input[3][at], t->input[4][at], t->input[5][at]};
  float slope = fmaxf(0, vec_dot(n, c->studio->light));
  vec lit = vec_along(t->fill[at], t->key[at] * slope, c->studio->light_colour);
  return vec_scale(bare, lit);
}

static void add_up(const tile *t) {
  const tile_context *c = t->c;
  film *f = c->film;
  for (uint32_t at = 0; at < t->count; at++) {
    vec albedo = output(t, c->albedo, at), radiance;
    if (c->radiance >= 0)
      radiance = output(t, c->radiance, at);
    else { /* matt, for want of better */
      vec n = {t->input[3][at], t->input[4][at], t->input[5][at]};
      float slope = fmaxf(0, vec_dot(n, c->studio->light));
      radiance = vec_scale(slope, vec_mul(albedo, c->studio->light_colour));
    }
    float *beauty = beauty_of(t, t->pixel[at]);
    add(beauty, vec_add(vec_scale(t->key[at], radiance), sky_light(t, at, albedo)));
    if (c->gaps > 0) add(beauty, card(t, at));
    float *layers = f->layers + (size_t)(beauty - f->beauty) / 3 * f->components;
    for (uint32_t i = 0; i < f->components; i++)
      layers[i] += t->out[f->channel_of[i]->first + f->component_of[i]][at];
  }
}

static bool evaluate(tile *t, failure *why) {
  if (t->count == 0) return true;
  const tile_context *c = t->c;
  sozai_batch batch = {.size = sizeof batch,
                       .count = t->count,
                       .footprint = t->input[15],
                       .out = t->out,
                       .out_count = c->info->component_count};
  for (uint32_t k = 0; k < 3; k++) {
    batch.point[k] = t->input[k];
    batch.normal[k] = t->input[3 + k];
    batch.light[k] = t->input[6 + k];
    batch.light_colour[k] = t->input[9 + k];
    batch.view[k] = t->input[12 + k];
  }
  if (c->job->textures->evaluate(c->job->texture, &batch) != SOZAI_OK)
    return fail(why, EXIT_FAILURE, "evaluate: %s", c->job->textures->last_error());
  add_up(t);
  t->count = 0;
  return true;
}

static void average(const tile *t) {
  film *f = t->c->film;
  float share = 1.0f / (float)t->c->job->spp;
  for (uint32_t pixel = 0; pixel < t->width * t->height; pixel++) {
    float *beauty = beauty_of(t, pixel);
    size_t at = (size_t)(beauty - f->beauty) / 3;
    for (uint32_t k = 0; k < 3; k++) beauty[k] *= share;
    uint32_t hits = t->hits[pixel];
    f->coverage[at] = share * (float)hits;
    for (uint32_t i = 0; hits > 0 && i < f->components; i++)
      f->layers[at * f->components + i] /= (float)hits;
  }
}

static bool run(tile *t, size_t room, failure *why) {
  uint32_t pixels = t->width * t->height;
  for (uint32_t sample = 0; sample < t->c->job->spp; sample++) {
    if (cancel_requested()) return fail(why, EXIT_FAILURE, "cancelled");
    if (t->count + pixels > room && !evaluate(t, why)) return false;
    for (uint32_t pixel = 0; pixel < pixels; pixel++) trace_sample(t, pixel, sample);
  }
  if (!evaluate(t, why)) return false;
  average(t);
  return true;
}

bool tile_render(const tile_context *c, uint32_t index, failure *why) {
  tile t = {.c = c};
  const film *f = c->film;
  uint32_t across = (f->width + TILE_SIDE - 1) / TILE_SIDE;
  t.x = index % across * TILE_SIDE;
  t.y = index / across * TILE_SIDE;
  t.width = f->width - t.x < TILE_SIDE ? f->width - t.x : TILE_SIDE;
  t.height = f->height - t.y < TILE_SIDE ? f->height - t.y : TILE_SIDE;
  size_t room = (size_t)t.width * t.height * c->job->spp;
  if (room > BATCH) room = BATCH;
  bool ok = allocate(&t, room) ? run(&t, room, why) : fail(why, EXIT_FAILURE, "out of memory");
  release(&t);
  return ok;
}
