/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_WOOD_SURFACE_BUILD_H
#define SOZAI_WOOD_SURFACE_BUILD_H

#include "../../core/params.h"
#include "../wood.h"

/* The surface from the settings; rings and vessels are built. */
int32_t surface_build(wood_constants *w, const settings *s);

/* What surface and finish make of colours and gloss; both are built. */
void surface_build_colour(wood_constants *w, const settings *s, const float (*colours)[3]);

/* What is left of the fibres' own reflection. */
double surface_fibres(const settings *s);

#endif
