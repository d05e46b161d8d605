/* SPDX-License-Identifier: Apache-2.0
 *
 * log.png: to the left the log's lower end with its cuts, to the right the
 * boards' faces, all at one scale, with the numbers of their files. */
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "image.h"
#include "progress.h"
#include "saw.h"
#include "saw_end.h"
#include "saw_face.h"

#define PIECES 24 /* of one long sheet, at most */

/* A face, or a piece of a sheet, and where it stands. */
typedef struct tile {
  size_t board;
  double from, length; /* mm along it */
  double across;       /* mm */
  uint32_t x, y, width, height;
} tile;

typedef struct layout {
  tile *tiles;
  size_t count;
  uint32_t left, top, width, height; /* of the room for them */
  uint32_t gutter, gap, letters;     /* pixels: for the number; between tiles; of the text */
  double pixel;                      /* mm */
} layout;

/* ---- where the faces stand -------------------------------------------------- */

static bool list_tiles(layout *l, const saw_work *w, failure *why) {
  l->tiles = calloc(w->plan.count * PIECES, sizeof *l->tiles);
  if (!l->tiles) return fail(why, EXIT_FAILURE, "out of memory");
  for (size_t i = 0; i < w->plan.count; i++) {
    const saw_board *b = &w->plan.boards[i];
    bool sheet = b->plan == SAW_ROTARY;
    double length = sheet ? b->width : w->log.length, across = sheet ? w->log.length : b->width;
    double room = (double)l->height / l->width;
    double pieces = w->plan.count > 1 ? 1 : floor(sqrt(length / across * room));
    pieces = fmin(fmax(pieces, 1), PIECES);
    for (int k = 0; k < (int)pieces; k++)
      l->tiles[l->count++] = (tile){
          .board = i, .from = length * k / pieces, .length = length / pieces, .across = across};
  }
  return true;
}

/* In rows from the left; false: they do not fit at that scale. */
static bool place_tiles(layout *l, double pixel) {
  uint32_t x = 0, y = 0, row = 0;
  for (size_t i = 0; i < l->count; i++) {
    tile *t = &l->tiles[i];
    t->width = (uint32_t)fmax(1, floor(t->length / pixel + 0.5));
    t->height = (uint32_t)fmax(1, floor(t->across / pixel + 0.5));
    uint32_t wide = l->gutter + t->width, high = t->height;
    if (high < l->letters + 2) high = l->letters + 2;
    if (x > 0 && x + wide > l->width) {
      y += row + l->gap;
      x = row = 0;
    }
    if (x + wide > l->width || y + high > l->height) return false;
    t->x = l->left + x + l->gutter;
    t->y = l->top + y;
    x += wide + l->gap;
    if (high > row) row = high;
  }
  l->pixel = pixel;
  return true;
}

static bool find_scale(layout *l, failure *why) {
  double small = 1e-3, large = 1e5; /* mm to a pixel: too few, and enough */
  if (!place_tiles(l, large))
    return fail(why, EXIT_BAD_INPUT, "--res: the picture is too small for %zu faces", l->count);
  for (int i = 0; i < 48; i++) {
    double middle = sqrt(small * large);
    *(place_tiles(l, middle) ? &large : &small) = middle;
  }
  return place_tiles(l, large);
}

/* ---- drawing ------------------------------------------------------------------ */

static bool draw_tile(saw_canvas *c, const saw_work *w, const layout *l, const tile *t,
                      failure *why) {
  const saw_board *b = &w->plan.boards[t->board];
  saw_face f = saw_board_face(w, b, t->from, t->length, l->pixel);
  size_t n = (size_t)f.width * f.height;
  float *rgb = malloc(3 * n * sizeof *rgb);
  if (!rgb) return fail(why, EXIT_FAILURE, "out of memory");
  bool ok = saw_face_evaluate(&f, rgb, NULL, why) &&
            display_apply(&w->session->colour, &w->session->shown, rgb, n, why);
  for (uint32_t y = 0; ok && y < f.height; y++)
    for (uint32_t x = 0; x < f.width; x++)
      saw_blend(c, t->x + x, t->y + y, rgb + 3 * ((size_t)y * f.width + x), 1);
  free(rgb);
  return ok;
}

