/* SPDX-License-Identifier: Apache-2.0
 *
 * The parameters of paving and weather: a part of parameters.c, for its length.
 */
#ifndef SOZAI_STONE_PARAMETERS_LAID_H
#define SOZAI_STONE_PARAMETERS_LAID_H

#include "../layout/layout.h"

/* clang-format off */
#define NUMBER_(name, id_, label_, group_, unit_, low, high, soft_low, soft_high, usual, doc_) \
  static const sozai_parameter name = { \
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT, \
   .id = id_, .label = label_, .group = group_, .unit = unit_, .doc = doc_, \
   .hard_min = low, .hard_max = high, .soft_min = soft_low, .soft_max = soft_high, .default_number = {usual}}
#define COLOUR_(name, id_, label_, group_, r, g, b, doc_) \
  static const sozai_parameter name = { \
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR, \
   .id = id_, .label = label_, .group = group_, .unit = "", .doc = doc_, \
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {r, g, b}, .default_text = "sRGB"}

#define LAYOUT_ID_(kind, id, length, width, joint, doc) id,
#define LAYOUT_DOC_(kind, id, length, width, joint, doc) doc,
static const char *const laid_layout_choices[] = {LAYOUT_CATALOGUE(LAYOUT_ID_)};
static const char *const laid_layout_docs[] = {LAYOUT_CATALOGUE(LAYOUT_DOC_)};
static const sozai_parameter laid_layout = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "layout", .label = "Layout", .group = "layout", .unit = "",
   .doc = "How stones cover the plane: object space x, y is the ground, +z the stones' face, +x along the "
   "first course. Each is cut from a place of its own in the block, turned by quarters.",
   .choices = laid_layout_choices, .choice_docs = laid_layout_docs, .choice_count = COUNT(laid_layout_choices), .default_number = {0}};

NUMBER_(laid_hole_depth, "hole_depth", "Hole depth", "holes", "", 0, 2, 0, 1, 0.5,
        "Of holes, as a part of their size; shows in height.");
NUMBER_(laid_stone_length, "stone_length", "Stone length", "layout", "mm", 0, 100000, 0, 1500, 0,
        "Of a stone, joint to joint; 0: the usual of the layout.");
NUMBER_(laid_stone_width, "stone_width", "Stone width", "layout", "mm", 0, 100000, 0, 1000, 0,
        "Likewise.");
NUMBER_(laid_length_variation, "length_variation", "Length variation", "layout", "", 0, 0.9, 0, 0.6, 0.25,
        "strip, butcher, ashlar: how far lengths stray from the mean, relative.");
NUMBER_(laid_stagger, "stagger", "Stagger", "layout", "", 0, 0.5, 0, 0.5, 0.3,
        "running: how far a course is shifted against the last, of the length. strip, butcher, ashlar: how far apart the ends of neighbouring courses are, less the length variation.");
NUMBER_(laid_chevron_angle, "chevron_angle", "Chevron angle", "layout", "deg", 15, 75, 30, 60, 45,
        "chevron: of the blocks to the square across the strip.");
NUMBER_(laid_layout_rotation, "layout_rotation", "Layout rotation", "layout", "deg", -36000, 36000, -180, 180, 0,
        "The whole layout is turned about z, from x towards y.");
NUMBER_(laid_joint_width, "joint_width", "Joint width", "layout", "mm", -1, 1000, -1, 30, -1,
        "Between neighbours; -1: the usual of the layout.");
NUMBER_(laid_joint_depth, "joint_depth", "Joint depth", "layout", "mm", 0, 1000, 0, 20, 2,
        "Of what fills the joint, below the foot of the stones' edges.");
NUMBER_(laid_joint_grain, "joint_grain", "Joint grain", "layout", "mm", 0.05, 50, 0.2, 6, 0.5,
        "Of the sand or mortar that fills it: its grains shade it and roughen it.");
COLOUR_(laid_joint_colour, "joint_colour", "Joint colour", "layout", 0.45, 0.43, 0.4,
        "Of what fills the joint.");
