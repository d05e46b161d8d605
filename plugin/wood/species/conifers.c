/* SPDX-License-Identifier: Apache-2.0
 * Conifers: no vessels, and rays too fine to see. */
#include "tissues.h"

static const sozai_value values_sugi[] = {SUGI};
SPECIES(sugi, "Sugi, Japanese cedar (Cryptomeria japonica)",
        "A conifer: pinkish earlywood and dark, abrupt latewood.", FFPRI "; " INSIDEWOOD);

static const sozai_value values_hinoki[] = {
    RINGS(1.9, 0.25, 0.6),
    LATEWOOD(0.15, 0.45),
    NUMBER("latewood_variation", 0.35),
    NUMBER("slope_noise", 0.01),
    CONIFER(0.3),
    NUMBER("fibre_brightness", 0.09),
    NUMBER("fibre_width", 0.05),
    SRGB("earlywood_colour", 236, 203, 156),
    SRGB("latewood_colour", 206, 150, 98),
    SRGB("sapwood_earlywood_colour", 239, 212, 169),
    SRGB("sapwood_latewood_colour", 209, 163, 113),
    NUMBER("heartwood_years", 130.0),
    NUMBER("heartwood_edge", INDISTINCT),
    NUMBER("specular", 0.09),
    AGED(208, 154, 96, 4.0),
    TRACHEIDS(28.0, 32.0, 12.0, 360.0),
};
SPECIES(hinoki, "Hinoki, Japanese cypress (Chamaecyparis obtusa)",
        "A conifer: pale, fine and lustrous, with narrow, gradual latewood.",
        FFPRI "; " INSIDEWOOD);

static const sozai_value values_karamatsu[] = {
    RINGS(3.0, 0.34, 0.8),
    LATEWOOD(0.3, 0.85),
    NUMBER("latewood_variation", 0.25),
    NUMBER("slope_noise", 0.035),
    NUMBER("slope_noise_length", 120.0),
    CONIFER(0.2),
    NUMBER("fibre_brightness", 0.12),
    NUMBER("fibre_width", 0.05),
    SRGB("earlywood_colour", 214, 164, 112),
    SRGB("latewood_colour", 150, 94, 52),
    SRGB("sapwood_earlywood_colour", 234, 212, 170),
    SRGB("sapwood_latewood_colour", 196, 154, 104),
    NUMBER("heartwood_years", 110.0),
    NUMBER("specular", 0.06),
    AGED(166, 106, 60, 2.5),
    TRACHEIDS(40.0, 50.0, 16.0, 420.0),
    CANALS(0.4, 75.0),
    SRGB("canal_colour", 192, 138, 88),
};
SPECIES(karamatsu, "Karamatsu, Japanese larch (Larix kaempferi)",
        "A conifer: orange-brown heart, with wide dark latewood abrupt in both directions.",
        FFPRI "; " GYMNOSPERMS);

/* clang-format off */
#define AKAMATSU \
    RINGS(2.6, 0.32, 0.8), \
    LATEWOOD(0.25, 0.6), \
    NUMBER("latewood_variation", 0.3), \
    NUMBER("slope_noise", 0.02), \
    CONIFER(0.3), \
    NUMBER("fibre_brightness", 0.12), \
    NUMBER("fibre_width", 0.05), \
    SRGB("earlywood_colour", 226, 186, 132), \
    SRGB("latewood_colour", 174, 116, 66), \
    SRGB("sapwood_earlywood_colour", 238, 216, 172), \
    SRGB("sapwood_latewood_colour", 202, 158, 106), \
    NUMBER("heartwood_years", 100.0), \
    NUMBER("heartwood_edge", FAIRLY_DISTINCT), \
    NUMBER("specular", 0.06), \
    AGED(194, 134, 76, 2.0), \
    TRACHEIDS(34.0, 42.0, 16.0, 430.0), \
    CANALS(0.7, 150.0), \
    SRGB("canal_colour", 206, 152, 96)
/* clang-format on */

static const sozai_value values_akamatsu[] = {AKAMATSU};
SPECIES(akamatsu, "Akamatsu, Japanese red pine (Pinus densiflora)",
        "A conifer: yellowish, with a broad resinous latewood.", FFPRI "; " GYMNOSPERMS);

