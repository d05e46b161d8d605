/* SPDX-License-Identifier: Apache-2.0
 *
 * Wood's parameters and output channels, as data.
 */
#include "parameters.h"

#include "../core/count.h"
#include "plies/parameters.h"
#include "wood.h"

/* clang-format off */
static const sozai_parameter seed = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_INT,
   .id = "seed", .label = "Seed", .group = "tree", .unit = "",
   .doc = "Which tree: another seed is another tree of the same kind.",
   .hard_min = 0, .hard_max = 4294967295, .soft_min = 0, .soft_max = 1000, .default_number = {1}};

static const sozai_parameter object = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_TEXT,
   .id = "object", .label = "Object", .group = "tree", .unit = "",
   .doc = "A name that is mixed into the seed, so that each object is sawn from a tree of its "
   "own. Empty: the seed alone.",
   .default_text = ""};

static const char *const cut_choices[] = {"log", "flat", "quarter", "rift", "end", "rotary"};
static const char *const cut_docs[] = {
   "object space is log space: +y up the stem, the pith at x = z = 0",
   "flat-sawn: +y along the board, +z the face, square to the radius",
   "quarter-sawn: +y along the board, +x along the radius, +z the face",
   "rift-sawn: as flat, the rings at 45 degrees to the face",
   "end grain: +z, the face, looks up the stem",
   "veneer peeled off the turning log: +x along the sheet, +y up the stem, +z the face; it begins at cut_distance"};
static const sozai_parameter cut = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "cut", .label = "Cut", .group = "cut", .unit = "",
   .doc = "How the object's axes lie in the log.",
   .choices = cut_choices, .choice_docs = cut_docs, .choice_count = COUNT(cut_choices), .default_number = {0}};

static const sozai_parameter cut_distance = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "cut_distance", .label = "Distance from the pith", .group = "cut", .unit = "mm",
   .doc = "Of the object's origin from the pith; not for cut = log.",
   .hard_min = -5000, .hard_max = 5000, .soft_min = 0, .soft_max = 300, .default_number = {60}};

static const sozai_parameter cut_height = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "cut_height", .label = "Height in the stem", .group = "cut", .unit = "mm",
   .doc = "Of the object's origin above the section y = 0; not for cut = log.",
   .hard_min = -100000, .hard_max = 100000, .soft_min = 0, .soft_max = 4000, .default_number = {250}};

static const sozai_parameter cut_rotation = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "cut_rotation", .label = "Azimuth", .group = "cut", .unit = "deg",
   .doc = "The object is turned about the stem by this much.",
   .hard_min = -36000, .hard_max = 36000, .soft_min = -180, .soft_max = 180, .default_number = {0}};

static const sozai_parameter cut_offset = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT3,
   .id = "cut_offset", .label = "Offset", .group = "cut", .unit = "mm",
   .doc = "Added to the point in log space, after the turn; y is the height along the stem.",
   .hard_min = -100000, .hard_max = 100000, .soft_min = -1000, .soft_max = 1000, .default_number = {0, 0, 0}};

static const sozai_parameter cut_tilt = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "cut_tilt", .label = "Tilt of the cut", .group = "cut", .unit = "deg",
   .doc = "How far a board's length leans away from the stem's, towards its face: rings run out of a flat-sawn face in arches. For cut = flat, quarter and rift; in a layout, the standard deviation from board to board.",
   .hard_min = -45, .hard_max = 45, .soft_min = -3, .soft_max = 3, .default_number = {1}};

static const sozai_parameter cut_skew = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "cut_skew", .label = "Skew of the cut", .group = "cut", .unit = "deg",
   .doc = "How far a board's length leans away from the stem's within its face, towards +x: lines of a quarter-sawn face run askew to its edges. As cut_tilt otherwise.",
   .hard_min = -45, .hard_max = 45, .soft_min = -3, .soft_max = 3, .default_number = {0.3}};

static const sozai_parameter veneer_thickness = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "veneer_thickness", .label = "Veneer thickness", .group = "cut", .unit = "mm",
   .doc = "How much nearer to the pith the knife is after each turn of the log; for cut = rotary.",
   .hard_min = 0.1, .hard_max = 10, .soft_min = 0.5, .soft_max = 3, .default_number = {0.8}};

static const sozai_parameter ring_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "ring_width", .label = "Ring width", .group = "rings", .unit = "mm",
   .doc = "A year's growth, the mean.",
   .hard_min = 0.2, .hard_max = 30, .soft_min = 0.5, .soft_max = 12, .default_number = {2}};

static const sozai_parameter ring_variation = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "ring_variation", .label = "Ring variation", .group = "rings", .unit = "",
   .doc = "Standard deviation of ring width from year to year, relative to the mean.",
   .hard_min = 0, .hard_max = 0.6, .soft_min = 0, .soft_max = 0.5, .default_number = {0.25}};

static const sozai_parameter ring_widths = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_BUFFER,
   .id = "ring_widths", .label = "Measured ring widths", .group = "rings", .unit = "mm",
   .doc = "A table of one column: the width of each year's ring from the pith outwards, as in "
   "dendrochronology. It repeats when it is used up, and stands in for ring_width and "
   "ring_variation.",
   .buffer_kind = SOZAI_BUFFER_TABLE};

static const sozai_parameter outline = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "section_wobble", .label = "Section wobble", .group = "rings", .unit = "",
   .doc = "How far the rings depart from circles, relative to their radius: the largest sum of "
   "the outline's three harmonics.",
   .hard_min = 0, .hard_max = 0.3, .soft_min = 0, .soft_max = 0.15, .default_number = {0.04}};

static const sozai_parameter undulation = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "undulation", .label = "Undulation", .group = "rings", .unit = "mm",
   .doc = "Local waviness of the growth front, away from y = 0; at most 0.09 of "
   "undulation_size.",
   .hard_min = 0, .hard_max = 10, .soft_min = 0, .soft_max = 3, .default_number = {0.8}};

static const sozai_parameter undulation_size = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "undulation_size", .label = "Undulation size", .group = "rings", .unit = "mm",
   .doc = "Size of that waviness across the stem; along it, it is 3 times as long.",
   .hard_min = 5, .hard_max = 400, .soft_min = 10, .soft_max = 100, .default_number = {34}};

static const sozai_parameter taper = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "taper", .label = "Taper", .group = "rings", .unit = "mm/m",
   .doc = "How much nearer to the pith a ring of 100 mm radius is for each metre up the stem.",
   .hard_min = -50, .hard_max = 50, .soft_min = 0, .soft_max = 20, .default_number = {6}};

static const sozai_parameter pith_wander = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "pith_wander", .label = "Pith wander", .group = "rings", .unit = "mm",
   .doc = "How far the pith strays from a straight line, over waves of 0.9 m.",
   .hard_min = 0, .hard_max = 100, .soft_min = 0, .soft_max = 40, .default_number = {14}};

static const sozai_parameter late_fraction = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "latewood_fraction", .label = "Latewood fraction", .group = "season", .unit = "",
   .doc = "Share of a ring after the point where its tissue is half way to latewood.",
   .hard_min = 0.01, .hard_max = 0.95, .soft_min = 0.05, .soft_max = 0.6, .default_number = {0.3}};

static const sozai_parameter late_abruptness = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "latewood_abruptness", .label = "Latewood abruptness", .group = "season", .unit = "",
   .doc = "From earlywood to latewood: 0 gradual, 1 abrupt.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.5}};

static const sozai_parameter late_variation = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "latewood_variation", .label = "Latewood variation", .group = "season", .unit = "",
   .doc = "How much paler than the darkest the latewood of a year may be.",
   .hard_min = 0, .hard_max = 0.9, .soft_min = 0, .soft_max = 0.7, .default_number = {0.3}};

static const sozai_parameter late_deepening = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "latewood_deepening", .label = "Latewood deepening", .group = "season", .unit = "",
   .doc = "How much paler latewood is where it begins than at the ring's end, towards which its cells go on flattening: 0 alike throughout.",
   .hard_min = 0, .hard_max = 0.5, .soft_min = 0, .soft_max = 0.4, .default_number = {0}};

static const sozai_parameter late_stray = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "latewood_stray", .label = "Latewood stray", .group = "season", .unit = "mm",
   .doc = "How far the latewood of single bundles of fibres strays from its ring's, at most: edges of flat-sawn rings are ragged along the grain. At most a quarter of ring_width.",
   .hard_min = 0, .hard_max = 2, .soft_min = 0, .soft_max = 0.3, .default_number = {0}};

static const char *const grain_choices[] = {"straight", "spiral", "wavy", "interlocked", "compound"};
static const char *const grain_docs[] = {
   "no slope but its variation",
   "spiral_slope",
   "the wave_ parameters",
   "the interlocked_ parameters",
   "the sum of all three"};
static const sozai_parameter grain = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "grain", .label = "Grain", .group = "grain", .unit = "",
   .doc = "Which of the slopes below act; their variation always does.",
   .choices = grain_choices, .choice_docs = grain_docs, .choice_count = COUNT(grain_choices), .default_number = {0}};

static const sozai_parameter spiral_slope = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "spiral_slope", .label = "Spiral slope", .group = "grain", .unit = "",
   .doc = "Slope of the fibres round the stem, r dtheta/dy: 0.12 is 6.8 degrees.",
   .hard_min = -1, .hard_max = 1, .soft_min = -0.3, .soft_max = 0.3, .default_number = {0.12}};

static const sozai_parameter wave_slope = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "wave_slope", .label = "Wave slope", .group = "grain", .unit = "",
   .doc = "Greatest slope of wavy grain; where it is irregular, of a strong wave.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 0.4, .default_number = {0.2}};

static const sozai_parameter wave_length = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "wave_length", .label = "Wavelength", .group = "grain", .unit = "mm",
   .doc = "Of wavy grain, along the stem.",
   .hard_min = 1, .hard_max = 1000, .soft_min = 5, .soft_max = 80, .default_number = {40}};

static const sozai_parameter wave_irregularity = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "wave_irregularity", .label = "Wave irregularity", .group = "grain", .unit = "",
   .doc = "How far the waves are from a perfect sine, which 0 is: their spacing and strength "
   "change along the stem and from year to year, they lean, fade, fork and end.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter wave_reach = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "wave_reach", .label = "Wave reach", .group = "grain", .unit = "mm",
   .doc = "How far along the radius an irregular wave keeps its strength and place.",
   .hard_min = 1, .hard_max = 10000, .soft_min = 10, .soft_max = 200, .default_number = {40}};

static const sozai_parameter interlocked_slope = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "interlocked_slope", .label = "Interlocked slope", .group = "grain", .unit = "",
   .doc = "Greatest slope of interlocked grain, to one side and then to the other.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 0.3, .default_number = {0.12}};

