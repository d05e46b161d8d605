/* SPDX-License-Identifier: Apache-2.0
 * The light of the studio: a key light, a soft sky, a light floor that fades
 * into the backdrop. */
#ifndef SOZAI_RENDER_STUDIO_H
#define SOZAI_RENDER_STUDIO_H

#include "render.h"
#include "scene.h"

/* Numbers of sample_pair each camera sample uses: see samples.h. */
#define PAIR_PIXEL 0
#define PAIR_LIGHT 1
#define PAIR_SKY 2
#define SKY_RAYS 2

typedef struct studio {
  vec light, light_s, light_t; /* towards the key light, and a frame about it */
  vec light_colour;
  float light_spread; /* tangent of half its size */
  float sky;
  vec up, centre;
  float radius;  /* of the shape */
  vec lit_floor; /* the floor's radiance where nothing shades it */
} studio;

void studio_init(studio *st, const render_job *job, const scene *s);

/* How much of the key light reaches a point: one sample of it, 0 or 1. */
float studio_key(const studio *st, const scene *s, const hit *h, uint32_t pixel, uint32_t sample);
/* Mean radiance from everywhere but the key light, over the cosine about the
 * normal: what a white matt surface shows. One sample of it. */
vec studio_fill(const studio *st, const scene *s, const hit *h, uint32_t pixel, uint32_t sample);
/* What a mirror shows in a direction: the sky, or the floor below it. */
vec studio_mirrored(const studio *st, const scene *s, vec direction);
/* What the camera sees of the floor, and where there is neither floor nor shape. */
vec studio_floor(const studio *st, const scene *s, const hit *h, uint32_t pixel, uint32_t sample);
vec studio_backdrop(const studio *st, const scene *s, vec direction);

#endif