static const sozai_value values_scots_pine[] = {SCOTS_PINE};
SPECIES(scots_pine, "Scots pine (Pinus sylvestris)",
        "A conifer: reddish heart, pale sapwood, latewood clear and brown.",
        SCHOCH "; " GYMNOSPERMS);

static const sozai_value values_douglas_fir[] = {
    RINGS(2.2, 0.32, 0.7),
    LATEWOOD(0.32, 0.82),
    NUMBER("latewood_variation", 0.25),
    NUMBER("slope_noise", 0.014),
    CONIFER(0.2),
    NUMBER("fibre_brightness", 0.12),
    NUMBER("fibre_width", 0.05),
    SRGB("earlywood_colour", 220, 164, 114),
    SRGB("latewood_colour", 158, 96, 58),
    SRGB("sapwood_earlywood_colour", 238, 212, 168),
    SRGB("sapwood_latewood_colour", 198, 152, 104),
    NUMBER("heartwood_years", 140.0),
    NUMBER("specular", 0.06),
    AGED(178, 110, 62, 2.0),
    TRACHEIDS(38.0, 48.0, 16.0, 450.0),
    CANALS(0.4, 80.0),
    SRGB("canal_colour", 198, 142, 96),
};
SPECIES(douglas_fir, "Douglas fir (Pseudotsuga menziesii)",
        "A conifer: orange-brown, with strong, abrupt latewood and even lines.",
        HANDBOOK "; " GYMNOSPERMS);

static const sozai_value values_spruce[] = {
    RINGS(1.9, 0.28, 0.6),
    LATEWOOD(0.18, 0.4),
    NUMBER("latewood_variation", 0.3),
    NUMBER("slope_noise", 0.012),
    CONIFER(0.3),
    NUMBER("fibre_brightness", 0.09),
    NUMBER("fibre_width", 0.05),
    SRGB("earlywood_colour", 238, 214, 170),
    SRGB("latewood_colour", 204, 160, 108),
    SRGB("sapwood_earlywood_colour", 240, 218, 176),
    SRGB("sapwood_latewood_colour", 208, 166, 114),
    NUMBER("heartwood_years", 60.0),
    NUMBER("heartwood_edge", INDISTINCT),
    NUMBER("specular", 0.1),
    AGED(204, 160, 106, 2.5),
    TRACHEIDS(32.0, 38.0, 14.0, 380.0),
    CANALS(0.35, 75.0),
    SRGB("canal_colour", 224, 190, 138),
};
SPECIES(spruce, "Norway spruce (Picea abies)",
        "A conifer: nearly white and lustrous, with gradual yellowish latewood.",
        SCHOCH "; " GYMNOSPERMS);

static const sozai_value values_momi[] = {
    RINGS(3.6, 0.3, 0.8),
    LATEWOOD(0.24, 0.45),
    NUMBER("latewood_variation", 0.3),
    NUMBER("slope_noise", 0.015),
    CONIFER(0.3),
    NUMBER("fibre_brightness", 0.12),
    NUMBER("fibre_width", 0.055),
    SRGB("earlywood_colour", 236, 214, 180),
    SRGB("latewood_colour", 194, 154, 116),
    SRGB("sapwood_earlywood_colour", 238, 218, 186),
    SRGB("sapwood_latewood_colour", 198, 160, 122),
    NUMBER("heartwood_years", 60.0),
    NUMBER("heartwood_edge", INDISTINCT),
    NUMBER("specular", 0.07),
    AGED(204, 166, 118, 3.0),
    TRACHEIDS(38.0, 45.0, 16.0, 360.0),
};
SPECIES(momi, "Momi, Japanese fir (Abies firma)",
        "A conifer: white with a grey cast, coarse, latewood distinct and pinkish brown.",
        FFPRI "; " GYMNOSPERMS);

