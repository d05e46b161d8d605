/* SPDX-License-Identifier: Apache-2.0 */
#include "job_options.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "numbers.h"

#define SPHERE_DIAMETER 80

static void set_mesh(render_job *job, const char *path) {
  job->shape = SHAPE_MESH;
  job->mesh = path;
  job->y_up = true; /* as most files have it */
}

static bool read_shape(render_job *job, const char *text, failure *why) {
  static const char *const names[] = {"board", "sphere", "plane"};
  for (int i = 0; i < 3; i++)
    if (strcmp(text, names[i]) == 0) {
      job->shape = i;
      return true;
    }
  if (!strchr(text, '.'))
    return fail(why, EXIT_BAD_INPUT, "--shape: '%s' is not board, sphere, plane or a mesh's file",
                text);
  set_mesh(job, text);
  return true;
}

static bool read_dimensions(render_job *job, const char *text, failure *why) {
  static const size_t wanted[] = {3, 1, 2}; /* by shape */
  static const char *const forms[] = {"WxHxT", "D", "WxH"};
  if (job->shape == SHAPE_MESH)
    return fail(why, EXIT_BAD_INPUT, "--size: a mesh has its own; see --scale");
  double size[3];
  size_t count = numbers_read(text, 'x', size, 3);
  bool ok = count == wanted[job->shape] || (job->shape == SHAPE_PLANE && count == 3);
  for (size_t i = 0; ok && i < count; i++) ok = size[i] >= 0.01 && size[i] <= 1e5;
  if (!ok)
    return fail(why, EXIT_BAD_INPUT, "--size: '%s' is not %s in mm, each from 0.01 to 100000", text,
                forms[job->shape]);
  memcpy(job->size, size, count * sizeof *size);
  return true;
}

/* A .sozai file's surface, if it names one. */
static void take_surface(render_job *job, const recipe_surface *surface) {
  if (surface->shape == RECIPE_PLANE) job->shape = SHAPE_PLANE;
  if (surface->shape == RECIPE_MESH) set_mesh(job, surface->mesh);
  for (int k = 0; k < 3; k++)
    if (surface->size[k] > 0) job->size[k] = surface->size[k];
}

static bool read_camera(render_job *job, const char *text, failure *why) {
  if (strcmp(text, "front") == 0) {
    job->camera = CAMERA_FRONT;
    return true;
  }
  double numbers[3];
  size_t count = numbers_read(text, ',', numbers, 3);
  if (count < 2 || fabs(numbers[0]) > 720 || fabs(numbers[1]) > 90 ||
      (count == 3 && !(numbers[2] >= 1 && numbers[2] <= 120)))
    return fail(why, EXIT_BAD_INPUT,
                "--camera: '%s' is neither front nor AZ,EL or AZ,EL,ANGLE (degrees; EL from -90 to "
                "90, ANGLE from 1 to 120)",
                text);
  job->camera_azimuth = numbers[0];
  job->camera_elevation = numbers[1];
  if (count == 3) job->camera_angle = numbers[2];
  return true;
}

static bool read_target(render_job *job, const char *text, failure *why) {
  bool ok = numbers_read(text, ',', job->target, 3) == 3;
  for (int i = 0; ok && i < 3; i++) ok = fabs(job->target[i]) <= 1e6;
  if (!ok)
    return fail(why, EXIT_BAD_INPUT,
                "--target: '%s' is not X,Y,Z in mm, each from -1000000 to 1000000", text);
  job->has_target = true;
  return true;
}

static bool read_light(render_job *job, const char *text, failure *why) {
  double numbers[2];
  if (numbers_read(text, ',', numbers, 2) != 2 || fabs(numbers[0]) > 720 || fabs(numbers[1]) > 90)
    return fail(why, EXIT_BAD_INPUT, "--light: '%s' is not AZ,EL in degrees, EL from -90 to 90",
                text);
  job->light_azimuth = numbers[0];
  job->light_elevation = numbers[1];
  return true;
}

static bool read_up(render_job *job, const char *text, failure *why) {
  if (strcmp(text, "y") != 0 && strcmp(text, "z") != 0)
    return fail(why, EXIT_BAD_INPUT, "--up: '%s' is neither y nor z", text);
  job->y_up = *text == 'y';
  return true;
}

bool job_options_apply(render_job *job, const job_options *o, const recipe_surface *surface,
                       failure *why) {
  if (o->shape && !read_shape(job, o->shape, why)) return false;
  if (!o->shape && surface) take_surface(job, surface);
  if (job->shape == SHAPE_SPHERE) job->size[0] = SPHERE_DIAMETER;
  return (!o->size || read_dimensions(job, o->size, why)) &&
         (!o->camera || read_camera(job, o->camera, why)) &&
         (!o->target || read_target(job, o->target, why)) &&
         (!o->light || read_light(job, o->light, why)) && (!o->up || read_up(job, o->up, why));
}
