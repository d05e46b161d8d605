/* SPDX-License-Identifier: Apache-2.0 */
#include "entry.h"

#define SATAKE                                                                                     \
  "Satake et al. 1989, Wild Flowers of Japan: Woody Plants: habit, heights, leaves, bark, whose "  \
  "ages are ours; divergence by the golden angle where it is not measured"

/* Alternate leaves and branches stand about the golden angle apart. */
#define GOLDEN(turns, sd) TURNING(turns, 360.0 / 137.5, 0.4, sd, 60, 260)

static const sozai_value cherry[] = {
    HEIGHT(13, 0.06, 1.1),
    DIAMETER(700, 0.025, 1.1),
    STEM(1.0, 0.35, 0.03),
    GOLDEN(0.4, 40),
    NUMBER("flush", 1.2),
    CROWN(0.72, 5, 0.03, 0.45, 0.3, 0.15),
    CROWN_LIFE(0.68, 9, 1.5),
    BRANCHES(62, 32, 6, 4000, 8, 14, 0.024),
    FORKS(1200, 0.15, 0.9, 40),
    NUMBER("thickest", 0.72),
    SHOOTS("2", 160, 2600, 0.5, 0.45, 42, "random", 0.1, 2600, 14, 0.5),
    SHOOTS("3", 85, 620, 0.42, 0.45, 42, "random", 0.12, 0, 8, 0.45),
    LEAVES("blade", 34, 1, 95, 50, 0, 60, "spiral", 20, 3, 420),
    SHOOT(0.36, 0.27, 0.22),
    PERIDERM(4, 0.36, 0.27, 0.25),
    RHYTIDOME(35, 110, 0.29, 0.27, 0.26),
    FURROWS(5, 30, 60, 0.4),
    PLATES(0.4, 0, 0.6, 0.15),
    LENTICELS(3, 60, 6, 0.45),
    SCARS(4, 0.4, 0.35),
    TRIPLE("leaf_colour", 0.29, 0.43, 0.17)};
SPECIES(cherry, "Yamazakura (Prunus jamasakura)",
        "Mountain cherry: low limbs spread wide and rise.", SATAKE "; leaves 80 to 120 mm");

static const sozai_value cherry_paper[] = {
    NUMBER("age", 12),
    NUMBER("bark_depth", 0),
    NUMBER("leaf_variation", 0),
    HEIGHT(13, 0.06, 1.1),
    DIAMETER(700, 0.025, 1.1),
    STEM(1.0, 0.2, 0.03),
    GOLDEN(0.8, 40),
    NUMBER("flush", 1.2),
    CROWN(0.62, 5, 0.05, 0.5, 0.35, 0.22),
    CROWN_LIFE(0.7, 9, 2),
    BRANCHES(64, 30, 10, 4000, 4, 8, 0.024),
    NUMBER("thickest", 0.72),
    SHOOTS("2", 320, 2400, 0.45, 0.7, 45, "random", 0.2, 0, 0, 0.4),
    SHOOTS("3", 200, 1, 0, 0, 45, "random", 0, 0, 0, 0),
    LEAVES("ellipse", 60, 3, 100, 60, 0, 90, "flat", 50, 1, 0),
    SHOOT(0.36, 0.27, 0.22),
    PERIDERM(4, 0.36, 0.27, 0.25),
    RHYTIDOME(20, 60, 0.29, 0.27, 0.26),
    TRIPLE("leaf_colour", 0.29, 0.43, 0.17)};
SPECIES(cherry_paper, "Cherry, the paper's leaves",
        "Section 5.1 of the paper: three ellipses of 10 x 6 cm at sites every 6 cm, left and right "
        "in turn, 5 cm out, one square to the branch and two along it. For a field table.",
        "Hayashi & Takahashi 1997, section 5; its measured table is not printed");