static const sozai_parameter interlocked_years = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "interlocked_years", .label = "Interlocked period", .group = "grain", .unit = "years",
   .doc = "Years from one side to the other and back.",
   .hard_min = 1, .hard_max = 500, .soft_min = 4, .soft_max = 40, .default_number = {20}};

static const sozai_parameter interlocked_length = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "interlocked_length", .label = "Interlocked length", .group = "grain", .unit = "mm",
   .doc = "Along the stem: the slopes also change sides slowly, over this length, which bounds "
   "the shear between years.",
   .hard_min = 100, .hard_max = 100000, .soft_min = 500, .soft_max = 5000, .default_number = {600}};

static const sozai_parameter interlocked_irregularity = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "interlocked_irregularity", .label = "Interlocked irregularity", .group = "grain",
   .unit = "",
   .doc = "How much the years from side to side differ, how steep each of them is, and where along "
   "the stem it changes sides; 0 is a perfect sine.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter slope_noise = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "slope_noise", .label = "Slope variation", .group = "grain", .unit = "",
   .doc = "The greatest departure of the slope from its pattern; continuous along the stem and "
   "from year to year.",
   .hard_min = 0, .hard_max = 0.2, .soft_min = 0, .soft_max = 0.08, .default_number = {0.02}};

static const sozai_parameter slope_noise_length = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "slope_noise_length", .label = "Variation length", .group = "grain", .unit = "mm",
   .doc = "Length of that variation along the stem.",
   .hard_min = 5, .hard_max = 2000, .soft_min = 10, .soft_max = 300, .default_number = {70}};

static const sozai_parameter curl_slope = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "curl_slope", .label = "Curl slope", .group = "grain", .unit = "",
   .doc = "Greatest slope of the fibres in and out, in waves that the rings follow; where they are "
   "irregular, of a strong one. The radial half of curly and fiddleback figure, wave_slope being "
   "the tangential. At most 0.8 times curl_reach over curl_length and a factor from 0 to 4.9 that "
   "grows with curl_irregularity. 0 for none.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 0.4, .default_number = {0}};

static const sozai_parameter curl_length = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "curl_length", .label = "Curl length", .group = "grain", .unit = "mm",
   .doc = "Of those waves, along the stem.",
   .hard_min = 1, .hard_max = 1000, .soft_min = 4, .soft_max = 60, .default_number = {12}};

static const sozai_parameter curl_irregularity = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "curl_irregularity", .label = "Curl irregularity", .group = "grain", .unit = "",
   .doc = "How far the waves are from a perfect sine, which 0 is: their spacing and strength "
   "change, they lean, fade, fork and end.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.5}};

static const sozai_parameter curl_reach = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "curl_reach", .label = "Curl reach", .group = "grain", .unit = "mm",
   .doc = "How far across the stem an irregular wave keeps its strength and place.",
   .hard_min = 1, .hard_max = 10000, .soft_min = 10, .soft_max = 200, .default_number = {45}};

static const sozai_parameter quilt_slope = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "quilt_slope", .label = "Quilt slope", .group = "grain", .unit = "",
   .doc = "Slope of the fibres over the pillows of quilted figure, root mean square; at most 0.117 "
   "times quilt_width over quilt_height. 0 for none.",
   .hard_min = 0, .hard_max = 0.5, .soft_min = 0, .soft_max = 0.25, .default_number = {0}};

static const sozai_parameter quilt_height = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "quilt_height", .label = "Quilt height", .group = "grain", .unit = "mm",
   .doc = "Of the pillows, along the stem.",
   .hard_min = 1, .hard_max = 400, .soft_min = 5, .soft_max = 60, .default_number = {14}};

static const sozai_parameter quilt_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "quilt_width", .label = "Quilt width", .group = "grain", .unit = "mm",
   .doc = "Of the pillows, across the stem.",
   .hard_min = 1, .hard_max = 400, .soft_min = 5, .soft_max = 80, .default_number = {28}};

static const sozai_parameter eye_density = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "eye_density", .label = "Eye density", .group = "grain", .unit = "1/cm2",
   .doc = "Bird's eyes to an area of the tangential face; at most 32 over the square of "
   "eye_diameter in mm. 0 for none.",
   .hard_min = 0, .hard_max = 30, .soft_min = 0, .soft_max = 2, .default_number = {0}};

static const sozai_parameter eye_diameter = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "eye_diameter", .label = "Eye diameter", .group = "grain", .unit = "mm",
   .doc = "Of a bird's eye's dimple, across the stem, the mean; from 0.35 to 1.5 times as much. Its stain is half "
   "as wide.",
   .hard_min = 0.3, .hard_max = 40, .soft_min = 1, .soft_max = 8, .default_number = {3.5}};

static const sozai_parameter eye_depth = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "eye_depth", .label = "Eye depth", .group = "grain", .unit = "",
   .doc = "Of its dimple in the rings, over its radius; at most eye_length over 17.5 times eye_diameter.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 0.8, .default_number = {0.4}};

static const sozai_parameter eye_length = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "eye_length", .label = "Eye length", .group = "grain", .unit = "mm",
   .doc = "How far an eye goes on along the radius, at most.",
   .hard_min = 5, .hard_max = 500, .soft_min = 20, .soft_max = 150, .default_number = {60}};

static const sozai_parameter tree = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_TEXT,
   .id = "tree", .label = "Tree", .group = "knots", .unit = "",
   .doc = "A species of tree, whose branches are this wood's knots: an id of `sozai describe tree`. It grows from `seed` to `tree_age`. Empty: no knots but those of tree_field or of the table knots.",
   .default_text = ""};

static const sozai_parameter tree_age = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "tree_age", .label = "Age of the tree", .group = "knots", .unit = "years",
   .doc = "Years since it sprouted, when it was felled.",
   .hard_min = 1, .hard_max = 300, .soft_min = 5, .soft_max = 120, .default_number = {45}};

static const sozai_parameter tree_field = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_TEXT,
   .id = "tree_field", .label = "Field table", .group = "knots", .unit = "",
   .doc = "The text of a measured tree (docs/tree.md), whose branches are the knots; with `tree`, of that species.",
   .default_text = ""};

static const sozai_parameter tree_rings = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_BOOL,
   .id = "tree_rings", .label = "Rings of the tree", .group = "knots", .unit = "",
   .doc = "The tree's yearly growth at log_height gives the widths of the rings, in place of ring_width; ring_variation varies them.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {1}};

static const sozai_parameter log_height = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "log_height", .label = "Height of the log", .group = "knots", .unit = "mm",
   .doc = "Where on the stem the log's y = 0 lies. Below the live crown knots are dead, or have been grown over.",
   .hard_min = 0, .hard_max = 100000, .soft_min = 0, .soft_max = 15000, .default_number = {3000}};

static const sozai_parameter knots = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_BUFFER,
   .id = "knots", .label = "Knots", .group = "knots", .unit = "",
   .doc = "A table of knots in place of a tree: the columns of the generator tree's table of that name (branch, birth, death, shed, azimuth, inclination, height, radius, first, count).",
   .buffer_kind = SOZAI_BUFFER_TABLE};

static const sozai_parameter knot_radii = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_BUFFER,
   .id = "knot_radii", .label = "Radii of the knots", .group = "knots", .unit = "",
   .doc = "With knots: their radii from year to year (knot, year, radius). Without it they slow down by half.",
   .buffer_kind = SOZAI_BUFFER_TABLE};

static const sozai_parameter stem_rings = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_BUFFER,
   .id = "stem_rings", .label = "Rings of the stem", .group = "knots", .unit = "",
   .doc = "With knots: the stem's radius by year and height (year, height, radius). Without it the rings are those of ring_width.",
   .buffer_kind = SOZAI_BUFFER_TABLE};

static const sozai_parameter knot_size = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "knot_size", .label = "Knot size", .group = "knots", .unit = "",
   .doc = "Factor of the knots' radii.",
   .hard_min = 0.1, .hard_max = 3, .soft_min = 0.5, .soft_max = 2, .default_number = {1}};

static const sozai_parameter knot_collar = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "knot_collar", .label = "Knot collar", .group = "knots", .unit = "",
   .doc = "How far the rings about a knot bend out to it: 1 by two fifths of its radius at its sides, and by all of it above and below.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {1}};

static const sozai_parameter knot_grain = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "knot_grain", .label = "Knot grain", .group = "knots", .unit = "",
   .doc = "How far the fibres part round a knot: 0 not, 1 wholly.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {1}};

static const sozai_parameter knot_bark = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "knot_bark", .label = "Knot bark", .group = "knots", .unit = "mm",
   .doc = "Thickness of the bark that a dead knot sits in.",
   .hard_min = 0, .hard_max = 10, .soft_min = 0, .soft_max = 4, .default_number = {0.8}};

static const sozai_parameter knot_checks = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "knot_checks", .label = "Knot checks", .group = "knots", .unit = "",
   .doc = "How far knots have split in drying: 1, by a twelfth of their radius.",
   .hard_min = 0, .hard_max = 2, .soft_min = 0, .soft_max = 1, .default_number = {0.4}};

static const sozai_parameter knot_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "knot_colour", .label = "Knot colour", .group = "knots", .unit = "",
   .doc = "Of a knot's earlywood; its latewood has three fifths of it. Knots are up to a quarter darker or lighter than each other.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.65, 0.37, 0.18},
   .default_text = "sRGB"};

static const sozai_parameter knot_stain = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "knot_stain", .label = "Knot stain", .group = "knots", .unit = "",
   .doc = "From the wood's own colour, 0, to knot_colour, 1.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.7}};

static const sozai_parameter knot_bark_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "knot_bark_colour", .label = "Knot bark colour", .group = "knots", .unit = "",
   .doc = "Of the bark about a dead knot.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.20, 0.12, 0.07},
   .default_text = "sRGB"};

static const char *const porosity_choices[] = {"none", "diffuse", "semi_ring", "ring"};
static const char *const porosity_docs[] = {
   "no vessels: a conifer",
   "vessels alike across the ring",
   "vessels shrinking from earlywood to latewood",
   "rows of large vessels in the earlywood, small ones elsewhere"};
static const sozai_parameter porosity = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "porosity", .label = "Porosity", .group = "vessels", .unit = "",
   .doc = "How the vessels lie within a ring.",
   .choices = porosity_choices, .choice_docs = porosity_docs, .choice_count = COUNT(porosity_choices), .default_number = {1}};

static const sozai_parameter pore_density = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "vessel_density", .label = "Vessel density", .group = "vessels", .unit = "1/mm2",
   .doc = "Vessels to an area of cross-section; in ring-porous wood those outside the rows.",
   .hard_min = 0.1, .hard_max = 400, .soft_min = 1, .soft_max = 200, .default_number = {25}};

