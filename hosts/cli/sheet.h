/* SPDX-License-Identifier: Apache-2.0
 * Many pictures of one size, small and with their names, side by side in one. */
#ifndef SOZAI_CLI_SHEET_H
#define SOZAI_CLI_SHEET_H

#include "film.h"

#define SHEET_NAME 64

/* A picture at half its size. */
typedef struct sheet_picture {
  uint32_t width, height;
  float *rgb;
} sheet_picture;

bool sheet_shrink(sheet_picture *out, const film *f, failure *why);
void sheet_picture_free(sheet_picture *p);

typedef struct sheet {
  uint32_t width, height; /* of a small picture */
  uint32_t count;
  float *pictures; /* r g b, one picture after another */
  char (*names)[SHEET_NAME];
} sheet;

/* Pictures of another size than the first's are refused. A name ends at its first bracket;
 * neighbours of one name share one caption. */
bool sheet_add(sheet *s, const sheet_picture *p, const char *name, failure *why);
/* Lay them out, with captions where there is a font to write them in; out holds a beauty and no
 * layers. */
bool sheet_finish(const sheet *s, uint32_t columns, film *out, failure *why);
void sheet_free(sheet *s);

#endif
