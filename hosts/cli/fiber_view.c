/* SPDX-License-Identifier: Apache-2.0 */
#include "fiber_view.h"

#include <math.h>
#include <string.h>
#include "fiber_lobe.h"
#include "growth.h"
#include "job_options.h"
#include "samples.h"
#include "strands.h"
#include "studio.h"
#include "view.h"

#define ROULETTE_FROM 4

typedef struct view {
  const fiber_view *how;
  const sozai_curves *curves;
  const strands *strands;
  studio studio;
  fiber_lobe lobe, wide; /* wide: of light that has met strands already */
  vec colour[VIEW_PARTS];
  float spread, round; /* lightness from strand to strand; roughness round */
} view;

static float number_of(const sozai_geometry_1 *table, const sozai_geometry *g, const char *id) {
  sozai_value v;
  memset(&v, 0, sizeof v);
  return table->value(g, id, &v) == SOZAI_OK ? (float)v.number[0] : 0;
}

/* ---- light ------------------------------------------------------------- */

static vec colour_of(const view *w, uint32_t curve) {
  uint32_t part = 0;
  const sozai_curves *c = w->curves;
  while (part + 1 < c->part_count && part + 1 < VIEW_PARTS && curve >= c->parts[part + 1].first)
    part++;
  uint32_t h = sample_hash(c->ids[curve] * 2654435761u + 13u);
  float sum = -2;
  for (int k = 0; k < 4; k++) {
    sum += sample_unit(h);
    h = sample_hash(h + 1);
  }
  float by = fminf(fmaxf(1 + 1.7f * w->spread * sum, 0.2f), 2.0f);
  vec a = vec_scale(by, w->colour[part]);
  return (vec){fminf(a.x, 0.985f), fminf(a.y, 0.985f), fminf(a.z, 0.985f)};
}

static vec key_light(const view *w, const fiber_lobe *lobe, const fiber_view_from *f,
                     const strand_hit *h, sample_stream *d) {
  const studio *st = &w->studio;
  float r = st->light_spread * sqrtf(sample_next(d)), turn = 6.2831853f * sample_next(d);
  vec towards = vec_along(st->light, r * cosf(turn), st->light_s);
  towards = vec_unit(vec_along(towards, r * sinf(turn), st->light_t));
  vec value = fiber_lobe_value(lobe, f, towards);
  if (value.x + value.y + value.z < 1e-5f) return (vec){0, 0, 0};
  if (scene_blocked(&w->strands->scene, strand_leave(h, towards), towards)) return (vec){0, 0, 0};
  return vec_scale(3.14159265f, vec_mul(value, st->light_colour));
}

/* What a ray that leaves the aggregate meets: the sky, or the floor, darker
 * below the aggregate. */
static vec surroundings(const view *w, vec origin, vec direction) {
  const scene *s = &w->strands->scene;
  const studio *st = &w->studio;
  if (!s->has_floor || direction.y >= -1e-4f) {
    vec up = direction;
    up.y = fabsf(up.y);
    return studio_mirrored(st, s, up);
  }
  float t = (s->floor - origin.y) / direction.y;
  vec at = vec_along(origin, t, direction), away = vec_sub(at, st->centre);
  float d = sqrtf(away.x * away.x + away.z * away.z) / st->radius;
  return vec_scale(0.3f + 0.7f * fminf(1, d * d), st->lit_floor);
}

static vec follow(const view *w, strand_hit h, vec direction, sample_stream *d) {
  vec sum = {0, 0, 0}, through = {1, 1, 1}, weight, origin;
  for (uint32_t bounce = 0; bounce <= w->how->bounces; bounce++) {
    vec absorption = fiber_lobe_absorption(colour_of(w, h.curve), w->round);
    vec normal = vec_dot(h.normal, direction) > 0 ? vec_scale(-1, h.normal) : h.normal;
    h.normal = normal;
    /* a highlight seen in a highlight is one sample in a thousand: blurred */
    const fiber_lobe *lobe = bounce ? &w->wide : &w->lobe;
    fiber_view_from f =
        fiber_lobe_from(lobe, h.tangent, normal, vec_scale(-1, direction), absorption);
    vec lit = vec_mul(through, key_light(w, lobe, &f, &h, d));
    float most = fmaxf(lit.x, fmaxf(lit.y, lit.z));
    if (bounce && most > 3) lit = vec_scale(3 / most, lit);
    sum = vec_add(sum, lit);
    float u[4];
    for (int k = 0; k < 4; k++) u[k] = sample_next(d);
    direction = fiber_lobe_sample(lobe, &f, u, &weight);
    through = vec_mul(through, weight);
    if (bounce >= ROULETTE_FROM) {
      float keep = fminf(0.97f, fmaxf(through.x, fmaxf(through.y, through.z)));
      if (!(sample_next(d) < keep)) break;
      through = vec_scale(1 / keep, through);
    }
    origin = strand_leave(&h, direction);
    if (!strands_trace(w->strands, origin, direction, &h)) {
      sum = vec_add(sum, vec_mul(through, surroundings(w, origin, direction)));
      break;
    }
  }
  return sum;
}

