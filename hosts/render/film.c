/* SPDX-License-Identifier: Apache-2.0 */
#include "film.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "image.h"
#include "ceilings.h"

#define NAME_SIZE 80

bool film_allocate(film *f, uint32_t width, uint32_t height, const sozai_texture_info *info,
                   const uint32_t *channels, uint32_t channel_count, failure *why) {
  memset(f, 0, sizeof *f);
  f->width = width;
  f->height = height;
  for (uint32_t i = 0; i < channel_count; i++)
    f->components += info->channels[channels[i]]->components;
  size_t pixels = (size_t)width * height;
  if (!limits_check(HOST_LIMIT_VIEW_BYTES, pixels * sizeof(float) * (4ull + f->components),
                    "the picture", why))
    return false;
  f->beauty = calloc(3 * pixels, sizeof(float));
  f->coverage = calloc(pixels, sizeof(float));
  f->layers = calloc(pixels * f->components + 1, sizeof(float));
  f->channel_of = calloc(f->components + 1, sizeof *f->channel_of);
  f->component_of = calloc(f->components + 1, sizeof *f->component_of);
  if (!f->beauty || !f->coverage || !f->layers || !f->channel_of || !f->component_of) {
    film_free(f);
    return fail(why, EXIT_FAILURE, "out of memory for %ux%u pixels of %u components", width, height,
                f->components);
  }
  uint32_t at = 0;
  for (uint32_t i = 0; i < channel_count; i++)
    for (uint32_t k = 0; k < info->channels[channels[i]]->components; k++, at++) {
      f->channel_of[at] = info->channels[channels[i]];
      f->component_of[at] = k;
    }
  return true;
}

void film_free(film *f) {
  free(f->beauty);
  free(f->coverage);
  free(f->layers);
  free(f->channel_of);
  free(f->component_of);
  memset(f, 0, sizeof *f);
}

static bool is_colour(const sozai_channel *c) { return strcmp(c->suffixes, "rgb") == 0; }

/* Colours' suffixes are upper case in EXR files, vectors' lower. */
static void layer_name(char *name, const sozai_channel *c, uint32_t component) {
  int suffix = (unsigned char)c->suffixes[c->components > 1 ? component : 0];
  if (is_colour(c)) suffix = toupper(suffix);
  if (c->components == 1)
    snprintf(name, NAME_SIZE, "%s", c->id);
  else
    snprintf(name, NAME_SIZE, "%s.%c", c->id, suffix);
}

bool film_write_exr(const film *f, const char *path, const colour *c, failure *why) {
  uint32_t count = 4 + f->components;
  image_channel *channels = calloc(count, sizeof *channels);
  char(*names)[NAME_SIZE] = calloc(f->components + 1, NAME_SIZE);
  if (!channels || !names) {
    free(channels);
    free(names);
    return fail(why, EXIT_FAILURE, "out of memory");
  }
  static const char *const rgb[3] = {"R", "G", "B"};
  for (uint32_t k = 0; k < 3; k++)
    channels[k] = (image_channel){rgb[k], f->beauty + k, 3, IMAGE_HALF};
  channels[3] = (image_channel){"coverage", f->coverage, 1, IMAGE_HALF};
  for (uint32_t i = 0; i < f->components; i++) {
    layer_name(names[i], f->channel_of[i], f->component_of[i]);
    channels[4 + i] = (image_channel){names[i], f->layers + i, f->components,
                                      is_colour(f->channel_of[i]) ? IMAGE_HALF : IMAGE_FLOAT};
  }
  float xy[8];
  image_colour space = {0};
  if (display_working(c, &space.space, xy)) space.chromaticities = xy;
  bool ok = image_write(path, f->width, f->height, channels, count, &space, why);
  free(channels);
  free(names);
  return ok;
}

bool film_write_png(const film *f, const char *path, const colour *c, const display_choice *choice,
                    double exposure, uint32_t bits, failure *why) {
  size_t pixels = (size_t)f->width * f->height;
  float *shown = malloc(3 * pixels * sizeof *shown);
  if (!shown) return fail(why, EXIT_FAILURE, "out of memory");
  float gain = exp2f((float)exposure);
  for (size_t i = 0; i < 3 * pixels; i++) shown[i] = gain * f->beauty[i];
  bool ok = display_apply(c, choice, shown, pixels, why);
  if (ok) {
    int type = bits == 16 ? IMAGE_UINT16 : IMAGE_UINT8;
    image_channel channels[3] = {
        {"R", shown, 3, type}, {"G", shown + 1, 3, type}, {"B", shown + 2, 3, type}};
    image_colour space = {.srgb = display_is_srgb(c, choice)};
    ok = image_write(path, f->width, f->height, channels, 3, &space, why);
  }
  free(shown);
  return ok;
}