static const sozai_value keyaki[] = {
    HEIGHT(25, 0.035, 1.2),
    DIAMETER(1100, 0.015, 1.1),
    STEM(1.0, 0.4, 0.02),
    GOLDEN(0.22, 30),
    NUMBER("flush", 1.2),
    CROWN(1.1, 6, 0.05, 0.8, 0.7, 0.14),
    CROWN_LIFE(0.8, 18, 1.5),
    BRANCHES(46, 32, -18, 6000, -6, 14, 0.02),
    FORKS(1300, 0.15, 0.9, 30),
    NUMBER("thickest", 0.75),
    SHOOTS("2", 115, 2600, 0.5, 0.2, 46, "random", 0.15, 3000, 6, 0.45),
    SHOOTS("3", 58, 650, 0.42, 0.4, 44, "flat", 0.15, 0, -12, 0.4),
    LEAVES("blade", 26, 1, 62, 26, 0, 58, "flat", 4, 3, 500),
    SHOOT(0.40, 0.28, 0.21),
    PERIDERM(5, 0.46, 0.43, 0.39),
    RHYTIDOME(30, 90, 0.46, 0.40, 0.34),
    FURROWS(3, 75, 65, 0.95),
    PLATES(0.65, 0, 0.2, 0.22),
    NUMBER("bark_shade", 0.3),
    TRIPLE("leaf_colour", 0.27, 0.42, 0.17)};
SPECIES(
    keyaki, "Keyaki (Zelkova serrata)",
    "A vase: limbs fan upwards from a short stem into fine twigs; smooth grey bark, old feet flake "
    "and are patched with orange-brown.",
    SATAKE);

static const sozai_value buna[] = {HEIGHT(28, 0.025, 1.3),
                                   DIAMETER(900, 0.013, 1.2),
                                   STEM(0.9, 0.35, 0.012),
                                   GOLDEN(0.5, 30),
                                   NUMBER("flush", 1.5),
                                   CROWN(0.62, 6, 0.08, 0.6, 0.45, 0.16),
                                   CROWN_LIFE(0.66, 30, 2),
                                   BRANCHES(60, 34, 10, 4000, 10, 12, 0.019),
                                   FORKS(1500, 0.15, 0.92, 36),
                                   NUMBER("thickest", 0.62),
                                   SHOOTS("2", 150, 2500, 0.5, 0.4, 48, "flat", 0.1, 3000, 10, 0.4),
                                   SHOOTS("3", 75, 520, 0.45, 0.4, 48, "flat", 0.12, 0, -4, 0.35),
                                   LEAVES("blade", 26, 1, 75, 42, 0, 60, "flat", 8, 3, 360),
                                   SHOOT(0.37, 0.29, 0.23),
                                   PERIDERM(4, 0.55, 0.55, 0.52),
                                   RHYTIDOME(60, 150, 0.58, 0.58, 0.55),
                                   NUMBER("bark_depth", 0),
                                   SCARS(6, 0.45, 0.28),
                                   TRIPLE("leaf_colour", 0.25, 0.42, 0.16)};
SPECIES(
    buna, "Buna (Fagus crenata)",
    "Japanese beech: a broad dome in layered sprays; its grey bark stays smooth and only pales.",
    SATAKE);

static const sozai_value mizunara[] = {
    HEIGHT(26, 0.025, 1.25),
    DIAMETER(1100, 0.012, 1.15),
    STEM(0.95, 0.4, 0.03),
    GOLDEN(0.3, 40),
    NUMBER("flush", 3),
    CROWN(0.62, 6, 0.06, 0.6, 0.45, 0.18),
    CROWN_LIFE(0.62, 26, 2),
    BRANCHES(58, 20, 6, 4000, 18, 20, 0.024),
    FORKS(1400, 0.12, 0.9, 45),
    NUMBER("thickest", 0.68),
    SHOOTS("2", 160, 2600, 0.5, 0.35, 50, "random", 0.1, 3000, 16, 0.55),
    SHOOTS("3", 95, 480, 0.45, 0.3, 48, "random", 0.2, 0, 16, 0.5),
    LEAVES("toothed", 24, 1, 125, 74, 0, 55, "spiral", 3, 3, 240),
    SHOOT(0.43, 0.36, 0.27),
    PERIDERM(5, 0.45, 0.42, 0.38),
    RHYTIDOME(12, 45, 0.40, 0.37, 0.34),
    FURROWS(18, 34, 220, 0.35),
    PLATES(0.25, 0.8, 0.3, 0.15),
    NUMBER("bark_shade", 0.65),
    TRIPLE("leaf_colour", 0.26, 0.39, 0.16)};
