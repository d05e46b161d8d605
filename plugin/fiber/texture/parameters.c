/* SPDX-License-Identifier: Apache-2.0
 *
 * Fibre's parameters and output channels, as data.
 */
#include "parameters.h"

#include "../../core/count.h"
#include "texture.h"

/* clang-format off */
static const sozai_parameter seed = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_INT,
   .id = "seed", .label = "Seed", .group = "fiber", .unit = "",
   .doc = "Which aggregate: another seed is another piece of the same.",
   .hard_min = 0, .hard_max = 4294967295, .soft_min = 0, .soft_max = 1000, .default_number = {1}};

static const sozai_parameter object = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_TEXT,
   .id = "object", .label = "Object", .group = "fiber", .unit = "",
   .doc = "A name that is mixed into the seed, so that each object has strands of its own. Empty: the seed alone.",
   .default_text = ""};

static const sozai_parameter offset = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT3,
   .id = "offset", .label = "Offset", .group = "fiber", .unit = "mm",
   .doc = "Added to the point: another part of the same.",
   .hard_min = -100000, .hard_max = 100000, .soft_min = -1000, .soft_max = 1000, .default_number = {0, 0, 0}};

static const char *const structure_choices[] = {"aggregate", "woven"};
static const char *const structure_docs[] = {
   "matted, loose, combed or standing as pile, below the hull",
   "in yarns, over and under one another"};

static const sozai_parameter structure = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "structure", .label = "Structure", .group = "fiber", .unit = "",
   .doc = "How the strands lie.",
   .choices = structure_choices, .choice_docs = structure_docs, .choice_count = COUNT(structure_choices), .default_number = {0}};

static const char *const axis_choices[] = {"x", "y", "z"};
static const char *const axis_docs[] = {
   "+x",
   "+y",
   "+z"};

static const sozai_parameter axis = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "axis", .label = "Axis", .group = "fiber", .unit = "",
   .doc = "Which axis of the object strands are aligned with, pile leans towards, and warp runs along.",
   .choices = axis_choices, .choice_docs = axis_docs, .choice_count = COUNT(axis_choices), .default_number = {1}};

static const sozai_parameter diameter = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "diameter", .label = "Diameter", .group = "strand", .unit = "um",
   .doc = "Of a strand, the mean.",
   .hard_min = 1, .hard_max = 2000, .soft_min = 5, .soft_max = 200, .default_number = {25}};

static const sozai_parameter diameter_spread = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "diameter_spread", .label = "Diameter's spread", .group = "strand", .unit = "",
   .doc = "How much thicker or thinner a strand may be, relatively; 0.6 times this is about the standard deviation.",
   .hard_min = 0, .hard_max = 0.8, .soft_min = 0, .soft_max = 0.7, .default_number = {0.35}};

static const sozai_parameter crimp = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "crimp", .label = "Crimp", .group = "strand", .unit = "1/cm",
   .doc = "Waves that neighbouring strands share, to a centimetre of length; 0: none.",
   .hard_min = 0, .hard_max = 100, .soft_min = 0, .soft_max = 20, .default_number = {4}};

static const sozai_parameter crimp_height = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "crimp_height", .label = "Crimp's height", .group = "strand", .unit = "mm",
   .doc = "Half of trough to crest. Limited to a slope of 1.",
   .hard_min = 0, .hard_max = 10, .soft_min = 0, .soft_max = 3, .default_number = {0.15}};

static const sozai_parameter waver = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "waver", .label = "Waver", .group = "strand", .unit = "",
   .doc = "How far each strand strays from its neighbours' course: 0 parallel, 1 crossing them.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.8}};

static const sozai_parameter packing = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "packing", .label = "Packing", .group = "aggregate", .unit = "",
   .doc = "Share of the shell's volume that is fibre.",
   .hard_min = 0.0001, .hard_max = 0.7, .soft_min = 0.002, .soft_max = 0.4, .default_number = {0.12}};

static const sozai_parameter thickness = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "thickness", .label = "Thickness", .group = "aggregate", .unit = "mm",
   .doc = "Of the shell of strands below the hull.",
   .hard_min = 0.01, .hard_max = 1000, .soft_min = 0.2, .soft_max = 30, .default_number = {3}};

static const sozai_parameter bundle = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "bundle", .label = "Bundle", .group = "aggregate", .unit = "mm",
   .doc = "How far strands run before another's course hides them; neighbours within it lie alike.",
   .hard_min = 0.05, .hard_max = 500, .soft_min = 0.3, .soft_max = 20, .default_number = {1.6}};

