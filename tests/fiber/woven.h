/* SPDX-License-Identifier: Apache-2.0
 * A cloth's strands as curves: what the texture's parameters say of a weave, yarn by yarn and
 * fibre by fibre. */
#ifndef SOZAI_TESTS_WOVEN_H
#define SOZAI_TESTS_WOVEN_H

#include "traced.h"

/* As the parameters of those names; lengths in mm but the diameter, angles in degrees. Of two
 * the first is the warp's. */
typedef struct {
  const char *preset, *weave;
  double spacing[2], width, flatness, swell, twist, slub;
  double diameter, elevation_spread, flyaway, flyaway_height;
  double roughness, tilt, index, transmission;
} cloth;

typedef struct {
  traced t;
  float *points, *radii;
  uint64_t *first;
  uint64_t points_count, curves_count;
} woven;

/* False: the preset is no cloth. */
bool cloth_of(const sozai_texture_info *info, const sozai_preset *p, cloth *c);
/* Warp along x, weft along y, facing z. */
void weave_cloth(woven *b, const cloth *c);
void free_cloth(woven *b);

#endif
