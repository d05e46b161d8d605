/* SPDX-License-Identifier: Apache-2.0 */
#include "entry.h"

#define MITCHELL "Mitchell 1974, A Field Guide to the Trees of Britain and Northern Europe: habit; "
#define FARJON                                                                                     \
  "Farjon 2010, A Handbook of the World's Conifers: heights, needles, bark; ages of bark ours"

static const sozai_value norway_spruce[] = {
    HEIGHT(40, 0.026, 1.5),
    DIAMETER(900, 0.016, 1.2),
    TURNING(1, 6, 0, 14, 25, 110),
    CHOICE("phyllotaxis", "whorls"),
    CROWN(0.28, 4, 0.2, 0.65, 0.55, 0.14),
    CROWN_LIFE(0.65, 40, 18),
    BRANCHES(42, -12, 22, 2200, 40, 5, 0.012),
    SHOOTS("2", 42, 900, 0.5, 0.75, 58, "flat", 0.04, 2400, -55, 0.3),
    SHOOTS("3", 27, 260, 0.55, 0.6, 48, "random", 0.05, 0, -45, 0.25),
    LEAVES("needle", 1.8, 1, 18, 2, 0, 52, "spiral", 0, 2, 0),
    SHOOT(0.50, 0.34, 0.20),
    PERIDERM(5, 0.41, 0.28, 0.21),
    RHYTIDOME(25, 80, 0.34, 0.29, 0.28),
    FURROWS(6, 32, 34, 0.7),
    PLATES(0.25, 0, 0.8, 0.2),
    TRIPLE("leaf_colour", 0.17, 0.30, 0.16)};
SPECIES(norway_spruce, "Norway spruce (Picea abies)",
        "Regular whorls that sweep down and out, hung with drooping sprays.", MITCHELL FARJON);

static const sozai_value scots_pine[] = {
    HEIGHT(30, 0.03, 1.25),
    DIAMETER(700, 0.018, 1.1),
    STEM(0.75, 0.25, 0.02),
    TURNING(1, 5, 0, 14, 30, 120),
    CHOICE("phyllotaxis", "whorls"),
    CROWN(0.30, 4, 0.08, 0.6, 0.32, 0.2),
    CROWN_LIFE(0.33, 24, 8),
    BRANCHES(42, 8, 8, 2500, 18, 18, 0.018),
    FORKS(1400, 0.3, 0.8, 42),
    SHOOTS("2", 80, 1000, 0.5, 0.6, 50, "flat", 0.25, 2200, 30, 0.4),
    SHOOTS("3", 40, 220, 0.5, 0.4, 46, "spiral", 0.3, 0, 40, 0.35),
    LEAVES("needle", 2.4, 2, 55, 1.6, 0, 44, "spiral", 0, 2, 190),
    SHOOT(0.44, 0.40, 0.26),
    PERIDERM(4, 0.58, 0.37, 0.24),
    RHYTIDOME(12, 45, 0.37, 0.32, 0.29),
    FURROWS(18, 50, 120, 0.85),
    PLATES(0.35, 0.45, 0.5, 0.2),
    NUMBER("bark_turning", -1),
    TRIPLE("leaf_colour", 0.24, 0.36, 0.25)};
SPECIES(scots_pine, "Scots pine (Pinus sylvestris)",
        "Whorls, orange bark above grey-brown plates, short blue-green needles.", MITCHELL FARJON);

static const sozai_value douglas_fir[] = {
    HEIGHT(60, 0.022, 1.4),
    DIAMETER(1400, 0.014, 1.2),
    TURNING(1.6, 4.2, 0.3, 25, 25, 170),
    NUMBER("flush", 5),
    CROWN(0.29, 4, 0.24, 0.62, 0.5, 0.16),
    CROWN_LIFE(0.55, 40, 25),
    BRANCHES(45, -2, 15, 2500, 30, 6, 0.011),
    SHOOTS("2", 52, 950, 0.45, 0.7, 55, "flat", 0.06, 3000, -20, 0.3),
    SHOOTS("3", 40, 220, 0.5, 0.6, 48, "flat", 0.05, 0, -15, 0.25),
    LEAVES("needle", 1.6, 1, 25, 1.4, 0, 58, "spiral", 0, 2, 0),
    SHOOT(0.42, 0.38, 0.24),
    PERIDERM(5, 0.39, 0.38, 0.35),
    RHYTIDOME(18, 60, 0.33, 0.27, 0.23),
    FURROWS(38, 60, 250, 0.4),
    PLATES(0.25, 0.75, 0.3, 0.12),
    NUMBER("bark_shade", 0.65),
    TRIPLE("leaf_colour", 0.20, 0.34, 0.18)};
SPECIES(douglas_fir, "Douglas fir (Pseudotsuga menziesii)",
        "A tall cone of loose whorls with branches between them.",
        "Burns & Honkala 1990, Silvics of North America 1: growth; " FARJON);
