/* SPDX-License-Identifier: Apache-2.0
 * One aggregate as grown strands between which rays go to and fro, and as the texture: the same
 * looks at both. */
#ifndef SOZAI_TESTS_SLABBED_H
#define SOZAI_TESTS_SLABBED_H

#include "slab.h"
#include "textured.h"

enum { SLAB_VIEWS = 2, SLAB_LOOKS = SLAB_VIEWS * LIGHTS };
extern const double slab_views[SLAB_VIEWS]; /* elevations, degrees */

/* Radiance under light of irradiance pi of the three colours, by view and light, with its chance;
 * and the mean of all. */
typedef struct {
  double radiance[SLAB_LOOKS][3], chance[SLAB_LOOKS][3], mean[3], mean_chance[3];
} slabbed;

slabbed slab_as_curves(slab *b, uint32_t seed, uint32_t rays);
sozai_texture *slab_as_texture(const slab *b, const sozai_textures_1 *textures);
slabbed slab_as_seen(const sozai_texture *t, const sozai_textures_1 *textures, double footprint,
                     uint32_t points);

#endif