static const sozai_parameter pore_diameter = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "vessel_diameter", .label = "Vessel diameter", .group = "vessels", .unit = "um",
   .doc = "Mean diameter at the ring's start.",
   .hard_min = 5, .hard_max = 600, .soft_min = 15, .soft_max = 400, .default_number = {90}};

static const sozai_parameter pore_diameter_late = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "vessel_diameter_late", .label = "Vessel diameter, late", .group = "vessels", .unit = "um",
   .doc = "Mean diameter at the ring's end; for semi_ring only.",
   .hard_min = 5, .hard_max = 600, .soft_min = 20, .soft_max = 400, .default_number = {60}};

static const sozai_parameter pore_spread = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "vessel_diameter_spread", .label = "Vessel spread", .group = "vessels", .unit = "",
   .doc = "Standard deviation of the diameter, relative to its mean; normally distributed, and "
   "nothing below a fifth of the mean.",
   .hard_min = 0, .hard_max = 0.4, .soft_min = 0, .soft_max = 0.35, .default_number = {0.18}};

static const char *const arrangement_choices[] = {"even", "tangential", "radial", "diagonal",
                                                  "dendritic"};
static const char *const arrangement_docs[] = {
   "spread evenly",
   "in wavy bands along the rings, as elm's (IAWA feature 6)",
   "in files along the rays (7)",
   "in oblique files (7)",
   "in flames that fork towards the ring's end, as oak's (8)"};
static const sozai_parameter arrangement = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "vessel_arrangement", .label = "Vessel arrangement", .group = "vessels", .unit = "",
   .doc = "How the vessels outside the rows lie together on the cross-section.",
   .choices = arrangement_choices, .choice_docs = arrangement_docs, .choice_count = COUNT(arrangement_choices), .default_number = {0}};

static const sozai_parameter bands = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "vessel_bands", .label = "Vessel bands", .group = "vessels", .unit = "",
   .doc = "Share of those vessels that stand in the arrangement; the others are spread evenly.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.9}};

static const sozai_parameter band_spacing = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "vessel_band_spacing", .label = "Vessel band spacing", .group = "vessels", .unit = "mm",
   .doc = "From one band, file or flame to the next; of tangential ones a ring holds a whole number.",
   .hard_min = 0.1, .hard_max = 10, .soft_min = 0.2, .soft_max = 3, .default_number = {0.6}};

static const sozai_parameter band_stray = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "vessel_band_waviness", .label = "Vessel band waviness", .group = "vessels", .unit = "",
   .doc = "How far bands stray from their course, with bundles of fibres, in their spacing.",
   .hard_min = 0, .hard_max = 2, .soft_min = 0, .soft_max = 1, .default_number = {0.4}};

static const sozai_parameter rows = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_INT,
   .id = "earlywood_rows", .label = "Earlywood rows", .group = "vessels", .unit = "",
   .doc = "Rows of large vessels at the start of a ring; for ring only.",
   .hard_min = 0, .hard_max = 6, .soft_min = 1, .soft_max = 4, .default_number = {1}};

static const sozai_parameter row_density = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "earlywood_density", .label = "Earlywood density", .group = "vessels", .unit = "1/mm",
   .doc = "Vessels of a row to a length of arc.",
   .hard_min = 0.2, .hard_max = 30, .soft_min = 1, .soft_max = 8, .default_number = {2.8}};

static const sozai_parameter row_diameter = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "earlywood_diameter", .label = "Earlywood diameter", .group = "vessels", .unit = "um",
   .doc = "Mean diameter of the earlywood's vessels.",
   .hard_min = 10, .hard_max = 800, .soft_min = 100, .soft_max = 400, .default_number = {230}};

static const sozai_parameter row_spread = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "earlywood_diameter_spread", .label = "Earlywood spread", .group = "vessels", .unit = "",
   .doc = "Standard deviation of that diameter, relative to its mean; normally distributed, and "
   "nothing below a fifth of the mean.",
   .hard_min = 0, .hard_max = 0.4, .soft_min = 0, .soft_max = 0.35, .default_number = {0.15}};

static const sozai_parameter row_jitter = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "earlywood_jitter", .label = "Earlywood jitter", .group = "vessels", .unit = "",
   .doc = "How far a vessel may stray from even spacing along its row: 1 is the whole spacing.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.5}};

static const sozai_parameter marginal = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "marginal_parenchyma", .label = "Marginal parenchyma", .group = "parenchyma", .unit = "um",
   .doc = "Width of the pale line at a ring's end (IAWA feature 89), at most half the ring; 0 for none.",
   .hard_min = 0, .hard_max = 2000, .soft_min = 0, .soft_max = 300, .default_number = {0}};

static const sozai_parameter sheath = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "paratracheal_parenchyma", .label = "Paratracheal parenchyma", .group = "parenchyma", .unit = "um",
   .doc = "Thickness of the pale sheath about each vessel outside the earlywood's rows (79), the mean; at most as far as "
   "half-way to the next vessel. 0 for none.",
   .hard_min = 0, .hard_max = 1000, .soft_min = 0, .soft_max = 150, .default_number = {0}};

static const sozai_parameter wings = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "paratracheal_wings", .label = "Paratracheal wings", .group = "parenchyma", .unit = "",
   .doc = "How much farther vessel and sheath reach round the stem than along the radius: 1 for a sheath alike all round, "
   "2 for lozenges and wings (80), more where they run together (83).",
   .hard_min = 1, .hard_max = 10, .soft_min = 1, .soft_max = 5, .default_number = {1}};

static const sozai_parameter between = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "vessel_band_parenchyma", .label = "Vessel band parenchyma", .group = "parenchyma", .unit = "",
   .doc = "How much of the tissue between the vessels of a band, file or flame is parenchyma and as pale; for a "
   "vessel_arrangement other than even.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter soft_band_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "parenchyma_band_width", .label = "Parenchyma band width", .group = "parenchyma", .unit = "um",
   .doc = "Of pale bands along the rings that stand by themselves (85, 86), the mean; at most nine tenths of "
   "their spacing. 0 for none.",
   .hard_min = 0, .hard_max = 4000, .soft_min = 0, .soft_max = 500, .default_number = {0}};

static const sozai_parameter soft_band_spacing = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "parenchyma_band_spacing", .label = "Parenchyma band spacing", .group = "parenchyma", .unit = "mm",
   .doc = "From one of those bands to the next, the mean: a ring holds a whole number.",
   .hard_min = 0.02, .hard_max = 20, .soft_min = 0.1, .soft_max = 4, .default_number = {0.5}};

static const sozai_parameter soft_band_stray = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "parenchyma_band_waviness", .label = "Parenchyma band waviness", .group = "parenchyma", .unit = "",
   .doc = "How far those bands stray from their course, and swell and thin out, with bundles of fibres: in their "
   "spacing.",
   .hard_min = 0, .hard_max = 2, .soft_min = 0, .soft_max = 1, .default_number = {0.3}};

static const sozai_parameter soft_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "parenchyma_colour", .label = "Parenchyma colour", .group = "parenchyma", .unit = "",
   .doc = "Of that tissue in heartwood.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.86, 0.74, 0.56}, .default_text = "sRGB"};

static const sozai_parameter sap_soft = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "sapwood_parenchyma_colour", .label = "Sapwood parenchyma colour", .group = "parenchyma", .unit = "",
   .doc = "Of that tissue beyond the heartwood.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.92, 0.83, 0.67}, .default_text = "sRGB"};

static const sozai_parameter ray_density = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "ray_density", .label = "Ray density", .group = "rays", .unit = "1/mm2",
   .doc = "Rays to an area of the tangential face; 0 for none that can be seen.",
   .hard_min = 0, .hard_max = 20, .soft_min = 0, .soft_max = 12, .default_number = {0}};

static const sozai_parameter ray_height = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "ray_height", .label = "Ray height", .group = "rays", .unit = "mm",
   .doc = "Along the fibre, the mean; from half to one and a half times as much.",
   .hard_min = 0.05, .hard_max = 100, .soft_min = 0.08, .soft_max = 40, .default_number = {1}};

static const sozai_parameter ray_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "ray_width", .label = "Ray width", .group = "rays", .unit = "um",
   .doc = "Across the fibre where a ray is thickest, the mean.",
   .hard_min = 5, .hard_max = 1500, .soft_min = 10, .soft_max = 500, .default_number = {90}};

static const sozai_parameter ray_length = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "ray_length", .label = "Ray length", .group = "rays", .unit = "mm",
   .doc = "Along the radius, at most.",
   .hard_min = 2, .hard_max = 500, .soft_min = 10, .soft_max = 100, .default_number = {50}};

static const sozai_parameter ray_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "ray_colour", .label = "Ray colour", .group = "rays", .unit = "",
   .doc = "Of the rays' tissue in heartwood; in sapwood it is four fifths of earlywood's there.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.84, 0.71, 0.53},
   .default_text = "sRGB"};

static const sozai_parameter canal_density = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "canal_density", .label = "Canal density", .group = "canals", .unit = "1/mm2",
   .doc = "Resin canals to an area of cross-section; 0 for none.",
   .hard_min = 0, .hard_max = 10, .soft_min = 0, .soft_max = 2, .default_number = {0}};

static const sozai_parameter canal_diameter = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "canal_diameter", .label = "Canal diameter", .group = "canals", .unit = "um",
   .doc = "Of a resin canal with the cells that line it, the mean.",
   .hard_min = 10, .hard_max = 1000, .soft_min = 50, .soft_max = 300, .default_number = {120}};

static const sozai_parameter canal_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "canal_colour", .label = "Canal colour", .group = "canals", .unit = "",
   .doc = "Of the cells that line a resin canal; its lumen is darker.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.82, 0.62, 0.40},
   .default_text = "sRGB"};

static const sozai_parameter cell_contrast = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "cell_contrast", .label = "Cell contrast", .group = "cells", .unit = "",
   .doc = "How much single cells show under footprints of some hundredths of a millimetre; the mean "
   "colour does not change. 0 for none, and at no cost.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter cell_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "cell_width", .label = "Cell width", .group = "cells", .unit = "um",
   .doc = "Of a tracheid or fibre across the radius: that of a radial file of them.",
   .hard_min = 4, .hard_max = 200, .soft_min = 10, .soft_max = 60, .default_number = {22}};

static const sozai_parameter cell_depth = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "cell_depth", .label = "Cell depth", .group = "cells", .unit = "um",
   .doc = "Along the radius, in earlywood.",
   .hard_min = 4, .hard_max = 200, .soft_min = 8, .soft_max = 70, .default_number = {22}};

