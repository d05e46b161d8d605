/* SPDX-License-Identifier: Apache-2.0 */
#include "tree_view.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "growth.h"
#include "job_options.h"
#include "scene.h"
#include "studio.h"
#include "view.h"

/* Of leaves: what passes through, as a share of what is thrown back. */
#define TRANSLUCENCY 0.55f

typedef struct view {
  const sozai_mesh *mesh;
  const scene *scene;
  studio studio;
  vec albedo[VIEW_PARTS];
  bool sheet[VIEW_PARTS];
  float *colours; /* of the points, or NULL: as the parts are */
} view;

static uint32_t part_of(const sozai_mesh *m, uint32_t triangle) {
  uint32_t i = 0;
  while (i + 1 < m->part_count && i + 1 < VIEW_PARTS && triangle >= m->parts[i + 1].first) i++;
  return i;
}

/* Between the triangle's corners. */
static vec between(const view *w, const hit *h) {
  const uint32_t *t = w->mesh->indices + 3 * (size_t)h->triangle;
  const float share[3] = {1 - h->u - h->v, h->u, h->v};
  vec sum = {0, 0, 0};
  for (int k = 0; k < 3; k++) {
    const float *c = w->colours + 3 * (size_t)t[k];
    sum = vec_add(sum, vec_scale(share[k], (vec){c[0], c[1], c[2]}));
  }
  return sum;
}

static vec shade(const view *w, const hit *h, uint32_t pixel, uint32_t sample) {
  uint32_t part = part_of(w->mesh, h->triangle);
  vec albedo = w->colours ? between(w, h) : w->albedo[part], light;
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

static vec look(const void *context, const view_ray *r, bool *hit_any) {
  const view *w = context;
  hit h = scene_trace(w->scene, r->origin, r->direction);
  *hit_any = h.what == HIT_SHAPE;
  if (*hit_any) return shade(w, &h, r->seed, r->sample);
  if (h.what == HIT_FLOOR) return studio_floor(&w->studio, w->scene, &h, r->seed, r->sample);
  return studio_backdrop(&w->studio, w->scene, r->direction);
}

static bool take_colours(view *w, const session *s, failure *why) {
  const sozai_mesh *m = w->mesh;
  const float *colours = growth_mesh_colours(m);
  if (!colours) return true;
  w->colours = malloc((size_t)m->point_count * 3 * sizeof *w->colours);
  if (!w->colours) return fail(why, EXIT_FAILURE, "out of memory");
  memcpy(w->colours, colours, (size_t)m->point_count * 3 * sizeof *colours);
  return view_working(w->colours, m->point_count, "a tree's points", s, why);
}

static bool draw(view *w, const render_job *job, const session *s, film *out, failure *why) {
  camera from;
  camera_place(&from, job, w->scene, out->width, out->height);
  studio_init(&w->studio, job, w->scene);
  const sozai_part *parts = w->mesh->parts;
  if (!view_colours(parts, w->mesh->part_count, s, w->albedo, why)) return false;
  for (uint32_t i = 0; i < w->mesh->part_count && i < VIEW_PARTS; i++)
    w->sheet[i] = strcmp(parts[i].id, "bark") != 0 && strcmp(parts[i].id, "shoot") != 0;
  if (!take_colours(w, s, why)) return false;
  const view_picture picture = {job, &from, out, look, w};
  return view_draw(&picture, why);
}

bool tree_view_render(const tree_view *v, const sozai_mesh *m, session *s, film *out,
                      failure *why) {
  memset(out, 0, sizeof *out);
  if (m->triangle_count == 0) return fail(why, EXIT_FAILURE, "nothing was grown to be seen");
  mesh given;
  render_job job;
  render_job_init(&job, NULL, NULL);
  job.threads = v->threads ? v->threads : s->host.threads;
  job.quiet = v->quiet;
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
  view w = {.mesh = m, .scene = &sc};
  bool ok =
      film_allocate(out, v->size[0], v->size[1], NULL, NULL, 0, why) && draw(&w, &job, s, out, why);
  scene_close(&sc);
  free(w.colours);
  if (!ok) film_free(out);
  return ok;
}

bool tree_view_write(const tree_view *v, const sozai_mesh *m, session *s, const char *path,
                     failure *why) {
  film f;
  if (!tree_view_render(v, m, s, &f, why)) return false;
  bool ok = view_write(&f, s, path, why);
  film_free(&f);
  return ok;
}
