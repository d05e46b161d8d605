/* SPDX-License-Identifier: Apache-2.0
 *
 * In what settings effects.c tries each parameter, before it tries all presets: what a parameter
 * works on must be there. A new parameter that no preset shows wants a line here.
 */
#ifndef SOZAI_TESTS_EFFECTS_SETTINGS_H
#define SOZAI_TESTS_EFFECTS_SETTINGS_H

/* A preset, and values on top of it: "id=text; id=text". */
typedef struct {
  const char *texture, *preset, *values;
} setting;

/* those first that are soon made */
static const setting settings[] = {
    {"wood", "keyaki", ""},
    {"wood", "sugi", "grain=compound; cut=flat; curl_slope=0.2"},
    {"wood", "sugi", "cut=flat; quilt_slope=0.02"},
    {"wood", "sugi", "cut=flat; quilt_width=80; quilt_height=5"},
    {"wood", "itayakaede", "cut=rotary; eye_density=0.4"},
    {"wood", "mizunara", "tyloses=0.5; fine_ray_density=30; cell_contrast=1"},
    {"wood", "sugi", "age_years=5"},
    {"wood", "sugi", "reflection=fibre_cone; coat=0.5"},
    {"wood", "sugi", "surface=band_sawn"},
    {"wood", "sugi", "surface=circular_sawn"},
    {"wood", "sugi", "surface=hand_planed"},
    {"wood", "sugi", "surface=sanded"},
    {"wood", "sugi", "surface=brushed; erosion=1"},
    {"wood", "sugi", "surface=charred"},
    {"wood", "sugi", "surface=weathered; age_years=20"},
    {"wood", "sugi", "checks=1; end_checks=1; fibre_wear=1"},
    {"wood", "sugi", "age_years=20; erosion=1"},
    {"wood", "sugi", "layout=strip; bevel=2; joint_width=3; board_width=60; board_length=200"},
    {"wood", "sugi",
     "layout=herringbone; joint_width=3; board_width=60; board_length=200; cupping=1"},
    {"wood", "sugi", "layout=chevron; board_width=60; board_length=200"},
    {"wood", "sugi", "construction=plywood; sheet_thickness=3"},
    {"wood", "sugi", "construction=plywood; face_cut=sliced; leaf_width=40"},
    {"wood", "sugi", "construction=blockboard; core_width=16; sheet_thickness=50"},
    {"wood", "sugi", "construction=lvl"},
    {"wood", "onigurumi", "cut=flat"},
    {"wood", "onigurumi", "heartwood_years=20"},
    {"wood", "birdseye_maple", "cut=flat; eye_depth=0.2"},
    {"wood", "spalted_beech", "cut=flat"},
    {"wood", "karamatsu", "cut=flat"},
    {"wood", "makaba", "cut=flat"},
    {"wood", "sugi", "cut=flat; tree=sugi; tree_age=60; cut_distance=100; log_height=1500"},
    {"wood", "knotty_sugi", "cut=flat; cut_distance=30; knot_size=2"},
    {"stone", "inada", ""},
    {"stone", "inada", "colour_mode=paper_rgb; paper_black=0.2; paper_white=0.2"},
    {"stone", "inada", "colour_mode=paper_lightness; paper_texel=8; paper_base=150 110 80"},
    {"stone", "inada", "colour_mode=paper_lightness; paper_pattern=igeta; paper_joint_height=4"},
    {"stone", "inada", "layout=strip; stone_length=90; stone_width=40; bevel=2; joint_width=6"},
    {"stone", "inada", "layout=herringbone; stone_length=90; stone_width=30; moss=0.5"},
    {"stone", "inada", "layout=chevron; stone_length=90; stone_width=30; undulation=20"},
    {"stone", "inada",
     "vein_width=4; vein_spacing=20; bed_contrast=1; bed_thickness=5; mottle=0.4"},
    {"stone", "inada", "hole_share=0.3; hole_size=10; hole_fines=0.5"},
    {"stone", "inada",
     "inclusion_share=0.4; inclusion_second_share=0.4; inclusion_rim=0.1; inclusion_relief=1"},
    {"stone", "inada", "inclusion_share=0.4; inclusion_contact=tangential"},
    {"fiber", "felt", ""},
    {"fiber", "felt", "structure=woven"},
};

#endif