static const sozai_parameter cell_depth_late = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "cell_depth_late", .label = "Cell depth, late", .group = "cells", .unit = "um",
   .doc = "Along the radius, in latewood.",
   .hard_min = 4, .hard_max = 200, .soft_min = 6, .soft_max = 40, .default_number = {18}};

static const sozai_parameter basic_density = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "basic_density", .label = "Basic density", .group = "cells", .unit = "kg/m3",
   .doc = "Dry mass to green volume: over 1500 kg/m3 it is the share of cell walls.",
   .hard_min = 50, .hard_max = 1400, .soft_min = 100, .soft_max = 1100, .default_number = {550}};

static const sozai_parameter cell_length = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "cell_length", .label = "Cell length", .group = "cells", .unit = "mm",
   .doc = "Along the fibre.",
   .hard_min = 0.1, .hard_max = 20, .soft_min = 0.5, .soft_max = 6, .default_number = {1.2}};

static const sozai_parameter cell_irregularity = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "cell_irregularity", .label = "Cell irregularity", .group = "cells", .unit = "",
   .doc = "How much files of cells bend aside: 0 for straight files, which a cut almost along them shows as stripes.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.5}};

static const sozai_parameter fine_ray_density = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "fine_ray_density", .label = "Fine rays", .group = "cells", .unit = "1/mm2",
   .doc = "Rays one cell wide and some ten cells high, on the tangential face; seen with the cells alone.",
   .hard_min = 0, .hard_max = 200, .soft_min = 0, .soft_max = 80, .default_number = {0}};

static const sozai_parameter tyloses = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "tyloses", .label = "Tyloses", .group = "cells", .unit = "",
   .doc = "Walls of the cells that have grown into the vessels of the earlywood's rows, by their contrast; 0 for none.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter element_length = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "element_length", .label = "Vessel elements", .group = "cells", .unit = "mm",
   .doc = "Length of a vessel element: a vessel has a rim where two meet.",
   .hard_min = 0.05, .hard_max = 5, .soft_min = 0.15, .soft_max = 1, .default_number = {0.4}};

static const sozai_parameter spalt = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "spalt", .label = "Spalting", .group = "spalting", .unit = "",
   .doc = "How much of the wood fungi have taken: zone lines and bleached wood; 0 for none.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter spalt_size = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "spalt_size", .label = "Spalting size", .group = "spalting", .unit = "mm",
   .doc = "Of the colonies, across the fibre.",
   .hard_min = 2, .hard_max = 2000, .soft_min = 10, .soft_max = 150, .default_number = {40}};

static const sozai_parameter spalt_line = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "spalt_line", .label = "Zone line width", .group = "spalting", .unit = "mm",
   .doc = "Of the black lines, the mean.",
   .hard_min = 0.05, .hard_max = 10, .soft_min = 0.2, .soft_max = 2, .default_number = {0.6}};

static const sozai_parameter fibre_brightness = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "fibre_brightness", .label = "Fibre brightness", .group = "fibres", .unit = "",
   .doc = "Greatest shift of brightness from fibre to fibre, up or down, as a fraction.",
   .hard_min = 0, .hard_max = 0.4, .soft_min = 0, .soft_max = 0.4, .default_number = {0.12}};

static const sozai_parameter fibre_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "fibre_width", .label = "Fibre width", .group = "fibres", .unit = "mm",
   .doc = "Of the finest of three sizes: bundles are 7 times, drifts of colour 60 times as "
   "wide.",
   .hard_min = 0.02, .hard_max = 2, .soft_min = 0.03, .soft_max = 0.3, .default_number = {0.07}};

static const sozai_parameter drift = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "drift", .label = "Drift", .group = "fibres", .unit = "",
   .doc = "How much lighter and darker the wood becomes along the stem: the standard deviation, relative.",
   .hard_min = 0, .hard_max = 0.2, .soft_min = 0, .soft_max = 0.1, .default_number = {0}};

static const sozai_parameter drift_length = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "drift_length", .label = "Drift length", .group = "fibres", .unit = "mm",
   .doc = "Along the stem, over which it does.",
   .hard_min = 100, .hard_max = 20000, .soft_min = 200, .soft_max = 3000, .default_number = {700}};

static const sozai_parameter early_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "earlywood_colour", .label = "Earlywood colour", .group = "colour", .unit = "",
   .doc = "Of the tissue at the ring's start.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.80, 0.64, 0.44},
   .default_text = "sRGB"};

static const sozai_parameter late_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "latewood_colour", .label = "Latewood colour", .group = "colour", .unit = "",
   .doc = "Of the tissue at the ring's end, where it is darkest.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.64, 0.45, 0.27},
   .default_text = "sRGB"};

static const sozai_parameter vessel_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "vessel_colour", .label = "Vessel colour", .group = "colour", .unit = "",
   .doc = "Of an open vessel.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.42, 0.29, 0.18},
   .default_text = "sRGB"};

static const sozai_parameter sap_early = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "sapwood_earlywood_colour", .label = "Sapwood, earlywood", .group = "colour", .unit = "",
   .doc = "Of the tissue at the ring's start beyond the heartwood.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.88, 0.77, 0.59},
   .default_text = "sRGB"};

static const sozai_parameter sap_late = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "sapwood_latewood_colour", .label = "Sapwood, latewood", .group = "colour", .unit = "",
   .doc = "Of the tissue at the ring's end beyond the heartwood.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.76, 0.61, 0.43},
   .default_text = "sRGB"};

static const sozai_parameter sap_vessel = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "sapwood_vessel_colour", .label = "Sapwood, vessels", .group = "colour", .unit = "",
   .doc = "Of an open vessel beyond the heartwood.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.44, 0.31, 0.20},
   .default_text = "sRGB"};

static const sozai_parameter heart_years = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "heartwood_years", .label = "Heartwood", .group = "colour", .unit = "years",
   .doc = "Rings of heartwood, from the pith; those beyond are sapwood.",
   .hard_min = 0, .hard_max = 100000, .soft_min = 0, .soft_max = 300, .default_number = {150}};

static const sozai_parameter heart_edge = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "heartwood_edge", .label = "Heartwood edge", .group = "colour", .unit = "years",
   .doc = "How many rings heartwood takes to turn into sapwood.",
   .hard_min = 0.05, .hard_max = 50, .soft_min = 0.1, .soft_max = 10, .default_number = {0.8}};

static const sozai_parameter heart_stray = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "heartwood_stray", .label = "Heartwood stray", .group = "colour", .unit = "years",
   .doc = "How many rings the boundary departs from following one, at most, round the stem.",
   .hard_min = 0, .hard_max = 50, .soft_min = 0, .soft_max = 10, .default_number = {3}};

static const sozai_parameter pigment = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "pigment", .label = "Pigment figure", .group = "colour", .unit = "",
   .doc = "How deep the deepest bands of pigment in the heartwood are: the share of pigment_colour in them. Bands go with groups of rings, as in walnut, olive and rosewood.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter pigment_spacing = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "pigment_spacing", .label = "Spacing of bands", .group = "colour", .unit = "years",
   .doc = "From one band of pigment to the next, the mean; it is irregular.",
   .hard_min = 0.5, .hard_max = 64, .soft_min = 1, .soft_max = 20, .default_number = {6}};

static const sozai_parameter pigment_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "pigment_width", .label = "Width of bands", .group = "colour", .unit = "",
   .doc = "Of a band of pigment, relative to pigment_spacing, the mean. It deepens outwards and ends at its outer edge.",
   .hard_min = 0.05, .hard_max = 3, .soft_min = 0.1, .soft_max = 1.5, .default_number = {0.6}};

static const sozai_parameter pigment_stray = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "pigment_stray", .label = "Stray of bands", .group = "colour", .unit = "years",
   .doc = "How many rings a band of pigment departs from following one, at most.",
   .hard_min = 0, .hard_max = 20, .soft_min = 0, .soft_max = 6, .default_number = {2}};

static const sozai_parameter pigment_reach = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "pigment_reach", .label = "Reach of bands", .group = "colour", .unit = "mm",
   .doc = "Across the section: how far a band of pigment keeps its course and strength.",
   .hard_min = 5, .hard_max = 2000, .soft_min = 20, .soft_max = 200, .default_number = {50}};

static const sozai_parameter pigment_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "pigment_colour", .label = "Pigment colour", .group = "colour", .unit = "",
   .doc = "Of earlywood where a band of pigment is deepest; of latewood there three quarters of it.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.3, 0.2, 0.14},
   .default_text = "sRGB"};

static const sozai_parameter streak_share = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "streak_share", .label = "Mineral streaks", .group = "colour", .unit = "",
   .doc = "Share of the section that streaks of minerals stain; there is room for 0.06.",
   .hard_min = 0, .hard_max = 0.06, .soft_min = 0, .soft_max = 0.06, .default_number = {0}};

static const sozai_parameter streak_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "streak_width", .label = "Streak width", .group = "colour", .unit = "mm",
   .doc = "Of the widest, across the fibre.",
   .hard_min = 0.1, .hard_max = 100, .soft_min = 0.5, .soft_max = 10, .default_number = {2.5}};

static const sozai_parameter streak_length = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "streak_length", .label = "Streak length", .group = "colour", .unit = "mm",
   .doc = "Along the fibre.",
   .hard_min = 2, .hard_max = 5000, .soft_min = 20, .soft_max = 1000, .default_number = {200}};

static const sozai_parameter streak_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "streak_colour", .label = "Streak colour", .group = "colour", .unit = "",
   .doc = "Of a mineral streak in its middle.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.52, 0.46, 0.34},
   .default_text = "sRGB"};

static const sozai_parameter end_shade = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "end_shade", .label = "End shade", .group = "colour", .unit = "",
   .doc = "How much darker end grain is than a face along the fibre, since light that goes into open cells does not all come back. Not of a picture for section. 0 for none.",
   .hard_min = 0, .hard_max = 0.9, .soft_min = 0, .soft_max = 0.6, .default_number = {0}};

static const sozai_parameter ray_shade = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "ray_shade", .label = "Rays' end shade", .group = "colour", .unit = "",
   .doc = "How much darker rays are where the tangential face cuts across them: pale flakes of a quarter-sawn face are dark dashes on a flat-sawn one. 0 for none.",
   .hard_min = 0, .hard_max = 0.9, .soft_min = 0, .soft_max = 0.7, .default_number = {0}};

static const sozai_parameter age_years = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "age_years", .label = "Age", .group = "colour", .unit = "years",
   .doc = "Years of light and air indoors since the face was cut: colours go from those given towards aged_colour.",
   .hard_min = 0, .hard_max = 1000, .soft_min = 0, .soft_max = 50, .default_number = {0}};

