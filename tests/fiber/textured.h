/* SPDX-License-Identifier: Apache-2.0
 * The texture of fibre on level ground, for what is compared with curves. */
#ifndef SOZAI_TESTS_TEXTURED_H
#define SOZAI_TESTS_TEXTURED_H

#include "sozai.h"

/* Components, as describe lists them. */
enum { ALBEDO = 0, RADIANCE = 3, COVERAGE = 6, DEPTH = 11, COMPONENTS = 17 };

/* Points of the plane z = 0, mm, that faces +z; views and lights, where it is lit. */
typedef struct {
  uint32_t count;
  float *at[2], *view[3], *light[3];
  int lit;
  float *out[COMPONENTS];
} ground;

const sozai_textures_1 *textures_of(void);
/* Within 400 mm; the points are drawn by the caller's numbers. */
ground ground_of(uint32_t count, int lit);
void ground_free(ground *g);
/* All components, under one footprint. */
void ground_ask(ground *g, const sozai_textures_1 *textures, const sozai_texture *t,
                double footprint);
double ground_mean(const ground *g, int component);

/* 0 to 1, the same in every run. */
double random_of(uint32_t *state);
/* A linear value in sRGB's code. */
double encoded(double linear);

#endif
