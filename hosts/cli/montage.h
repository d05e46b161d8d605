/* SPDX-License-Identifier: Apache-2.0
 * A material's plane placed in a given picture by four points, in perspective. */
#ifndef SOZAI_CLI_MONTAGE_H
#define SOZAI_CLI_MONTAGE_H

#include <stdint.h>
#include "failure.h"
#include "sozai.h"

typedef struct montage {
  /* Where the rectangle's corners are in the picture, in pixels from the top
   * left: of (0, 0), (length, 0), (length, width) and (0, width) of the plane. */
  double corner[4][2];
  double length, width; /* mm, along x and y of the plane z = 0 */
  double light[3], light_colour[3];
  double view[3]; /* towards the eye */
  double sky[3];  /* what a white matt plane shows of the sky */
} montage;

/* What was measured on the way. */
typedef struct montage_report {
  double corner_error;     /* mm: of the corners through the map and back */
  double footprint[2];     /* mm, least and greatest */
  uint32_t pixels;         /* that show the plane */
  double albedo[3], joint; /* means over them */
} montage_report;

/* Paints over rgb, scene-linear, width x height, three floats to a pixel. */
bool montage_paint(const montage *m, const sozai_textures_1 *textures, const sozai_texture *texture,
                   float *rgb, uint32_t width, uint32_t height, montage_report *report,
                   failure *why);

#endif