static const sozai_parameter ageing_years = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "ageing_years", .label = "Ageing time", .group = "colour", .unit = "years",
   .doc = "In which 63 % of the change is done.",
   .hard_min = 0.05, .hard_max = 200, .soft_min = 0.3, .soft_max = 20, .default_number = {4}};

static const sozai_parameter aged_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "aged_colour", .label = "Aged colour", .group = "colour", .unit = "",
   .doc = "What earlywood comes to, between its own colour to the power of 0.4 and of 4 in each component; all other tissue changes with it.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.70, 0.51, 0.30},
   .default_text = "sRGB"};

static const sozai_parameter section = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_IMAGE,
   .id = "section", .label = "Section", .group = "section", .unit = "",
   .doc = "A photograph or scan of the end grain, seen from above: it stands in for rings, vessels, "
   "colours and fibres down to its pixels, and the grain carries it along the stem. ring_width "
   "still says how many years its radius is.",
   .default_number = {3, SOZAI_WRAP_MIRROR}, .default_text = "", .buffer_kind = SOZAI_BUFFER_IMAGE};

static const sozai_parameter section_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "section_width", .label = "Section width", .group = "section", .unit = "mm",
   .doc = "Of the whole picture, edge to edge.",
   .hard_min = 1, .hard_max = 20000, .soft_min = 20, .soft_max = 1500, .default_number = {300}};

static const char *const section_pith_choices[] = {"found", "given"};
static const char *const section_pith_docs[] = {
   "where the lines square to the rings meet",
   "at section_pith_s and section_pith_t"};
static const sozai_parameter section_pith = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "section_pith", .label = "Pith", .group = "section", .unit = "",
   .doc = "Where the pith is in the picture.",
   .choices = section_pith_choices, .choice_docs = section_pith_docs, .choice_count = COUNT(section_pith_choices), .default_number = {0}};

static const sozai_parameter section_pith_s = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "section_pith_s", .label = "Pith from the left", .group = "section", .unit = "",
   .doc = "In parts of the picture's width; may be outside it.",
   .hard_min = -4, .hard_max = 5, .soft_min = 0, .soft_max = 1, .default_number = {0.5}};

static const sozai_parameter section_pith_t = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "section_pith_t", .label = "Pith from the top", .group = "section", .unit = "",
   .doc = "In parts of the picture's height; may be outside it.",
   .hard_min = -4, .hard_max = 5, .soft_min = 0, .soft_max = 1, .default_number = {0.5}};

static const char *const section_rim_choices[] = {"found", "given", "none"};
static const char *const section_rim_docs[] = {
   "where the wood stands out from the background, or else the largest circle about the pith within the picture",
   "a circle of section_radius about the pith",
   "nowhere: beyond its edges the picture goes on by its wrap mode"};
static const sozai_parameter section_rim = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "section_rim", .label = "Rim", .group = "section", .unit = "",
   .doc = "Where the wood ends in the picture; beyond, it is folded back.",
   .choices = section_rim_choices, .choice_docs = section_rim_docs, .choice_count = COUNT(section_rim_choices), .default_number = {0}};

static const sozai_parameter section_radius = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "section_radius", .label = "Rim radius", .group = "section", .unit = "mm",
   .doc = "Of the rim, where it is given.",
   .hard_min = 1, .hard_max = 10000, .soft_min = 20, .soft_max = 1000, .default_number = {140}};

static const sozai_parameter section_detail = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "section_detail", .label = "Detail", .group = "section", .unit = "",
   .doc = "Contrast of the picture's detail finer than section_detail_size: 1 as photographed, 0 none. The brightness of single fibres lies there.",
   .hard_min = 0, .hard_max = 4, .soft_min = 0, .soft_max = 2, .default_number = {1}};

static const sozai_parameter section_detail_size = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "section_detail_size", .label = "Detail size", .group = "section", .unit = "mm",
   .doc = "Size of the finest detail that section_detail leaves alone.",
   .hard_min = 0.02, .hard_max = 100, .soft_min = 0.1, .soft_max = 5, .default_number = {1}};

static const sozai_parameter diffuse = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "diffuse", .label = "Diffuse", .group = "figure", .unit = "",
   .doc = "kd of equation (4): times the albedo and the cosine of incidence.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.9}};

static const sozai_parameter specular = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "specular", .label = "Specular", .group = "figure", .unit = "",
   .doc = "ks of equation (4): height of the lobe that the fibres reflect.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 0.5, .default_number = {0.1}};

static const sozai_parameter shininess = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "shininess", .label = "Shininess", .group = "figure", .unit = "",
   .doc = "n of equation (4): the lobe's exponent.",
   .hard_min = 1, .hard_max = 1000, .soft_min = 5, .soft_max = 200, .default_number = {12}};

static const sozai_parameter tint = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "specular_tint", .label = "Specular tint", .group = "figure", .unit = "",
   .doc = "Colour of that lobe: 0 the light's, 1 the earlywood's hue.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.6}};

static const char *const reflection_choices[] = {"kawai", "fibre_cone"};
static const char *const reflection_docs[] = {
   "equation (4) as printed, which does not depend on the view",
   "the cone of Marschner and others (2005) about the fibre, below a coat"};
static const sozai_parameter reflection = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "reflection", .label = "Reflection", .group = "figure", .unit = "",
   .doc = "How radiance follows from albedo and fibre direction.",
   .choices = reflection_choices, .choice_docs = reflection_docs, .choice_count = COUNT(reflection_choices), .default_number = {0}};

static const sozai_parameter fibre_reflectance = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "fibre_reflectance", .label = "Fibre reflectance", .group = "figure", .unit = "",
   .doc = "fibre_cone: strength of the fibres' lobe in its brightest channel; its hue is that of specular_tint. Lessened at dive angles at which the lobe would reflect more than it receives.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 0.3, .default_number = {0.07}};

static const sozai_parameter ray_lustre = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "ray_lustre", .label = "Ray lustre", .group = "figure", .unit = "",
   .doc = "fibre_cone: strength of the lobe about the rays' cells, which lie along the radius, over the fibres': flakes of quarter-sawn oak flash where the fibres are dull, and are dull where those shine. 0 for none. Lessened where it would reflect more than it receives.",
   .hard_min = 0, .hard_max = 10, .soft_min = 0, .soft_max = 3, .default_number = {1}};

static const sozai_parameter cone_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "cone_width", .label = "Cone width", .group = "figure", .unit = "deg",
   .doc = "fibre_cone: standard deviation of the lobe about the cone.",
   .hard_min = 1, .hard_max = 45, .soft_min = 4, .soft_max = 25, .default_number = {11}};

static const sozai_parameter ior = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "ior", .label = "Index of refraction", .group = "figure", .unit = "",
   .doc = "Of the surface: of a coat, and for fibre_cone of that through which light enters and leaves.",
   .hard_min = 1.01, .hard_max = 3, .soft_min = 1.3, .soft_max = 1.7, .default_number = {1.55}};

static const sozai_parameter coat = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "coat", .label = "Coat", .group = "figure", .unit = "",
   .doc = "Share of the surface's own reflection over the wood's: 0 raw wood, 1 a film of varnish.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter coat_roughness = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "coat_roughness", .label = "Coat roughness", .group = "figure", .unit = "",
   .doc = "Of the coat; of oil and char, which are no films, 0.45 or more. Its square is the width of the facets' distribution (GGX).",
   .hard_min = 0.03, .hard_max = 1, .soft_min = 0.05, .soft_max = 0.6, .default_number = {0.25}};

static const char *const surface_choices[] = {
   "smooth", "band_sawn", "circular_sawn", "planed", "hand_planed", "sanded", "brushed", "charred",
   "weathered"};
static const char *const surface_docs[] = {
   "no relief at all",
   "straight grooves across the board, one to a tooth of a band saw, and torn fibres",
   "the same on arcs of saw_radius, crossed by those of the teeth behind",
   "a planing machine's knives: fine cusps across the board",
   "broad troughs of a hand plane's cambered iron along the board; bright",
   "scratches along the board, by sanding_grit",
   "earlywood brushed out from between the latewood",
   "yakisugi: black, the latewood standing, cracked into cells",
   "silver grey, the earlywood eroded, checks along the fibre and from the pith on its ends"};
static const sozai_parameter surface = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "surface", .label = "Surface", .group = "surface", .unit = "",
   .doc = "What has worked on the face: shows in height, normal and roughness. Tools run along "
   "the board (+y of a piece; along x over its ends), on the face that the normal is nearest to; "
   "wear follows rings and fibres.",
   .choices = surface_choices, .choice_docs = surface_docs, .choice_count = COUNT(surface_choices), .default_number = {0}};

static const char *const finish_choices[] = {"raw", "oiled", "lacquered"};
static const char *const finish_docs[] = {
   "nothing on it",
   "oil in the fibres scatters less: darker and more saturated; a satin coat of 0.3",
   "a film that fills vessels and scratches: likewise, and a coat of 1, as glossy as coat_roughness"};
static const sozai_parameter finish = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "finish", .label = "Finish", .group = "surface", .unit = "",
   .doc = "What has been put on it.",
   .choices = finish_choices, .choice_docs = finish_docs, .choice_count = COUNT(finish_choices), .default_number = {0}};

static const sozai_parameter mark_pitch = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "mark_pitch", .label = "Mark pitch", .group = "surface", .unit = "mm",
   .doc = "Of a tool's marks, one to the next, 0.05 or more; 0: the usual of the surface.",
   .hard_min = 0, .hard_max = 200, .soft_min = 0, .soft_max = 50, .default_number = {0}};

static const sozai_parameter mark_depth = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "mark_depth", .label = "Mark depth", .group = "surface", .unit = "mm",
   .doc = "Of a tool's marks, a scratch's 2 sd; -1: the usual of the surface.",
   .hard_min = -1, .hard_max = 5, .soft_min = -1, .soft_max = 0.5, .default_number = {-1}};

static const sozai_parameter mark_angle = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "mark_angle", .label = "Mark angle", .group = "surface", .unit = "deg",
   .doc = "By which the tool's run is turned in the face, from the board's length towards its width.",
   .hard_min = -360, .hard_max = 360, .soft_min = -90, .soft_max = 90, .default_number = {0}};

static const sozai_parameter saw_radius = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "saw_radius", .label = "Saw radius", .group = "surface", .unit = "mm",
   .doc = "circular_sawn: of the blade.",
   .hard_min = 20, .hard_max = 5000, .soft_min = 100, .soft_max = 700, .default_number = {250}};

static const sozai_parameter sanding_grit = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "sanding_grit", .label = "Grit", .group = "surface", .unit = "P",
   .doc = "sanded: of the last paper, by FEPA's P scale: grains of 425 um for 40, 125 for 120, 35 for 400.",
   .hard_min = 12, .hard_max = 2500, .soft_min = 40, .soft_max = 400, .default_number = {120}};

