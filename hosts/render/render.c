/* SPDX-License-Identifier: Apache-2.0 */
#include "render.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include "cancel.h"
#include "parallel.h"
#include "progress.h"
#include "tile.h"

typedef struct crew {
  tile_context context;
  uint32_t tiles;
  atomic_uint done;
  atomic_bool failed;
  pthread_mutex_t lock; /* guards why */
  failure why;
} crew;

static void run_tile(void *context, uint32_t index) {
  crew *w = context;
  failure why = {0};
  if (atomic_load(&w->failed)) return;
  if (!tile_render(&w->context, index, &why)) {
    pthread_mutex_lock(&w->lock);
    if (!atomic_exchange(&w->failed, true)) w->why = why;
    pthread_mutex_unlock(&w->lock);
    return;
  }
  uint32_t done = atomic_fetch_add(&w->done, 1) + 1;
  if (!w->context.job->quiet) progress_show((float)done / (float)w->tiles, "rendering");
}

#define MOST_COMPONENTS 64

static int32_t find(const sozai_texture_info *info, const char *id, uint32_t components) {
  for (uint32_t i = 0; i < info->channel_count; i++)
    if (strcmp(info->channels[i]->id, id) == 0 && info->channels[i]->components == components)
      return (int32_t)info->channels[i]->first;
  return -1;
}

static void find_channels(tile_context *c) {
  c->coverage = find(c->info, "coverage", 1);
  c->occlusion = find(c->info, "occlusion", 1);
  c->normal = find(c->info, "normal", 3);
  c->roughness = find(c->info, "roughness", 1);
  c->specular = find(c->info, "specular", 1);
  if (c->normal < 0 || c->roughness < 0 || c->specular < 0) c->occlusion = -1;
}

#define AFAR 1e4f /* mm: the widest footprint there is */

/* What of a face is not covered, over all. */
static float find_gaps(const tile_context *c) {
  const float zero = 0, one = 1, afar = AFAR;
  float covered = 0, *out[MOST_COMPONENTS] = {NULL};
  if (c->coverage < 0 || c->coverage >= MOST_COMPONENTS) return 0;
  out[c->coverage] = &covered;
  const sozai_batch batch = {.size = sizeof batch,
                             .count = 1,
                             .point = {&zero, &zero, &zero},
                             .normal = {&zero, &zero, &one},
                             .light = {&zero, &zero, &one},
                             .view = {&zero, &zero, &one},
                             .footprint = &afar,
                             .out = out,
                             .out_count = (uint32_t)c->coverage + 1};
  return c->job->textures->evaluate(c->job->texture, &batch) == SOZAI_OK ? 1 - covered : 1;
}

static bool run_tiles(const render_job *job, const scene *s, const sozai_texture_info *info,
                      film *out, failure *why) {
  camera cam;
  studio light;
  camera_place(&cam, job, s, out->width, out->height);
  studio_init(&light, job, s);
  crew w = {.context = {.job = job,
                        .info = info,
                        .scene = s,
                        .camera = &cam,
                        .studio = &light,
                        .film = out,
                        .albedo = find(info, "albedo", 3),
                        .radiance = find(info, "radiance", 3)},
            .tiles = tile_count(out),
            .lock = PTHREAD_MUTEX_INITIALIZER};
  find_channels(&w.context);
  w.context.gaps = find_gaps(&w.context);
  parallel_for(job->threads, w.tiles, run_tile, &w);
  if (!job->quiet) progress_clear();
  if (atomic_load(&w.failed)) *why = w.why;
  return !atomic_load(&w.failed);
}

bool render(const render_job *job, film *out, failure *why) {
  memset(out, 0, sizeof *out);
  const sozai_texture_info *info = job->textures->info_of(job->texture);
  scene s;
  if (!scene_open(&s, job, why)) return false;
  uint32_t width, height;
  camera_resolution(job, &s, &width, &height);
  bool ok = film_allocate(out, width, height, info, job->channels, job->channel_count, why) &&
            run_tiles(job, &s, info, out, why);
  scene_close(&s);
  if (!ok) film_free(out);
  return ok;
}
