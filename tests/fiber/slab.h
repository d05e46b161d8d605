/* SPDX-License-Identifier: Apache-2.0
 * A slab of grown strands without end, and the light that rays bring from it: they are
 * followed through Embree with the renderer's lobes, until nothing is left. */
#ifndef SOZAI_TESTS_SLAB_H
#define SOZAI_TESTS_SLAB_H

#include "fiber.h"

#include "fiber_lobe.h"
#include "strands.h"

#define PI 3.14159265358979
enum { LIGHTS = 7, VIEWS = 2 };

/* Degrees: elevation, and azimuth from where the view leans to; elevation. */
extern const double lights[LIGHTS][2], views[VIEWS];
/* Three colours of strands, in bulk: white, wool, dark. They are followed as one. */
extern const float colours[3];

typedef struct {
  const char *name, *preset; /* of the texture: its strand's light */
  double diameter, length;   /* um, mm */
  double side, thick;        /* mm */
  double packing;
  double squeeze;                      /* of heights: 1 every direction alike */
  float roughness, round, tilt, index; /* as the catalogue has them */
  uint32_t rays;
  /* what is allowed, of each colour: of the mean of all views and lights; of each beyond
   * chance; and of one footprint from the mean of five */
  double mean[3], each[3], apart;
} aggregate;

typedef struct {
  const aggregate *of;
  strands s;
  fiber_lobe lobe;
  double packing, rise;
  float *points, *radii;
  uint64_t *first;
} slab;

/* Under light of irradiance pi: means over the rays, and of the squares. */
typedef struct {
  double sum[LIGHTS][3], square[LIGHTS][3];
  double square_of_all[3]; /* of what all lights give one ray */
} seen;

vec aim(double elevation, double azimuth);
void grow_slab(slab *b, const aggregate *a);
void free_slab(slab *b);
/* Turned to every azimuth alike. */
seen look_at_curves(const slab *b, int view, uint32_t rays);

#endif
