/* SPDX-License-Identifier: Apache-2.0
 * How one fibre scatters light: reflected, through, reflected within, and the
 * rest (Marschner et al. 2003; d'Eon et al. 2011; absorption from a colour as
 * Chiang et al. 2016 fitted it). */
#ifndef SOZAI_RENDER_FIBER_LOBE_H
#define SOZAI_RENDER_FIBER_LOBE_H

#include "vec.h"

#define LOBES 4

typedef struct fiber_lobe {
  float variance[LOBES];    /* along the fibre */
  float spread;             /* around it: the logistic's scale */
  float sine[3], cosine[3]; /* of the scales' tilt: alpha, 2 alpha, 4 alpha */
  float index;
} fiber_lobe;

/* degrees, 0 to 1, degrees */
fiber_lobe fiber_lobe_make(float roughness, float roughness_round, float tilt, float index);
/* Absorption over a diameter that gives fibres in bulk that colour, 0 to 1. */
vec fiber_lobe_absorption(vec colour, float roughness_round);

/* One fibre lit: its frame, where along its width the eye meets it. */
typedef struct fiber_view_from {
  vec tangent, across, up; /* `across` towards the eye's side, square to the tangent */
  float sine, cosine;      /* of the eye's elevation out of the normal plane */
  float h, gamma;          /* across the width: -1 to 1, and its arc sine */
  vec attenuation[LOBES];
  float share[LOBES]; /* for choosing one */
  float turn[LOBES];  /* where each lobe goes, around */
  float up_sine[LOBES], up_cosine[LOBES];
} fiber_view_from;

/* eye: unit, towards the eye; normal: unit, of the surface. */
fiber_view_from fiber_lobe_from(const fiber_lobe *l, vec tangent, vec normal, vec eye,
                                vec absorption);
/* Scattered towards the eye of light from a unit direction, times its cosine. */
vec fiber_lobe_value(const fiber_lobe *l, const fiber_view_from *f, vec light);
/* A direction chosen by the lobes; *weight: value over density. u: 4 numbers in [0, 1). */
vec fiber_lobe_sample(const fiber_lobe *l, const fiber_view_from *f, const float u[4], vec *weight);

#endif