static void write_beside(saw_canvas *c, const saw_work *w, const layout *l, const tile *t) {
  char text[48];
  uint32_t small = l->letters * 7 / 10, x = t->x - l->gutter + 4;
  uint32_t middle = t->y + t->height / 2;
  if (t->from > 0) return;
  bool two = t->height >= l->letters + small + 6 && l->gutter > 5 * small;
  uint32_t base = two ? middle - 1 : middle + l->letters * 2 / 5;
  if (base < t->y + l->letters - 2) base = t->y + l->letters - 2;
  snprintf(text, sizeof text, "%zu", t->board + 1);
  image_text(c->rgb, c->width, c->height, x, base, t->x, l->letters, text);
  if (!two) return;
  uint32_t knots = w->crossing[t->board];
  snprintf(text, sizeof text, "%u knot%s", knots, knots == 1 ? "" : "s");
  image_text(c->rgb, c->width, c->height, x, base + small + 4, t->x, small, text);
}

static void write_title(saw_canvas *c, const saw_work *w, uint32_t letters) {
  const saw_options *o = &w->options;
  char text[256];
  static const char *const sawn[SAW_PLANS] = {"Live-sawn", "Quarter-sawn", "Rift-sawn",
                                              "Rotary-cut"};
  bool sheet = w->job.plan == SAW_ROTARY;
  size_t n = w->plan.count;
  snprintf(text, sizeof text,
           "%s, %g years. Log of %g mm, %.0f to %.0f mm across. %s: %zu %s%s, %.0f %% of it",
           o->species, o->age, w->log.length, 2 * w->lower, 2 * w->job.radius, sawn[w->job.plan], n,
           sheet ? "sheet" : "board", n == 1 ? "" : "s", w->yield);
  image_text(c->rgb, c->width, c->height, letters, 2 * letters, c->width, letters, text);
}

/* 100 mm, or what is a twentieth to a half of the log. */
static void draw_scale(saw_canvas *c, double pixel, uint32_t x, uint32_t y, uint32_t letters) {
  static const float ink[3] = {0.1f, 0.1f, 0.1f};
  char text[32];
  double length = 100;
  while (length / pixel > c->width / 5.0) length /= 10;
  uint32_t end = x + (uint32_t)(length / pixel);
  for (uint32_t i = x; i <= end; i++)
    for (uint32_t k = 0; k < (i == x || i == end ? 9 : 2); k++)
      saw_blend(c, i, (long)y - (long)k, ink, 1);
  snprintf(text, sizeof text, "%g mm", length);
  image_text(c->rgb, c->width, c->height, end + letters / 2, y, c->width, letters, text);
}

static bool draw(saw_canvas *c, const saw_work *w, layout *l, failure *why) {
  uint32_t letters = c->height / 48 > 10 ? c->height / 48 : 10, margin = letters;
  uint32_t top = 3 * letters, side = c->height - top - 3 * letters;
  if (side > c->width / 2) side = c->width / 2;
  l->letters = letters;
  l->gap = letters / 2;
  l->gutter = (w->plan.count > 24 ? 2 : 4) * letters;
  l->left = side + 2 * margin;
  l->top = top;
  l->width = c->width - l->left - margin;
  l->height = c->height - top - margin;
  if (!list_tiles(l, w, why) || !find_scale(l, why)) return false;
  write_title(c, w, letters);
  if (!saw_draw_end(c, w, margin, top, side, why)) return false;
  draw_scale(c, 2 * w->lower * (1 + 1.1 * 0.045) / side, margin, c->height - margin, letters);
  for (size_t i = 0; i < l->count; i++) {
    if (!draw_tile(c, w, l, &l->tiles[i], why)) return false;
    write_beside(c, w, l, &l->tiles[i]);
    progress_show(0.5f + 0.5f * (float)(i + 1) / (float)l->count, "drawing");
  }
  return true;
}

static bool write_png(const saw_canvas *c, const saw_work *w, const char *path, failure *why) {
  static const char *const names[3] = {"R", "G", "B"};
  image_channel channels[3];
  for (int i = 0; i < 3; i++) channels[i] = (image_channel){names[i], c->rgb + i, 3, IMAGE_UINT8};
  const image_colour space = {.srgb = display_is_srgb(&w->session->colour, &w->session->shown)};
  return image_write(path, c->width, c->height, channels, 3, &space, why);
}

bool saw_write_picture(const saw_work *w, const saw_folder *f, failure *why) {
  char path[FOLDER_PATH];
  if (!saw_folder_file(f, "log.png", path, why)) return false;
  saw_canvas c = {.width = w->options.size[0], .height = w->options.size[1]};
  layout l = {0};
  size_t n = 3 * (size_t)c.width * c.height;
  c.rgb = malloc(n * sizeof *c.rgb);
  if (!c.rgb) return fail(why, EXIT_FAILURE, "out of memory");
  for (size_t i = 0; i < n; i++) c.rgb[i] = 1;
  bool ok = draw(&c, w, &l, why) && write_png(&c, w, path, why);
  free(l.tiles);
  free(c.rgb);
  return ok;
}
