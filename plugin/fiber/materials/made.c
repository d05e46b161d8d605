/* SPDX-License-Identifier: Apache-2.0
 *
 * Man-made fibres, and what gathers of all kinds.
 */
#include "entry.h"

MATERIAL(fleece) = {.id = "fleece",
                    .label = "Polyester fleece pile",
                    .doc = "Brushed microfibre: fine, soft, dense, dyed.",
                    .source = "McIntyre 2005, Synthetic Fibres: microfibres 0.5 to 1 dtex, which "
                              "at 1.38 g/cm3 is 7 to 10 um; "
                              "index 1.54 across",
                    .length = 6,
                    .length_spread = 0.3,
                    .diameter = 11,
                    .diameter_spread = 0.1,
                    .taper = 1,
                    .flatness = 1,
                    .vertices = 48,
                    .phi = {-70, 70},
                    .theta = {-10, 24},
                    .packing = 0.03,
                    .density = 1.38,
                    .colour = {74, 100, 138},
                    .colour_2 = {88, 114, 152},
                    .share_2 = 0.4,
                    .colour_spread = 0.03,
                    .roughness = 7,
                    .roughness_round = 0.25,
                    .index = 1.6};

MATERIAL(polyester_staple) = {
    .id = "polyester_staple",
    .label = "Polyester filling",
    .doc = "Cushion filling: slick white curls, hollow and springy, of one thickness.",
    .source = "McIntyre 2005: filling 6 to 7 dtex, hollow, 25 to 30 um, staple 32 to 64 mm, spiral "
              "crimp 3 to 4 "
              "a cm; fill 8 to 15 kg/m3",
    .length = 50,
    .length_spread = 0.03,
    .diameter = 27,
    .diameter_spread = 0.04,
    .taper = 1,
    .flatness = 1,
    .vertices = 160,
    .phi = {9.9, 31.9},
    .theta = {6.4, 26.4},
    .crimp = 3,
    .crimp_height = 0.416,
    .packing = 0.008,
    .density = 1.38,
    .colour = {245, 246, 248},
    .colour_spread = 0.01,
    .roughness = 4,
    .roughness_round = 0.2,
    .medulla = 0.45,
    .index = 1.6};

MATERIAL(viscose) = {.id = "viscose",
                     .label = "Viscose staple",
                     .doc = "Grooved, limp and shiny, slightly wavy.",
                     .source = "Woodings 2001, Regenerated Cellulose Fibres: 1.7 dtex, 12 um, "
                               "staple 38 mm; " MORTON_HEARLE,
                     .length = 38,
                     .length_spread = 0.03,
                     .diameter = 13,
                     .diameter_spread = 0.06,
                     .taper = 1,
                     .flatness = 0.8,
                     .vertices = 96,
                     .phi = {-60, 60},
                     .theta = {-4, 16},
                     .packing = 0.012,
                     .density = 1.51,
                     .colour = {246, 246, 242},
                     .colour_spread = 0.01,
                     .roughness = 6,
                     .roughness_round = 0.3,
                     .index = 1.53};

MATERIAL(mineral_wool) = {
    .id = "mineral_wool",
    .label = "Mineral wool",
    .doc =
        "Asbestos-like: straight brittle needles of many lengths and widths, grey-green to brown.",
    .source = "Sirok, Blagojevic & Bullen 2008, Mineral Wool: stone wool 3 to 8 um, log-normal, 1 "
              "to 30 mm; "
              "slabs of 30 to 150 kg/m3 over 2.7 g/cm3",
    .length = 8,
    .length_spread = 0.6,
    .diameter = 6,
    .diameter_spread = 0.5,
    .taper = 0.8,
    .flatness = 1,
    .vertices = 24,
    .phi = {-90, 90},
    .theta = {-2, 3},
    .packing = 0.02,
    .density = 2.7,
    .colour = {176, 170, 146},
    .colour_2 = {138, 122, 92},
    .share_2 = 0.3,
    .colour_spread = 0.06,
    .roughness = 4,
    .roughness_round = 0.2,
    .index = 1.6};

MATERIAL(dust) = {
    .id = "dust",
    .label = "Dust bunny",
    .doc = "Grey house dust: worn textile fibres of every kind, a few hairs, very loose.",
    .source = "Butte & Heinzow 2002, Reviews of Environmental Contamination 175: house dust's "
              "fibre share, "
              "cotton and synthetic, 0.5 to 10 mm; widths as of cotton, wool and hair",
    .length = 9,
    .length_spread = 0.6,
    .diameter = 18,
    .diameter_spread = 0.45,
    .taper = 0.8,
    .flatness = 0.8,
    .vertices = 48,
    .phi = {-60, 60},
    .theta = {-10, 24},
    .packing = 0.0022,
    .density = 1.4,
    .colour = {150, 144, 136},
    .colour_2 = {92, 84, 78},
    .share_2 = 0.18,
    .colour_spread = 0.22,
    .roughness = 14,
    .roughness_round = 0.6,
    .tilt = 1,
    .index = 1.55};

MATERIAL(lint) = {.id = "lint",
                  .label = "Dryer lint",
                  .doc = "Blue-grey mat of short cotton broken out of cloth.",
                  .source = "Napper & Thompson 2016, Marine Pollution Bulletin 112: shed fibres 5 "
                            "to 8 mm, 11 to 18 um; cotton "
                            "after Gordon & Hsieh 2007",
                  .length = 6,
                  .length_spread = 0.5,
                  .diameter = 15,
                  .diameter_spread = 0.25,
                  .taper = 0.9,
                  .flatness = 0.5,
                  .vertices = 40,
                  .phi = {-70, 70},
                  .theta = {-12, 26},
                  .packing = 0.015,
                  .density = 1.5,
                  .colour = {158, 164, 178},
                  .colour_2 = {96, 108, 138},
                  .share_2 = 0.3,
                  .colour_spread = 0.12,
                  .roughness = 14,
                  .roughness_round = 0.55,
                  .index = 1.55};