static const sozai_parameter erosion = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "erosion", .label = "Erosion", .group = "surface", .unit = "mm",
   .doc = "How far earlywood lies below the densest latewood; -1: the usual of the surface.",
   .hard_min = -1, .hard_max = 10, .soft_min = -1, .soft_max = 2, .default_number = {-1}};

static const sozai_parameter fibre_wear = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "fibre_wear", .label = "Fibre wear", .group = "surface", .unit = "mm",
   .doc = "How far single bundles of fibres stand out or lie low, at most; -1: the usual of the surface.",
   .hard_min = -1, .hard_max = 2, .soft_min = -1, .soft_max = 0.3, .default_number = {-1}};

static const sozai_parameter open_vessels = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "open_vessels", .label = "Open vessels", .group = "surface", .unit = "",
   .doc = "Mean depth of vessels cut open, in their radii: 0 none or filled; -1: the usual of the surface.",
   .hard_min = -1, .hard_max = 5, .soft_min = -1, .soft_max = 2, .default_number = {-1}};

static const sozai_parameter checks = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "checks", .label = "Checks", .group = "surface", .unit = "",
   .doc = "Cracks along the fibre that a line of 100 mm across it meets; -1: the usual of the surface.",
   .hard_min = -1, .hard_max = 40, .soft_min = -1, .soft_max = 20, .default_number = {-1}};

static const sozai_parameter check_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "check_width", .label = "Check width", .group = "surface", .unit = "mm",
   .doc = "Of the widest.",
   .hard_min = 0.02, .hard_max = 5, .soft_min = 0.05, .soft_max = 1, .default_number = {0.35}};

static const sozai_parameter check_length = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "check_length", .label = "Check length", .group = "surface", .unit = "mm",
   .doc = "Along the fibre, of the longest.",
   .hard_min = 2, .hard_max = 2000, .soft_min = 10, .soft_max = 300, .default_number = {60}};

static const sozai_parameter end_checks = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "end_checks", .label = "End checks", .group = "surface", .unit = "",
   .doc = "Cracks of end grain, from the pith outwards, that 100 mm along a ring meet; -1: the usual of the surface.",
   .hard_min = -1, .hard_max = 40, .soft_min = -1, .soft_max = 10, .default_number = {-1}};

static const sozai_parameter end_check_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "end_check_width", .label = "End check width", .group = "surface", .unit = "mm",
   .doc = "Of the widest; never more than a fifth of the way between two.",
   .hard_min = 0.02, .hard_max = 10, .soft_min = 0.1, .soft_max = 3, .default_number = {1}};

static const sozai_parameter end_check_length = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "end_check_length", .label = "End check length", .group = "surface", .unit = "mm",
   .doc = "Along the radius, of the longest.",
   .hard_min = 2, .hard_max = 2000, .soft_min = 10, .soft_max = 200, .default_number = {55}};

static const sozai_parameter charring = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "charring", .label = "Charring", .group = "surface", .unit = "",
   .doc = "charred: how far: 0 not at all, 0.5 toasted brown, 1 black and cracked.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {1}};

static const sozai_parameter char_cell = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "char_cell", .label = "Char cell", .group = "surface", .unit = "mm",
   .doc = "charred: across the fibre, of the cells that char cracks into; along it 1.5 times as much.",
   .hard_min = 0.5, .hard_max = 200, .soft_min = 2, .soft_max = 30, .default_number = {7}};

static const sozai_parameter greying = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "greying", .label = "Greying", .group = "surface", .unit = "",
   .doc = "weathered: how far grey_colour has taken over.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.9}};

static const sozai_parameter grey_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "grey_colour", .label = "Grey", .group = "surface", .unit = "",
   .doc = "weathered: of earlywood that has greyed; latewood and vessels are darker by what they were.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.63, 0.625, 0.60},
   .default_text = "sRGB"};

#define LAYOUT_ID_(kind, id, length, width, joint, doc) id,
#define LAYOUT_DOC_(kind, id, length, width, joint, doc) doc,
static const char *const layout_choices[] = {LAYOUT_CATALOGUE(LAYOUT_ID_)};
static const char *const layout_docs[] = {LAYOUT_CATALOGUE(LAYOUT_DOC_)};
static const sozai_parameter layout_ = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "layout", .label = "Layout", .group = "layout", .unit = "",
   .doc = "How boards or blocks cover the plane: object space x, y is the floor, +z its face, +y "
   "along the boards. Each is sawn from a log of its own; cut (but for end), cut_height, "
   "cut_rotation and cut_offset are then not used.",
   .choices = layout_choices, .choice_docs = layout_docs, .choice_count = COUNT(layout_choices), .default_number = {0}};

static const sozai_parameter board_length = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "board_length", .label = "Board length", .group = "layout", .unit = "mm",
   .doc = "Of a board or block, joint to joint; 0: the usual of the layout.",
   .hard_min = 0, .hard_max = 100000, .soft_min = 0, .soft_max = 3000, .default_number = {0}};

static const sozai_parameter board_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "board_width", .label = "Board width", .group = "layout", .unit = "mm",
   .doc = "Likewise.",
   .hard_min = 0, .hard_max = 100000, .soft_min = 0, .soft_max = 400, .default_number = {0}};

static const sozai_parameter board_length_variation = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "board_length_variation", .label = "Length variation", .group = "layout", .unit = "",
   .doc = "strip, butcher, ashlar: how far lengths stray from the mean, relative.",
   .hard_min = 0, .hard_max = 0.9, .soft_min = 0, .soft_max = 0.6, .default_number = {0.25}};

static const sozai_parameter stagger = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "stagger", .label = "Stagger", .group = "layout", .unit = "",
   .doc = "running: how far a course is shifted against the last, of the length. strip, butcher, ashlar: how far apart the ends of neighbouring courses are, less the length variation.",
   .hard_min = 0, .hard_max = 0.5, .soft_min = 0, .soft_max = 0.5, .default_number = {0.3}};

static const sozai_parameter chevron_angle = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "chevron_angle", .label = "Chevron angle", .group = "layout", .unit = "deg",
   .doc = "chevron: of the blocks to the square across the strip.",
   .hard_min = 15, .hard_max = 75, .soft_min = 30, .soft_max = 60, .default_number = {45}};

static const sozai_parameter layout_rotation = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "layout_rotation", .label = "Layout rotation", .group = "layout", .unit = "deg",
   .doc = "The whole layout is turned about z, from x towards y.",
   .hard_min = -36000, .hard_max = 36000, .soft_min = -180, .soft_max = 180, .default_number = {0}};

static const sozai_parameter joint_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "joint_width", .label = "Joint width", .group = "layout", .unit = "mm",
   .doc = "Between neighbours; -1: the usual of the layout.",
   .hard_min = -1, .hard_max = 1000, .soft_min = -1, .soft_max = 20, .default_number = {-1}};

static const sozai_parameter joint_depth = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "joint_depth", .label = "Joint depth", .group = "layout", .unit = "mm",
   .doc = "Of the joint below the foot of the bevels; shows in height.",
   .hard_min = 0, .hard_max = 1000, .soft_min = 0, .soft_max = 10, .default_number = {2}};

static const sozai_parameter joint_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "joint_colour", .label = "Joint colour", .group = "layout", .unit = "",
   .doc = "Of the gap, or of what fills it.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.16, 0.13, 0.11}, .default_text = "sRGB"};

static const sozai_parameter bevel = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "bevel", .label = "Bevel", .group = "layout", .unit = "mm",
   .doc = "Width of the bevelled edge.",
   .hard_min = 0, .hard_max = 1000, .soft_min = 0, .soft_max = 6, .default_number = {0}};

static const sozai_parameter bevel_angle = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "bevel_angle", .label = "Bevel angle", .group = "layout", .unit = "deg",
   .doc = "Of the bevel to the face.",
   .hard_min = 0, .hard_max = 80, .soft_min = 5, .soft_max = 60, .default_number = {35}};

static const sozai_parameter tone_spread = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "tone_spread", .label = "Tone spread", .group = "layout", .unit = "",
   .doc = "Standard deviation of brightness from board to board, or from ply to ply, relative.",
   .hard_min = 0, .hard_max = 0.5, .soft_min = 0, .soft_max = 0.2, .default_number = {0.06}};

static const sozai_parameter cupping = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "cupping", .label = "Cupping", .group = "layout", .unit = "mm",
   .doc = "How far the middle of a board may stand off its edges, up or down.",
   .hard_min = 0, .hard_max = 20, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const char *const flip_choices[] = {"random", "alternate", "none"};
static const char *const flip_docs[] = {
   "either way, each board as it comes", "every other one", "all the same way"};
static const sozai_parameter flip = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "board_flip", .label = "Ends", .group = "layout", .unit = "",
   .doc = "Which way up the stem boards are laid.",
   .choices = flip_choices, .choice_docs = flip_docs, .choice_count = COUNT(flip_choices), .default_number = {0}};

static const sozai_parameter cut_flat = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "boards_flat", .label = "Flat-sawn", .group = "layout", .unit = "",
   .doc = "Share of flat-sawn boards; the three shares are scaled to a sum of 1.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.6}};

static const sozai_parameter cut_rift = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "boards_rift", .label = "Rift-sawn", .group = "layout", .unit = "",
   .doc = "Share of rift-sawn boards.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.25}};

static const sozai_parameter cut_quarter = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "boards_quarter", .label = "Quarter-sawn", .group = "layout", .unit = "",
   .doc = "Share of quarter-sawn boards.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.15}};