/* ---- the picture ------------------------------------------------------- */

static vec beyond(const view *w, const view_ray *r) {
  const scene *s = &w->strands->scene;
  if (s->has_floor && r->direction.y < -1e-6f) {
    hit h = {.what = HIT_FLOOR, .normal = s->up, .geometric = s->up};
    h.distance = (s->floor - r->origin.y) / r->direction.y;
    h.point = vec_along(r->origin, h.distance, r->direction);
    if (h.distance > 0) return studio_floor(&w->studio, s, &h, r->seed, r->sample);
  }
  return s->has_floor ? studio_backdrop(&w->studio, s, r->direction)
                      : (vec){0.035f, 0.037f, 0.041f};
}

static vec look(const void *context, const view_ray *r, bool *hit_any) {
  const view *w = context;
  strand_hit h;
  sample_stream d = {sample_hash(r->seed ^ (r->sample + 1) * 0x9e3779b9u)};
  *hit_any = strands_trace(w->strands, r->origin, r->direction, &h);
  vec got = *hit_any ? follow(w, h, r->direction, &d) : beyond(w, r);
  return (vec){fminf(got.x, 4), fminf(got.y, 4), fminf(got.z, 4)};
}

static bool draw(view *w, const render_job *job, const session *s, film *out, failure *why) {
  camera from;
  camera_place(&from, job, &w->strands->scene, out->width, out->height);
  studio_init(&w->studio, job, &w->strands->scene);
  if (!view_colours(w->curves->parts, w->curves->part_count, s, w->colour, why)) return false;
  const view_picture picture = {job, &from, out, look, w};
  return view_draw(&picture, why);
}

static bool render_curves(const fiber_view *v, const sozai_geometry_1 *table,
                          const sozai_geometry *g, const sozai_curves *c, session *s, film *out,
                          failure *why) {
  render_job job;
  render_job_init(&job, NULL, NULL);
  job.threads = s->host.threads;
  job.spp = v->spp;
  job.zoom = v->zoom;
  job.shape = SHAPE_GIVEN;
  job.y_up = true;
  if (v->sky > 0) job.sky = v->sky;
  const job_options look = {.camera = v->camera, .target = v->target, .light = v->light};
  if (!job_options_apply(&job, &look, NULL, why)) return false;
  strands st;
  if (!strands_open(&st, c, v->smooth, !v->no_floor, why)) return false;
  view w = {.how = v, .curves = c, .strands = &st};
  w.round = number_of(table, g, "roughness_round");
  w.spread = number_of(table, g, "colour_spread");
  float rough = number_of(table, g, "roughness"), tilt = number_of(table, g, "tilt");
  w.lobe = fiber_lobe_make(rough, w.round, tilt, 1.55f);
  w.wide = fiber_lobe_make(fmaxf(rough, 28), fmaxf(w.round, 0.75f), tilt, 1.55f);
  bool ok =
      film_allocate(out, v->size[0], v->size[1], NULL, NULL, 0, why) && draw(&w, &job, s, out, why);
  strands_close(&st);
  if (!ok) film_free(out);
  return ok;
}

bool fiber_view_render(const fiber_view *v, const sozai_geometry_1 *table, const sozai_geometry *g,
                       session *s, film *out, failure *why) {
  memset(out, 0, sizeof *out);
  const sozai_curves *c = NULL;
  int32_t code = table->curves(g, NULL, &c);
  if (code != SOZAI_OK) return growth_failed(table, code, why);
  bool ok = render_curves(v, table, g, c, s, out, why);
  table->release_curves(c);
  return ok;
}

bool fiber_view_write(const fiber_view *v, const sozai_geometry_1 *table, const sozai_geometry *g,
                      session *s, const char *path, failure *why) {
  film f;
  if (!fiber_view_render(v, table, g, s, &f, why)) return false;
  bool ok = view_write(&f, s, path, why);
  film_free(&f);
  return ok;
}