SPECIES(mizunara, "Mizunara (Quercus crispula)",
        "Japanese oak: stout crooked limbs, leaves bunched towards the shoots' ends.", SATAKE);

static const sozai_value shirakaba[] = {
    HEIGHT(22, 0.05, 1.15),
    DIAMETER(420, 0.028, 1.1),
    STEM(0.85, 0.15, 0.015),
    GOLDEN(1.1, 35),
    NUMBER("flush", 1.3),
    CROWN(0.32, 5, 0.15, 0.55, 0.45, 0.15),
    CROWN_LIFE(0.6, 22, 3),
    BRANCHES(64, 38, 12, 2500, -10, 8, 0.014),
    FORKS(1000, 0.15, 0.8, 35),
    SHOOTS("2", 110, 1100, 0.45, 0.45, 42, "random", 0.15, 0, -18, 0.4),
    SHOOTS("3", 60, 420, 0.5, 0.4, 45, "random", 0.1, 0, -35, 0.35),
    LEAVES("blade", 24, 1, 58, 46, 0, 62, "spiral", 22, 3, 320),
    SHOOT(0.33, 0.24, 0.20),
    PERIDERM(9, 0.86, 0.84, 0.79),
    RHYTIDOME(60, 170, 0.27, 0.25, 0.24),
    FURROWS(12, 40, 130, 0.6),
    PLATES(0.25, 0.4, 0.3, 0.15),
    NUMBER("bark_turning", 0.8),
    LENTICELS(2.5, 35, 4, 0.75),
    SCARS(6, 0.75, 0.9),
    TRIPLE("leaf_colour", 0.34, 0.48, 0.18)};
SPECIES(
    shirakaba, "Shirakaba (Betula platyphylla)",
    "Japanese white birch: a light white stem, brown twigs, ascending branches with hanging tips.",
    SATAKE);

static const sozai_value momiji[] = {
    HEIGHT(11, 0.05, 1.15),
    DIAMETER(420, 0.02, 1.1),
    STEM(1.0, 0.3, 0.05),
    TURNING(0.5, 2, 0.2, 14, 120, 240),
    NUMBER("flush", 1.3),
    CROWN(0.85, 4, 0.05, 0.75, 0.6, 0.16),
    CROWN_LIFE(0.84, 18, 1.5),
    BRANCHES(52, 36, 6, 3000, -20, 14, 0.022),
    FORKS(800, 0.12, 0.92, 46),
    NUMBER("thickest", 0.7),
    SHOOTS("2", 190, 1500, 0.5, 0.4, 44, "opposite", 0.1, 2000, -8, 0.4),
    SHOOTS("3", 80, 420, 0.45, 0.55, 42, "opposite", 0.12, 0, -12, 0.35),
    LEAVES("lobed", 40, 2, 55, 60, 0, 62, "opposite", 24, 3, 330),
    SHOOT(0.40, 0.37, 0.22),
    PERIDERM(8, 0.41, 0.40, 0.33),
    RHYTIDOME(25, 70, 0.46, 0.44, 0.41),
    FURROWS(2, 14, 145, 0.1),
    PLATES(0.2, 0.7, 0, 0.1),
    TRIPLE("leaf_colour", 0.36, 0.46, 0.17)};
SPECIES(momiji, "Iroha-momiji (Acer palmatum)",
        "Japanese maple: arching tiers of opposite shoots, leaves of five lobes.", SATAKE);
