/* SPDX-License-Identifier: Apache-2.0 */
#include "plate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "image.h"
#include "output_file.h"

#define GAP 8 /* pixels of white between panels */

static size_t row_length(const plate *p) {
  return (size_t)p->panels * (p->panel_width + GAP) - GAP;
}

bool plate_init(plate *p, uint32_t panels, uint32_t width, uint32_t height, failure *why) {
  *p = (plate){.panel_width = width, .panel_height = height, .panels = panels, .srgb = true};
  size_t n = 3 * row_length(p) * height;
  p->rgb = malloc(n * sizeof *p->rgb);
  for (size_t i = 0; p->rgb && i < n; i++) p->rgb[i] = 1.0f;
  return p->rgb || fail(why, EXIT_FAILURE, "out of memory");
}

void plate_free(plate *p) {
  free(p->rgb);
  p->rgb = NULL;
}

static float *pixel_of(plate *p, uint32_t panel, uint32_t x, uint32_t y) {
  return p->rgb + 3 * (y * row_length(p) + (size_t)panel * (p->panel_width + GAP) + x);
}

void plate_ink(plate *p, uint32_t i, const float *share) {
  for (uint32_t y = 0; y < p->panel_height; y++) {
    for (uint32_t x = 0; x < p->panel_width; x++) {
      float *to = pixel_of(p, i, x, y);
      /* coverage is linear in light */
      float grey = powf(1.0f - share[(size_t)y * p->panel_width + x], 1.0f / 2.2f);
      to[0] = to[1] = to[2] = grey;
    }
  }
}

bool plate_colour(plate *p, uint32_t i, float *const *rgb, const session *s, failure *why) {
  p->srgb = display_is_srgb(&s->colour, &s->shown);
  for (uint32_t y = 0; y < p->panel_height; y++) {
    for (uint32_t x = 0; x < p->panel_width; x++) {
      for (int c = 0; c < 3; c++) pixel_of(p, i, x, y)[c] = rgb[c][(size_t)y * p->panel_width + x];
    }
    if (!display_apply(&s->colour, &s->shown, pixel_of(p, i, 0, y), p->panel_width, why))
      return false;
  }
  return true;
}

bool plate_write(const plate *p, const char *folder, const char *name, failure *why) {
  char path[4096];
  output_file o;
  int n = snprintf(path, sizeof path, "%s/%s.png", folder, name);
  if (n < 0 || (size_t)n >= sizeof path)
    return fail(why, EXIT_BAD_INPUT, "'%s' is too long a path", folder);
  if (!output_begin(&o, path, why)) return false;
  image_channel channels[3];
  static const char *const names[3] = {"R", "G", "B"};
  for (int c = 0; c < 3; c++) channels[c] = (image_channel){names[c], p->rgb + c, 3, IMAGE_UINT8};
  const image_colour space = {.srgb = p->srgb};
  if (image_write(o.writing, (uint32_t)row_length(p), p->panel_height, channels, 3, &space, why))
    return output_commit(&o, why);
  return output_failed(&o, why);
}

double plate_direction(const float *share, uint32_t width, uint32_t height) {
  double xx = 0, xy = 0, yy = 0;
  for (uint32_t y = 1; y + 1 < height; y++) {
    for (uint32_t x = 1; x + 1 < width; x++) {
      const float *at = share + (size_t)y * width + x;
      double gx = (double)at[1] - (double)at[-1];
      double gy = (double)at[-(ptrdiff_t)width] - (double)at[width]; /* up is positive */
      xx += gx * gx;
      xy += gx * gy;
      yy += gy * gy;
    }
  }
  /* the gradient's main axis, and the lines square to it */
  double axis = 0.5 * atan2(2 * xy, xx - yy);
  return -axis * 180 / 3.14159265358979323846;
}
