/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_WOOD_CONE_TABLE_H
#define SOZAI_WOOD_CONE_TABLE_H

#include "wood.h"

/* Fills cone_table, cone_mean, cone_scale and cone_ray from ior, cone_width and
 * fibre_brightest: where the lobe would reflect more than it receives, as of end
 * grain it may, its scale is less than 1; the rays' likewise, which is ray_lustre over that. */
void cone_table_build(wood_constants *w, double ray_lustre);

#endif