NUMBER_(laid_joint_wander, "joint_wander", "Joint wander", "layout", "", 0, 0.15, 0, 0.1, 0,
        "How far joints stray from their line, of the stones' width: hand-cut setts 0.03 to 0.1.");
NUMBER_(laid_joint_divisions, "joint_divisions", "Joint divisions", "layout", "", 0.5, 8, 1, 6, 2,
        "Into how many parts the width of a stone is split, whose ends stray each by itself.");
NUMBER_(laid_corner_radius, "corner_radius", "Corner radius", "layout", "mm", 0, 1000, 0, 30, 0,
        "Of the corners, seen from above.");
NUMBER_(laid_bevel, "bevel", "Chamfer", "layout", "mm", 0, 1000, 0, 10, 0,
        "Width of the chamfered edge.");
NUMBER_(laid_bevel_angle, "bevel_angle", "Chamfer angle", "layout", "deg", 0, 80, 5, 60, 45,
        "Of the chamfer to the face.");
NUMBER_(laid_edge_round, "edge_round", "Rounded edge", "layout", "mm", 0, 1000, 0, 30, 0.8,
        "Width of the rounded edge, in from the joint.");
NUMBER_(laid_edge_drop, "edge_drop", "Edge drop", "layout", "mm", 0, 1000, 0, 15, 0.5,
        "How far the rounding falls to the joint.");
NUMBER_(laid_edge_chipping, "edge_chipping", "Edge chipping", "layout", "", 0, 1, 0, 1, 0,
        "How unevenly the edges have broken away: by how much of itself the rounded edge is wider here and narrower there.");
NUMBER_(laid_tilt, "tilt", "Tilt", "layout", "mm", 0, 200, 0, 6, 0,
        "How far the sides of a stone may stand above or below its middle.");
NUMBER_(laid_settle, "settle", "Settlement", "layout", "mm", 0, 200, 0, 8, 0,
        "How far a stone may have sunk, at most; the more, the fewer.");
NUMBER_(laid_crown, "crown", "Crown", "layout", "mm", -50, 200, 0, 12, 0,
        "How far a stone's middle stands above its sides, as of setts and cobbles.");
NUMBER_(laid_tone_spread, "tone_spread", "Tone spread", "layout", "", 0, 0.5, 0, 0.25, 0.06,
        "Standard deviation of brightness from stone to stone, relative.");
NUMBER_(laid_tint_spread, "tint_spread", "Tint spread", "layout", "", 0, 0.3, 0, 0.1, 0,
        "Standard deviation of warmth from stone to stone: of red up and blue down, relative.");
NUMBER_(laid_undulation, "undulation", "Undulation", "layout", "mm", 0, 1000, 0, 20, 0,
        "How far the ground beneath the paving rises and falls; shows in height, and where water stands.");
NUMBER_(laid_undulation_size, "undulation_size", "Undulation size", "layout", "mm", 10, 100000, 300, 5000, 1600,
        "Of its waves.");
NUMBER_(laid_wear, "wear", "Wear", "weather", "", 0, 1, 0, 1, 0,
        "Feet and wheels: rounds the edges, smooths the relief of the tops and polishes them.");
NUMBER_(laid_grime, "grime", "Grime", "weather", "", 0, 1, 0, 0.6, 0,
        "Dirt that gathers at the edges and in patches: how much of the stone it hides at most.");
NUMBER_(laid_moss, "moss", "Moss", "weather", "", 0, 1, 0, 1, 0,
        "0 none; at 0.5 most joints are grown over, at 1 much of the stones as well.");
NUMBER_(laid_moss_spread, "moss_spread", "Moss spread", "weather", "mm", 0.5, 1000, 2, 80, 18,
        "How far from the joint it grows onto the stone.");
NUMBER_(laid_moss_height, "moss_height", "Moss height", "weather", "mm", 0, 50, 0, 8, 2.5,
        "Of its cushions.");
COLOUR_(laid_moss_colour, "moss_colour", "Moss colour", "weather", 0.36, 0.42, 0.16,
        "Of the cushions' lighter parts.");
NUMBER_(laid_wet, "wet", "Wetness", "weather", "", 0, 1, 0, 1, 0,
        "A film of water: darker, deeper in colour, glossier. 0 dry, 1 streaming.");
