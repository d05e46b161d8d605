/* SPDX-License-Identifier: Apache-2.0
 *
 * How fibres lie in use: what a preset says beyond the catalogue's entry of its
 * fibre. Lengths in mm, angles in degrees. 0, or what is left out, stands for
 *   the fibre's own       diameter, diameter_spread, packing, crimp, crimp_height, roughness,
 *                         transmission, variation
 *   the default           waver, thickness, bundle, nap_reach, darkening, hollow, mottle_size
 *   0                     all else
 */
#ifndef SOZAI_FIBERTEX_ARRANGEMENTS_H
#define SOZAI_FIBERTEX_ARRANGEMENTS_H

#include <stdint.h>

typedef struct {
  const char *id, *fiber;  /* of the preset; of the catalogue's entry */
  const char *label, *doc; /* NULL: the fibre's */
  const char *source;      /* of a weave's figures. NULL: the fibre's own are shown; how it lies,
                            and what colours are said here, are set by eye */
  double diameter, diameter_spread; /* um; as the parameter has it */
  double thickness, packing, bundle;
  double alignment, elevation, elevation_spread; /* degrees */
  double nap_drift, nap_reach;
  double flyaway, flyaway_height;
  double crimp, crimp_height, waver;         /* 1/cm; mm */
  double darkening, roughness, transmission; /* degrees, the second */
  const char *weave;                         /* NULL: an aggregate */
  double spacing, weft_spacing, width, flatness, swell, twist, slub, hollow;
  int32_t coloured, weft_coloured; /* the colours below stand */
  uint8_t colour[3], second[3], weft[3];
  double second_share, variation;
  double mottle, mottle_size;
} fiber_arrangement;

extern const fiber_arrangement fiber_arrangements[];
extern const uint32_t fiber_arrangement_count;

#endif
