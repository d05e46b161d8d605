/* SPDX-License-Identifier: Apache-2.0
 * What views of trees and of fibre share: rays through every pixel of a film,
 * the colours of parts, the file. */
#ifndef SOZAI_CLI_VIEW_H
#define SOZAI_CLI_VIEW_H

#include "camera.h"
#include "film.h"
#include "render.h"
#include "session.h"

#define VIEW_PARTS 8 /* at most; those past them look like the last */

/* A ray, and what stands for its place in the picture's sampling. */
typedef struct view_ray {
  vec origin, direction;
  uint32_t seed, sample; /* the pixel's, and which of its samples */
} view_ray;

typedef struct view_picture {
  const render_job *job;
  const camera *camera;
  film *film;
  /* The light that comes back along the ray; *hit: it met what was grown. */
  vec (*look)(const void *context, const view_ray *ray, bool *hit);
  const void *context;
} view_picture;

/* All of the film, by the job's threads. */
bool view_draw(const view_picture *p, failure *why);

/* Parts' colours, which are sRGB, in the working space: at most VIEW_PARTS. */
bool view_colours(const sozai_part *parts, uint32_t count, const session *s, vec *out,
                  failure *why);

/* Colours that are sRGB, r g b each, in the working space, in place; whose: for a message. */
bool view_working(float *rgb, uint64_t count, const char *whose, const session *s, failure *why);

/* By the path's ending: .png through the display, .exr. */
bool view_write(const film *f, const session *s, const char *path, failure *why);

#endif
