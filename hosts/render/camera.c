/* SPDX-License-Identifier: Apache-2.0 */
#include "camera.h"

#include <math.h>

#define DEGREE (3.14159265358979323846 / 180)
#define LONGER_SIDE 1024
/* How much of the picture the shape may take. */
#define FILL 0.80f
#define FILL_SPHERE 0.54f /* with room for its shadow */

vec camera_direction(double azimuth, double elevation, bool y_up) {
  double a = azimuth * DEGREE, e = elevation * DEGREE;
  double along = cos(e) * cos(a), across = cos(e) * sin(a), height = sin(e);
  /* Turning the world so that +y is up takes +y to -z. */
  return y_up ? vec_of(along, height, -across) : vec_of(along, across, height);
}

static bool is_face(const render_job *job) {
  return job->camera == CAMERA_FRONT && (job->shape == SHAPE_PLANE || job->shape == SHAPE_BOARD);
}

void camera_resolution(const render_job *job, const scene *s, uint32_t *width, uint32_t *height) {
  *width = job->width;
  *height = job->height;
  if (*width && *height) return;
  *width = LONGER_SIDE;
  *height = LONGER_SIDE * 3 / 4;
  if (!is_face(job)) return;
  vec size = vec_sub(s->high, s->low);
  float ratio = size.y / size.x;
  float w = ratio > 1 ? LONGER_SIDE / ratio : LONGER_SIDE;
  float h = ratio > 1 ? LONGER_SIDE : LONGER_SIDE * ratio;
  *width = w < 1 ? 1 : (uint32_t)lroundf(w);
  *height = h < 1 ? 1 : (uint32_t)lroundf(h);
}

/* Points around the shape that must be in the picture: what a cube's corners,
 * edges and faces are to its middle, on the bounding box; on a sphere, itself. */
#define OUTLINE 26

static void outline(const render_job *job, const scene *s, vec *points) {
  vec middle = scene_centre(s), half = vec_scale(0.5f, vec_sub(s->high, s->low));
  for (int i = 0, count = 0; i < 27; i++) {
    vec p = {(float)(i % 3 - 1), (float)(i / 3 % 3 - 1), (float)(i / 9 - 1)};
    if (i == 13) continue; /* the middle */
    if (job->shape == SHAPE_SPHERE) p = vec_unit(p);
    points[count++] = vec_add(middle, vec_mul(half, p));
  }
}

static void look_along(camera *c, vec forward, vec up) {
  c->forward = forward;
  c->right = vec_unit(vec_cross(forward, up));
  c->up = vec_cross(c->right, forward);
}

static void place_front(camera *c, const render_job *job, const scene *s, float aspect) {
  c->parallel = true;
  look_along(c, (vec){0, 0, -1}, (vec){0, 1, 0});
  vec size = vec_sub(s->high, s->low);
  /* A face fills the picture; what does not fit its proportions is cut off.
   * Anything else is shown whole. */
  float by_width = size.x / aspect, by_height = size.y;
  float height = is_face(job) ? fminf(by_width, by_height) : fmaxf(by_width, by_height) / FILL;
  c->half_height = 0.5f * height / (float)job->zoom;
  vec middle = scene_centre(s);
  if (job->has_target) middle = vec_of(job->target[0], job->target[1], job->target[2]);
  c->eye = (vec){middle.x, middle.y, s->high.z + scene_radius(s)};
}

/* Draw the eye back until every point is within the frame, then
 * move it sideways to centre them; a few rounds settle both. */
static vec frame(const camera *c, const vec *points, vec target, float limit_x, float limit_y) {
  vec eye = target;
  for (int round = 0; round < 12; round++) {
    float back = 0;
    for (int i = 0; i < OUTLINE; i++) {
      vec p = vec_sub(points[i], target);
      float depth = vec_dot(p, c->forward);
      back = fmaxf(back, fabsf(vec_dot(p, c->right)) / limit_x - depth);
      back = fmaxf(back, fabsf(vec_dot(p, c->up)) / limit_y - depth);
    }
    eye = vec_along(target, -back, c->forward);
    float left = INFINITY, right = -INFINITY, bottom = INFINITY, top = -INFINITY;
    for (int i = 0; i < OUTLINE; i++) {
      vec p = vec_sub(points[i], eye);
      float depth = vec_dot(p, c->forward);
      left = fminf(left, vec_dot(p, c->right) / depth);
      right = fmaxf(right, vec_dot(p, c->right) / depth);
      bottom = fminf(bottom, vec_dot(p, c->up) / depth);
      top = fmaxf(top, vec_dot(p, c->up) / depth);
    }
    target = vec_along(target, back * (left + right) / 2, c->right);
    target = vec_along(target, back * (bottom + top) / 2, c->up);
  }
  return eye;
}

static void place_view(camera *c, const render_job *job, const scene *s, float aspect) {
  c->parallel = false;
  vec towards = camera_direction(job->camera_azimuth, job->camera_elevation, job->y_up);
  bool overhead = fabs(job->camera_elevation) > 89.9;
  vec up = overhead ? camera_direction(job->camera_azimuth + 180, 0, job->y_up) : s->up;
  look_along(c, vec_scale(-1, towards), up);
  float longer = tanf((float)(job->camera_angle * DEGREE / 2));
  float half_width = aspect > 1 ? longer : longer * aspect;
  vec middle = scene_centre(s);
  vec points[OUTLINE];
  outline(job, s, points);
  float fill = job->shape == SHAPE_SPHERE ? FILL_SPHERE : FILL;
  c->eye = frame(c, points, middle, fill * half_width, fill * half_width / aspect);
  if (job->has_target) {
    vec to = vec_of(job->target[0], job->target[1], job->target[2]);
    c->eye = vec_along(to, -vec_dot(vec_sub(middle, c->eye), c->forward), c->forward);
  }
  c->half_height = half_width / aspect / (float)job->zoom;
}

void camera_place(camera *c, const render_job *job, const scene *s, uint32_t width,
                  uint32_t height) {
  float aspect = (float)width / (float)height;
  if (job->camera == CAMERA_FRONT)
    place_front(c, job, s, aspect);
  else
    place_view(c, job, s, aspect);
  c->half_width = c->half_height * aspect;
  c->pixel = 2 * c->half_height / (float)height;
}

void camera_ray(const camera *c, float x, float y, uint32_t width, uint32_t height, vec *origin,
                vec *direction) {
  float u = (2 * x / (float)width - 1) * c->half_width;
  float v = (1 - 2 * y / (float)height) * c->half_height;
  vec offset = vec_add(vec_scale(u, c->right), vec_scale(v, c->up));
  *origin = c->parallel ? vec_add(c->eye, offset) : c->eye;
  *direction = c->parallel ? c->forward : vec_unit(vec_add(c->forward, offset));
}
