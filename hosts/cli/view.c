/* SPDX-License-Identifier: Apache-2.0 */
#include "view.h"

#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include "cancel.h"
#include "ending.h"
#include "parallel.h"
#include "progress.h"
#include "samples.h"
#include "srgb.h"
#include "studio.h"

typedef struct drawing {
  const view_picture *picture;
  atomic_uint rows; /* done */
} drawing;

static void draw_pixel(const view_picture *p, uint32_t x, uint32_t y) {
  film *f = p->film;
  view_ray ray = {.seed = sample_hash(y * f->width + x)};
  vec sum = {0, 0, 0};
  float hits = 0;
  for (ray.sample = 0; ray.sample < p->job->spp; ray.sample++) {
    float u, v;
    sample_pair(ray.seed, ray.sample, PAIR_PIXEL, &u, &v);
    camera_ray(p->camera, (float)x + u, (float)y + v, f->width, f->height, &ray.origin,
               &ray.direction);
    bool hit = false;
    sum = vec_add(sum, p->look(p->context, &ray, &hit));
    if (hit) hits++;
  }
  size_t at = (size_t)y * f->width + x;
  float share = 1.0f / (float)p->job->spp;
  f->beauty[3 * at] = share * sum.x;
  f->beauty[3 * at + 1] = share * sum.y;
  f->beauty[3 * at + 2] = share * sum.z;
  f->coverage[at] = share * hits;
}

static void draw_row(void *context, uint32_t y) {
  drawing *d = context;
  const film *f = d->picture->film;
  if (cancel_requested()) return;
  for (uint32_t x = 0; x < f->width; x++) draw_pixel(d->picture, x, y);
  uint32_t rows = atomic_fetch_add(&d->rows, 1) + 1;
  if (!d->picture->job->quiet) progress_show((float)rows / (float)f->height, "rendering");
}

bool view_draw(const view_picture *p, failure *why) {
  drawing d = {.picture = p};
  atomic_init(&d.rows, 0);
  parallel_for(p->job->threads, p->film->height, draw_row, &d);
  if (!p->job->quiet) progress_clear();
  return !cancel_requested() || fail(why, EXIT_FAILURE, "cancelled");
}

bool view_working(float *rgb, uint64_t count, const char *whose, const session *s, failure *why) {
  const sozai_colour_1 *c = s->colour.service;
  for (uint64_t i = 0; !c && i < 3 * count; i++) rgb[i] = (float)srgb_to_linear((double)rgb[i]);
  char text[256] = "";
  return !c || c->to_working(c->self, "sRGB", rgb, count, text, sizeof text) == SOZAI_OK ||
         fail(why, EXIT_FAILURE, "colour of %s: %s", whose, text);
}

bool view_colours(const sozai_part *parts, uint32_t count, const session *s, vec *out,
                  failure *why) {
  for (uint32_t i = 0; i < count && i < VIEW_PARTS; i++) {
    const sozai_part *p = &parts[i];
    float rgb[3] = {p->colour[0], p->colour[1], p->colour[2]};
    char whose[128];
    snprintf(whose, sizeof whose, "part %s", p->id);
    if (!view_working(rgb, 1, whose, s, why)) return false;
    out[i] = (vec){rgb[0], rgb[1], rgb[2]};
  }
  return true;
}

bool view_write(const film *f, const session *s, const char *path, failure *why) {
  return ends_in(path, ".png") ? film_write_png(f, path, &s->colour, &s->shown, 0, 8, why)
                               : film_write_exr(f, path, &s->colour, why);
}
