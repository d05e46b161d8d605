/* SPDX-License-Identifier: Apache-2.0 */
#include "saw_end.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "image.h"
#include "samples.h"
#include "saw_face.h"

#define BARK 0.045       /* thickness over the log's radius */
#define MOST_NUMBERS 200 /* more could not be read */

/* A square of the canvas, and mm of the log to its pixel. */
typedef struct end_view {
  saw_canvas *canvas;
  const saw_work *work;
  uint32_t x, y, side;
  double pixel;
} end_view;

void saw_blend(saw_canvas *c, long x, long y, const float rgb[3], double share) {
  if (x < 0 || y < 0 || x >= (long)c->width || y >= (long)c->height || share <= 0) return;
  float *to = c->rgb + 3 * ((size_t)y * c->width + (size_t)x), k = (float)fmin(share, 1);
  for (int i = 0; i < 3; i++) to[i] += k * (rgb[i] - to[i]);
}

void saw_number(saw_canvas *c, double x, double y, uint32_t size, size_t number) {
  static const float pale[3] = {1, 0.99f, 0.95f};
  char text[24];
  int digits = snprintf(text, sizeof text, "%zu", number);
  double wide = 0.56 * size * digits, radius = 0.62 * size;
  double straight = fmax(0, 0.5 * wide - 0.35 * size);
  for (long j = (long)(y - radius - 1); j <= (long)(y + radius + 1); j++)
    for (long i = (long)(x - straight - radius - 1); i <= (long)(x + straight + radius + 1); i++) {
      double dx = fmax(0, fabs((double)i + 0.5 - x) - straight), dy = (double)j + 0.5 - y;
      saw_blend(c, i, j, pale, 0.86 * fmin(1, fmax(0, radius + 0.5 - hypot(dx, dy))));
    }
  double left = x - 0.5 * wide, base = y + 0.36 * size;
  if (left >= 0 && base < (double)c->height)
    image_text(c->rgb, c->width, c->height, (uint32_t)left, (uint32_t)base, c->width, size, text);
}

/* ---- bark ------------------------------------------------------------------- */

/* Smooth noise on a circle of n knots, 0 to 1. */
static double ring_noise(uint32_t seed, double turns, uint32_t n) {
  double at = (turns - floor(turns)) * n;
  uint32_t i = (uint32_t)at % n;
  double t = at - floor(at), s = t * t * (3 - 2 * t);
  double a = sample_hash(seed * 977u + i) / 4294967296.0;
  double b = sample_hash(seed * 977u + (i + 1) % n) / 4294967296.0;
  return a + s * (b - a);
}

/* Plates with furrows between them: how far the bark goes, over its thickness. */
static double bark_height(uint32_t seed, double turns) {
  double plate = ring_noise(seed + 1, turns, 58), rough = ring_noise(seed + 2, turns, 240);
  double furrow = fmin(1, 2.2 * fabs(plate - 0.5));
  return 0.45 + 0.42 * furrow + 0.18 * rough;
}

static void draw_bark(const end_view *v, long i, long j, double r, double turns) {
  uint32_t seed = v->work->options.seed * 16;
  double thick = BARK * v->work->lower, deep = r - v->work->lower;
  double share = fmin(1, fmax(0, deep / v->pixel + 0.5));
  double end = thick * bark_height(seed, turns),
         out = fmin(1, fmax(0, (end - deep) / v->pixel + 0.5));
  if (share <= 0 || out <= 0) return;
  /* a pale line of bast, then brown, darker outside, in fine layers */
  double t = fmin(1, fmax(0, deep / thick));
  double layer = ring_noise(seed + 3 + (uint32_t)(t * 9), turns + 0.01 * t, 320);
  double shade = (0.36 - 0.2 * t) * (0.7 + 0.6 * layer);
  const float rgb[3] = {(float)(shade * 1.05), (float)(shade * 0.78), (float)(shade * 0.6)};
  saw_blend(v->canvas, i, j, rgb, share * out);
}

/* ---- cuts ------------------------------------------------------------------- */

static void to_canvas(const end_view *v, const double point[2], double out[2]) {
  out[0] = v->x + 0.5 * v->side + point[0] / v->pixel;
  out[1] = v->y + 0.5 * v->side - point[1] / v->pixel;
}

/* What is in no board is paled by `waste`, and boards are lined. */
static void mark_board(const end_view *v, const saw_board *b, float *waste) {
  static const float ink[3] = {0.10f, 0.05f, 0.02f};
  double along[2], out[2], middle[2];
  saw_board_axes(b, along, out);
  to_canvas(v, b->centre, middle);
  double a = 0.5 * b->width / v->pixel, q = 0.5 * b->thickness / v->pixel, far = hypot(a, q) + 2;
  for (long j = (long)(middle[1] - far); j <= (long)(middle[1] + far); j++)
    for (long i = (long)(middle[0] - far); i <= (long)(middle[0] + far); i++) {
      long x = i - (long)v->x, y = j - (long)v->y;
      if (x < 0 || y < 0 || x >= (long)v->side || y >= (long)v->side) continue;
      double dx = (double)i + 0.5 - middle[0], dz = middle[1] - (double)j - 0.5;
      double u = fabs(dx * along[0] + dz * along[1]) - a, w = fabs(dx * out[0] + dz * out[1]) - q;
      double off = fmax(u, w); /* from the rectangle's edge, inside below 0 */
      float *left = waste + (size_t)y * v->side + (size_t)x;
      *left = fminf(*left, (float)fmin(1, fmax(0, off + 0.5)));
      saw_blend(v->canvas, i, j, ink, 0.75 * fmin(1, fmax(0, 1.1 - fabs(off))));
    }
}

