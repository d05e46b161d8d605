/* SPDX-License-Identifier: Apache-2.0
 * A flat face of a material, evaluated on a grid of pixels: what the figures
 * are drawn and measured from. */
#ifndef SOZAI_CLI_FACE_H
#define SOZAI_CLI_FACE_H

#include <stddef.h>
#include <stdint.h>
#include "failure.h"
#include "session.h"

/* Which rectangle of object space, mm, and under which light. */
typedef struct face_view {
  double centre[3];
  double right[3], up[3]; /* unit vectors in the face; its normal is right x up */
  double light[3];        /* towards the light */
  uint32_t width, height; /* pixels */
  double pixel;           /* mm */
} face_view;

typedef struct face {
  face_view view;
  const sozai_texture_info *info;
  float **components; /* component_count of them, of width * height, top row first */
} face;

/* Make the texture that the material, preset (or NULL) and parameters ("a=b", ended by NULL)
 * name, and evaluate every channel over the view, each pixel its own footprint. */
bool face_evaluate(face *f, session *s, const char *material, const char *preset,
                   const char *const *parameters, const face_view *view, failure *why);
void face_free(face *f);

/* The first component of a channel; a channel that is missing is a failure. */
const float *face_channel(const face *f, const char *id, failure *why);

#endif
