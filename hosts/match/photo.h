/* SPDX-License-Identifier: Apache-2.0
 * A photograph of a material: its colours in the working space, and which of
 * its pixels to go by. */
#ifndef SOZAI_MATCH_PHOTO_H
#define SOZAI_MATCH_PHOTO_H

#include <stdint.h>
#include "colour.h"

#define PHOTO_LEAST_PIXELS 1024u /* fewer say nothing of a covariance */

/* What photo.pixel holds. */
#define PIXEL_OUT 0    /* a border, a highlight, transparent, or between two parts */
#define PIXEL_PART 1   /* the material, or the first of its two parts */
#define PIXEL_SECOND 2 /* the second */

typedef struct photo_options {
  const char *space;    /* of its numbers; NULL: by the config's file rules */
  const uint32_t *crop; /* x, y from the top left, width, height; NULL: all of it */
  bool specks;          /* what is near black and no border is of the material */
  bool even_light;      /* divide out what light varies slowly over it */
} photo_options;

typedef struct photo {
  uint32_t width, height;
  uint32_t full_width; /* before it was cropped */
  float *rgb;          /* working space */
  uint8_t *pixel;
  const char *space;            /* that its numbers were read in */
  double dark, bright;          /* shares left out as borders and as highlights */
  double clipped;               /* share of kept pixels at the top of an integer's range */
  double light_low, light_high; /* what was divided out, over its mean; 1 and 1: nothing */
} photo;

bool photo_read(photo *p, const char *path, const photo_options *o, const colour *c, failure *why);
void photo_free(photo *p);

#endif
