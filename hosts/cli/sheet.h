/* SPDX-License-Identifier: Apache-2.0
 * Many pictures of one size, small, side by side in one. */
#ifndef SOZAI_CLI_SHEET_H
#define SOZAI_CLI_SHEET_H

#include "film.h"

typedef struct sheet {
  uint32_t width, height; /* of a small picture */
  uint32_t count;
  float *pictures; /* r g b, one picture after another */
} sheet;

/* Half its size. Pictures of another size than the first's are refused. */
bool sheet_add(sheet *s, const film *f, failure *why);
/* Lay them out; out holds a beauty and no layers. */
bool sheet_finish(const sheet *s, uint32_t columns, film *out, failure *why);
void sheet_free(sheet *s);

#endif
