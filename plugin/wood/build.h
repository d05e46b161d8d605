/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_WOOD_BUILD_H
#define SOZAI_WOOD_BUILD_H

#include "../core/images.h"
#include "knot_source.h"
#include "wood.h"

/* From settings to what the kernel reads. colours: in the working space. */
int32_t wood_build(wood_constants *w, const sozai_host *host, const settings *s,
                   const float (*colours)[3], const image_set *images);

/* Knots, after stem and rings; to be released. */
int32_t wood_build_knots(wood_constants *w, const sozai_host *host, const settings *s,
                         const knot_source *from, const float (*colours)[3]);
void wood_release_knots(wood_constants *w, const sozai_host *host);

/* The layout of boards, if there is one. */
int32_t wood_build_boards(wood_constants *w, const settings *s, const float (*colours)[3]);

/* The table of pigment's bands. */
void pigment_build(wood_constants *w, const settings *s);

/* The table that vessel radii are drawn from; once, at init. */
void wood_build_prepare(void);

#endif
