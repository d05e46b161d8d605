/* SPDX-License-Identifier: Apache-2.0
 * Wood sought for its figure: a species of the other groups, as it grows now and
 * then. */
#include "entry.h"

#define MAPLE_TISSUE                                                                               \
  DIFFUSE_POROUS(40.0, 66.0, 0.2), NUMBER("fibre_brightness", 0.06),                               \
      SRGB("earlywood_colour", 230, 202, 164), SRGB("latewood_colour", 200, 163, 122),             \
      SRGB("vessel_colour", 217, 188, 149), SRGB("sapwood_earlywood_colour", 236, 212, 178),       \
      SRGB("sapwood_latewood_colour", 210, 178, 138), NUMBER("heartwood_years", 110.0),            \
      SRGB("sapwood_vessel_colour", 223, 197, 162), NUMBER("heartwood_edge", INDISTINCT),          \
      NUMBER("diffuse", 0.8), NUMBER("specular", 0.3), NUMBER("shininess", 14.0),                  \
      RAYS(2.2, 0.6, 70.0, 28.0), SRGB("ray_colour", 221, 189, 150), FIBRES(20.0, 540.0),          \
      AGED(206, 162, 110, 4.0)

static const sozai_value values_curly_maple[] = {
    RINGS(2.2, 0.22, 0.7),
    LATEWOOD(0.06, 0.7),
    WAVY(0.2, 9.0, 0.85, 40.0),
    CURL(0.18, 9.0, 0.95, 26.0),
    LUSTRE(0.065),
    NUMBER("slope_noise", 0.03),
    NUMBER("slope_noise_length", 45.0),
    MAPLE_TISSUE,
};
SPECIES(curly_maple, "Curly maple, tiger stripe (Acer saccharum)",
        "Fibres that wave from side to side and in and out: bars across the board on every face.",
        PANSHIN "; " BEALS);

static const sozai_value values_quilted_maple[] = {
    RINGS(2.4, 0.22, 0.7), LATEWOOD(0.06, 0.7),         QUILT(0.17, 13.0, 23.0),
    LUSTRE(0.05),          NUMBER("slope_noise", 0.05), NUMBER("slope_noise_length", 20.0),
    MAPLE_TISSUE,
};
SPECIES(quilted_maple, "Quilted maple (Acer macrophyllum)",
        "Pillows of the growth front with creases between: three-dimensional on flat-sawn faces.",
        PANSHIN "; " BEALS);

static const sozai_value values_birdseye_maple[] = {
    RINGS(1.9, 0.22, 0.7),
    LATEWOOD(0.06, 0.7),
    NUMBER("slope_noise", 0.03),
    NUMBER("slope_noise_length", 45.0),
    QUILT(0.05, 18.0, 14.0),
    EYES(1.1, 5.2, 0.25, 70.0),
    LUSTRE(0.04),
    MAPLE_TISSUE,
};
SPECIES(birdseye_maple, "Bird's-eye maple (Acer saccharum var. saccharum)",
        "Dimples in the growth rings that go on for decades: little eyes on flat-sawn faces.",
        BRAGG "; " BEALS);

static const sozai_value values_pommele_sapele[] = {
    RINGS(2.4, 0.28, 1.0),
    LATEWOOD(0.2, 0.3),
    INTERLOCKED(0.1, 12.0, 900.0),
    QUILT(0.1, 9.0, 10.0),
    NUMBER("slope_noise", 0.06),
    NUMBER("slope_noise_length", 12.0),
    LUSTRE(0.03),
    DIFFUSE_POROUS(14.0, 125.0, 0.2),
    NUMBER("fibre_brightness", 0.17),
    SRGB("earlywood_colour", 150, 92, 62),
    SRGB("latewood_colour", 124, 70, 46),
    SRGB("vessel_colour", 116, 70, 46),
    SOFT_BANDS(50.0, 1.60, 0.5),
    SHEATHS(30.0, 1.5),
    SRGB("parenchyma_colour", 164, 112, 81),
    SRGB("sapwood_earlywood_colour", 214, 182, 152),
    SRGB("sapwood_parenchyma_colour", 220, 189, 157),
    SRGB("sapwood_latewood_colour", 194, 158, 128),
    SRGB("sapwood_vessel_colour", 167, 141, 117),
    NUMBER("heartwood_years", 140.0),
    NUMBER("specular", 0.26),
    NUMBER("shininess", 14.0),
    RAYS(3.6, 0.45, 55.0, 28.0),
    SRGB("ray_colour", 142, 85, 57),
    AGED(114, 66, 42, 1.5),
    FIBRES(19.0, 550.0),
};
SPECIES(pommele_sapele, "Sapele, pommele (Entandrophragma cylindricum)",
        "Small round blisters over interlocked grain, like drops of rain on a puddle.",
        RICHTER "; " BEALS);

static const sozai_value values_spalted_beech[] = {
    RINGS(2.2, 0.24, 0.8),
    LATEWOOD(0.14, 0.5),
    NUMBER("slope_noise", 0.035),
    NUMBER("slope_noise_length", 45.0),
    DIFFUSE_POROUS(120.0, 58.0, 0.2),
    NUMBER("fibre_brightness", 0.1),
    SRGB("earlywood_colour", 214, 170, 132),
    SRGB("latewood_colour", 188, 140, 104),
    SRGB("vessel_colour", 201, 157, 120),
    SRGB("sapwood_earlywood_colour", 222, 186, 150),
    SRGB("sapwood_latewood_colour", 200, 160, 124),
    SRGB("sapwood_vessel_colour", 209, 172, 137),
    NUMBER("heartwood_years", 95.0),
    NUMBER("heartwood_edge", INDISTINCT),
    NUMBER("specular", 0.06),
    RAYS(0.9, 1.4, 110.0, 45.0),
    SRGB("ray_colour", 193, 143, 107),
    FIBRES(20.0, 570.0),
    AGED(196, 146, 100, 4.0),
    SPALT(0.8, 45.0, 0.7),
};
SPECIES(spalted_beech, "Beech, spalted (Fagus sylvatica)",
        "Beech that fungi have begun on: black zone lines, and bleached wood along them.",
        SCHOCH "; " ROBINSON);
