/* SPDX-License-Identifier: Apache-2.0
 *
 * The tree's parameters, one line each:
 *   N(NAME, id, label, group, unit, hard min, hard max, soft min, soft max, default, doc)
 *   I(...) the same, a whole number
 *   C(NAME, id, label, group, choices, default index, doc)
 *   T(NAME, id, label, group, doc) text
 *   X3(NAME, id, label, group, three defaults, doc) a triple from 0 to 1
 * Lengths in mm but where the unit says m; angles in degrees.
 */
#ifndef SOZAI_TREE_PARAMETERS_H
#define SOZAI_TREE_PARAMETERS_H

#include "../../api/sozai.h"

/* clang-format off */
#define TREE_PARAMETERS(N, I, C, T, X3) \
 I(SEED, "seed", "Seed", "tree", "", 0, 4294967295.0, 0, 1000, 1, "Which tree of its kind.") \
 N(AGE, "age", "Age", "tree", "years", 1, 300, 1, 100, 20, "Years since it sprouted.") \
 I(ORDERS, "orders", "Orders", "tree", "", 0, 4, 1, 4, 4, "How far it is grown out: 1 branches on the stem, with the arms they fork into, 2 and 3 shoots, 4 needles or leaves.") \
 C(FOLIAGE, "foliage", "Foliage", "tree", foliage, 0, "What the leaves are.") \
 I(LEAVES_MOST, "leaves_most", "Most leaves", "tree", "", 1000, 50000000, 10000, 5000000, 1200000, "With foliage auto: above this number short needles are drawn as clothed shoots, and leaves and long needles fewer and larger, of the same area.") \
 T(FIELD, "field", "Field table", "field", "The text of a measured tree (docs/tree.md). It takes the place of stem and branches; what it lacks is grown.") \
 C(RESAMPLE, "resample", "Resample", "field", resample, 0, "What the field table is for.") \
 N(UPSLOPE, "upslope", "Upslope", "field", "deg", 0, 360, 0, 360, 0, "Azimuth that points up the slope: crown_a holds on that side, crown_a_down on the other.") \
 N(HEIGHT_MAX, "height_max", "Greatest height", "growth", "m", 0.1, 130, 2, 60, 30, "H(t) = height_max (1 - exp(-height_rate t))^height_shape (Richards).") \
 N(HEIGHT_RATE, "height_rate", "Height rate", "growth", "1/year", 0.001, 1, 0.01, 0.1, 0.03, "See height_max.") \
 N(HEIGHT_SHAPE, "height_shape", "Height shape", "growth", "", 0.5, 5, 0.8, 2, 1.4, "See height_max.") \
 N(GIRTH_MAX, "diameter_max", "Greatest diameter", "growth", "mm", 5, 10000, 100, 1500, 700, "Of the stem at the ground: D(t) = diameter_max (1 - exp(-diameter_rate t))^diameter_shape.") \
 N(GIRTH_RATE, "diameter_rate", "Diameter rate", "growth", "1/year", 0.001, 1, 0.01, 0.1, 0.02, "See diameter_max.") \
 N(GIRTH_SHAPE, "diameter_shape", "Diameter shape", "growth", "", 0.5, 5, 0.8, 2, 1.15, "See diameter_max.") \
 N(STEM_FORM, "stem_form", "Stem form", "growth", "", 0.3, 2, 0.5, 1.2, 0.8, "Radius falls as (1 - h / H)^stem_form.") \
 N(BUTT, "butt", "Butt swell", "growth", "", 0, 2, 0, 1, 0.3, "Added to the radius at the ground, as a share; gone at some three diameters up.") \
 N(SWAY, "sway", "Sway", "growth", "", 0, 0.3, 0, 0.1, 0.003, "How far the stem wanders, as a share of its height.") \
 N(TURNS, "turns_year", "Turns a year", "turning", "1/year", 0.1, 20, 0.1, 6, 3.19, "How often the branches of a year climb round the stem.") \
 N(BRANCHES, "branches_turn", "Branches a turn", "turning", "", 1, 12, 1.5, 6, 2.1, "How many branches in a turn; the mean divergence is 360 over it.") \
 N(TURN_SPREAD, "turning_spread", "Spread of turning", "turning", "", 0, 1, 0, 1, 1, "How much trees differ in the two: 1 as the 17 sugi of the paper's table 1.") \
 N(DIVERGENCE_SD, "divergence_sd", "Divergence, spread", "turning", "deg", 0, 150, 0, 90, 73, "Standard deviation of the angle from a branch to the next.") \
 N(DIVERGENCE_MIN, "divergence_min", "Divergence, least", "turning", "deg", 0, 359, 0, 180, 33, "Its least.") \
 N(DIVERGENCE_MAX, "divergence_max", "Divergence, greatest", "turning", "deg", 1, 360, 90, 360, 293, "Its greatest.") \
 C(AZIMUTH, "azimuth", "Azimuths", "turning", azimuth, 0, "How the branches follow one another round the stem.") \
 N(FLUSH, "flush", "Spring flush", "turning", "", 1, 20, 1, 5, 2, "How steeply height rises with turning in spring and how flat it ends in winter: 1 - (1 - u)^flush of the year's shoot.") \
 C(WHORL, "phyllotaxis", "Branches along a year", "turning", whorl, 0, "How the branches of a year stand.") \
 N(CROWN_A, "crown_a", "Crown a", "crown", "", 0.01, 3, 0.1, 1.2, 0.255, "Branch length over tree height is crown_a (1 - z)^crown_b, z the height over tree height; of a tree as tall as crown_height.") \
 N(CROWN_A_DOWN, "crown_a_down", "Crown a, downslope", "crown", "", 0, 3, 0, 0.8, 0, "The same on the downslope side; 0: as crown_a.") \
 N(CROWN_B, "crown_b", "Crown b", "crown", "", 0.05, 2, 0.2, 1, 0.5, "See crown_a.") \
 N(CROWN_B_OLD, "crown_b_old", "Crown b, old", "crown", "", 0.05, 2, 0.2, 1, 0.5, "What it falls to with age: less is flatter. Not above crown_b.") \
 N(CROWN_HEIGHT, "crown_height", "Height of crown a", "crown", "m", 0.1, 100, 1, 30, 3, "See crown_a.") \
 N(CROWN_NARROWING, "crown_narrowing", "Narrowing", "crown", "", 0, 0.5, 0, 0.5, 0.3, "a falls as height^-crown_narrowing: 0 keeps the form, 0.5 keeps r = a0 sqrt(x).") \
 N(CROWN_SCATTER, "crown_scatter", "Scatter", "crown", "", 0, 0.9, 0, 0.5, 0.15, "Standard deviation of branch length about the crown's curve, as a share.") \
 N(CROWN_RATIO, "crown_ratio", "Crown ratio", "crown", "", 0.05, 1, 0.2, 1, 0.5, "Live share of the height when mature; branches lower down die.") \
 N(CROWN_AGE, "crown_age", "Crown age", "crown", "years", 1, 300, 5, 80, 25, "How soon it comes to that.") \
 N(SHEDDING, "shedding", "Shedding", "crown", "years", 0, 200, 1, 40, 12, "How long a dead branch stays, about.") \
 N(ANGLE_TOP, "elevation_top", "Elevation at the top", "branches", "deg", -80, 88, 0, 80, 45, "Of the branches' base above the horizontal.") \
 N(ANGLE_LOW, "elevation_base", "Elevation at the crown's base", "branches", "deg", -80, 88, -30, 70, 5, "Likewise.") \
 N(DROOP, "droop", "Droop", "branches", "deg", -120, 120, -30, 60, 25, "How far it bends down along its first half, when as long as droop_length.") \
 N(DROOP_LENGTH, "droop_length", "Length of droop", "branches", "mm", 10, 50000, 500, 8000, 1500, "Shorter branches bend less in proportion.") \
 N(UPTURN, "upturn", "Upturn", "branches", "deg", -120, 160, -20, 80, 45, "How far it turns up again towards the tip.") \
 N(WANDER, "wander", "Wander", "branches", "deg", 0, 90, 0, 40, 6, "How crooked: how far it may turn aside every 180 or 300 mm, of which it keeps four fifths each time.") \
 N(SLENDER, "slenderness", "Slenderness", "branches", "", 0.001, 0.2, 0.005, 0.04, 0.013, "Diameter at the base over length, where the parent is thick enough.") \
 N(THICKEST, "thickest", "Thickest", "branches", "", 0.05, 0.95, 0.2, 0.9, 0.5, "Radius at the base over the parent's there, at most; what a missing thickness is.") \
 N(FORK_SPACING, "fork_spacing", "Fork spacing", "branches", "mm", 0, 20000, 0, 3000, 0, "How far apart a branch forks along it, about; at most 6 times. Its arms fork likewise, and theirs. 0: never.") \
 N(FORK_FROM, "fork_from", "Forks from", "branches", "", 0, 0.95, 0, 0.6, 0.15, "Share of a branch that does not fork, from its base.") \
 N(FORK_SHARE, "fork_share", "Fork share", "branches", "", 0.05, 1.2, 0.4, 1, 0.9, "Length of an arm over what its branch has left: drawn from 0.7 to 1.1 of this.") \
 N(FORK_ANGLE, "fork_angle", "Fork angle", "branches", "deg", 1, 120, 15, 70, 38, "From the branch to its arm, to one side and the other.") \
 N(SPACING_2, "spacing_2", "Spacing, 2nd order", "second order", "mm", 2, 5000, 10, 500, 50, "Along the branch.") \
 N(LENGTH_2, "length_2", "Length, 2nd order", "second order", "mm", 1, 30000, 20, 3000, 350, "At most.") \
 N(SHARE_2, "share_2", "Share, 2nd order", "second order", "", 0, 2, 0, 1, 0.5, "At most this share of the parent's length; 0: no such limit.") \
 N(TAPER_2, "taper_2", "Taper, 2nd order", "second order", "", 0, 3, 0, 1, 0.7, "Lengths fall towards the tip as (1 - s)^taper: 0 all alike, 0.5 a parabola.") \
 N(ANGLE_2, "angle_2", "Angle, 2nd order", "second order", "deg", 1, 120, 20, 90, 55, "Alpha, from the parent's direction.") \
 C(ROUND_2, "arrangement_2", "Arrangement, 2nd order", "second order", round, 1, "Beta, round the parent.") \
 N(BARE_2, "bare_2", "Bare, 2nd order", "second order", "", 0, 0.95, 0, 0.6, 0.05, "Share of the parent that bears none, from its base.") \
 N(ZONE_2, "zone_2", "Zone, 2nd order", "second order", "mm", 0, 30000, 0, 3000, 1500, "Only so far from the parent's tip; 0: everywhere.") \
 N(BEND_2, "bend_2", "Bend, 2nd order", "second order", "deg", -120, 120, -60, 60, 20, "Upwards, from base to tip.") \
 N(JITTER_2, "jitter_2", "Jitter, 2nd order", "second order", "", 0, 1, 0, 0.6, 0.2, "Of place, length and angles, as a share.") \
 N(SPACING_3, "spacing_3", "Spacing, 3rd order", "third order", "mm", 1, 2000, 5, 200, 22, "As of the second.") \
 N(LENGTH_3, "length_3", "Length, 3rd order", "third order", "mm", 1, 10000, 1, 1000, 110, "As of the second.") \
 N(SHARE_3, "share_3", "Share, 3rd order", "third order", "", 0, 2, 0, 1, 0.6, "As of the second.") \
 N(TAPER_3, "taper_3", "Taper, 3rd order", "third order", "", 0, 3, 0, 1, 0.5, "As of the second.") \
 N(ANGLE_3, "angle_3", "Angle, 3rd order", "third order", "deg", 1, 120, 20, 90, 45, "As of the second.") \
 C(ROUND_3, "arrangement_3", "Arrangement, 3rd order", "third order", round, 0, "As of the second.") \
 N(BARE_3, "bare_3", "Bare, 3rd order", "third order", "", 0, 0.95, 0, 0.6, 0.05, "As of the second.") \
 N(ZONE_3, "zone_3", "Zone, 3rd order", "third order", "mm", 0, 10000, 0, 1000, 0, "As of the second.") \
 N(BEND_3, "bend_3", "Bend, 3rd order", "third order", "deg", -120, 120, -60, 60, 25, "As of the second.") \
 N(JITTER_3, "jitter_3", "Jitter, 3rd order", "third order", "", 0, 1, 0, 0.5, 0.2, "As of the second.") \
 C(LEAF, "leaf", "Leaf", "leaves", leaf, 0, "Its shape.") \
 N(LEAF_SPACING, "leaf_spacing", "Leaf spacing", "leaves", "mm", 0.3, 500, 1, 100, 3, "From site to site along the shoot.") \
 I(LEAF_SITE, "leaves_site", "Leaves a site", "leaves", "", 1, 12, 1, 12, 1, "How many stand together.") \
 N(LEAF_LENGTH, "leaf_length", "Leaf length", "leaves", "mm", 0.5, 500, 3, 150, 10, "At most.") \
 N(LEAF_WIDTH, "leaf_width", "Leaf width", "leaves", "mm", 0.1, 300, 0.5, 100, 1.2, "Its greatest.") \
 N(LEAF_TAPER, "leaf_taper", "Leaf taper", "leaves", "", 0, 0.5, 0, 0.5, 0.5, "0: all of a length; 0.5: short at the shoot's tip by a parabola.") \
 N(LEAF_ANGLE, "leaf_angle", "Leaf angle", "leaves", "deg", 1, 120, 20, 90, 40, "Alpha, from the shoot's direction.") \
 C(LEAF_ROUND, "leaf_arrangement", "Leaf arrangement", "leaves", round, 0, "Beta, round the shoot.") \
 N(LEAF_STALK, "leaf_stalk", "Leaf stalk", "leaves", "mm", 0, 200, 0, 50, 0, "From the shoot to the blade.") \
 I(LEAF_FROM, "leaf_from", "Lowest order with leaves", "leaves", "", 1, 3, 1, 3, 2, "Shoots of this order and above bear leaves.") \
 N(LEAF_ZONE, "leaf_zone", "Leaf zone", "leaves", "mm", 0, 10000, 0, 1000, 0, "Only so far from the shoot's tip; 0: everywhere.") \
 X3(BARK_COLOUR, "bark_colour", "Bark", "colour", 0.40, 0.27, 0.21, "Of bark that is periderm, from periderm_age on. Display-referred sRGB, 0 to 1, as the others.") \
 X3(SHOOT_COLOUR, "shoot_colour", "Shoots", "colour", 0.33, 0.31, 0.18, "Of the year's shoots; what grows older turns to bark_colour.") \
 X3(LEAF_COLOUR, "leaf_colour", "Leaves", "colour", 0.22, 0.34, 0.15, "Of leaves and needles.") \
 X3(RHYTIDOME_COLOUR, "rhytidome_colour", "Old bark", "colour", 0.38, 0.31, 0.27, "Of bark that is rhytidome, dead outer bark, from rhytidome_age on: of an old stem's foot.") \
 N(LEAF_VARIATION, "leaf_variation", "Leaf variation", "colour", "", 0, 1, 0, 0.4, 0.15, "How far leaves are off leaf_colour at most, lighter or darker, as a share; half of it by shoots. Yellower or bluer by half as much.") \
 N(PERIDERM_AGE, "periderm_age", "Age of periderm", "colour", "years", 0, 100, 1, 20, 5, "Years until a shoot's skin has given way to periderm and bark has bark_colour.") \
 N(RHYTIDOME_FROM, "rhytidome_from", "Onset of rhytidome", "colour", "years", 0, 1000, 1, 100, 12, "Years until bark begins to turn from bark_colour to rhytidome_colour.") \
 N(RHYTIDOME_AGE, "rhytidome_age", "Age of rhytidome", "colour", "years", 0, 1000, 1, 200, 45, "Years until it has; before rhytidome_from: it turns all at once.") \
 N(BARK_DEPTH, "bark_depth", "Bark depth", "bark", "mm", 0, 200, 0, 40, 7, "From rhytidome's furrows up to its plates, where it is rhytidome_age old; 0: smooth. At most 0.16 of the stem's radius.") \
 N(BARK_WIDTH, "bark_width", "Bark width", "bark", "mm", 4, 1000, 10, 100, 20, "From furrow to furrow round the stem, the mean: of plates or strips.") \
 N(BARK_LENGTH, "bark_length", "Bark length", "bark", "mm", 4, 10000, 20, 500, 260, "And along it.") \
 N(BARK_PLATES, "bark_plates", "Bark plates", "bark", "", 0, 1, 0, 1, 0.4, "0: rounded ridges; 1: flat plates with narrow furrows between.") \
 N(BARK_JOINED, "bark_joined", "Bark joined", "bark", "", 0, 1, 0, 0.8, 0.2, "How many plates have grown together with each of their neighbours, as a share: larger and less regular ones.") \
 N(BARK_RIDGES, "bark_ridges", "Bark ridges", "bark", "", 0, 1, 0, 1, 0.85, "How much shallower cracks across the stem are than furrows along it: 0 plates, 1 ridges that run on.") \
 N(BARK_SCALES, "bark_scales", "Bark scales", "bark", "", 0, 1, 0, 1, 0.3, "How scaly plates are: in layers of which some have flaked off, each standing off a little at its lower end.") \
 N(BARK_VARIATION, "bark_variation", "Bark variation", "bark", "", 0, 1, 0, 0.5, 0.12, "How far plates and their scales are off the bark's colour at most, lighter or darker, as a share; and where it is turning to rhytidome, how far they are ahead or behind.") \
 N(BARK_SHADE, "bark_shade", "Bark shade", "bark", "", 0, 1, 0, 0.8, 0.5, "How much darker furrows' bottoms are than the highest plates, as a share of the mean.") \
 N(BARK_TURNING, "bark_turning", "Bark turning", "bark", "", -1, 1, -1, 1, 0, "Where bark turns to rhytidome first: in furrows at 1, as birch does; on plates at -1, as red pines do, between whose plates young bark shows; alike at 0.") \
 N(LENTICEL_DENSITY, "lenticel_density", "Lenticel density", "bark", "1/dm2", 0, 100, 0, 12, 0, "Of the bars of birch and cherry bark, on periderm; at most 3200 over lenticel_length and lenticel_height in mm. 0 for none.") \
 N(LENTICEL_LENGTH, "lenticel_length", "Lenticel length", "bark", "mm", 1, 300, 5, 80, 25, "Across the stem, of the longest; from half as much.") \
 N(LENTICEL_HEIGHT, "lenticel_height", "Lenticel height", "bark", "mm", 1, 50, 2, 10, 4, "Along it.") \
 N(LENTICEL_SHADE, "lenticel_shade", "Lenticel shade", "bark", "", 0, 1, 0, 0.9, 0.6, "How much darker they are than the bark about them, as a share. Stems 16 cm through and more show them, up to 0.4 of bark_reach.") \
 N(SCAR_WIDTH, "scar_width", "Scar width", "bark", "", 0, 20, 0, 10, 0, "Of the brows that branches leave on a grown stem's periderm, from tip to tip, when the branch left it: in diameters of the branch. The stem's growth draws them wider. 0 for none.") \
 N(SCAR_DROOP, "scar_droop", "Scar droop", "bark", "", 0, 3, 0, 1.5, 0.6, "How far a brow's ends hang below its middle, in halves of its width when the branch left; at most 27 cm.") \
 N(SCAR_SHADE, "scar_shade", "Scar shade", "bark", "", 0, 1, 0, 0.9, 0.6, "How much darker brows and wounds are than the bark about them, as a share. Stems 20 cm through at the foot and more show them, up to bark_reach.") \
 N(BARK_REACH, "bark_reach", "Bark reach", "bark", "m", 0, 130, 1, 20, 12, "Up to this height plates and furrows are cut into a mesh, from half of it less and less; above it bark is as thick as they are in the mean.")
/* clang-format on */

enum {
#define NAME_(name, ...) T_##name,
  TREE_PARAMETERS(NAME_, NAME_, NAME_, NAME_, NAME_)
#undef NAME_
      TREE_PARAMETER_COUNT
};

/* Choices, by index. */
#define FOLIAGE_AUTO 0
#define FOLIAGE_FULL 1
#define FOLIAGE_SPRIGS 2
#define FOLIAGE_NONE 3
#define RESAMPLE_MEASURED 0
#define RESAMPLE_SIBLING 1
#define AZIMUTH_TURNING 0
#define AZIMUTH_RANDOM 1
#define WHORL_SPIRAL 0
#define WHORL_WHORLS 1
#define ROUND_RANDOM 0
#define ROUND_FLAT 1
#define ROUND_SPIRAL 2
#define ROUND_OPPOSITE 3
#define LEAF_NEEDLE 0
#define LEAF_BLADE 1
#define LEAF_ELLIPSE 2
#define LEAF_LOBED 3
#define LEAF_TOOTHED 4

extern const sozai_parameter *const tree_parameters[TREE_PARAMETER_COUNT];

#endif
