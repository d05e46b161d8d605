/* SPDX-License-Identifier: Apache-2.0
 * One cloth as curves between which rays go to and fro, and as the texture: the same looks at
 * both. */
#ifndef SOZAI_TESTS_CLOTHED_H
#define SOZAI_TESTS_CLOTHED_H

#include "textured.h"
#include "woven.h"

enum { VIEWS = 3, SIDES = 4 };
extern const double views[VIEWS]; /* elevations, degrees; each all round, in parts */

/* Of the three colours. Radiance under each light, of light of irradiance pi, and with which
 * chance; the mean of all views, sides and lights; albedo to an eye above, of what comes back from
 * within. */
typedef struct {
  double radiance[VIEWS][SIDES][LIGHTS][3], chance[VIEWS][SIDES][LIGHTS][3];
  double mean[3], mean_chance[3], albedo[3], albedo_chance[3], covered;
} clothed;

/* rays: from each view and side; points likewise. */
clothed cloth_as_curves(const cloth *c, uint32_t seed, uint32_t rays);
/* Of the cloth's own parameters; of one colour. */
sozai_texture *cloth_as_texture(const cloth *c, const sozai_textures_1 *textures,
                                const float of[3]);
clothed cloth_as_seen(const sozai_texture *t, const sozai_textures_1 *textures, double footprint,
                      uint32_t points);

#endif
