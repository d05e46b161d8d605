/* SPDX-License-Identifier: Apache-2.0
 *
 * Tissues that more than one entry has: the species, and panels made of it.
 */
#ifndef SOZAI_WOOD_SPECIES_TISSUES_H
#define SOZAI_WOOD_SPECIES_TISSUES_H

#include "entry.h"

/* clang-format off */
#define BIRCH \
    RINGS(2.2, 0.25, 0.8), \
    LATEWOOD(0.08, 0.5), \
    NUMBER("slope_noise", 0.03), \
    NUMBER("slope_noise_length", 45.0), \
    DIFFUSE_POROUS(55.0, 78.0, 0.2), \
    NUMBER("fibre_brightness", 0.1), \
    SRGB("earlywood_colour", 230, 202, 164), \
    SRGB("latewood_colour", 206, 170, 130), \
    SRGB("vessel_colour", 219, 190, 150), \
    SRGB("sapwood_earlywood_colour", 234, 210, 174), \
    SRGB("sapwood_latewood_colour", 212, 182, 142), \
    SRGB("sapwood_vessel_colour", 223, 198, 159), \
    NUMBER("heartwood_years", 90.0), \
    NUMBER("heartwood_edge", INDISTINCT), \
    NUMBER("specular", 0.1), \
    RAYS(5.0, 0.35, 26.0, 25.0), \
    SRGB("ray_colour", 222, 192, 152), \
    AGED(202, 158, 108, 4.0), \
    MINERAL_STREAKS(0.006, 1.6, 60.0), \
    SRGB("streak_colour", 158, 118, 84), \
    FIBRES(20.0, 510.0)

#define WALNUT \
    RINGS(2.8, 0.3, 1.3), \
    LATEWOOD(0.28, 0.2), \
    NUMBER("slope_noise", 0.05), \
    NUMBER("slope_noise_length", 45.0), \
    SEMI_RING_POROUS(6.0, 180.0, 100.0, 0.2), \
    NUMBER("fibre_brightness", 0.25), \
    SRGB("earlywood_colour", 154, 122, 90), \
    SRGB("latewood_colour", 110, 82, 58), \
    SRGB("vessel_colour", 80, 58, 40), \
    SOFT_BANDS(25.0, 0.22, 0.5), \
    SRGB("parenchyma_colour", 142, 113, 83), \
    SRGB("sapwood_earlywood_colour", 206, 188, 158), \
    SRGB("sapwood_parenchyma_colour", 213, 196, 165), \
    SRGB("sapwood_latewood_colour", 184, 162, 130), \
    SRGB("sapwood_vessel_colour", 151, 135, 112), \
    NUMBER("heartwood_years", 100.0), \
    NUMBER("heartwood_edge", FAIRLY_DISTINCT), \
    NUMBER("specular", 0.08), \
    RAYS(4.0, 0.4, 35.0, 28.0), \
    SRGB("ray_colour", 158, 126, 94), \
    AGED(164, 130, 90, 6.0), \
    FIBRES(22.0, 540.0), \
    PIGMENT(0.75, 6.0, 0.6, 2.0, 50.0), \
    SRGB("pigment_colour", 72, 51, 39)

#define LARCH \
    RINGS(1.7, 0.3, 0.6), \
    LATEWOOD(0.32, 0.85), \
    NUMBER("latewood_variation", 0.25), \
    NUMBER("slope_noise", 0.02), \
    CONIFER(0.2), \
    NUMBER("fibre_brightness", 0.12), \
    NUMBER("fibre_width", 0.05), \
    SRGB("earlywood_colour", 208, 152, 104), \
    SRGB("latewood_colour", 148, 90, 54), \
    SRGB("sapwood_earlywood_colour", 234, 208, 164), \
    SRGB("sapwood_latewood_colour", 192, 148, 100), \
    NUMBER("heartwood_years", 100.0), \
    NUMBER("specular", 0.06), \
    AGED(160, 100, 56, 2.5), \
    TRACHEIDS(38.0, 48.0, 16.0, 480.0), \
    CANALS(0.4, 80.0), \
    SRGB("canal_colour", 188, 132, 86)

#define SCOTS_PINE \
    RINGS(2.0, 0.3, 0.8), \
    LATEWOOD(0.26, 0.62), \
    NUMBER("latewood_variation", 0.3), \
    NUMBER("slope_noise", 0.018), \
    CONIFER(0.3), \
    NUMBER("fibre_brightness", 0.12), \
    NUMBER("fibre_width", 0.05), \
    SRGB("earlywood_colour", 224, 180, 128), \
    SRGB("latewood_colour", 172, 112, 66), \
    SRGB("sapwood_earlywood_colour", 238, 214, 168), \
    SRGB("sapwood_latewood_colour", 200, 156, 104), \
    NUMBER("heartwood_years", 90.0), \
    NUMBER("heartwood_edge", FAIRLY_DISTINCT), \
    NUMBER("specular", 0.06), \
    AGED(192, 132, 74, 2.0), \
    TRACHEIDS(32.0, 40.0, 15.0, 420.0), \
    CANALS(0.6, 130.0), \
    SRGB("canal_colour", 204, 152, 98)

#define SUGI \
    RINGS(3.4, 0.32, 0.9), \
    LATEWOOD(0.2, 0.72), \
    NUMBER("latewood_variation", 0.35), \
    NUMBER("slope_noise", 0.012), \
    CONIFER(0.3), \
    NUMBER("fibre_brightness", 0.1), \
    NUMBER("fibre_width", 0.05), \
    SRGB("earlywood_colour", 226, 176, 138), \
    SRGB("latewood_colour", 152, 86, 56), \
    SRGB("sapwood_earlywood_colour", 238, 220, 190), \
    SRGB("sapwood_latewood_colour", 198, 158, 116), \
    NUMBER("heartwood_years", 110.0), \
    NUMBER("specular", 0.05), \
    AGED(184, 128, 86, 3.0), \
    TRACHEIDS(32.0, 38.0, 12.0, 320.0)
/* clang-format on */

#endif
