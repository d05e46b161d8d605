/* SPDX-License-Identifier: Apache-2.0
 *
 * A small renderer to look at materials with: one shape on a studio floor, one
 * directional light with a slightly soft shadow, a soft sky. No bounces. All
 * lengths in mm, in the texture's object space. */
#ifndef SOZAI_RENDER_H
#define SOZAI_RENDER_H

#include <stdbool.h>
#include <stdint.h>
#include "failure.h"
#include "film.h"
#include "sozai.h"
#include "ceilings.h"

#define SHAPE_BOARD 0  /* +y along its length, +z its face's normal, centred */
#define SHAPE_SPHERE 1 /* of diameter size[0], centred */
#define SHAPE_PLANE 2  /* the face alone, at z = 0 */
#define SHAPE_MESH 3   /* a file's */
#define SHAPE_GIVEN 4  /* one in memory */

#define CAMERA_VIEW 0  /* pinhole, from camera_azimuth and camera_elevation */
#define CAMERA_FRONT 1 /* parallel rays, straight at the face: -z, with +y up */

typedef struct render_job {
  const sozai_textures_1 *textures;
  const sozai_texture *texture;

  int shape;          /* SHAPE_* */
  double size[3];     /* board: width, length, thickness; sphere: diameter; plane: width, length */
  double bevel;       /* board: radius of its rounded edges */
  const char *mesh;   /* mesh: path */
  double mesh_scale;  /* mesh: mm per unit of the file */
  struct mesh *given; /* given: the render takes its memory over */
  bool y_up;          /* +y points up from the floor instead of +z */

  uint32_t width, height; /* pixels; 0: by the shape and camera */
  uint32_t spp;           /* samples per pixel */
  uint32_t threads;

  int camera;                              /* CAMERA_* */
  double camera_azimuth, camera_elevation; /* degrees; azimuth from +x towards the next axis */
  double camera_angle;                     /* degrees, over the picture's longer side */
  double zoom;                             /* 1: the whole shape */
  bool has_target;
  double target[3]; /* the point in the picture's middle, if has_target */

  double light_azimuth, light_elevation; /* degrees, like the camera's */
  double light_colour[3];                /* irradiance of a face turned to it, over pi */
  double light_size;                     /* degrees across: how soft the shadow is */
  double sky;                            /* 1: as the studio has it; 0: none */
  bool floor;                            /* a floor to stand on, and a backdrop */

  /* Which channels to keep as layers, as indices; albedo and radiance are
   * evaluated in any case. */
  uint32_t channels[RENDER_MOST_CHANNELS];
  uint32_t channel_count;

  bool quiet; /* no progress bar */
} render_job;

/* A board of 120 x 240 x 20 mm as the studio shows it. */
void render_job_init(render_job *job, const sozai_textures_1 *textures,
                     const sozai_texture *texture);

/* Fills film, which film_free frees. Stops when cancel_requested(). The same
 * job gives the same bits whatever the number of threads. */
bool render(const render_job *job, film *out, failure *why);

#endif
