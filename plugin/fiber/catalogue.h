/* SPDX-License-Identifier: Apache-2.0
 *
 * Kinds of fibre: what textile literature says of each, one entry of data in
 * materials/. Presets of the generator and of the texture are made of these.
 */
#ifndef SOZAI_FIBER_CATALOGUE_H
#define SOZAI_FIBER_CATALOGUE_H

#include <stdint.h>

typedef struct fiber_material {
  const char *id; /* lower_case, stable for ever */
  const char *label;
  const char *doc;    /* how it looks */
  const char *source; /* the literature of its figures */

  /* the strand */
  double length;          /* mm */
  double length_spread;   /* sd over mean */
  double diameter;        /* um */
  double diameter_spread; /* sd over mean, from fibre to fibre */
  double taper;           /* the tips' diameter over the middle's: 1, cut; 0, pointed */
  double flatness;        /* narrow over wide side of its section: 1, round */
  uint32_t vertices;      /* that its angles are meant for */
  double phi[2];          /* least and greatest twist at each joint, degrees */
  double theta[2];        /* least and greatest bend at each joint, degrees */
  double crimp;           /* crimps per cm; 0: none that repeats */
  double crimp_height;    /* mm, half of trough to crest; 0: not known */

  /* the aggregate */
  double packing; /* share of the hull's volume that is fibre */
  double density; /* of the fibre's substance, g/cm3 */

  /* how it looks; colours are sRGB, 0 to 255, of one fibre's body seen in bulk */
  uint8_t colour[3];
  uint8_t colour_2[3];    /* of a share of the fibres */
  double share_2;         /* 0: all are of the first */
  double colour_spread;   /* sd of lightness from fibre to fibre, over mean */
  double roughness;       /* of the lobe along the fibre: its standard deviation, degrees */
  double roughness_round; /* around the fibre, 0 (a clear cylinder) to 1 (diffuse) */
  double tilt;            /* of the cuticle's scales, degrees; 0: it has none */
  double medulla;         /* hollow or porous core: its diameter over the fibre's */
  double index;           /* of refraction */
} fiber_material;

extern const fiber_material *const fiber_materials[];
extern const uint32_t fiber_material_count;

/* NULL: there is none. */
const fiber_material *fiber_material_find(const char *id);

#endif
