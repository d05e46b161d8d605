/* SPDX-License-Identifier: Apache-2.0 */
#include "sheet.h"

#include "image.h"

#include <stdlib.h>
#include <string.h>

#define GAP 4       /* pixels between pictures */
#define GROUND 0.9f /* what shows in it */
#define LETTER 11   /* pixels: a caption's size */
#define CAPTION 15  /* and the room under a picture for it */

static size_t picture_floats(const sheet *s) { return (size_t)3 * s->width * s->height; }

/* The mean of the four pixels that make one of the small picture. */
static float mean_of_four(const film *f, uint32_t x, uint32_t y, uint32_t k) {
  const float *p = f->beauty + 3 * ((size_t)2 * y * f->width + 2 * x) + k;
  size_t row = (size_t)3 * f->width;
  return 0.25f * (p[0] + p[3] + p[row] + p[row + 3]);
}

bool sheet_shrink(sheet_picture *out, const film *f, failure *why) {
  *out = (sheet_picture){.width = f->width / 2, .height = f->height / 2};
  float *to = out->rgb = malloc((size_t)3 * out->width * out->height * sizeof *to);
  if (!to) return fail(why, EXIT_FAILURE, "out of memory");
  for (uint32_t y = 0; y < out->height; y++)
    for (uint32_t x = 0; x < out->width; x++)
      for (uint32_t k = 0; k < 3; k++) *to++ = mean_of_four(f, x, y, k);
  return true;
}

void sheet_picture_free(sheet_picture *p) {
  free(p->rgb);
  *p = (sheet_picture){0};
}

static void keep_name(char to[SHEET_NAME], const char *name) {
  size_t length = strcspn(name, "(");
  if (length >= SHEET_NAME) length = SHEET_NAME - 1;
  while (length && (name[length - 1] == ' ' || (name[length] & 0xC0) == 0x80)) length--;
  memcpy(to, name, length);
  to[length] = 0;
}

bool sheet_add(sheet *s, const sheet_picture *p, const char *name, failure *why) {
  if (s->count == 0) {
    s->width = p->width;
    s->height = p->height;
  }
  if (p->width != s->width || p->height != s->height)
    return fail(why, EXIT_FAILURE, "pictures of different sizes on one sheet");
  float *more = realloc(s->pictures, (s->count + 1) * picture_floats(s) * sizeof *more);
  if (!more) return fail(why, EXIT_FAILURE, "out of memory");
  s->pictures = more;
  char(*names)[SHEET_NAME] = realloc(s->names, (s->count + 1) * sizeof *names);
  if (!names) return fail(why, EXIT_FAILURE, "out of memory");
  s->names = names;
  keep_name(names[s->count], name);
  memcpy(more + s->count++ * picture_floats(s), p->rgb, picture_floats(s) * sizeof *more);
  return true;
}

/* As many neighbours of one row as have the first's name. */
static uint32_t run_of(const sheet *s, uint32_t first, uint32_t columns) {
  uint32_t n = 1;
  while (first + n < s->count && (first + n) % columns &&
         !strcmp(s->names[first], s->names[first + n]))
    n++;
  return n;
}

static void write_names(const sheet *s, uint32_t columns, film *out) {
  for (uint32_t i = 0; i < s->count; i += run_of(s, i, columns)) {
    uint32_t width = run_of(s, i, columns) * (s->width + GAP) - GAP;
    uint32_t x = (i % columns) * (s->width + GAP);
    uint32_t y = (i / columns + 1) * (s->height + CAPTION + GAP) - GAP;
    image_text(out->beauty, out->width, out->height, x, y - 4, x + width, LETTER, s->names[i]);
  }
}

bool sheet_finish(const sheet *s, uint32_t columns, film *out, failure *why) {
  if (s->count == 0) return fail(why, EXIT_FAILURE, "there is no preset to show");
  if (columns > s->count) columns = s->count;
  uint32_t rows = (s->count + columns - 1) / columns, caption = image_has_text() ? CAPTION : 0;
  uint32_t pitch = s->height + caption + GAP;
  uint32_t width = columns * (s->width + GAP) - GAP, height = rows * pitch - GAP;
  if (!film_allocate(out, width, height, NULL, NULL, 0, why)) return false;
  for (size_t i = 0; i < (size_t)3 * width * height; i++) out->beauty[i] = GROUND;
  for (uint32_t i = 0; i < s->count; i++)
    for (uint32_t y = 0; y < s->height; y++) {
      size_t row = (size_t)(i / columns) * pitch + y;
      size_t column = (size_t)(i % columns) * (s->width + GAP);
      memcpy(out->beauty + 3 * (row * width + column),
             s->pictures + i * picture_floats(s) + (size_t)3 * y * s->width,
             3 * s->width * sizeof(float));
    }
  if (caption) write_names(s, columns, out);
  return true;
}

void sheet_free(sheet *s) {
  free(s->pictures);
  free(s->names);
  memset(s, 0, sizeof *s);
}
