/* SPDX-License-Identifier: Apache-2.0 */
#include "tree_view.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include "camera.h"
#include "cancel.h"
#include "ending.h"
#include "job_options.h"
#include "parallel.h"
#include "progress.h"
#include "samples.h"
#include "scene.h"
#include "studio.h"

#define PARTS 8
/* Of leaves: what passes through, as a share of what is thrown back. */
#define TRANSLUCENCY 0.55f

typedef struct view {
  const render_job *job;
  const sozai_mesh *mesh;
  const scene *scene;
  camera camera;
  studio studio;
  film *film;
  vec albedo[PARTS];
  bool sheet[PARTS];
  atomic_uint rows;
} view;

static double to_linear(double x) {
  return x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4);
}

/* The parts' colours in the working space. */
static bool take_colours(view *w, const session *s, failure *why) {
  for (uint32_t i = 0; i < w->mesh->part_count && i < PARTS; i++) {
    const sozai_part *p = &w->mesh->parts[i];
    float rgb[3] = {p->colour[0], p->colour[1], p->colour[2]};
    const sozai_colour_1 *c = s->colour.service;
    if (!c) {
      for (int k = 0; k < 3; k++) rgb[k] = (float)to_linear((double)rgb[k]);
    } else {
      char text[256] = "";
      if (c->to_working(c->self, "sRGB", rgb, 1, text, sizeof text) != SOZAI_OK)
        return fail(why, EXIT_FAILURE, "colour of part %s: %s", p->id, text);
    }
    w->albedo[i] = (vec){rgb[0], rgb[1], rgb[2]};
    w->sheet[i] = strcmp(p->id, "bark") != 0 && strcmp(p->id, "shoot") != 0;
  }
  return true;
}

static uint32_t part_of(const sozai_mesh *m, uint32_t triangle) {
  uint32_t i = 0;
  while (i + 1 < m->part_count && i + 1 < PARTS && triangle >= m->parts[i + 1].first) i++;
  return i;
}

/* Leaves and shoots differ a little from one to another, as they do. */
static vec varied(const view *w, const hit *h, uint32_t part) {
  vec a = w->albedo[part];
  if (!w->sheet[part]) return a;
  const sozai_mesh *m = w->mesh;
  uint32_t owner = m->owner[m->indices[3 * (size_t)h->triangle]];
  float own = (float)(sample_hash(owner * 2654435761u) >> 8) / 16777216.0f;
  float leaf = (float)(sample_hash(h->triangle / 8u + 77u) >> 8) / 16777216.0f;
  float shade = 0.78f + 0.3f * own + 0.14f * leaf, warm = 0.9f + 0.25f * own;
  return (vec){a.x * shade * warm, a.y * shade, a.z * shade};
}

static vec shade(const view *w, const hit *h, uint32_t pixel, uint32_t sample) {
  uint32_t part = part_of(w->mesh, h->triangle);
  vec albedo = varied(w, h, part), light;
  float front = fmaxf(0, vec_dot(h->normal, w->studio.light));
  float key = front > 0 ? front * studio_key(&w->studio, w->scene, h, pixel, sample) : 0;
  if (w->sheet[part]) {
    hit back = *h;
    back.normal = vec_scale(-1, h->normal);
    back.geometric = vec_scale(-1, h->geometric);
    float behind = fmaxf(0, vec_dot(back.normal, w->studio.light));
    if (behind > 0)
      key += TRANSLUCENCY * behind * studio_key(&w->studio, w->scene, &back, pixel, sample);
  }
  light = vec_scale(key, w->studio.light_colour);
  return vec_mul(albedo, vec_add(light, studio_fill(&w->studio, w->scene, h, pixel, sample)));
}

static void draw_row(void *context, uint32_t y) {
  view *w = context;
  film *f = w->film;
  if (cancel_requested()) return;
  for (uint32_t x = 0; x < f->width; x++) {
    uint32_t seed = sample_hash(y * f->width + x);
    vec sum = {0, 0, 0};
    float hits = 0;
    for (uint32_t i = 0; i < w->job->spp; i++) {
      float u, v;
      vec origin, direction;
      sample_pair(seed, i, PAIR_PIXEL, &u, &v);
      camera_ray(&w->camera, (float)x + u, (float)y + v, f->width, f->height, &origin, &direction);
      hit h = scene_trace(w->scene, origin, direction);
      if (h.what == HIT_SHAPE) {
        sum = vec_add(sum, shade(w, &h, seed, i));
        hits++;
      } else if (h.what == HIT_FLOOR)
        sum = vec_add(sum, studio_floor(&w->studio, w->scene, &h, seed, i));
      else
        sum = vec_add(sum, studio_backdrop(&w->studio, w->scene, direction));
    }
    size_t at = (size_t)y * f->width + x;
    float share = 1.0f / (float)w->job->spp;
    f->beauty[3 * at] = share * sum.x;
    f->beauty[3 * at + 1] = share * sum.y;
    f->beauty[3 * at + 2] = share * sum.z;
    f->coverage[at] = share * hits;
  }
  progress_show((float)(atomic_fetch_add(&w->rows, 1) + 1) / (float)f->height, "rendering");
}

static bool draw(view *w, const render_job *job, const session *s, failure *why) {
  camera_place(&w->camera, job, w->scene, w->film->width, w->film->height);
  studio_init(&w->studio, job, w->scene);
  if (!take_colours(w, s, why)) return false;
  atomic_init(&w->rows, 0);
  parallel_for(job->threads, w->film->height, draw_row, w);
  progress_clear();
  return !cancel_requested() || fail(why, EXIT_FAILURE, "cancelled");
}

bool tree_view_render(const tree_view *v, const sozai_mesh *m, session *s, film *out,
                      failure *why) {
  memset(out, 0, sizeof *out);
  if (m->triangle_count == 0) return fail(why, EXIT_FAILURE, "nothing was grown to be seen");
  mesh given;
  render_job job;
  render_job_init(&job, NULL, NULL);
  job.threads = s->host.threads;
  job.spp = v->spp;
  job.zoom = v->zoom;
  const job_options look = {.camera = v->camera, .target = v->target};
  if (!job_options_apply(&job, &look, NULL, why)) return false;
  if (!mesh_allocate(&given, (uint32_t)m->point_count, (uint32_t)m->triangle_count, why))
    return false;
  memcpy(given.points, m->points, (size_t)m->point_count * 3 * sizeof(float));
  memcpy(given.normals, m->normals, (size_t)m->point_count * 3 * sizeof(float));
  memcpy(given.indices, m->indices, (size_t)m->triangle_count * 3 * sizeof(uint32_t));
  job.shape = SHAPE_GIVEN;
  job.given = &given; /* the scene's from here on */
  job.y_up = true;
  scene sc;
  if (!scene_open(&sc, &job, why)) return false;
  view w = {.job = &job, .mesh = m, .scene = &sc, .film = out};
  bool ok =
      film_allocate(out, v->size[0], v->size[1], NULL, NULL, 0, why) && draw(&w, &job, s, why);
  scene_close(&sc);
  if (!ok) film_free(out);
  return ok;
}

bool tree_view_write(const tree_view *v, const sozai_mesh *m, session *s, const char *path,
                     failure *why) {
  film f;
  if (!tree_view_render(v, m, s, &f, why)) return false;
  bool ok = ends_in(path, ".png") ? film_write_png(&f, path, &s->colour, &s->shown, 0, 8, why)
                                  : film_write_exr(&f, path, &s->colour, why);
  film_free(&f);
  return ok;
}
