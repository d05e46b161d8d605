/* SPDX-License-Identifier: Apache-2.0 */
#include "entry.h"

#define HAYASHI                                                                                    \
  "Hayashi & Takahashi 1997 (J. Jpn. For. Soc. 79, 222-228): turning, divergence, crown a and b; " \
  "Takeshita 1985: b = 0.5"
#define FARJON                                                                                     \
  "Farjon 2010, A Handbook of the World's Conifers: habit, heights, needles, bark; ages of bark "  \
  "ours"

#define SUGI_SHOOTS                                                                                \
  CROWN(0.255, 3, 0.18, 0.5, 0.5, 0.15), CROWN_LIFE(0.55, 25, 12),                                 \
      SHOOTS("2", 42, 480, 0.55, 0.6, 55, "flat", 0.03, 1600, 20, 0.5),                            \
      SHOOTS("3", 18, 130, 0.6, 0.5, 45, "random", 0.03, 0, 30, 0.25),                             \
      LEAVES("needle", 2.8, 1, 15, 3.2, 0.5, 36, "random", 0, 2, 0)

static const sozai_value sugi[] = {SUGI_SHOOTS};
SPECIES(sugi, "Sugi (Cryptomeria japonica)",
        "Japanese cedar: a narrow cone; branches sweep down and turn up, clothed in cords of awls.",
        HAYASHI "; " FARJON);

static const sozai_value sugi_h4[] = {SUGI_SHOOTS, NUMBER("age", 5), NUMBER("crown_a", 0.33),
                                      NUMBER("crown_a_down", 0.35), NUMBER("crown_height", 2.0)};
SPECIES(sugi_h4, "Sugi, planted 1992",
        "The paper's younger planting, wider for its height: crown a 0.33 upslope, 0.35 downslope.",
        HAYASHI);

static const sozai_value sugi_paper[] = {
    NUMBER("age", 7),
    NUMBER("bark_depth", 0),
    NUMBER("leaf_variation", 0),
    CROWN(0.25, 2.9, 0, 0.5, 0.5, 0),
    NUMBER("crown_a_down", 0.26),
    CHOICE("azimuth", "random"),
    CROWN_LIFE(1, 25, 12),
    NUMBER("sway", 0),
    NUMBER("butt", 0),
    BRANCHES(10, 10, 0, 1500, 0, 0, 0.013),
    SHOOTS("2", 50, 200, 0, 0, 80, "random", 0, 0, 0, 0),
    SHOOTS("3", 20, 60, 0, 0.5, 80, "random", 0, 0, 0, 0),
    LEAVES("needle", 3, 1, 15, 1.2, 0.5, 80, "random", 0, 3, 0)};
SPECIES(sugi_paper, "Sugi, the paper's model",
        "Section 6.1 of the paper to the letter: first order by its equation 2, azimuths random, "
        "alpha 80 degrees, beta random, second order every 5 cm and 20 cm long, third every 2 cm, "
        "needles every 0.3 cm.",
        HAYASHI "; the greatest lengths of the third and fourth order are not printed there");

static const sozai_value hinoki[] = {
    HEIGHT(27, 0.027, 1.4),
    DIAMETER(650, 0.016, 1.15),
    TURNING(3.0, 360.0 / 164.0, 1, 52, 52, 244),
    CROWN(0.28, 3.5, 0.3, 0.5, 0.5, 0.15),
    CROWN_LIFE(0.5, 28, 15),
    BRANCHES(40, 0, 10, 1500, 25, 6, 0.013),
    SHOOTS("2", 28, 460, 0.55, 0.5, 50, "flat", 0.05, 1600, 5, 0.4),
    SHOOTS("3", 11, 180, 0.6, 0.6, 45, "flat", 0.02, 0, -10, 0.2),
    LEAVES("needle", 3, 1, 9, 3.4, 0, 28, "opposite", 0, 2, 0),
    SHOOT(0.30, 0.31, 0.17),
    PERIDERM(5, 0.42, 0.27, 0.20),
    RHYTIDOME(15, 55, 0.41, 0.33, 0.28),
    FURROWS(5, 30, 320, 0.7),
    PLATES(0.2, 0.85, 0.3, 0.15),
    TRIPLE("leaf_colour", 0.20, 0.36, 0.17)};
SPECIES(hinoki, "Hinoki (Chamaecyparis obtusa)",
        "Hinoki cypress: scale leaves in flat sprays, a rounder cone than sugi.",
        HAYASHI " (structure; turns a year are not given for it and taken as sugi's); " FARJON);

static const sozai_value akamatsu[] = {
    HEIGHT(28, 0.03, 1.2),
    DIAMETER(650, 0.02, 1.1),
    STEM(0.75, 0.25, 0.025),
    TURNING(1, 5, 0, 14, 30, 120),
    CHOICE("phyllotaxis", "whorls"),
    CROWN(0.36, 4, 0.03, 0.6, 0.28, 0.2),
    CROWN_LIFE(0.34, 22, 5),
    BRANCHES(38, 8, 8, 2500, 18, 20, 0.0075),
    FORKS(1400, 0.3, 0.8, 42),
    SHOOTS("2", 90, 1100, 0.5, 0.6, 52, "flat", 0.25, 2200, 35, 0.45),
    SHOOTS("3", 45, 260, 0.5, 0.4, 48, "spiral", 0.3, 0, 45, 0.4),
    LEAVES("needle", 3, 2, 95, 1.8, 0, 42, "spiral", 0, 2, 200),
    SHOOT(0.46, 0.38, 0.22),
    PERIDERM(4, 0.56, 0.32, 0.21),
    RHYTIDOME(12, 40, 0.39, 0.34, 0.31),
    FURROWS(12, 44, 105, 0.9),
    PLATES(0.4, 0.4, 0.5, 0.2),
    NUMBER("bark_turning", -1),
    TRIPLE("leaf_colour", 0.25, 0.37, 0.17)};