static const sozai_parameter alignment = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "alignment", .label = "Alignment", .group = "aggregate", .unit = "",
   .doc = "0: every direction on the surface as often; 1: all along the axis.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter elevation = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "elevation", .label = "Elevation", .group = "aggregate", .unit = "deg",
   .doc = "How steeply strands rise out of the surface, the mean: 0 lying, 70 a pile.",
   .hard_min = 0, .hard_max = 80, .soft_min = 0, .soft_max = 75, .default_number = {0}};

static const sozai_parameter elevation_spread = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "elevation_spread", .label = "Elevation's spread", .group = "aggregate", .unit = "deg",
   .doc = "How much steeper or flatter a strand may be.",
   .hard_min = 0, .hard_max = 60, .soft_min = 0, .soft_max = 45, .default_number = {15}};

static const sozai_parameter nap_drift = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "nap_drift", .label = "Nap's drift", .group = "aggregate", .unit = "deg",
   .doc = "How far strands' direction strays from patch to patch, as in a nap that was brushed, stroked or crushed: of that angle the standard deviation.",
   .hard_min = 0, .hard_max = 60, .soft_min = 0, .soft_max = 30, .default_number = {0}};

static const sozai_parameter nap_reach = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "nap_reach", .label = "Nap's reach", .group = "aggregate", .unit = "mm",
   .doc = "How wide such patches are, about.",
   .hard_min = 1, .hard_max = 10000, .soft_min = 5, .soft_max = 300, .default_number = {30}};

static const sozai_parameter flyaway = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "flyaway", .label = "Flyaway", .group = "aggregate", .unit = "",
   .doc = "Share of the surface that single strands standing off it cover, as a nap does. Each 0.08 of it takes a layer more, up to 0.4.",
   .hard_min = 0, .hard_max = 0.5, .soft_min = 0, .soft_max = 0.4, .default_number = {0.03}};

static const sozai_parameter flyaway_height = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "flyaway_height", .label = "Flyaway's height", .group = "aggregate", .unit = "mm",
   .doc = "How far over the rest they are.",
   .hard_min = 0, .hard_max = 50, .soft_min = 0, .soft_max = 5, .default_number = {0.3}};

static const char *const weave_choices[] = {"plain", "basket", "twill_2_1", "twill_3_1", "twill_2_2", "satin"};
static const char *const weave_docs[] = {
   "one over, one under",
   "two over, two under, in pairs",
   "two over, one under, a step to the side in each row",
   "three over, one under: denim",
   "two over, two under: serge, herringbone's half",
   "four over, one under, two steps to the side"};

static const sozai_parameter weave = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "weave", .label = "Weave", .group = "cloth", .unit = "",
   .doc = "Which yarns lie on top.",
   .choices = weave_choices, .choice_docs = weave_docs, .choice_count = COUNT(weave_choices), .default_number = {0}};

static const sozai_parameter yarn_spacing = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "yarn_spacing", .label = "Warp's spacing", .group = "cloth", .unit = "mm",
   .doc = "From the middle of one warp yarn to the next.",
   .hard_min = 0.02, .hard_max = 100, .soft_min = 0.1, .soft_max = 5, .default_number = {0.5}};

static const sozai_parameter weft_spacing = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "weft_spacing", .label = "Weft's spacing", .group = "cloth", .unit = "mm",
   .doc = "From the middle of one weft yarn to the next; 0: the warp's.",
   .hard_min = 0, .hard_max = 100, .soft_min = 0, .soft_max = 5, .default_number = {0}};

static const sozai_parameter yarn_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "yarn_width", .label = "Yarn's width", .group = "cloth", .unit = "",
   .doc = "Over the spacing: below 1 there are holes, above it yarns press on one another.",
   .hard_min = 0.2, .hard_max = 1.4, .soft_min = 0.6, .soft_max = 1.3, .default_number = {0.94}};

static const sozai_parameter yarn_flatness = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "yarn_flatness", .label = "Yarn's thickness", .group = "cloth", .unit = "",
   .doc = "Over its width: 1 round, 0.4 pressed flat.",
   .hard_min = 0.1, .hard_max = 1, .soft_min = 0.2, .soft_max = 1, .default_number = {0.6}};

static const sozai_parameter yarn_swell = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "yarn_swell", .label = "Yarn's swell", .group = "cloth", .unit = "",
   .doc = "How much broader a yarn is where it lies on top, unpressed, than where it lies below, over its width.",
   .hard_min = 0, .hard_max = 0.6, .soft_min = 0, .soft_max = 0.5, .default_number = {0.2}};

static const sozai_parameter twist = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "twist", .label = "Twist", .group = "cloth", .unit = "deg",
   .doc = "Of the strands about their yarn, at its surface: positive S, negative Z.",
   .hard_min = -60, .hard_max = 60, .soft_min = -40, .soft_max = 40, .default_number = {22}};

