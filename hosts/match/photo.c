/* SPDX-License-Identifier: Apache-2.0 */
#include "photo.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "linear.h"
#include "photo_pixels.h"

#define BINS 4096
#define LOG_LEAST (-16.0) /* of the histogram: 1e-7 */
#define LOG_MOST 4.0
#define BLACK 0.002f /* a black border, in JPEG as well */
#define DARKEST 0.02 /* of the median: no wood beside other wood is darker */

/* What photo.pixel holds between whiles. */
#define PIXEL_DARK 3
#define PIXEL_BORDER 4

static double brightness(const float *rgb) {
  return ((double)rgb[0] + (double)rgb[1] + (double)rgb[2]) / 3;
}

/* ---- borders and highlights ----------------------------------------------------- */

static double quantile(const uint64_t *bins, uint64_t count, double share) {
  uint64_t wanted = (uint64_t)(share * (double)count), sum = 0;
  int i = 0;
  while (i < BINS - 1 && (sum += bins[i]) <= wanted) i++;
  return LOG_LEAST + (LOG_MOST - LOG_LEAST) * (i + 0.5) / BINS;
}

/* Row by row, forth or back: what is dark beside a border is border. */
static bool spread_border(photo *p, bool back) {
  const size_t w = p->width, pixels = w * p->height;
  bool any = false;
  for (size_t n = 0; n < pixels; n++) {
    size_t i = back ? pixels - 1 - n : n, x = i % w;
    if (p->pixel[i] != PIXEL_DARK) continue;
    bool edge = x == 0 || x == w - 1 || i < w || i >= pixels - w;
    if (!edge && p->pixel[i - 1] != PIXEL_BORDER && p->pixel[i + 1] != PIXEL_BORDER &&
        p->pixel[i - w] != PIXEL_BORDER && p->pixel[i + w] != PIXEL_BORDER)
      continue;
    p->pixel[i] = PIXEL_BORDER;
    any = true;
  }
  return any;
}

/* Of what is dark a border is left out; specks, which do not reach the
 * picture's edge, are the material's. */
static double leave_out_dark(photo *p, bool specks) {
  uint64_t dark = 0, all = 0;
  size_t pixels = (size_t)p->width * p->height;
  for (bool back = false; specks && spread_border(p, back);) back = !back;
  for (size_t i = 0; i < pixels; i++) {
    all += p->pixel[i] != PIXEL_OUT;
    if (p->pixel[i] == PIXEL_DARK && specks) p->pixel[i] = PIXEL_PART;
    if (p->pixel[i] != PIXEL_DARK && p->pixel[i] != PIXEL_BORDER) continue;
    p->pixel[i] = PIXEL_OUT;
    dark++;
  }
  return all ? (double)dark / (double)all : 0;
}

/* Fences in the logarithm of brightness. Above: twice as far from the median as
 * the 98th percentile, which no tail of a material reaches, and a highlight
 * does. Below: what no wood is beside the median. */
static void leave_out(photo *p, bool specks) {
  uint64_t bins[BINS] = {0}, count = 0, bright = 0, all = 0;
  size_t pixels = (size_t)p->width * p->height;
  for (size_t i = 0; i < pixels; i++) {
    if (p->pixel[i] == PIXEL_OUT) continue;
    all++;
    const float *c = p->rgb + 3 * i;
    if (c[0] <= BLACK && c[1] <= BLACK && c[2] <= BLACK) {
      p->pixel[i] = PIXEL_DARK;
      continue;
    }
    double at = (log(fmax(brightness(c), 1e-9)) - LOG_LEAST) / (LOG_MOST - LOG_LEAST) * BINS;
    bins[at < 0 ? 0 : at >= BINS ? BINS - 1 : (int)at]++;
    count++;
  }
  double middle = quantile(bins, count, 0.5), high = quantile(bins, count, 0.98);
  double most = exp(fmax(2 * high - middle, middle + 0.05)), least = DARKEST * exp(middle);
  for (size_t i = 0; i < pixels; i++) {
    double b = brightness(p->rgb + 3 * i);
    if (p->pixel[i] != PIXEL_OUT && b < least) p->pixel[i] = PIXEL_DARK;
  }
  p->dark = leave_out_dark(p, specks);
  for (size_t i = 0; i < pixels; i++) {
    if (p->pixel[i] == PIXEL_OUT || brightness(p->rgb + 3 * i) <= most) continue;
    p->pixel[i] = PIXEL_OUT;
    bright++;
  }
  p->bright = all ? (double)bright / (double)all : 0;
}

/* ---- even light --------------------------------------------------------------------- */

#define TERMS 6

static void terms_at(const photo *p, uint32_t x, uint32_t y, double t[TERMS]) {
  double u = 2 * (x + 0.5) / p->width - 1, v = 2 * (y + 0.5) / p->height - 1;
  const double all[TERMS] = {1, u, v, u * u - 1 / 3.0, u * v, v * v - 1 / 3.0};
  memcpy(t, all, sizeof all);
}

/* A parabola in x and y through the logarithm of brightness, by least squares:
 * what a lamp to one side or a lens's fall-off leaves, and no ring. */
static void even_light(photo *p) {
  double a[TERMS * TERMS] = {0}, b[TERMS] = {0}, t[TERMS];
  for (uint32_t y = 0; y < p->height; y++)
    for (uint32_t x = 0; x < p->width; x++) {
      size_t i = (size_t)y * p->width + x;
      if (p->pixel[i] == PIXEL_OUT) continue;
      terms_at(p, x, y, t);
      double l = log(fmax(brightness(p->rgb + 3 * i), 1e-9));
      for (int r = 0; r < TERMS; r++) {
        b[r] += t[r] * l;
        for (int c = 0; c < TERMS; c++) a[r * TERMS + c] += t[r] * t[c];
      }
    }
  for (int r = 0; r < TERMS; r++) a[r * TERMS + r] *= 1 + 1e-9;
  if (!solve_positive(a, b, TERMS)) return;
  p->light_low = INFINITY;
  p->light_high = 0;
  for (uint32_t y = 0; y < p->height; y++)
    for (uint32_t x = 0; x < p->width; x++) {
      terms_at(p, x, y, t);
      double l = 0;
      for (int r = 1; r < TERMS; r++) l += b[r] * t[r];
      double light = exp(l);
      p->light_low = fmin(p->light_low, light);
      p->light_high = fmax(p->light_high, light);
      float *c = p->rgb + 3 * ((size_t)y * p->width + x);
      for (int k = 0; k < 3; k++) c[k] = (float)((double)c[k] / light);
    }
}

/* ---- all of it ------------------------------------------------------------------------ */

bool photo_read(photo *p, const char *path, const photo_options *o, const colour *c, failure *why) {
  memset(p, 0, sizeof *p);
  p->light_low = p->light_high = 1;
  bool ok = photo_pixels(p, path, o, c, why);
  if (ok) {
    leave_out(p, o->specks);
    if (o->even_light) even_light(p);
    if (p->dark + p->bright > 0.9)
      ok = fail(why, EXIT_BAD_INPUT,
                "%s: %.0f %% of it is black, %.0f %% far brighter than the rest; see --crop", path,
                100 * p->dark, 100 * p->bright);
  }
  if (!ok) photo_free(p);
  return ok;
}

void photo_free(photo *p) {
  free(p->rgb);
  free(p->pixel);
  memset(p, 0, sizeof *p);
}