const sozai_parameter *const wood_parameters[WOOD_PARAMETERS] = {
   [P_SEED] = &seed,
   [P_OBJECT] = &object,
   [P_CUT] = &cut,
   [P_CUT_DISTANCE] = &cut_distance,
   [P_CUT_HEIGHT] = &cut_height,
   [P_CUT_ROTATION] = &cut_rotation,
   [P_CUT_OFFSET] = &cut_offset,
   [P_CUT_TILT] = &cut_tilt,
   [P_CUT_SKEW] = &cut_skew,
   [P_VENEER] = &veneer_thickness,
   [P_RING_WIDTH] = &ring_width,
   [P_RING_VARIATION] = &ring_variation,
   [P_RING_WIDTHS] = &ring_widths,
   [P_OUTLINE] = &outline,
   [P_UNDULATION] = &undulation,
   [P_UNDULATION_SIZE] = &undulation_size,
   [P_TAPER] = &taper,
   [P_PITH_WANDER] = &pith_wander,
   [P_LATE_FRACTION] = &late_fraction,
   [P_LATE_ABRUPTNESS] = &late_abruptness,
   [P_LATE_VARIATION] = &late_variation,
   [P_LATE_DEEPENING] = &late_deepening,
   [P_LATE_STRAY] = &late_stray,
   [P_GRAIN] = &grain,
   [P_SPIRAL_SLOPE] = &spiral_slope,
   [P_WAVE_SLOPE] = &wave_slope,
   [P_WAVE_LENGTH] = &wave_length,
   [P_WAVE_IRREGULARITY] = &wave_irregularity,
   [P_WAVE_REACH] = &wave_reach,
   [P_INTERLOCKED_SLOPE] = &interlocked_slope,
   [P_INTERLOCKED_YEARS] = &interlocked_years,
   [P_INTERLOCKED_LENGTH] = &interlocked_length,
   [P_INTERLOCKED_IRREGULARITY] = &interlocked_irregularity,
   [P_SLOPE_NOISE] = &slope_noise,
   [P_SLOPE_NOISE_LENGTH] = &slope_noise_length,
   [P_CURL_SLOPE] = &curl_slope,
   [P_CURL_LENGTH] = &curl_length,
   [P_CURL_IRREGULARITY] = &curl_irregularity,
   [P_CURL_REACH] = &curl_reach,
   [P_QUILT_SLOPE] = &quilt_slope,
   [P_QUILT_HEIGHT] = &quilt_height,
   [P_QUILT_WIDTH] = &quilt_width,
   [P_EYE_DENSITY] = &eye_density,
   [P_EYE_DIAMETER] = &eye_diameter,
   [P_EYE_DEPTH] = &eye_depth,
   [P_EYE_LENGTH] = &eye_length,
   [P_TREE] = &tree,
   [P_TREE_AGE] = &tree_age,
   [P_TREE_FIELD] = &tree_field,
   [P_TREE_RINGS] = &tree_rings,
   [P_LOG_HEIGHT] = &log_height,
   [P_KNOTS] = &knots,
   [P_KNOT_RADII] = &knot_radii,
   [P_STEM_RINGS] = &stem_rings,
   [P_KNOT_SIZE] = &knot_size,
   [P_KNOT_COLLAR] = &knot_collar,
   [P_KNOT_GRAIN] = &knot_grain,
   [P_KNOT_BARK] = &knot_bark,
   [P_KNOT_CHECKS] = &knot_checks,
   [P_KNOT_COLOUR] = &knot_colour,
   [P_KNOT_STAIN] = &knot_stain,
   [P_KNOT_BARK_COLOUR] = &knot_bark_colour,
   [P_POROSITY] = &porosity,
   [P_PORE_DENSITY] = &pore_density,
   [P_PORE_DIAMETER] = &pore_diameter,
   [P_PORE_DIAMETER_LATE] = &pore_diameter_late,
   [P_PORE_SPREAD] = &pore_spread,
   [P_ARRANGEMENT] = &arrangement,
   [P_BANDS] = &bands,
   [P_BAND_SPACING] = &band_spacing,
   [P_BAND_STRAY] = &band_stray,
   [P_ROWS] = &rows,
   [P_ROW_DENSITY] = &row_density,
   [P_ROW_DIAMETER] = &row_diameter,
   [P_ROW_SPREAD] = &row_spread,
   [P_ROW_JITTER] = &row_jitter,
   [P_MARGINAL] = &marginal,
   [P_SHEATH] = &sheath,
   [P_WINGS] = &wings,
   [P_BETWEEN] = &between,
   [P_SOFT_BAND_WIDTH] = &soft_band_width,
   [P_SOFT_BAND_SPACING] = &soft_band_spacing,
   [P_SOFT_BAND_STRAY] = &soft_band_stray,
   [P_SOFT_COLOUR] = &soft_colour,
   [P_SAP_SOFT] = &sap_soft,
   [P_RAY_DENSITY] = &ray_density,
   [P_RAY_HEIGHT] = &ray_height,
   [P_RAY_WIDTH] = &ray_width,
   [P_RAY_LENGTH] = &ray_length,
   [P_RAY_COLOUR] = &ray_colour,
   [P_CANAL_DENSITY] = &canal_density,
   [P_CANAL_DIAMETER] = &canal_diameter,
   [P_CANAL_COLOUR] = &canal_colour,
   [P_CELL_CONTRAST] = &cell_contrast,
   [P_CELL_WIDTH] = &cell_width,
   [P_CELL_DEPTH] = &cell_depth,
   [P_CELL_DEPTH_LATE] = &cell_depth_late,
   [P_BASIC_DENSITY] = &basic_density,
   [P_CELL_LENGTH] = &cell_length,
   [P_CELL_IRREGULARITY] = &cell_irregularity,
   [P_FINE_RAYS] = &fine_ray_density,
   [P_TYLOSES] = &tyloses,
   [P_ELEMENT_LENGTH] = &element_length,
   [P_SPALT] = &spalt,
   [P_SPALT_SIZE] = &spalt_size,
   [P_SPALT_WIDTH] = &spalt_line,
   [P_FIBRE_BRIGHTNESS] = &fibre_brightness,
   [P_FIBRE_WIDTH] = &fibre_width,
   [P_DRIFT] = &drift,
   [P_DRIFT_LENGTH] = &drift_length,
   [P_EARLY_COLOUR] = &early_colour,
   [P_LATE_COLOUR] = &late_colour,
   [P_VESSEL_COLOUR] = &vessel_colour,
   [P_SAP_EARLY] = &sap_early,
   [P_SAP_LATE] = &sap_late,
   [P_SAP_VESSEL] = &sap_vessel,
   [P_HEART_YEARS] = &heart_years,
   [P_HEART_EDGE] = &heart_edge,
   [P_HEART_STRAY] = &heart_stray,
   [P_PIGMENT] = &pigment,
   [P_PIGMENT_SPACING] = &pigment_spacing,
   [P_PIGMENT_WIDTH] = &pigment_width,
   [P_PIGMENT_STRAY] = &pigment_stray,
   [P_PIGMENT_REACH] = &pigment_reach,
   [P_PIGMENT_COLOUR] = &pigment_colour,
   [P_STREAK_SHARE] = &streak_share,
   [P_STREAK_WIDTH] = &streak_width,
   [P_STREAK_LENGTH] = &streak_length,
   [P_STREAK_COLOUR] = &streak_colour,
   [P_END_SHADE] = &end_shade,
   [P_RAY_SHADE] = &ray_shade,
   [P_AGE_YEARS] = &age_years,
   [P_AGEING_YEARS] = &ageing_years,
   [P_AGED_COLOUR] = &aged_colour,
   [P_SECTION] = &section,
   [P_SECTION_WIDTH] = &section_width,
   [P_SECTION_PITH] = &section_pith,
   [P_SECTION_PITH_S] = &section_pith_s,
   [P_SECTION_PITH_T] = &section_pith_t,
   [P_SECTION_RIM] = &section_rim,
   [P_SECTION_RADIUS] = &section_radius,
   [P_SECTION_DETAIL] = &section_detail,
   [P_SECTION_DETAIL_SIZE] = &section_detail_size,
   [P_DIFFUSE] = &diffuse,
   [P_SPECULAR] = &specular,
   [P_SHININESS] = &shininess,
   [P_TINT] = &tint,
   [P_REFLECTION] = &reflection,
   [P_FIBRE_REFLECTANCE] = &fibre_reflectance,
   [P_RAY_LUSTRE] = &ray_lustre,
   [P_CONE_WIDTH] = &cone_width,
   [P_IOR] = &ior,
   [P_COAT] = &coat,
   [P_COAT_ROUGHNESS] = &coat_roughness,
   [P_SURFACE] = &surface,
   [P_FINISH] = &finish,
   [P_MARK_PITCH] = &mark_pitch,
   [P_MARK_DEPTH] = &mark_depth,
   [P_MARK_ANGLE] = &mark_angle,
   [P_SAW_RADIUS] = &saw_radius,
   [P_SANDING_GRIT] = &sanding_grit,
   [P_EROSION] = &erosion,
   [P_FIBRE_WEAR] = &fibre_wear,
   [P_OPEN_VESSELS] = &open_vessels,
   [P_CHECKS] = &checks,
   [P_CHECK_WIDTH] = &check_width,
   [P_CHECK_LENGTH] = &check_length,
   [P_END_CHECKS] = &end_checks,
   [P_END_CHECK_WIDTH] = &end_check_width,
   [P_END_CHECK_LENGTH] = &end_check_length,
   [P_CHARRING] = &charring,
   [P_CHAR_CELL] = &char_cell,
   [P_GREYING] = &greying,
   [P_GREY_COLOUR] = &grey_colour,
   [P_LAYOUT] = &layout_,
   [P_BOARD_LENGTH] = &board_length,
   [P_BOARD_WIDTH] = &board_width,
   [P_BOARD_LENGTH_VARIATION] = &board_length_variation,
   [P_STAGGER] = &stagger,
   [P_CHEVRON_ANGLE] = &chevron_angle,
   [P_LAYOUT_ROTATION] = &layout_rotation,
   [P_JOINT_WIDTH] = &joint_width,
   [P_JOINT_DEPTH] = &joint_depth,
   [P_JOINT_COLOUR] = &joint_colour,
   [P_BEVEL] = &bevel,
   [P_BEVEL_ANGLE] = &bevel_angle,
   [P_TONE_SPREAD] = &tone_spread,
   [P_CUPPING] = &cupping,
   [P_FLIP] = &flip,
   [P_CUT_FLAT] = &cut_flat,
   [P_CUT_RIFT] = &cut_rift,
   [P_CUT_QUARTER] = &cut_quarter,
   [P_CONSTRUCTION] = &plies_construction,
   [P_SHEET_THICKNESS] = &plies_sheet_thickness,
   [P_SHEETS] = &plies_sheets,
   [P_FACE_HEIGHT] = &plies_face_height,
   [P_PLIES] = &plies_count,
   [P_FACE_VENEER] = &plies_face_veneer,
   [P_CORE_VENEER] = &plies_core_veneer,
   [P_FACE_CUT] = &plies_face_cut,
   [P_LEAF_WIDTH] = &plies_leaf_width,
   [P_LEAF_MATCH] = &plies_leaf_match,
   [P_CORE_WIDTH] = &plies_core_width,
   [P_CORE_GAP] = &plies_core_gap,
   [P_LATHE_CHECKS] = &plies_lathe_checks,
   [P_GLUE_LINE] = &plies_glue_line,
   [P_GLUE_UNEVENNESS] = &plies_glue_unevenness,
   [P_GLUE_COLOUR] = &plies_glue_colour,
   [P_GLUE_STEP] = &plies_glue_step};

static const sozai_channel channel_albedo = {
   .size = sizeof(sozai_channel), .first = WOOD_ALBEDO, .components = 3,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "albedo", .unit = "", .suffixes = "rgb",
   .doc = "Diffuse reflectance, scene-linear, in the working space. Linear in the palette: above 1 where what varies meets a colour near white."};