static const sozai_value values_silver_fir[] = {
    RINGS(2.4, 0.3, 0.7),
    LATEWOOD(0.2, 0.42),
    NUMBER("latewood_variation", 0.3),
    NUMBER("slope_noise", 0.014),
    CONIFER(0.3),
    NUMBER("fibre_brightness", 0.1),
    NUMBER("fibre_width", 0.05),
    SRGB("earlywood_colour", 236, 214, 178),
    SRGB("latewood_colour", 196, 158, 120),
    SRGB("sapwood_earlywood_colour", 238, 218, 184),
    SRGB("sapwood_latewood_colour", 200, 164, 126),
    NUMBER("heartwood_years", 60.0),
    NUMBER("heartwood_edge", INDISTINCT),
    NUMBER("specular", 0.07),
    AGED(204, 164, 114, 3.0),
    TRACHEIDS(36.0, 44.0, 15.0, 350.0),
};
SPECIES(silver_fir, "European silver fir (Abies alba)",
        "A conifer: whitish, without resin, with a greyish latewood.", SCHOCH "; " GYMNOSPERMS);

static const sozai_value values_western_red_cedar[] = {
    RINGS(1.8, 0.3, 0.6),
    LATEWOOD(0.12, 0.6),
    NUMBER("latewood_variation", 0.35),
    NUMBER("slope_noise", 0.01),
    CONIFER(0.3),
    NUMBER("fibre_brightness", 0.19),
    NUMBER("fibre_width", 0.05),
    SRGB("earlywood_colour", 190, 132, 94),
    SRGB("latewood_colour", 134, 82, 56),
    SRGB("sapwood_earlywood_colour", 236, 214, 180),
    SRGB("sapwood_latewood_colour", 202, 166, 126),
    NUMBER("heartwood_years", 160.0),
    NUMBER("specular", 0.05),
    AGED(152, 106, 76, 1.5),
    TRACHEIDS(34.0, 40.0, 12.0, 310.0),
    PIGMENT(0.55, 7.0, 0.8, 3.0, 70.0),
    SRGB("pigment_colour", 116, 68, 44),
};
SPECIES(western_red_cedar, "Western red cedar (Thuja plicata)",
        "A conifer: from pinkish to chocolate brown, drifting; thin dark latewood.",
        HANDBOOK "; " GYMNOSPERMS);

static const sozai_value values_larch[] = {LARCH};
SPECIES(larch, "European larch (Larix decidua)",
        "A conifer: reddish brown heart; sharp dark latewood in narrow rings.",
        SCHOCH "; " GYMNOSPERMS);

static const sozai_value values_yew[] = {
    RINGS(1.1, 0.36, 1.6),
    NUMBER("undulation_size", 30.0),
    LATEWOOD(0.22, 0.3),
    NUMBER("latewood_variation", 0.3),
    NUMBER("slope_noise", 0.04),
    NUMBER("slope_noise_length", 40.0),
    CONIFER(0.3),
    NUMBER("fibre_brightness", 0.17),
    NUMBER("fibre_width", 0.045),
    SRGB("earlywood_colour", 192, 122, 72),
    SRGB("latewood_colour", 144, 82, 46),
    SRGB("sapwood_earlywood_colour", 236, 214, 168),
    SRGB("sapwood_latewood_colour", 210, 178, 126),
    NUMBER("heartwood_years", 200.0),
    NUMBER("heartwood_edge", 0.3),
    NUMBER("specular", 0.1),
    AGED(160, 94, 52, 3.0),
    TRACHEIDS(20.0, 22.0, 10.0, 600.0),
    PIGMENT(0.4, 8.0, 0.6, 3.0, 40.0),
    SRGB("pigment_colour", 112, 54, 30),
};
SPECIES(yew, "Yew (Taxus baccata)",
        "A conifer: orange-brown within thin white sapwood, with wavy, close rings.",
        SCHOCH "; " GYMNOSPERMS);

static const sozai_value values_hiba[] = {
    RINGS(1.5, 0.26, 0.6),
    LATEWOOD(0.13, 0.4),
    NUMBER("latewood_variation", 0.35),
    NUMBER("slope_noise", 0.02),
    NUMBER("slope_noise_length", 90.0),
    CONIFER(0.3),
    NUMBER("fibre_brightness", 0.1),
    NUMBER("fibre_width", 0.05),
    SRGB("earlywood_colour", 234, 206, 154),
    SRGB("latewood_colour", 206, 164, 108),
    SRGB("sapwood_earlywood_colour", 240, 222, 184),
    SRGB("sapwood_latewood_colour", 216, 184, 138),
    NUMBER("heartwood_years", 120.0),
    NUMBER("heartwood_edge", INDISTINCT),
    NUMBER("specular", 0.07),
    AGED(206, 160, 98, 3.0),
    TRACHEIDS(28.0, 32.0, 12.0, 370.0),
};
SPECIES(hiba, "Hiba, hiba arborvitae (Thujopsis dolabrata)",
        "A conifer: pale yellow, fine and even, with thin gradual latewood.",
        FFPRI "; " GYMNOSPERMS);