NUMBER_(laid_water_level, "water_level", "Water level", "weather", "mm", -1000, 1000, -20, 10, -1000,
        "Height at which water stands, over the face of the stones; -1000: none.");

/* ---- the paper's tile -------------------------------------------------- */

static const char *const tile_pattern_choices[] = {"none", "cut", "igeta", "chidori"};
static const char *const tile_pattern_docs[] = {
   "colour alone, without end",
   "kiriishi, cut stone: one stone to a tile",
   "kumiishi or igeta: a stone in the middle, halves and quarters round it, four different stones to a tile",
   "chidori: cut stones, every other course shifted by half, two to a tile"};
static const sozai_parameter tile_pattern = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "paper_pattern", .label = "Pattern", .group = "paper", .unit = "",
   .doc = "colour_mode paper_rgb and paper_lightness: the paper's periodic tile of stones and joints "
   "on the plane x, y, whose relief then takes the place of the finish's.",
   .choices = tile_pattern_choices, .choice_docs = tile_pattern_docs, .choice_count = COUNT(tile_pattern_choices), .default_number = {0}};
static const sozai_parameter tile_length = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_INT,
   .id = "paper_length", .label = "Paper's stone length", .group = "paper", .unit = "texel",
   .doc = "Of a stone with its joint, along x; even.",
   .hard_min = 16, .hard_max = 1024, .soft_min = 64, .soft_max = 512, .default_number = {200}};
static const sozai_parameter tile_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_INT,
   .id = "paper_width", .label = "Paper's stone width", .group = "paper", .unit = "texel",
   .doc = "Likewise, along y.",
   .hard_min = 16, .hard_max = 1024, .soft_min = 64, .soft_max = 512, .default_number = {200}};
static const sozai_parameter tile_levels = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_INT,
   .id = "paper_levels", .label = "Levels", .group = "paper", .unit = "",
   .doc = "How often the square's two triangles are divided by their edges' midpoints, each level "
   "displaced with half the variance of the last: 3 gives 128 triangles, 4 gives 512.",
   .hard_min = 1, .hard_max = 4, .soft_min = 3, .soft_max = 4, .default_number = {4}};
NUMBER_(tile_dh, "paper_dh", "Fine roughness dh", "paper", "code", 0, 1024, 0, 128, 30,
        "H' = alpha (H + e dh), e uniform on 0 to 1 for each texel, H within 0 to 128, alpha such that the highest is 256.");
NUMBER_(tile_relief, "paper_relief", "Paper's relief", "paper", "mm", 0, 1000, 0, 20, 8,
        "Height of 256 codes.");
NUMBER_(tile_joint, "paper_joint", "Joint", "paper", "texel", 0, 200, 0, 20, 6,
        "Least width between neighbours.");
NUMBER_(tile_wander, "paper_joint_wander", "Paper's joint wander", "paper", "", 0, 0.2, 0, 0.1, 0.06,
        "Range in which each division point of a stone's outline lies further in, of the stone's width.");
static const sozai_parameter tile_parts = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_INT,
   .id = "paper_joint_parts", .label = "Joint parts", .group = "paper", .unit = "",
   .doc = "Equal parts into which each side's line is split.",
   .hard_min = 1, .hard_max = 16, .soft_min = 3, .soft_max = 12, .default_number = {8}};
NUMBER_(tile_repair, "paper_repair", "Repair", "paper", "texel", 1, 100, 1, 12, 4,
        "Width in from the outline over which the stone's height comes down to the joint's.");
NUMBER_(tile_joint_height, "paper_joint_height", "Joint height", "paper", "code", 0, 256, 0, 256, 0,
        "Of all joints.");
static const sozai_parameter tile_joint_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT3,
   .id = "paper_joint_colour", .label = "Paper's joint colour", .group = "paper", .unit = "code",
   .doc = "R, G and B of display-referred sRGB, 8 bits; rounded.",
   .hard_min = 0, .hard_max = 255, .soft_min = 0, .soft_max = 255, .default_number = {110, 105, 98}};
/* clang-format on */

#endif
