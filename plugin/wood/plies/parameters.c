/* SPDX-License-Identifier: Apache-2.0
 *
 * Wood's parameters of the group `plies`, as data. Terms after EN 313-2 (plywood,
 * classification and terminology).
 */
#include "parameters.h"

#include "../../core/count.h"

/* clang-format off */
static const char *const construction_choices[] = {"solid", "plywood", "lvl", "blockboard"};
static const char *const construction_docs[] = {
   "wood as it was sawn",
   "veneers glued crosswise: every other ply's grain runs across the faces'",
   "laminated veneer lumber: veneers of core_veneer glued with their grain along y, all of them",
   "strips of solid wood, core_width wide, between crossbands of core_veneer and the faces"};
const sozai_parameter plies_construction = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "construction", .label = "Construction", .group = "plies", .unit = "",
   .doc = "What a sheet or board is glued up from: z runs through it, and the faces' grain along +y, or along a "
   "layout's boards. Each ply is of a log of its own, whose radius is about cut_distance; cut and the other cut_ "
   "parameters are then not used.",
   .choices = construction_choices, .choice_docs = construction_docs,
   .choice_count = COUNT(construction_choices), .default_number = {0}};

const sozai_parameter plies_sheet_thickness = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "sheet_thickness", .label = "Sheet thickness", .group = "plies", .unit = "mm",
   .doc = "From face to back.",
   .hard_min = 0.5, .hard_max = 500, .soft_min = 3, .soft_max = 50, .default_number = {18}};

const sozai_parameter plies_sheets = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_INT,
   .id = "sheets", .label = "Sheets", .group = "plies", .unit = "",
   .doc = "That are glued one below the other. Beyond the first face and the last back their plies go on.",
   .hard_min = 1, .hard_max = 1000, .soft_min = 1, .soft_max = 20, .default_number = {1}};

const sozai_parameter plies_face_height = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "face_height", .label = "Height of the face", .group = "plies", .unit = "mm",
   .doc = "z of the face, from which the sheet goes down; for a board about the origin half of sheet_thickness.",
   .hard_min = -100000, .hard_max = 100000, .soft_min = -100, .soft_max = 100, .default_number = {0}};

const sozai_parameter plies_count = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_INT,
   .id = "plies", .label = "Plies", .group = "plies", .unit = "",
   .doc = "Of a sheet, odd for plywood; 0: as many as veneers of face_veneer and core_veneer fill it best. "
   "The core's share what the faces leave.",
   .hard_min = 0, .hard_max = 101, .soft_min = 0, .soft_max = 21, .default_number = {0}};

const sozai_parameter plies_face_veneer = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "face_veneer", .label = "Face veneer", .group = "plies", .unit = "mm",
   .doc = "Thickness of the face and the back, sanded.",
   .hard_min = 0.1, .hard_max = 20, .soft_min = 0.3, .soft_max = 4, .default_number = {1.2}};

const sozai_parameter plies_core_veneer = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "core_veneer", .label = "Core veneer", .group = "plies", .unit = "mm",
   .doc = "Thickness of the plies between them, nominal; of a blockboard's crossbands.",
   .hard_min = 0.2, .hard_max = 50, .soft_min = 0.6, .soft_max = 5, .default_number = {1.4}};

static const char *const face_cut_choices[] = {"rotary", "sliced", "quartered"};
static const char *const face_cut_docs[] = {
   "peeled off the turning log", "sliced flat off a flitch: cathedrals", "sliced along the radius: stripes"};
const sozai_parameter plies_face_cut = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "face_cut", .label = "Face's cut", .group = "plies", .unit = "",
   .doc = "How the veneer of face and back was cut; the core's is peeled.",
   .choices = face_cut_choices, .choice_docs = face_cut_docs,
   .choice_count = COUNT(face_cut_choices), .default_number = {0}};

const sozai_parameter plies_leaf_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "leaf_width", .label = "Leaf width", .group = "plies", .unit = "mm",
   .doc = "Of the pieces that face and back are joined from; 0: 2500 mm peeled, 180 mm sliced.",
   .hard_min = 0, .hard_max = 10000, .soft_min = 0, .soft_max = 2500, .default_number = {0}};

static const char *const match_choices[] = {"book", "slip", "random"};
static const char *const match_docs[] = {
   "every other leaf turned over, so that neighbours mirror each other", "all the same way up",
   "each of a log of its own"};
const sozai_parameter plies_leaf_match = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "leaf_match", .label = "Matching", .group = "plies", .unit = "",
   .doc = "How the leaves of a sliced face follow each other.",
   .choices = match_choices, .choice_docs = match_docs, .choice_count = COUNT(match_choices), .default_number = {0}};

const sozai_parameter plies_core_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "core_width", .label = "Core width", .group = "plies", .unit = "mm",
   .doc = "Of the pieces that the core's plies are laid from, or of a blockboard's strips; 0: 640 mm and 24 mm.",
   .hard_min = 0, .hard_max = 10000, .soft_min = 0, .soft_max = 1300, .default_number = {0}};

const sozai_parameter plies_core_gap = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "core_gap", .label = "Core gap", .group = "plies", .unit = "mm",
   .doc = "The widest gap between those pieces; most are much narrower, and half of them tight.",
   .hard_min = 0, .hard_max = 20, .soft_min = 0, .soft_max = 4, .default_number = {0}};

const sozai_parameter plies_lathe_checks = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "lathe_checks", .label = "Lathe checks", .group = "plies", .unit = "",
   .doc = "Depth of the deepest checks that the knife leaves in peeled veneer, of its thickness; 0 for none.",
   .hard_min = 0, .hard_max = 0.9, .soft_min = 0, .soft_max = 0.9, .default_number = {0.7}};

const sozai_parameter plies_glue_line = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "glue_line", .label = "Glue line", .group = "plies", .unit = "mm",
   .doc = "Thickness of the glue between plies.",
   .hard_min = 0, .hard_max = 2, .soft_min = 0, .soft_max = 0.3, .default_number = {0.08}};

const sozai_parameter plies_glue_unevenness = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "glue_unevenness", .label = "Glue unevenness", .group = "plies", .unit = "",
   .doc = "How far glue lines wander, swell and thin out; 0: they are straight and all alike.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.5}};

const sozai_parameter plies_glue_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "glue_colour", .label = "Glue colour", .group = "plies", .unit = "",
   .doc = "Of the glue with the wood that it has soaked: phenolic is dark brown, urea pale.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.36, 0.24, 0.17}, .default_text = "sRGB"};

const sozai_parameter plies_glue_step = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "glue_step", .label = "Glue step", .group = "plies", .unit = "mm",
   .doc = "How far the glue, which is harder, stands above the wood of a sanded edge; below 0, beneath it.",
   .hard_min = -1, .hard_max = 1, .soft_min = -0.05, .soft_max = 0.05, .default_number = {0.004}};
/* clang-format on */
