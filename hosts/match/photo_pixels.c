/* SPDX-License-Identifier: Apache-2.0 */
#include "photo_pixels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "appearance.h"
#include "image.h"
#include "photo_rule.h"
#include "ceilings.h"

#define GREY 0.02f /* of a pixel's brightness: differences of channels below it are no colour */
#define FULL 0.998f

/* ---- as it is ------------------------------------------------------------------ */

static bool check_size(const char *path, uint32_t width, uint32_t height, uint32_t channels,
                       failure *why) {
  char what[sizeof why->text];
  snprintf(what, sizeof what, "%s: %ux%u pixels", path, width, height);
  if (!limits_check(HOST_LIMIT_PHOTO_PIXELS, (uint64_t)width * height, what, why)) return false;
  return channels == 3 || channels == 4 ||
         fail(why, EXIT_BAD_INPUT, "%s: has %u channel%s, not three of colour", path, channels,
              channels == 1 ? "" : "s");
}

static bool check_numbers(photo *p, const image *picture, const char *path, bool integers,
                          failure *why) {
  size_t pixels = (size_t)picture->width * picture->height, bad = 0, full = 0;
  for (size_t i = 0; i < pixels; i++) {
    const float *c = picture->data + i * picture->channels;
    bad += !isfinite(c[0]) || !isfinite(c[1]) || !isfinite(c[2]);
    full += integers && fmaxf(c[0], fmaxf(c[1], c[2])) >= FULL;
  }
  p->clipped = (double)full / (double)pixels;
  return bad == 0 || fail(why, EXIT_BAD_INPUT, "%s: %zu pixels are not finite numbers", path, bad);
}

/* ---- in the working space --------------------------------------------------------- */

static bool begin_part(photo *p, uint32_t width, uint32_t height, const uint32_t *crop,
                       const char *path, failure *why) {
  if (crop && ((uint64_t)crop[0] + crop[2] > width || (uint64_t)crop[1] + crop[3] > height))
    return fail(why, EXIT_BAD_INPUT, "--crop: %u,%u,%u,%u is not within %s, of %ux%u pixels",
                crop[0], crop[1], crop[2], crop[3], path, width, height);
  p->full_width = width;
  p->width = crop ? crop[2] : width;
  p->height = crop ? crop[3] : height;
  uint64_t pixels = (uint64_t)p->width * p->height;
  if (pixels < PHOTO_LEAST_PIXELS)
    return fail(why, EXIT_BAD_INPUT, "%s: %llu pixel%s; a palette takes at least %u", path,
                (unsigned long long)pixels, pixels == 1 ? " is too few" : "s are too few",
                PHOTO_LEAST_PIXELS);
  p->rgb = malloc(3 * pixels * sizeof *p->rgb);
  p->pixel = malloc(pixels);
  return (p->rgb && p->pixel) || fail(why, EXIT_FAILURE, "out of memory");
}

static void keep(photo *p, size_t i, const float rgb[3], float alpha) {
  memcpy(p->rgb + 3 * i, rgb, 3 * sizeof *rgb);
  p->pixel[i] = alpha > 0.5f ? PIXEL_PART : PIXEL_OUT;
}

static bool convert(photo *p, const image *picture, const photo_options *o, const colour *c,
                    const char *path, failure *why) {
  if (!begin_part(p, picture->width, picture->height, o->crop, path, why)) return false;
  uint32_t x0 = o->crop ? o->crop[0] : 0, y0 = o->crop ? o->crop[1] : 0;
  for (uint32_t y = 0; y < p->height; y++)
    for (uint32_t x = 0; x < p->width; x++) {
      const float *from =
          picture->data + ((size_t)(y0 + y) * picture->width + x0 + x) * picture->channels;
      keep(p, (size_t)y * p->width + x, from, picture->channels < 4 ? 1 : from[3]);
    }
  failure reason = {0};
  if (appearance_to_working(c, p->space, p->rgb, (size_t)p->width * p->height, &reason))
    return true;
  return fail(why, reason.exit_code, "%s%s", o->space ? "--space: " : "", reason.text);
}

/* ---- is there anything to match? ------------------------------------------------------ */

static bool check_colours(const photo *p, const char *path, failure *why) {
  size_t pixels = (size_t)p->width * p->height, coloured = 0, kept = 0;
  const float *first = NULL;
  bool differs = false;
  for (size_t i = 0; i < pixels; i++) {
    const float *c = p->rgb + 3 * i;
    if (!isfinite(c[0]) || !isfinite(c[1]) || !isfinite(c[2]))
      return fail(why, EXIT_BAD_INPUT, "%s: not finite in the working space", path);
    if (p->pixel[i] == PIXEL_OUT) continue;
    kept++;
    if (!first) first = c;
    float high = fmaxf(c[0], fmaxf(c[1], c[2])), low = fminf(c[0], fminf(c[1], c[2]));
    coloured += high - low > GREY * fmaxf(high, 0.01f);
    for (int k = 0; k < 3; k++) differs = differs || fabsf(c[k] - first[k]) > 0.002f;
  }
  if (kept < PHOTO_LEAST_PIXELS)
    return fail(why, EXIT_BAD_INPUT, "%s: only %zu pixels are not transparent", path, kept);
  if (!differs)
    return fail(why, EXIT_BAD_INPUT, "%s: is of one colour all over: no covariance to match", path);
  return coloured * 100 >= kept ||
         fail(why, EXIT_BAD_INPUT, "%s: is grey: no colour to match", path);
}

bool photo_pixels(photo *p, const char *path, const photo_options *o, const colour *c,
                  failure *why) {
  uint32_t width, height, channels;
  bool integers;
  image picture;
  if (!image_probe(path, &width, &height, &channels, &integers, why) ||
      !check_size(path, width, height, channels, why) || !image_read(&picture, path, why))
    return false;
  p->space = o->space ? o->space : photo_rule(path, integers, c);
  bool ok =
      check_numbers(p, &picture, path, integers, why) && convert(p, &picture, o, c, path, why);
  image_free(&picture);
  return ok && check_colours(p, path, why);
}
