/* SPDX-License-Identifier: Apache-2.0 */
#include "photo.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "appearance.h"
#include "image.h"
#include "linear.h"

#define BINS 4096
#define LOG_LEAST (-16.0) /* of the histogram: 1e-7 */
#define LOG_MOST 4.0
#define BLACK 0.002f /* a black border, in JPEG as well */
#define DARKEST 0.02 /* of the median: no wood beside other wood is darker */
#define GREY 0.004f  /* an 8-bit step: differences of channels below it are no colour */

static double brightness(const float *rgb) {
  return ((double)rgb[0] + (double)rgb[1] + (double)rgb[2]) / 3;
}

/* ---- the file ---------------------------------------------------------------- */

static bool check_size(const char *path, uint32_t width, uint32_t height, uint32_t channels,
                       const photo_options *o, failure *why) {
  if ((uint64_t)width * height > PHOTO_MOST_PIXELS)
    return fail(why, EXIT_BAD_INPUT, "%s: %ux%u pixels are more than %u; make it smaller", path,
                width, height, PHOTO_MOST_PIXELS);
  if (channels != 3 && channels != 4)
    return fail(why, EXIT_BAD_INPUT, "%s: has %u channel%s, not three of colour", path, channels,
                channels == 1 ? "" : "s");
  const uint32_t *crop = o->crop;
  if (crop && ((uint64_t)crop[0] + crop[2] > width || (uint64_t)crop[1] + crop[3] > height))
    return fail(why, EXIT_BAD_INPUT, "--crop: %u,%u,%u,%u is not within %s, of %ux%u pixels",
                crop[0], crop[1], crop[2], crop[3], path, width, height);
  uint64_t pixels = crop ? (uint64_t)crop[2] * crop[3] : (uint64_t)width * height;
  if (pixels >= PHOTO_LEAST_PIXELS) return true;
  return fail(why, EXIT_BAD_INPUT, "%s: %llu pixel%s; a palette takes at least %u", path,
              (unsigned long long)pixels, pixels == 1 ? " is too few" : "s are too few",
              PHOTO_LEAST_PIXELS);
}

/* The part asked for and its three channels, moved to the front in place. */
static bool take_part(photo *p, image *picture, const photo_options *o, failure *why) {
  uint32_t x0 = o->crop ? o->crop[0] : 0, y0 = o->crop ? o->crop[1] : 0;
  p->width = o->crop ? o->crop[2] : picture->width;
  p->height = o->crop ? o->crop[3] : picture->height;
  size_t pixels = (size_t)p->width * p->height;
  p->pixel = malloc(pixels);
  if (!p->pixel) return fail(why, EXIT_FAILURE, "out of memory");
  for (uint32_t y = 0; y < p->height; y++)
    for (uint32_t x = 0; x < p->width; x++) {
      const float *from =
          picture->data + ((size_t)(y0 + y) * picture->width + x0 + x) * picture->channels;
      size_t i = (size_t)y * p->width + x;
      p->pixel[i] = picture->channels < 4 || from[3] > 0.5f ? PIXEL_PART : PIXEL_OUT;
      for (int k = 0; k < 3; k++) p->rgb[3 * i + (size_t)k] = from[k];
    }
  return true;
}

static bool check_numbers(const photo *p, const char *path, bool integers, double *clipped,
                          failure *why) {
  size_t pixels = (size_t)p->width * p->height, bad = 0, coloured = 0, kept = 0, full = 0;
  const float *first = NULL;
  bool differs = false;
  for (size_t i = 0; i < pixels; i++) {
    const float *c = p->rgb + 3 * i;
    if (!isfinite(c[0]) || !isfinite(c[1]) || !isfinite(c[2])) bad++;
    if (p->pixel[i] == PIXEL_OUT) continue;
    kept++;
    if (!first) first = c;
    float spread = fmaxf(fabsf(c[0] - c[1]), fabsf(c[1] - c[2]));
    float scale = integers ? 1 : fmaxf(fabsf(c[1]), 1e-3f);
    coloured += spread > GREY * scale;
    full += integers && fmaxf(c[0], fmaxf(c[1], c[2])) >= 0.998f;
    for (int k = 0; k < 3; k++) differs = differs || fabsf(c[k] - first[k]) > 0.002f;
  }
  *clipped = kept ? (double)full / (double)kept : 0;
  if (bad) return fail(why, EXIT_BAD_INPUT, "%s: %zu pixels are not finite numbers", path, bad);
  if (kept < PHOTO_LEAST_PIXELS)
    return fail(why, EXIT_BAD_INPUT, "%s: only %zu pixels are not transparent", path, kept);
  if (!differs)
    return fail(why, EXIT_BAD_INPUT, "%s: is of one colour all over: no covariance to match", path);
  if (coloured * 100 < kept)
    return fail(why, EXIT_BAD_INPUT, "%s: is grey: no colour to match", path);
  return true;
}