static bool mark_boards(const end_view *v, failure *why) {
  const saw_plan *p = &v->work->plan;
  size_t n = (size_t)v->side * v->side;
  static const float pale[3] = {1, 0.95f, 0.85f};
  float *waste = malloc(n * sizeof *waste);
  if (!waste) return fail(why, EXIT_FAILURE, "out of memory");
  for (size_t i = 0; i < n; i++) waste[i] = 1;
  for (size_t i = 0; i < p->count; i++) mark_board(v, &p->boards[i], waste);
  for (uint32_t y = 0; y < v->side; y++)
    for (uint32_t x = 0; x < v->side; x++) {
      double dx = (x + 0.5 - 0.5 * v->side) * v->pixel, dz = (0.5 * v->side - y - 0.5) * v->pixel;
      size_t at = (size_t)y * v->side + x;
      double wood = fmin(1, fmax(0, (v->work->lower - hypot(dx, dz)) / v->pixel + 0.5));
      float *to = v->canvas->rgb + 3 * ((size_t)(v->y + y) * v->canvas->width + v->x + x);
      float grey = 0.3f * to[0] + 0.55f * to[1] + 0.15f * to[2];
      float dull[3];
      for (int k = 0; k < 3; k++) dull[k] = 0.34f * grey + 0.34f * to[k] + 0.02f;
      saw_blend(v->canvas, v->x + x, v->y + y, dull, wood * (double)waste[at]);
      /* the upper end */
      double off = fabs(hypot(dx, dz) - v->work->job.radius) / v->pixel;
      double dash = fmod(atan2(dz, dx) * 24 / SAW_PI + 48, 1) < 0.55 ? 0.5 : 0;
      saw_blend(v->canvas, v->x + x, v->y + y, pale,
                dash * waste[at] * fmin(1, fmax(0, 1.3 - off)));
    }
  free(waste);
  uint32_t least = v->side / 70 > 9 ? v->side / 70 : 9, most = v->side / 34;
  for (size_t i = 0; i < p->count && p->count <= MOST_NUMBERS; i++) {
    const saw_board *b = &p->boards[i];
    double at[2], fits = 0.75 * fmin(b->thickness, b->width) / v->pixel;
    to_canvas(v, b->centre, at);
    uint32_t size = fits < least ? least : fits > most ? most : (uint32_t)fits;
    saw_number(v->canvas, at[0], at[1], size, i + 1);
  }
  return true;
}

/* The knife's way; where its turns would run together, one for every few. */
static void mark_spiral(const end_view *v) {
  static const float ink[3] = {0.10f, 0.05f, 0.02f};
  const saw_job *job = &v->work->job;
  const saw_plan *p = &v->work->plan;
  double core = p->boards[p->count - 1].to, t = job->thickness;
  double lead = t * ceil(8 * v->pixel / t), turns = (job->radius - core) / lead;
  for (uint32_t y = 0; y < v->side; y++)
    for (uint32_t x = 0; x < v->side; x++) {
      double dx = (x + 0.5 - 0.5 * v->side) * v->pixel, dz = (0.5 * v->side - y - 0.5) * v->pixel;
      double r = hypot(dx, dz);
      /* the turn on which the knife comes by here is n + after */
      double after = 0.25 + job->azimuth / 360 - atan2(dz, dx) / (2 * SAW_PI);
      after -= floor(after);
      double n = round((job->radius - r) / lead - after);
      if (n < 0 || n + after > turns) continue;
      double off = fabs(r - (job->radius - (n + after) * lead)) / v->pixel;
      saw_blend(v->canvas, v->x + x, v->y + y, ink, 0.6 * fmin(1, fmax(0, 1.1 - off)));
    }
  for (size_t i = 0; p->count > 1 && i < p->count && p->count <= MOST_NUMBERS; i++) {
    double at[2];
    to_canvas(v, p->boards[i].centre, at);
    saw_number(v->canvas, at[0], at[1], v->side / 60, i + 1);
  }
}

bool saw_draw_end(saw_canvas *c, const saw_work *w, uint32_t x, uint32_t y, uint32_t side,
                  failure *why) {
  const float bast[3] = {0.62f, 0.44f, 0.28f};
  end_view v = {c, w, x, y, side, 2 * w->lower * (1 + 1.1 * BARK) / side};
  saw_face f = saw_end_face(w, side, v.pixel);
  float *rgb = malloc((size_t)side * side * 3 * sizeof *rgb);
  if (!rgb) return fail(why, EXIT_FAILURE, "out of memory");
  bool ok = saw_face_evaluate(&f, rgb, NULL, why) &&
            display_apply(&w->session->colour, &w->session->shown, rgb, (size_t)side * side, why);
  for (uint32_t j = 0; ok && j < side; j++)
    for (uint32_t i = 0; i < side; i++) {
      double dx = (i + 0.5 - 0.5 * side) * v.pixel, dz = (0.5 * side - j - 0.5) * v.pixel;
      double r = hypot(dx, dz), edge = (w->lower - r) / v.pixel;
      saw_blend(c, x + i, y + j, rgb + 3 * ((size_t)j * side + i), fmin(1, fmax(0, edge + 0.5)));
      saw_blend(c, x + i, y + j, bast, 0.8 * fmin(1, fmax(0, 1.2 - fabs(edge))));
      draw_bark(&v, x + i, y + j, r, atan2(dz, dx) / (2 * SAW_PI));
    }
  free(rgb);
  if (!ok) return false;
  if (w->job.plan == SAW_ROTARY) {
    mark_spiral(&v);
    return true;
  }
  return mark_boards(&v, why);
}
