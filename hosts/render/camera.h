/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_RENDER_CAMERA_H
#define SOZAI_RENDER_CAMERA_H

#include "render.h"
#include "scene.h"

typedef struct camera {
  bool parallel;
  vec eye;                       /* parallel: the middle of the picture plane */
  vec right, up, forward;        /* unit */
  float half_width, half_height; /* of the picture plane, one unit ahead; parallel: mm */
  float pixel;                   /* side of a pixel there: an angle; parallel: mm */
} camera;

/* A unit vector from azimuth and elevation in degrees: from +x about `up`. */
vec camera_direction(double azimuth, double elevation, bool y_up);

/* Pictures of faces take the face's proportions when the job gives none. */
void camera_resolution(const render_job *job, const scene *s, uint32_t *width, uint32_t *height);
void camera_place(camera *c, const render_job *job, const scene *s, uint32_t width,
                  uint32_t height);
/* x, y: in pixels from the top left. */
void camera_ray(const camera *c, float x, float y, uint32_t width, uint32_t height, vec *origin,
                vec *direction);

#endif
