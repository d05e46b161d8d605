/* SPDX-License-Identifier: Apache-2.0 */
#include "studio.h"

#include <math.h>
#include "camera.h"
#include "samples.h"

/* Scene-linear, near neutral so that any working space will do. */
static const vec floor_albedo = {0.62f, 0.605f, 0.585f};
static const vec sky_zenith = {0.47f, 0.48f, 0.50f};
static const vec sky_horizon = {0.33f, 0.325f, 0.32f};
/* What a ray that meets the shape itself brings back, for want of bounces: this
 * share of the sky, in the colour of nothing much. */
static const vec bounce = {0.10f, 0.09f, 0.08f};
/* The floor's brightness far off, and where it begins and ends to fall to it,
 * in radii of the shape. */
#define FAR_FLOOR 0.40f
#define FADE_FROM 1.0f
#define FADE_TO 14.0f
#define PI 3.14159265f

/* The sky's mean over a hemisphere that faces it, by its gradient in the sine
 * of the elevation: integral of (h + (z - h) u) 2u du. */
static vec mean_sky(float sky) {
  return vec_scale(sky, vec_mix(sky_horizon, sky_zenith, 2 / 3.0f));
}

void studio_init(studio *st, const render_job *job, const scene *s) {
  st->light = camera_direction(job->light_azimuth, job->light_elevation, job->y_up);
  vec_frame(st->light, &st->light_s, &st->light_t);
  st->light_colour = vec_of(job->light_colour[0], job->light_colour[1], job->light_colour[2]);
  st->light_spread = (float)tan(job->light_size / 2 * 3.14159265358979323846 / 180);
  st->sky = (float)job->sky;
  st->up = s->up;
  st->centre = scene_centre(s);
  st->radius = scene_radius(s);
  float slope = fmaxf(0, vec_dot(st->light, st->up));
  vec light = vec_add(vec_scale(slope, st->light_colour), mean_sky(st->sky));
  st->lit_floor = vec_mul(floor_albedo, light);
}

float studio_key(const studio *st, const scene *s, const hit *h, uint32_t pixel, uint32_t sample) {
  vec side = scene_lit_side(h);
  float u, v, rise = vec_dot(side, st->light);
  if (rise <= -st->light_spread) return 0;
  if (rise > st->light_spread && scene_sees_all(s, h)) return 1;
  sample_pair(pixel, sample, PAIR_LIGHT, &u, &v);
  float r = st->light_spread * sqrtf(u), turn = 2 * PI * v;
  vec towards = vec_along(st->light, r * cosf(turn), st->light_s);
  towards = vec_unit(vec_along(towards, r * sinf(turn), st->light_t));
  if (vec_dot(side, towards) <= 0) return 0;
  return scene_blocked_from(s, h, towards) ? 0 : 1;
}

static vec sky_towards(const studio *st, vec direction) {
  float height = fmaxf(0, vec_dot(direction, st->up));
  return vec_scale(st->sky, vec_mix(sky_horizon, sky_zenith, height));
}

vec studio_mirrored(const studio *st, const scene *s, vec direction) {
  if (s->has_floor && vec_dot(direction, st->up) < 0) return vec_scale(FAR_FLOOR, st->lit_floor);
  return sky_towards(st, direction);
}

/* What comes to a face with nothing before it. Of the hemisphere's cosine-weighted directions
 * (1 + c) / 2 point upwards, c being the normal's; their mean height, downwards counted as 0,
 * is the convolution of two clamped cosines. */
static vec open_fill(const studio *st, const scene *s, vec normal) {
  float c = fminf(fmaxf(vec_dot(normal, st->up), -1), 1), above = (1 + c) / 2;
  float height = 2 / (3 * PI) * (sqrtf(1 - c * c) + (PI - acosf(c)) * c);
  vec low = s->has_floor ? st->lit_floor : vec_scale(st->sky, sky_horizon);
  vec sky = vec_along(vec_scale(above, sky_horizon), height, vec_sub(sky_zenith, sky_horizon));
  return vec_along(vec_scale(1 - above, low), st->sky, sky);
}

vec studio_fill(const studio *st, const scene *s, const hit *h, uint32_t pixel, uint32_t sample) {
  vec sum = {0, 0, 0}, a, b;
  if (st->sky == 0 && !s->has_floor) return sum;
  if (scene_sees_all(s, h)) return open_fill(st, s, h->normal);
  vec_frame(h->normal, &a, &b);
  vec side = scene_lit_side(h);
  for (uint32_t i = 0; i < SKY_RAYS; i++) {
    float u, v;
    sample_pair(pixel, sample * SKY_RAYS + i, PAIR_SKY, &u, &v);
    float r = sqrtf(u), turn = 2 * PI * v;
    vec towards = vec_scale(sqrtf(1 - u), h->normal);
    towards = vec_along(towards, r * cosf(turn), a);
    towards = vec_along(towards, r * sinf(turn), b);
    if (vec_dot(towards, side) <= 0) continue;
    if (scene_blocked_from(s, h, towards))
      sum = vec_along(sum, st->sky, bounce);
    else if (s->has_floor && vec_dot(towards, st->up) < 0)
      sum = vec_add(sum, st->lit_floor);
    else
      sum = vec_add(sum, sky_towards(st, towards));
  }
  return vec_scale(1.0f / SKY_RAYS, sum);
}

/* The floor darkens away from the shape, all the way to the horizon, so that
 * there is no edge between it and the backdrop. */
static float fade(const studio *st, vec point) {
  vec away = vec_sub(point, st->centre);
  away = vec_along(away, -vec_dot(away, st->up), st->up);
  float t = (vec_length(away) / st->radius - FADE_FROM) / (FADE_TO - FADE_FROM);
  t = fminf(fmaxf(t, 0), 1);
  return 1 + (FAR_FLOOR - 1) * t * (2 - t);
}

vec studio_floor(const studio *st, const scene *s, const hit *h, uint32_t pixel, uint32_t sample) {
  float key = studio_key(st, s, h, pixel, sample) * fmaxf(0, vec_dot(st->light, st->up));
  vec light = vec_add(vec_scale(key, st->light_colour), studio_fill(st, s, h, pixel, sample));
  return vec_scale(fade(st, h->point), vec_mul(floor_albedo, light));
}

vec studio_backdrop(const studio *st, const scene *s, vec direction) {
  if (!s->has_floor) return (vec){0, 0, 0};
  float height = fmaxf(0, vec_dot(direction, st->up));
  return vec_scale(FAR_FLOOR * (1 + 0.5f * height), st->lit_floor);
}
