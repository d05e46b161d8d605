/* SPDX-License-Identifier: Apache-2.0
 * A figure's picture: panels of one size side by side, and its file with the
 * JSON of measured numbers beside it. */
#ifndef SOZAI_CLI_PLATE_H
#define SOZAI_CLI_PLATE_H

#include <stdint.h>
#include "face.h"
#include "json.h"

typedef struct plate {
  uint32_t panel_width, panel_height, panels;
  float *rgb; /* display's 0 to 1 */
  bool srgb;  /* which is an sRGB display */
} plate;

bool plate_init(plate *p, uint32_t panels, uint32_t width, uint32_t height, failure *why);
void plate_free(plate *p);

/* Panel i: black where `share` is 1, white where it is 0. */
void plate_ink(plate *p, uint32_t i, const float *share);
/* Panel i: scene-linear colour from three arrays, through the display. */
bool plate_colour(plate *p, uint32_t i, float *const *rgb, const session *s, failure *why);

/* Writes folder/name.png. */
bool plate_write(const plate *p, const char *folder, const char *name, failure *why);

/* How the picture's lines run: the direction in which it changes least, from
 * the structure tensor over the whole of `share`; degrees from upright, to the
 * right positive. */
double plate_direction(const float *share, uint32_t width, uint32_t height);

#endif