static const sozai_channel channel_radiance = {
   .size = sizeof(sozai_channel), .first = WOOD_RADIANCE, .components = 3,
   .needs = SOZAI_INPUT_POINT | SOZAI_INPUT_NORMAL | SOZAI_INPUT_LIGHT,
   .uses = SOZAI_INPUT_LIGHT_COLOUR | SOZAI_INPUT_VIEW | SOZAI_INPUT_FOOTPRINT,
   .id = "radiance", .unit = "", .suffixes = "rgb",
   .doc = "Towards the eye under the light, times light_colour, as `reflection` says: Kawai's "
   "equation (4), kd albedo cos(delta) + ks cos^n(delta - alpha), cosines clamped at 0, below the "
   "coat where there is one; or the fibres' cone. Cone and coat use the view."};

static const sozai_channel channel_fiber = {
   .size = sizeof(sozai_channel), .first = WOOD_FIBER, .components = 3,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "fiber", .unit = "", .suffixes = "xyz",
   .doc = "Unit direction of the fibres, object space, up the stem."};

static const sozai_channel channel_dive = {
   .size = sizeof(sozai_channel), .first = WOOD_DIVE, .components = 1,
   .needs = SOZAI_INPUT_POINT | SOZAI_INPUT_NORMAL,
   .uses = SOZAI_INPUT_FOOTPRINT,
   .id = "dive", .unit = "rad", .suffixes = "",
   .doc = "Angle alpha between fibre and surface, positive where the fibre dives in going up "
   "the stem."};

static const sozai_channel channel_specular = {
   .size = sizeof(sozai_channel), .first = WOOD_SPECULAR, .components = 1,
   .needs = SOZAI_INPUT_POINT | SOZAI_INPUT_NORMAL,
   .uses = SOZAI_INPUT_FOOTPRINT,
   .id = "specular", .unit = "", .suffixes = "",
   .doc = "Height of the fibres' lobe: ks, lower where the footprint averages over slopes, the fibres' or the surface's."};

static const sozai_channel channel_roughness = {
   .size = sizeof(sozai_channel), .first = WOOD_ROUGHNESS, .components = 1,
   .needs = SOZAI_INPUT_POINT | SOZAI_INPUT_NORMAL,
   .uses = SOZAI_INPUT_FOOTPRINT,
   .id = "roughness", .unit = "", .suffixes = "",
   .doc = "Width of that lobe, sqrt(2 / (n + 2)): a Beckmann roughness, wider where the "
   "footprint averages over slopes, the fibres' or the gentle ones of the surface."};

static const sozai_channel channel_time = {
   .size = sizeof(sozai_channel), .first = WOOD_TIME, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "time", .unit = "years", .suffixes = "",
   .doc = "When the wood was formed, from the pith's first year."};

static const sozai_channel channel_latewood = {
   .size = sizeof(sozai_channel), .first = WOOD_LATEWOOD, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "latewood", .unit = "", .suffixes = "",
   .doc = "How far towards latewood the tissue is, 0 to 1."};

static const sozai_channel channel_vessel = {
   .size = sizeof(sozai_channel), .first = WOOD_VESSEL, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "vessel", .unit = "", .suffixes = "",
   .doc = "Share of the footprint that open vessels cover, 0 to 1."};

static const sozai_channel channel_reference = {
   .size = sizeof(sozai_channel), .first = WOOD_REFERENCE, .components = 2,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "reference", .unit = "mm", .suffixes = "xz",
   .doc = "Where the point's fibre stands in the reference section, the section of the stem at "
   "y = 0. Constant along a fibre: a picture of the end grain looked up here is carried "
   "by the grain."};

static const sozai_channel channel_cone_colour = {
   .size = sizeof(sozai_channel), .first = WOOD_CONE_COLOUR, .components = 3,
   .needs = SOZAI_INPUT_POINT | SOZAI_INPUT_NORMAL,
   .uses = SOZAI_INPUT_FOOTPRINT,
   .id = "cone_colour", .unit = "", .suffixes = "rgb",
   .doc = "Colour k of the fibres' cone, for a host that builds the lobe itself: about `fiber_lobe`, whose length is a factor of it, "
   "below a surface of `ior`. The same all over. Scene-linear, in the working space."};

static const sozai_channel channel_cone_width = {
   .size = sizeof(sozai_channel), .first = WOOD_CONE_WIDTH, .components = 1,
   .needs = SOZAI_INPUT_POINT | SOZAI_INPUT_NORMAL,
   .uses = SOZAI_INPUT_FOOTPRINT,
   .id = "cone_width", .unit = "rad", .suffixes = "",
   .doc = "Standard deviation of that lobe, wider where the footprint averages over slopes."};

static const sozai_channel channel_coat = {
   .size = sizeof(sozai_channel), .first = WOOD_COAT, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "coat", .unit = "", .suffixes = "",
   .doc = "Share of the surface's own reflection over it, lower where the footprint averages over steep slopes: open vessels, checks, cracks, worn rings."};

static const sozai_channel channel_coat_roughness = {
   .size = sizeof(sozai_channel), .first = WOOD_COAT_ROUGHNESS, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "coat_roughness", .unit = "", .suffixes = "",
   .doc = "Of that reflection, as the finish has it: its square is GGX's alpha, wider where the footprint averages over the relief's gentle slopes."};

static const sozai_channel channel_ray = {
   .size = sizeof(sozai_channel), .first = WOOD_RAY, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "ray", .unit = "", .suffixes = "",
   .doc = "Share of the footprint that rays cover, 0 to 1."};

static const sozai_channel channel_board_id = {
   .size = sizeof(sozai_channel), .first = WOOD_BOARD_ID, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "board_id", .unit = "", .suffixes = "",
   .doc = "A whole number below 2^24, another for each board of the layout; without one the ply's, 1 for the face; 0 of one piece."};

static const sozai_channel channel_board_u = {
   .size = sizeof(sozai_channel), .first = WOOD_BOARD_U, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "board_u", .unit = "mm", .suffixes = "",
   .doc = "Place along the board, from its corner, joint's middle to joint's middle; without a layout along the ply's grain, from the origin; 0 of one piece."};

static const sozai_channel channel_board_v = {
   .size = sizeof(sozai_channel), .first = WOOD_BOARD_V, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "board_v", .unit = "mm", .suffixes = "",
   .doc = "Place across the board, likewise; without a layout across the ply's piece of veneer."};

static const sozai_channel channel_board_edge = {
   .size = sizeof(sozai_channel), .first = WOOD_BOARD_EDGE, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "board_edge", .unit = "mm", .suffixes = "",
   .doc = "Distance to the board's edge: positive within the board, negative in the joint; without a layout to the ply's glue; 0 of one piece."};

static const sozai_channel channel_normal = {
   .size = sizeof(sozai_channel), .first = WOOD_NORMAL, .components = 3,
   .needs = SOZAI_INPUT_POINT | SOZAI_INPUT_NORMAL,
   .uses = SOZAI_INPUT_FOOTPRINT,
   .id = "normal", .unit = "", .suffixes = "xyz",
   .doc = "Unit, object space: the normal given, tilted by the surface and by the layout's bevelled edges and cupping."};

static const sozai_channel channel_canal = {
   .size = sizeof(sozai_channel), .first = WOOD_CANAL, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "canal", .unit = "", .suffixes = "",
   .doc = "Share of the footprint that resin canals cover, 0 to 1."};

static const sozai_channel channel_parenchyma = {
   .size = sizeof(sozai_channel), .first = WOOD_PARENCHYMA, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "parenchyma", .unit = "", .suffixes = "",
   .doc = "Share of the footprint that axial parenchyma covers, 0 to 1."};

static const sozai_channel channel_knot = {
   .size = sizeof(sozai_channel), .first = WOOD_KNOT, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "knot", .unit = "", .suffixes = "",
   .doc = "Share of the footprint that knots cover, 0 to 1, without their bark."};

static const sozai_channel channel_height = {
   .size = sizeof(sozai_channel), .first = WOOD_HEIGHT, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "height", .unit = "mm", .suffixes = "",
   .doc = "Above the face: of the surface's relief, and the layout's bevels, joints and cupping."};

static const sozai_channel channel_fiber_lobe = {
   .size = sizeof(sozai_channel), .first = WOOD_FIBER_LOBE, .components = 3,
   .needs = SOZAI_INPUT_POINT | SOZAI_INPUT_NORMAL,
   .uses = SOZAI_INPUT_FOOTPRINT,
   .id = "fiber_lobe", .unit = "share", .suffixes = "xyz",
   .doc = "For a host that builds the fibres' lobe itself: `fiber`, object space, as long as the share of the footprint that shines so, which is a factor of `cone_colour`. Means of it stay right. It may be 0: where a joint is, and with `reflection: fibre_cone` in a flake (see `ray_lobe`) or a vessel, unless the relief shades those or a picture stands for the section."};

static const sozai_channel channel_ray_lobe = {
   .size = sizeof(sozai_channel), .first = WOOD_RAY_LOBE, .components = 3,
   .needs = SOZAI_INPUT_POINT | SOZAI_INPUT_NORMAL,
   .uses = SOZAI_INPUT_FOOTPRINT,
   .id = "ray_lobe", .unit = "share", .suffixes = "xyz",
   .doc = "The same of the cone about rays' cells, by which flakes flash: the radius, outwards, as long as the share of the footprint that shines so, a factor of `cone_colour` times `ray_lustre`. 0 beside rays, and with `reflection: kawai`."};

static const sozai_channel channel_ray_lustre = {
   .size = sizeof(sozai_channel), .first = WOOD_RAY_LUSTRE, .components = 1,
   .needs = SOZAI_INPUT_POINT | SOZAI_INPUT_NORMAL,
   .uses = SOZAI_INPUT_FOOTPRINT,
   .id = "ray_lustre", .unit = "ratio", .suffixes = "",
   .doc = "The parameter, for `ray_lobe`: the same all over. 0 with `reflection: kawai`."};

const sozai_channel *const wood_channels[] = {
   &channel_albedo, &channel_radiance, &channel_fiber, &channel_dive, &channel_specular, &channel_roughness, &channel_time, &channel_latewood, &channel_vessel, &channel_reference, &channel_cone_colour, &channel_cone_width, &channel_coat, &channel_coat_roughness, &channel_ray,
   &channel_board_id, &channel_board_u, &channel_board_v, &channel_board_edge, &channel_normal, &channel_height, &channel_canal, &channel_knot, &channel_parenchyma,
   &channel_fiber_lobe, &channel_ray_lobe, &channel_ray_lustre};
/* clang-format on */
const uint32_t wood_channel_count = COUNT(wood_channels);