static const sozai_parameter slub = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "slub", .label = "Unevenness", .group = "cloth", .unit = "",
   .doc = "How unevenly yarns are spun: how much their width and course vary.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.4}};

static const sozai_parameter hollow = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "hollow", .label = "Shade between yarns", .group = "cloth", .unit = "",
   .doc = "How dark the furrows between the yarns are.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.6}};

static const sozai_parameter colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "colour", .label = "Colour", .group = "colour", .unit = "",
   .doc = "Of a strand's body, seen in bulk.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1,
   .default_number = {222 / 255.0, 212 / 255.0, 190 / 255.0}, .default_text = "sRGB"};

static const sozai_parameter second_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "second_colour", .label = "Second colour", .group = "colour", .unit = "",
   .doc = "Of a share of the strands: melange.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1,
   .default_number = {120 / 255.0, 112 / 255.0, 100 / 255.0}, .default_text = "sRGB"};

static const sozai_parameter weft_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "weft_colour", .label = "Weft's colour", .group = "colour", .unit = "",
   .doc = "Of a cloth's weft, where `colour` is the warp's.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1,
   .default_number = {222 / 255.0, 212 / 255.0, 190 / 255.0}, .default_text = "sRGB"};

static const sozai_parameter second_share = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "second_share", .label = "Second colour's share", .group = "colour", .unit = "",
   .doc = "Of the strands.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter variation = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "variation", .label = "Variation", .group = "colour", .unit = "",
   .doc = "How much lighter or darker a strand may be, relatively.",
   .hard_min = 0, .hard_max = 0.6, .soft_min = 0, .soft_max = 0.35, .default_number = {0.12}};

static const sozai_parameter mottle = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "mottle", .label = "Mottle", .group = "colour", .unit = "",
   .doc = "Clouds of brightness over all strands, as in felt, lint and dust: relative, the standard deviation; 1 in the mean.",
   .hard_min = 0, .hard_max = 0.5, .soft_min = 0, .soft_max = 0.2, .default_number = {0}};

static const sozai_parameter mottle_size = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "mottle_size", .label = "Mottle's size", .group = "colour", .unit = "mm",
   .doc = "How wide the large clouds are, about; there are others of a half.",
   .hard_min = 0.5, .hard_max = 10000, .soft_min = 3, .soft_max = 300, .default_number = {15}};

static const sozai_parameter ior = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "ior", .label = "Index of refraction", .group = "light", .unit = "",
   .doc = "Of the fibre: cellulose 1.53, wool 1.55, silk 1.56, polyester 1.6.",
   .hard_min = 1.05, .hard_max = 2.5, .soft_min = 1.3, .soft_max = 1.8, .default_number = {1.55}};

static const sozai_parameter roughness = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "roughness", .label = "Roughness", .group = "light", .unit = "deg",
   .doc = "Of the gloss along a strand: its standard deviation.",
   .hard_min = 2, .hard_max = 45, .soft_min = 4, .soft_max = 25, .default_number = {10}};

static const sozai_parameter tilt = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "tilt", .label = "Tilt of scales", .group = "light", .unit = "deg",
   .doc = "Of the cuticle's scales towards the tip: shifts the gloss.",
   .hard_min = -10, .hard_max = 10, .soft_min = 0, .soft_max = 5, .default_number = {3}};

static const sozai_parameter transmission = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "transmission", .label = "Transmission", .group = "light", .unit = "",
   .doc = "How clear strands are: what of the light goes on through them at the first.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.4}};

static const sozai_parameter darkening = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "darkening", .label = "Darkening", .group = "light", .unit = "",
   .doc = "How much darker strands look the deeper they lie.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.6}};

const sozai_parameter *const fibertex_parameters[FIBERTEX_PARAMETERS] = {
   [P_SEED] = &seed,
   [P_OBJECT] = &object,
   [P_OFFSET] = &offset,
   [P_STRUCTURE] = &structure,
   [P_AXIS] = &axis,
   [P_DIAMETER] = &diameter,
   [P_DIAMETER_SPREAD] = &diameter_spread,
   [P_CRIMP] = &crimp,
   [P_CRIMP_HEIGHT] = &crimp_height,
   [P_WAVER] = &waver,
   [P_PACKING] = &packing,
   [P_THICKNESS] = &thickness,
   [P_BUNDLE] = &bundle,
   [P_ALIGNMENT] = &alignment,
   [P_ELEVATION] = &elevation,
   [P_ELEVATION_SPREAD] = &elevation_spread,
   [P_NAP_DRIFT] = &nap_drift,
   [P_NAP_REACH] = &nap_reach,
   [P_FLYAWAY] = &flyaway,
   [P_FLYAWAY_HEIGHT] = &flyaway_height,
   [P_WEAVE] = &weave,
   [P_YARN_SPACING] = &yarn_spacing,
   [P_WEFT_SPACING] = &weft_spacing,
   [P_YARN_WIDTH] = &yarn_width,
   [P_YARN_FLATNESS] = &yarn_flatness,
   [P_YARN_SWELL] = &yarn_swell,
   [P_TWIST] = &twist,
   [P_SLUB] = &slub,
   [P_HOLLOW] = &hollow,
   [P_COLOUR] = &colour,
   [P_SECOND] = &second_colour,
   [P_WEFT] = &weft_colour,
   [P_SECOND_SHARE] = &second_share,
   [P_VARIATION] = &variation,
   [P_MOTTLE] = &mottle,
   [P_MOTTLE_SIZE] = &mottle_size,
   [P_IOR] = &ior,
   [P_ROUGHNESS] = &roughness,
   [P_TILT] = &tilt,
   [P_TRANSMISSION] = &transmission,
   [P_DARKENING] = &darkening};

