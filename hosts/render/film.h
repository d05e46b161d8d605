/* SPDX-License-Identifier: Apache-2.0
 * A rendered picture: the beauty, and what the material said, in layers. */
#ifndef SOZAI_RENDER_FILM_H
#define SOZAI_RENDER_FILM_H

#include <stdbool.h>
#include <stdint.h>
#include "colour.h"
#include "display.h"
#include "failure.h"
#include "sozai.h"

typedef struct film {
  uint32_t width, height;
  float *beauty;   /* r g b each, working space */
  float *coverage; /* how much of the pixel the shape takes */
  /* What the material answered, averaged over the part of the pixel that the
   * shape takes; 0 where that is none. components numbers to a pixel. */
  float *layers;
  uint32_t components;
  /* component i: channel, and which of its components */
  const sozai_channel **channel_of;
  uint32_t *component_of;
} film;

bool film_allocate(film *f, uint32_t width, uint32_t height, const sozai_texture_info *info,
                   const uint32_t *channels, uint32_t channel_count, failure *why);
void film_free(film *f);

/* R G B, coverage, then every component by its channel: albedo.R, fiber.x, dive.
 * Colours in half, the rest in float. The file says its space: see image_colour. */
bool film_write_exr(const film *f, const char *path, const colour *c, failure *why);

/* The beauty through the display transform. bits: 8 or 16. exposure: stops. */
bool film_write_png(const film *f, const char *path, const colour *c, const display_choice *choice,
                    double exposure, uint32_t bits, failure *why);

#endif
