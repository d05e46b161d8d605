/* SPDX-License-Identifier: Apache-2.0
 * Panels glued up from veneers: a species of the other groups as it leaves the mill.
 * Lay-ups are typical of their trade: thicknesses of plies after the sources named
 * with each, glue lines of 0.05 to 0.1 mm as sections under a microscope show them. */
#include "tissues.h"

#define FINNISH                                                                                    \
  "Finnish Forest Industries Federation, Handbook of Finnish plywood (2002); EN 315 (2000)"
#define EN_PLYWOOD "EN 313-2, Plywood: classification and terminology (1999)"
#define JAS_PLYWOOD "Japanese Agricultural Standard for plywood, MAFF notification 233 (2003)"
#define EN_LVL "EN 14374, Timber structures: structural laminated veneer lumber (2004)"

/* mm: the sheet, its faces and its core's plies */
#define LAID(construction, thick, face, core)                                                      \
  CHOICE("construction", construction), NUMBER("sheet_thickness", thick),                          \
      NUMBER("face_veneer", face), NUMBER("core_veneer", core)
/* Radius of the log where the knife begins, and how much plies differ in shade. */
#define VENEER_LOG(radius, spread) NUMBER("cut_distance", radius), NUMBER("tone_spread", spread)
#define PHENOLIC(thick) NUMBER("glue_line", thick), SRGB("glue_colour", 92, 60, 42)
#define UREA(thick) NUMBER("glue_line", thick), SRGB("glue_colour", 168, 138, 100)

static const sozai_value values_birch_plywood[] = {BIRCH, LAID("plywood", 18.0, 1.2, 1.4),
                                                   VENEER_LOG(105.0, 0.03), PHENOLIC(0.09)};
SPECIES(
    birch_plywood, "Birch plywood (Betula pendula)",
    "18 mm of 13 plies of birch, crosswise: pale faces, the edge in fine dark and light stripes.",
    FINNISH "; " SCHOCH);

static const sozai_value values_lauan_plywood[] = {
    RINGS(5.0, 0.3, 1.0),
    LATEWOOD(0.2, 0.2),
    INTERLOCKED(0.1, 12.0, 900.0),
    NUMBER("slope_noise", 0.035),
    NUMBER("slope_noise_length", 45.0),
    DIFFUSE_POROUS(6.0, 210.0, 0.2),
    NUMBER("fibre_brightness", 0.14),
    SRGB("earlywood_colour", 198, 148, 116),
    SRGB("latewood_colour", 178, 126, 96),
    SRGB("vessel_colour", 177, 127, 97),
    SHEATHS(20.0, 1.3),
    SRGB("parenchyma_colour", 207, 164, 132),
    SRGB("sapwood_earlywood_colour", 214, 186, 154),
    SRGB("sapwood_parenchyma_colour", 220, 195, 162),
    SRGB("sapwood_latewood_colour", 196, 164, 132),
    SRGB("sapwood_vessel_colour", 191, 160, 129),
    NUMBER("heartwood_years", 150.0),
    NUMBER("heartwood_edge", INDISTINCT),
    NUMBER("specular", 0.08),
    RAYS(5.0, 0.5, 40.0, 24.0),
    SRGB("ray_colour", 188, 138, 108),
    AGED(166, 112, 82, 2.5),
    FIBRES(22.0, 430.0),
    LAID("plywood", 12.0, 0.8, 2.8),
    VENEER_LOG(260.0, 0.09),
    UREA(0.06),
    NUMBER("core_gap", 1.5),
};
SPECIES(lauan_plywood, "Lauan plywood (Shorea negrosensis)",
        "12 mm of five plies, pink to brown: open vessels, thick core plies, a gap now and then.",
        JAS_PLYWOOD "; " RICHTER);

static const sozai_value values_sugi_plywood[] = {SUGI, LAID("plywood", 12.0, 2.2, 2.6),
                                                  VENEER_LOG(120.0, 0.05), PHENOLIC(0.08),
                                                  NUMBER("core_gap", 1.0)};
SPECIES(sugi_plywood, "Sugi plywood (Cryptomeria japonica)",
        "Structural: five thick plies, peeled, whose rings spread into broad flames on the face.",
        JAS_PLYWOOD "; " FFPRI);

static const sozai_value values_walnut_plywood[] = {
    WALNUT,
    LAID("plywood", 19.0, 0.6, 1.7),
    VENEER_LOG(150.0, 0.04),
    UREA(0.07),
    CHOICE("face_cut", "sliced"),
    CHOICE("leaf_match", "book"),
    NUMBER("leaf_width", 190.0),
};
SPECIES(
    walnut_plywood, "Walnut plywood, book-matched (Juglans regia)",
    "Sliced leaves of 0.6 mm, every other one turned over so that neighbours mirror each other.",
    EN_PLYWOOD "; " WAGENFUEHR);

static const sozai_value values_larch_lvl[] = {LARCH, LAID("lvl", 45.0, 3.0, 3.0),
                                               VENEER_LOG(140.0, 0.06), PHENOLIC(0.1)};
SPECIES(larch_lvl, "Larch laminated veneer lumber (Larix decidua)",
        "45 mm of fifteen plies, all along the length: one long edge of stripes, one of end grain.",
        EN_LVL "; " SCHOCH);

static const sozai_value values_pine_blockboard[] = {SCOTS_PINE, LAID("blockboard", 19.0, 0.9, 2.0),
                                                     VENEER_LOG(110.0, 0.05), UREA(0.07)};
SPECIES(pine_blockboard, "Pine blockboard (Pinus sylvestris)",
        "A core of sawn strips between crossbands and peeled faces.", EN_PLYWOOD "; " SCHOCH);
