/* SPDX-License-Identifier: Apache-2.0
 *
 * What is hashed beside every preset as it is: what presets leave off, so that each feature
 * has a line of its own. A name never changes its meaning; new ones go to the end.
 */
#ifndef SOZAI_TESTS_HASH_SETS_H
#define SOZAI_TESTS_HASH_SETS_H

typedef struct {
  const char *kind, *name, *preset; /* preset NULL: the parameters' own defaults */
  const char *values;               /* "id=text; id=text" */
} hash_set;

/* docs/tree.md says how to read it. */
#define FIELD                                                                                      \
  "trunk\n40 0 90 3\n38 20 87 2.6\n35 200 88\n30 0 90\nB1\n0\n20 40 30 1\n15 44 20\n"              \
  "B2\n0\n0\n14 220 35\nB3\n0\n0\n0\n9 110 40\nB11\n0\n0\n6 90 10\n"

static const hash_set texture_sets[] = {
    {"wood", "defaults", NULL, ""},
    {"wood", "grain", "keyaki", "grain=compound; curl_slope=0.1; quilt_slope=0.2; eye_density=2"},
    {"wood", "cone", "keyaki", "reflection=fibre_cone; coat=0.5; heartwood_years=12"},
    {"wood", "veneer", "sugi", "cut=rotary"},
    {"wood", "cut", "mizunara", "cut=rift; cut_rotation=33; cut_offset=3 0 -4"},
    {"wood", "charred", "sugi", "surface=charred; finish=oiled"},
    {"wood", "weathered", "sugi", "surface=weathered; age_years=9"},
    {"wood", "sawn", "hinoki", "surface=circular_sawn; mark_angle=40"},
    {"wood", "lacquered", "onigurumi", "surface=hand_planed; finish=lacquered"},
    {"wood", "streaks", "sugi", "streak_share=0.05; spalt=0.5"},
    {"wood", "knots", "sugi", "tree=sugi; tree_age=30; log_height=2000"},
    {"wood", "measured", NULL, "tree_field=" FIELD},
    {"wood", "parquet", "keyaki", "layout=herringbone; bevel=1; cupping=0.4; board_flip=random"},
    {"wood", "chevron", "mizunara", "layout=chevron; layout_rotation=17"},
    {"wood", "versailles", "keyaki", "layout=versailles; tree=keyaki"},
    {"wood", "plywood", "birch", "construction=plywood; face_height=9; core_gap=2; sheets=3"},
    {"wood", "lvl", "sugi", "construction=lvl; core_veneer=3; surface=sanded; tree=sugi"},
    {"wood", "blockboard", "oak", "construction=blockboard; face_cut=quartered; finish=oiled"},
    {"wood", "plied_floor", "oak", "construction=plywood; layout=strip; face_veneer=4; bevel=0.6"},
    {"stone", "defaults", NULL, ""},
    {"stone", "paper", NULL, "colour_mode=paper_rgb; paper_black=0.1; paper_white=0.1"},
    {"stone", "tile", NULL, "colour_mode=paper_lightness; paper_pattern=chidori"},
    {"stone", "veins", NULL, "vein_width=4; hole_share=0.05"},
    {"stone", "rims", "baltic_brown",
     "vein_width=6; vein_crossing=1; inclusion_gap=4; inclusion_grading=0.9"},
    {"stone", "split", NULL, "finish=split; bed=x"},
    {"stone", "paved", NULL, "layout=fan; joint_wander=0.05; tilt=2; edge_round=5; moss=0.4"},
    {"stone", "crazy", NULL, "layout=crazy; wear=0.5; wet=0.7; water_level=-2; bevel=2"},
    {"fiber", "defaults", NULL, ""},
    {"fiber", "standing", NULL, "elevation=45; flyaway=0.1; axis=z"},
    {"fiber", "woven", NULL, "weave=twill_2_2; axis=x"},
};

/* Geometry: each preset small, and these. */
static const hash_set geometry_sets[] = {
    {"tree", "defaults", NULL, "age=9"},
    {"tree", "stem", "sugi", "age=60; orders=1"},
    {"tree", "measured", NULL, "age=9; orders=2; field=" FIELD},
    {"tree", "sibling", NULL, "age=9; orders=2; resample=sibling; field=" FIELD},
    {"fiber", "defaults", NULL, "count=12; iterations=20; cells=16"},
    {"fiber", "exact", NULL, "count=12; iterations=20; cells=16; mode=exact"},
    {"fiber", "literal", NULL, "count=12; iterations=20; spacing=1; mode=literal"},
    {"fiber", "rigid", NULL, "count=40; iterations=20; cells=16; contact=rigid; diameter=900"},
    {"fiber", "bend", NULL, "count=40; iterations=20; cells=16; contact=bend; diameter=900"},
};

#endif