static bool decode(photo *p, const char *path, const photo_options *o, bool integers,
                   const colour *c, failure *why) {
  p->space = o->space ? o->space : integers ? "sRGB" : NULL;
  if (!p->space) {
    p->space = c->service ? c->service->working_space(c->service->self) : "Linear Rec.709";
    return true;
  }
  failure reason = {0};
  size_t pixels = (size_t)p->width * p->height;
  if (!appearance_to_working(c, p->space, p->rgb, pixels, &reason))
    return fail(why, reason.exit_code, "%s '%s' of %s: %s", o->space ? "--space:" : "the space",
                p->space, path, reason.text);
  for (size_t i = 0; i < 3 * pixels; i++)
    if (!isfinite(p->rgb[i]))
      return fail(why, EXIT_BAD_INPUT, "%s: not finite once taken from %s", path, p->space);
  return true;
}

/* ---- borders and highlights ----------------------------------------------------- */

static double quantile(const uint64_t *bins, uint64_t count, double share) {
  uint64_t wanted = (uint64_t)(share * (double)count), sum = 0;
  int i = 0;
  while (i < BINS - 1 && (sum += bins[i]) <= wanted) i++;
  return LOG_LEAST + (LOG_MOST - LOG_LEAST) * (i + 0.5) / BINS;
}

/* Fences in the logarithm of brightness. Above: twice as far from the median as
 * the 98th percentile, which no tail of a material reaches, and a highlight
 * does. Below: what no wood is beside the median. */
static void leave_out(photo *p) {
  uint64_t bins[BINS] = {0}, count = 0, dark = 0, bright = 0, all = 0;
  size_t pixels = (size_t)p->width * p->height;
  for (size_t i = 0; i < pixels; i++) {
    if (p->pixel[i] == PIXEL_OUT) continue;
    all++;
    const float *c = p->rgb + 3 * i;
    if (c[0] <= BLACK && c[1] <= BLACK && c[2] <= BLACK) {
      p->pixel[i] = PIXEL_OUT;
      dark++;
      continue;
    }
    double at = (log(fmax(brightness(c), 1e-9)) - LOG_LEAST) / (LOG_MOST - LOG_LEAST) * BINS;
    bins[at < 0 ? 0 : at >= BINS ? BINS - 1 : (int)at]++;
    count++;
  }
  double middle = quantile(bins, count, 0.5), high = quantile(bins, count, 0.98);
  double most = exp(fmax(2 * high - middle, middle + 0.05)), least = DARKEST * exp(middle);
  for (size_t i = 0; i < pixels; i++) {
    if (p->pixel[i] == PIXEL_OUT) continue;
    double b = brightness(p->rgb + 3 * i);
    if (b >= least && b <= most) continue;
    p->pixel[i] = PIXEL_OUT;
    b < least ? dark++ : bright++;
  }
  p->dark = all ? (double)dark / (double)all : 0;
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

static bool read_from(photo *p, image *picture, const char *path, const photo_options *o,
                      bool integers, const colour *c, failure *why) {
  p->rgb = picture->data;
  p->full_width = picture->width;
  if (!take_part(p, picture, o, why)) return false;
  double clipped;
  if (!check_numbers(p, path, integers, &clipped, why)) return false;
  if (!decode(p, path, o, integers, c, why)) return false;
  p->clipped = clipped;
  leave_out(p);
  if (o->even_light) even_light(p);
  if (p->dark + p->bright < 0.9) return true;
  return fail(why, EXIT_BAD_INPUT, "%s: %.0f %% of it is black; see --crop", path,
              100 * (p->dark + p->bright));
}

bool photo_read(photo *p, const char *path, const photo_options *o, const colour *c, failure *why) {
  memset(p, 0, sizeof *p);
  p->light_low = p->light_high = 1;
  uint32_t width, height, channels;
  bool integers;
  image picture;
  if (!image_probe(path, &width, &height, &channels, &integers, why) ||
      !check_size(path, width, height, channels, o, why) || !image_read(&picture, path, why))
    return false;
  bool ok = read_from(p, &picture, path, o, integers, c, why);
  picture.data = NULL; /* the photograph's now */
  image_free(&picture);
  if (!ok) photo_free(p);
  return ok;
}

void photo_free(photo *p) {
  free(p->rgb);
  free(p->pixel);
  memset(p, 0, sizeof *p);
}