static const sozai_value values_sawara[] = {
    RINGS(2.2, 0.28, 0.7),
    LATEWOOD(0.14, 0.45),
    NUMBER("latewood_variation", 0.35),
    NUMBER("slope_noise", 0.012),
    CONIFER(0.3),
    NUMBER("fibre_brightness", 0.12),
    NUMBER("fibre_width", 0.05),
    SRGB("earlywood_colour", 218, 184, 138),
    SRGB("latewood_colour", 176, 130, 88),
    SRGB("sapwood_earlywood_colour", 238, 220, 184),
    SRGB("sapwood_latewood_colour", 208, 176, 132),
    NUMBER("heartwood_years", 120.0),
    NUMBER("specular", 0.05),
    AGED(180, 136, 90, 3.0),
    TRACHEIDS(28.0, 34.0, 12.0, 300.0),
};
SPECIES(sawara, "Sawara, Sawara cypress (Chamaecyparis pisifera)",
        "A conifer: dull yellowish brown, soft, its latewood narrow and brown.",
        FFPRI "; " GYMNOSPERMS);

static const sozai_value values_kaya[] = {
    RINGS(1.3, 0.28, 0.7),
    LATEWOOD(0.14, 0.3),
    NUMBER("latewood_variation", 0.3),
    NUMBER("slope_noise", 0.014),
    CONIFER(0.3),
    NUMBER("fibre_brightness", 0.09),
    NUMBER("fibre_width", 0.05),
    SRGB("earlywood_colour", 226, 192, 134),
    SRGB("latewood_colour", 202, 162, 106),
    SRGB("sapwood_earlywood_colour", 236, 208, 150),
    SRGB("sapwood_latewood_colour", 214, 178, 118),
    NUMBER("heartwood_years", 160.0),
    NUMBER("heartwood_edge", INDISTINCT),
    NUMBER("specular", 0.09),
    AGED(202, 150, 88, 4.0),
    TRACHEIDS(26.0, 30.0, 12.0, 440.0),
};
SPECIES(kaya, "Kaya, Japanese nutmeg yew (Torreya nucifera)",
        "A conifer: honey yellow and resilient, the board of go; close, faint rings.",
        FFPRI "; " GYMNOSPERMS);

static const sozai_value values_tsuga[] = {
    RINGS(1.4, 0.28, 0.7),
    LATEWOOD(0.28, 0.55),
    NUMBER("latewood_variation", 0.3),
    NUMBER("slope_noise", 0.014),
    CONIFER(0.3),
    NUMBER("fibre_brightness", 0.12),
    NUMBER("fibre_width", 0.05),
    SRGB("earlywood_colour", 222, 182, 144),
    SRGB("latewood_colour", 168, 120, 92),
    SRGB("sapwood_earlywood_colour", 234, 208, 172),
    SRGB("sapwood_latewood_colour", 192, 150, 118),
    NUMBER("heartwood_years", 150.0),
    NUMBER("heartwood_edge", FAIRLY_DISTINCT),
    NUMBER("specular", 0.06),
    AGED(184, 136, 96, 3.0),
    TRACHEIDS(32.0, 38.0, 14.0, 420.0),
};
SPECIES(tsuga, "Tsuga, southern Japanese hemlock (Tsuga sieboldii)",
        "A conifer: pale purplish brown, hard; latewood dark and close.", FFPRI "; " GYMNOSPERMS);