static const sozai_channel channel_albedo = {
   .size = sizeof(sozai_channel), .first = FIBERTEX_ALBEDO, .components = 3,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_VIEW | SOZAI_INPUT_FOOTPRINT,
   .id = "albedo", .unit = "", .suffixes = "rgb",
   .doc = "Diffuse reflectance of what is seen, in the shade of what is over it, scene-linear, in the working space; times `coverage`. The palette's colours are the mean of strands: single ones of a pale fibre are brighter than 1."};

static const sozai_channel channel_radiance = {
   .size = sizeof(sozai_channel), .first = FIBERTEX_RADIANCE, .components = 3,
   .needs = SOZAI_INPUT_POINT | SOZAI_INPUT_NORMAL | SOZAI_INPUT_LIGHT,
   .uses = SOZAI_INPUT_LIGHT_COLOUR | SOZAI_INPUT_VIEW | SOZAI_INPUT_FOOTPRINT,
   .id = "radiance", .unit = "", .suffixes = "rgb",
   .doc = "Towards the eye under the light, times light_colour and `coverage`: each strand's lobes and diffuse term, in the shade of what is over it."};

static const sozai_channel channel_coverage = {
   .size = sizeof(sozai_channel), .first = FIBERTEX_COVERAGE, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_VIEW | SOZAI_INPUT_FOOTPRINT,
   .id = "coverage", .unit = "", .suffixes = "",
   .doc = "Share of the footprint that strands cover."};

static const sozai_channel channel_tangent = {
   .size = sizeof(sozai_channel), .first = FIBERTEX_TANGENT, .components = 3,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_VIEW | SOZAI_INPUT_FOOTPRINT,
   .id = "tangent", .unit = "", .suffixes = "xyz",
   .doc = "Unit direction of the strand seen, object space; of several their mean."};

static const sozai_channel channel_strand_id = {
   .size = sizeof(sozai_channel), .first = FIBERTEX_STRAND, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_VIEW | SOZAI_INPUT_FOOTPRINT,
   .id = "strand_id", .unit = "", .suffixes = "",
   .doc = "A number between 0 and 1 for the strand seen most of; 0 where there is none."};

static const sozai_channel channel_depth = {
   .size = sizeof(sozai_channel), .first = FIBERTEX_DEPTH, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_VIEW | SOZAI_INPUT_FOOTPRINT,
   .id = "depth", .unit = "mm", .suffixes = "",
   .doc = "Of what is seen below the hull, the mean over what is covered."};

static const sozai_channel channel_height = {
   .size = sizeof(sozai_channel), .first = FIBERTEX_HEIGHT, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_VIEW | SOZAI_INPUT_FOOTPRINT,
   .id = "height", .unit = "mm", .suffixes = "",
   .doc = "The same, upwards: negative."};

static const sozai_channel channel_normal = {
   .size = sizeof(sozai_channel), .first = FIBERTEX_NORMAL, .components = 3,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_VIEW | SOZAI_INPUT_FOOTPRINT,
   .id = "normal", .unit = "", .suffixes = "xyz",
   .doc = "Unit normal of the strand's face towards the eye, object space; of several their mean."};

static const sozai_channel channel_roughness = {
   .size = sizeof(sozai_channel), .first = FIBERTEX_ROUGHNESS, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_VIEW | SOZAI_INPUT_FOOTPRINT,
   .id = "roughness", .unit = "", .suffixes = "",
   .doc = "GGX's alpha: a strand's, and the scatter of the normals that the footprint averages out."};

const sozai_channel *const fibertex_channels[] = {
   &channel_albedo, &channel_radiance, &channel_coverage, &channel_tangent, &channel_strand_id, &channel_depth, &channel_height, &channel_normal, &channel_roughness};
/* clang-format on */
const uint32_t fibertex_channel_count = COUNT(fibertex_channels);
