/* SPDX-License-Identifier: Apache-2.0 */
#include "sheet.h"

#include <stdlib.h>
#include <string.h>

#define GAP 4       /* pixels between pictures */
#define GROUND 0.9f /* what shows in it */

static size_t picture_floats(const sheet *s) { return (size_t)3 * s->width * s->height; }

/* The mean of the four pixels that make one of the small picture. */
static float mean_of_four(const film *f, uint32_t x, uint32_t y, uint32_t k) {
  const float *p = f->beauty + 3 * ((size_t)2 * y * f->width + 2 * x) + k;
  size_t row = (size_t)3 * f->width;
  return 0.25f * (p[0] + p[3] + p[row] + p[row + 3]);
}

bool sheet_add(sheet *s, const film *f, failure *why) {
  if (s->count == 0) {
    s->width = f->width / 2;
    s->height = f->height / 2;
  }
  if (f->width / 2 != s->width || f->height / 2 != s->height)
    return fail(why, EXIT_FAILURE, "pictures of different sizes on one sheet");
  float *more = realloc(s->pictures, (s->count + 1) * picture_floats(s) * sizeof *more);
  if (!more) return fail(why, EXIT_FAILURE, "out of memory");
  s->pictures = more;
  float *to = s->pictures + s->count++ * picture_floats(s);
  for (uint32_t y = 0; y < s->height; y++)
    for (uint32_t x = 0; x < s->width; x++)
      for (uint32_t k = 0; k < 3; k++) *to++ = mean_of_four(f, x, y, k);
  return true;
}

bool sheet_finish(const sheet *s, uint32_t columns, film *out, failure *why) {
  if (s->count == 0) return fail(why, EXIT_FAILURE, "there is no preset to show");
  if (columns > s->count) columns = s->count;
  uint32_t rows = (s->count + columns - 1) / columns;
  uint32_t width = columns * (s->width + GAP) - GAP, height = rows * (s->height + GAP) - GAP;
  if (!film_allocate(out, width, height, NULL, NULL, 0, why)) return false;
  for (size_t i = 0; i < (size_t)3 * width * height; i++) out->beauty[i] = GROUND;
  for (uint32_t i = 0; i < s->count; i++)
    for (uint32_t y = 0; y < s->height; y++) {
      size_t row = (size_t)(i / columns) * (s->height + GAP) + y;
      size_t column = (size_t)(i % columns) * (s->width + GAP);
      memcpy(out->beauty + 3 * (row * width + column),
             s->pictures + i * picture_floats(s) + (size_t)3 * y * s->width,
             3 * s->width * sizeof(float));
    }
  return true;
}

void sheet_free(sheet *s) {
  free(s->pictures);
  memset(s, 0, sizeof *s);
}