static const sozai_value values_ichii[] = {
    RINGS(1.2, 0.32, 1.0),
    LATEWOOD(0.2, 0.3),
    NUMBER("latewood_variation", 0.3),
    NUMBER("slope_noise", 0.02),
    NUMBER("slope_noise_length", 60.0),
    CONIFER(0.3),
    NUMBER("fibre_brightness", 0.13),
    NUMBER("fibre_width", 0.045),
    SRGB("earlywood_colour", 196, 134, 92),
    SRGB("latewood_colour", 156, 98, 64),
    SRGB("sapwood_earlywood_colour", 238, 216, 174),
    SRGB("sapwood_latewood_colour", 214, 180, 132),
    NUMBER("heartwood_years", 180.0),
    NUMBER("heartwood_edge", 0.3),
    NUMBER("specular", 0.1),
    AGED(158, 98, 60, 3.0),
    TRACHEIDS(22.0, 25.0, 11.0, 440.0),
    PIGMENT(0.3, 8.0, 0.7, 3.0, 60.0),
    SRGB("pigment_colour", 140, 84, 52),
};
SPECIES(ichii, "Ichii, Japanese yew (Taxus cuspidata)",
        "A conifer: reddish orange, fine and smooth, in a thin white sapwood.",
        FFPRI "; " GYMNOSPERMS);

static const sozai_value values_redwood[] = {
    RINGS(2.0, 0.34, 0.6),
    LATEWOOD(0.18, 0.72),
    NUMBER("latewood_variation", 0.3),
    NUMBER("slope_noise", 0.012),
    CONIFER(0.3),
    NUMBER("fibre_brightness", 0.14),
    NUMBER("fibre_width", 0.055),
    SRGB("earlywood_colour", 170, 110, 84),
    SRGB("latewood_colour", 110, 64, 50),
    SRGB("sapwood_earlywood_colour", 238, 214, 180),
    SRGB("sapwood_latewood_colour", 206, 168, 128),
    NUMBER("heartwood_years", 200.0),
    NUMBER("specular", 0.05),
    AGED(126, 80, 58, 1.5),
    TRACHEIDS(52.0, 58.0, 18.0, 360.0),
    PIGMENT(0.3, 8.0, 0.7, 3.0, 80.0),
    SRGB("pigment_colour", 118, 58, 48),
};
SPECIES(redwood, "Coast redwood (Sequoia sempervirens)",
        "A conifer: deep reddish brown, coarse and straight, with abrupt dark latewood.",
        HANDBOOK "; " GYMNOSPERMS);

static const sozai_value values_southern_pine[] = {
    RINGS(2.4, 0.32, 0.7),
    LATEWOOD(0.4, 0.85),
    NUMBER("latewood_variation", 0.25),
    NUMBER("slope_noise", 0.014),
    CONIFER(0.2),
    NUMBER("fibre_brightness", 0.12),
    NUMBER("fibre_width", 0.05),
    SRGB("earlywood_colour", 228, 178, 118),
    SRGB("latewood_colour", 181, 120, 71),
    SRGB("sapwood_earlywood_colour", 240, 214, 164),
    SRGB("sapwood_latewood_colour", 207, 160, 105),
    NUMBER("heartwood_years", 90.0),
    NUMBER("specular", 0.06),
    AGED(194, 128, 68, 2.0),
    TRACHEIDS(38.0, 46.0, 18.0, 510.0),
    CANALS(0.45, 160.0),
    SRGB("canal_colour", 206, 148, 90),
};
SPECIES(southern_pine, "Longleaf pine (Pinus palustris)",
        "A conifer: orange-yellow with latewood half of the ring, dark and abrupt.",
        HANDBOOK "; " GYMNOSPERMS);

/* ---- with the knots of a grown tree ------------------------------------- */

static const sozai_value values_knotty_pine[] = {AKAMATSU, TREE("akamatsu", 45.0, 6000.0)};
SPECIES(knotty_pine, "Pine, knotty (Pinus densiflora)",
        "Whorls of knots up the stem, some alive, most of them dead in a ring of bark.",
        FFPRI "; " GYMNOSPERMS);

static const sozai_value values_knotty_sugi[] = {SUGI, TREE("sugi", 45.0, 5000.0),
                                                 SRGB("knot_colour", 164, 88, 56)};
SPECIES(knotty_sugi, "Sugi, knotty (Cryptomeria japonica)",
        "Many small red-brown knots all along the board: sugi that was not pruned.",
        FFPRI "; " GYMNOSPERMS);
