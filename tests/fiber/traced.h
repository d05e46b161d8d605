/* SPDX-License-Identifier: Apache-2.0
 * Strands in a tile that is repeated without end, and the light that rays bring from them:
 * they are followed through Embree with the renderer's lobes, until nothing is left. */
#ifndef SOZAI_TESTS_TRACED_H
#define SOZAI_TESTS_TRACED_H

#include "fiber.h"

#include "fiber_lobe.h"
#include "strands.h"
#include "textured.h"

#define PI 3.14159265358979
enum { LIGHTS = 7 };

/* Degrees: elevation, and azimuth from where the view leans to. */
extern const double lights[LIGHTS][2];
/* White, wool, dark. */
extern const float colours[3];

typedef struct {
  strands s;
  fiber_lobe lobe;
  float round;         /* roughness around a fibre: colours' absorption goes by it */
  float colour[3];     /* of three kinds of strands, in bulk: they are followed as one */
  float half[2], high; /* of the tile; nothing is above or as far below */
  uint32_t seed;       /* of the rays: others are as good */
} traced;

/* From where is looked: elevation; and azimuths, evenly, over a range. Degrees. */
typedef struct {
  double elevation, from, range;
} eye;

/* Under light of irradiance pi: means over the rays, and of the squares. */
typedef struct {
  double sum[LIGHTS][3], square[LIGHTS][3];
  double square_of_all[3];      /* of what all lights give one ray */
  double covered;               /* share of rays that meet a strand */
  double around[3], around2[3]; /* under light from everywhere above: what comes back */
} seen;

/* The chance of one mean of so many rays. */
double seen_chance(const seen *s, int light, int colour, uint32_t rays);
vec aim(double elevation, double azimuth);
seen look_at_curves(const traced *b, eye e, uint32_t rays);

/* Sets what the texture's point i is looked at and lit from, as rays were. */
void ground_look(ground *g, uint32_t i, vec view, vec light);

#endif