SPECIES(akamatsu, "Akamatsu (Pinus densiflora)",
        "Japanese red pine: a whorl a year, red crooked limbs, grey-brown plates at the foot, "
        "flat-topped when old.",
        "Hayashi & Takahashi 1997, figure 12 (whorls); " FARJON "; needles in pairs, 70 to 120 mm; "
        "thickness of branches ours: 25 to 50 mm at 45 years");

static const sozai_value kuromatsu[] = {
    HEIGHT(25, 0.032, 1.2),
    DIAMETER(800, 0.02, 1.1),
    STEM(0.75, 0.3, 0.045),
    TURNING(1, 5, 0, 16, 30, 130),
    CHOICE("phyllotaxis", "whorls"),
    CROWN(0.38, 4, 0.04, 0.6, 0.3, 0.22),
    CROWN_LIFE(0.42, 25, 6),
    BRANCHES(40, -2, 10, 2500, 20, 26, 0.01),
    FORKS(1400, 0.3, 0.8, 42),
    SHOOTS("2", 95, 1100, 0.5, 0.6, 52, "flat", 0.2, 2200, 35, 0.5),
    SHOOTS("3", 50, 240, 0.5, 0.4, 48, "spiral", 0.3, 0, 50, 0.4),
    LEAVES("needle", 2.6, 2, 110, 1.8, 0, 38, "spiral", 0, 2, 200),
    SHOOT(0.42, 0.34, 0.21),
    PERIDERM(5, 0.36, 0.31, 0.27),
    RHYTIDOME(8, 35, 0.25, 0.22, 0.20),
    FURROWS(26, 50, 120, 0.85),
    PLATES(0.35, 0.45, 0.5, 0.2),
    NUMBER("bark_shade", 0.65),
    TRIPLE("leaf_colour", 0.16, 0.28, 0.14)};
SPECIES(kuromatsu, "Kuromatsu (Pinus thunbergii)",
        "Japanese black pine: stouter and more crooked than the red, with stiff dark needles.",
        FARJON "; needles in pairs, 80 to 150 mm");

static const sozai_value karamatsu[] = {
    HEIGHT(30, 0.04, 1.3),
    DIAMETER(600, 0.025, 1.1),
    TURNING(2.5, 360.0 / 137.5, 0.5, 35, 50, 240),
    NUMBER("flush", 1.6),
    CROWN(0.27, 4, 0.25, 0.6, 0.5, 0.2),
    CROWN_LIFE(0.45, 22, 8),
    BRANCHES(40, 0, 18, 2000, 30, 8, 0.013),
    SHOOTS("2", 75, 700, 0.45, 0.7, 60, "flat", 0.08, 2200, -25, 0.35),
    SHOOTS("3", 60, 160, 0.4, 0.5, 55, "random", 0.1, 0, 15, 0.3),
    LEAVES("needle", 14, 12, 27, 1.0, 0, 62, "random", 0, 2, 0),
    SHOOT(0.52, 0.34, 0.21),
    PERIDERM(5, 0.40, 0.28, 0.22),
    RHYTIDOME(18, 55, 0.36, 0.30, 0.27),
    FURROWS(14, 36, 80, 0.5),
    PLATES(0.3, 0.4, 0.7, 0.2),
    TRIPLE("leaf_colour", 0.36, 0.50, 0.22)};
SPECIES(karamatsu, "Karamatsu (Larix kaempferi)",
        "Japanese larch: a light open cone, needles in tufts on short shoots.",
        FARJON "; needles in tufts, 15 to 35 mm");

static const sozai_value todomatsu[] = {
    HEIGHT(28, 0.028, 1.6),
    DIAMETER(600, 0.018, 1.25),
    TURNING(1, 6, 0, 12, 25, 100),
    CHOICE("phyllotaxis", "whorls"),
    CROWN(0.26, 4, 0.3, 0.65, 0.55, 0.12),
    CROWN_LIFE(0.6, 35, 14),
    BRANCHES(48, 5, 5, 1500, 18, 4, 0.013),
    SHOOTS("2", 60, 700, 0.5, 0.85, 52, "flat", 0.06, 2000, 8, 0.2),
    SHOOTS("3", 42, 200, 0.5, 0.7, 50, "flat", 0.1, 0, 5, 0.2),
    LEAVES("needle", 1.8, 1, 24, 2.2, 0, 50, "spiral", 0, 2, 0),
    SHOOT(0.44, 0.36, 0.26),
    PERIDERM(5, 0.48, 0.47, 0.44),
    RHYTIDOME(35, 90, 0.41, 0.38, 0.35),
    FURROWS(2, 37, 55, 0.5),
    PLATES(0.4, 0, 0.4, 0.15),
    SCARS(4, 0.3, 0.35),
    TRIPLE("leaf_colour", 0.16, 0.32, 0.19)};
SPECIES(todomatsu, "Todomatsu (Abies sachalinensis)",
        "Sakhalin fir: regular whorls, flat dark sprays, a dense cone.",
        FARJON "; whorls as Suzuki et al. 1992 model it (J. Jpn. For. Soc. 74, 504-508)");
