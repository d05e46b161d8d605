/* SPDX-License-Identifier: Apache-2.0
 *
 * Stone's parameters and output channels, as data.
 */
#include "parameters.h"

#include "../core/count.h"
#include "parameters_laid.h"
#include "stone.h"

/* clang-format off */
static const sozai_parameter seed = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_INT,
   .id = "seed", .label = "Seed", .group = "stone", .unit = "",
   .doc = "Which block: another seed is another block from the same quarry.",
   .hard_min = 0, .hard_max = 4294967295, .soft_min = 0, .soft_max = 1000, .default_number = {1}};

static const sozai_parameter object = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_TEXT,
   .id = "object", .label = "Object", .group = "stone", .unit = "",
   .doc = "A name that is mixed into the seed, so that each object is hewn from a block of its "
   "own. Empty: the seed alone.",
   .default_text = ""};

static const char *const bed_choices[] = {"x", "y", "z", "usual"};
static const char *const bed_docs[] = {
   "+x",
   "+y: beds lie level where +y is up",
   "+z: the face is split along the bed",
   "z where stones are laid, as flags and floors are, else y"};

static const sozai_parameter bed = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "bed", .label = "Bed", .group = "stone", .unit = "",
   .doc = "Which axis of the object lies across the natural bed.",
   .choices = bed_choices, .choice_docs = bed_docs, .choice_count = COUNT(bed_choices), .default_number = {3}};

static const sozai_parameter offset = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT3,
   .id = "offset", .label = "Offset", .group = "stone", .unit = "mm",
   .doc = "Added to the point: another part of the block.",
   .hard_min = -100000, .hard_max = 100000, .soft_min = -1000, .soft_max = 1000, .default_number = {0, 0, 0}};

static const char *const colour_mode_choices[] = {"fabric", "paper_rgb", "paper_lightness"};

static const char *const colour_mode_docs[] = {
   "crystals, beds, inclusions, veins and holes, below",
   "Yamanaka and Nagaoka's: to each texel R, G and B varied independently",
   "the same, but lightness and chroma varied, so that the hue holds"};

static const sozai_parameter colour_mode = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "colour_mode", .label = "Colour mode", .group = "stone", .unit = "",
   .doc = "What gives the colour.",
   .choices = colour_mode_choices, .choice_docs = colour_mode_docs, .choice_count = COUNT(colour_mode_choices), .default_number = {0}};

static const sozai_parameter grain_size = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "grain_size", .label = "Grain size", .group = "grains", .unit = "mm",
   .doc = "Spacing of the crystals' centres, the mean.",
   .hard_min = 0.05, .hard_max = 200, .soft_min = 0.2, .soft_max = 20, .default_number = {2}};

static const sozai_parameter grain_grading = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "grain_grading", .label = "Grading", .group = "grains", .unit = "",
   .doc = "How unequal in size the crystals are: 0 even, 1 seriate.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.6}};

static const sozai_parameter grain_stretch = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "grain_stretch", .label = "Stretch", .group = "grains", .unit = "",
   .doc = "How much longer crystals are along the bed than across it.",
   .hard_min = 0.2, .hard_max = 20, .soft_min = 1, .soft_max = 6, .default_number = {1}};

static const sozai_parameter grain_interlock = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "grain_interlock", .label = "Interlock", .group = "grains", .unit = "",
   .doc = "How far the crystals' outlines stray from planes: 0 mosaic, 1 sutured.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.6}};

static const sozai_parameter grain_blur = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "grain_blur", .label = "Translucency", .group = "grains", .unit = "mm",
   .doc = "How far light carries from one crystal into the next: the width of their borders.",
   .hard_min = 0, .hard_max = 20, .soft_min = 0, .soft_max = 1, .default_number = {0.1}};

static const sozai_parameter second_share = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "second_share", .label = "Second mineral's share", .group = "grains", .unit = "",
   .doc = "Share of the grains that are of the second mineral. Where the second and the third ask for more "
   "than all, both get less, in proportion.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter third_share = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "third_share", .label = "Third mineral's share", .group = "grains", .unit = "",
   .doc = "Share of the grains that are of the third mineral; likewise.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter grain_variation = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "grain_variation", .label = "Crystals' variation", .group = "grains", .unit = "",
   .doc = "How much lighter or darker than its mineral a grain, or a part of one, may be; strays "
   "to three times this.",
   .hard_min = 0, .hard_max = 0.35, .soft_min = 0, .soft_max = 0.2, .default_number = {0.1}};

static const sozai_parameter grain_depth = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "grain_depth", .label = "Depth", .group = "grains", .unit = "",
   .doc = "How clear the crystals are: how much of their neighbours is seen through their edges, "
   "over some quarter of a grain.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter grain_clustering = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "grain_clustering", .label = "Clustering", .group = "grains", .unit = "",
   .doc = "How much grains of the second and third mineral keep together: of some four grains' size, "
   "places have up to this part more or less of them.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 0.8, .default_number = {0}};

static const sozai_parameter grain_seriate = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "grain_seriate", .label = "Seriate sizes", .group = "grains", .unit = "",
   .doc = "How far grains range in size, as in rocks of seriate texture: how often two, four or eight "
   "that lie together are one crystal. grain_size stays the mean crystal's, by number; the largest "
   "are up to eight times the least in volume.",
   .hard_min = 0, .hard_max = 0.6, .soft_min = 0, .soft_max = 0.5, .default_number = {0}};

static const sozai_parameter cleavage = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "cleavage", .label = "Cleavage", .group = "grains", .unit = "",
   .doc = "How plain the lamellae of cleavage and twins are: weakest in the second mineral, strongest "
   "in black specks, as of mica, which also differ from one to the next.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter turbidity = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "turbidity", .label = "Turbidity", .group = "grains", .unit = "",
   .doc = "How clouded crystals are within, flecked or, in the second mineral, crossed by healed "
   "cracks.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter bed_thickness = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "bed_thickness", .label = "Bed thickness", .group = "bedding", .unit = "mm",
   .doc = "Of a layer of sediment, the mean.",
   .hard_min = 0.2, .hard_max = 10000, .soft_min = 2, .soft_max = 300, .default_number = {20}};

static const sozai_parameter bed_contrast = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "bed_contrast", .label = "Bed contrast", .group = "bedding", .unit = "",
   .doc = "How far the layers go from the base's colour to bed_colour; on the average half of "
   "this.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter bed_wave = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "bed_wave", .label = "Wave", .group = "bedding", .unit = "mm",
   .doc = "How far the layers rise and fall.",
   .hard_min = 0, .hard_max = 1000, .soft_min = 0, .soft_max = 100, .default_number = {3}};

static const sozai_parameter bed_wavelength = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "bed_wavelength", .label = "Wavelength", .group = "bedding", .unit = "mm",
   .doc = "Of that rise and fall.",
   .hard_min = 1, .hard_max = 100000, .soft_min = 20, .soft_max = 1000, .default_number = {120}};

static const sozai_parameter bed_pinching = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "bed_pinching", .label = "Pinch and swell", .group = "bedding", .unit = "",
   .doc = "How much the thickness of beds changes along their way, sd: at 0 all of them wave alike. "
   "Without waves it is nothing.",
   .hard_min = 0, .hard_max = 0.5, .soft_min = 0, .soft_max = 0.4, .default_number = {0}};

static const sozai_parameter mottle = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "mottle", .label = "Mottle", .group = "bedding", .unit = "",
   .doc = "Cloudiness: the relative shift of brightness, which stays within twice this.",
   .hard_min = 0, .hard_max = 0.4, .soft_min = 0, .soft_max = 0.3, .default_number = {0}};

static const sozai_parameter mottle_size = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "mottle_size", .label = "Mottle size", .group = "bedding", .unit = "mm",
   .doc = "Of the clouds.",
   .hard_min = 0.5, .hard_max = 10000, .soft_min = 1, .soft_max = 300, .default_number = {30}};

static const sozai_parameter inclusion_size = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_size", .label = "Inclusion size", .group = "inclusions", .unit = "mm",
   .doc = "Spacing at which inclusions (phenocrysts, clasts, fossils, a terrazzo's chips) would "
   "fill the stone: their largest size.",
   .hard_min = 0.1, .hard_max = 1000, .soft_min = 1, .soft_max = 80, .default_number = {10}};

static const sozai_parameter inclusion_share = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_share", .label = "Inclusions' share", .group = "inclusions", .unit = "",
   .doc = "Share of area of inclusions of the first kind. Gap, grading and roundness leave so much room and "
   "no more: where the kinds ask for more, all get less, in proportion.",
   .hard_min = 0, .hard_max = 0.9, .soft_min = 0, .soft_max = 0.8, .default_number = {0}};

static const sozai_parameter inclusion_second_share = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_second_share", .label = "Second inclusions' share", .group = "inclusions", .unit = "",
   .doc = "Share of area of inclusions of the second kind; likewise.",
   .hard_min = 0, .hard_max = 0.9, .soft_min = 0, .soft_max = 0.8, .default_number = {0}};

static const sozai_parameter inclusion_third_share = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_third_share", .label = "Third inclusions' share", .group = "inclusions", .unit = "",
   .doc = "Share of area of inclusions of the third kind; likewise. They have no rim.",
   .hard_min = 0, .hard_max = 0.9, .soft_min = 0, .soft_max = 0.8, .default_number = {0}};

static const sozai_parameter inclusion_gap = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_gap", .label = "Gap", .group = "inclusions", .unit = "mm",
   .doc = "What stays free between an inclusion and its neighbours.",
   .hard_min = 0, .hard_max = 100, .soft_min = 0, .soft_max = 5, .default_number = {0.3}};

static const sozai_parameter inclusion_roundness = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_roundness", .label = "Roundness", .group = "inclusions", .unit = "",
   .doc = "0: angular, as crystals and crushed chips; 1: cut to balls.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const char *const inclusion_contact_choices[] = {"long", "tangential"};
static const char *const inclusion_contact_docs[] = {
   "straight, along the faces by which neighbours cut each other",
   "at points: each whole and rounded, large ones and small ones between them"};

static const sozai_parameter inclusion_contact = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "inclusion_contact", .label = "Contact", .group = "inclusions", .unit = "",
   .doc = "How inclusions meet (grain contacts: Taylor J. M., AAPG Bulletin 34, 1950).",
   .choices = inclusion_contact_choices, .choice_docs = inclusion_contact_docs,
   .choice_count = COUNT(inclusion_contact_choices), .default_number = {0}};

static const sozai_parameter inclusion_grading = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_grading", .label = "Inclusion grading", .group = "inclusions", .unit = "",
   .doc = "How unequal in size they are.",
   .hard_min = 0, .hard_max = 0.95, .soft_min = 0, .soft_max = 0.95, .default_number = {0.5}};

static const sozai_parameter inclusion_stretch = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_stretch", .label = "Inclusion stretch", .group = "inclusions", .unit = "",
   .doc = "How much longer they are along the bed than across it.",
   .hard_min = 0.2, .hard_max = 20, .soft_min = 1, .soft_max = 6, .default_number = {1}};

static const sozai_parameter inclusion_interlock = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_interlock", .label = "Raggedness", .group = "inclusions", .unit = "",
   .doc = "How far their outlines stray from planes or balls.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.1}};

static const sozai_parameter inclusion_variation = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_variation", .label = "Inclusion variation", .group = "inclusions", .unit = "",
   .doc = "How much lighter or darker than its kind an inclusion may be; strays to three times this.",
   .hard_min = 0, .hard_max = 0.35, .soft_min = 0, .soft_max = 0.3, .default_number = {0.1}};

static const sozai_parameter inclusion_polymict = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_polymict", .label = "Polymict inclusions", .group = "inclusions", .unit = "",
   .doc = "How far an inclusion's colour lies towards that of the other kind, or away from it, by chance: at 0.3 both kinds are two rocks each, four in all, as in gravel. Of a third kind, towards what lies between the two or away from it: then there are six.",
   .hard_min = 0, .hard_max = 0.5, .soft_min = 0, .soft_max = 0.5, .default_number = {0}};

static const sozai_parameter inclusion_blur = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_blur", .label = "Inclusion blur", .group = "inclusions", .unit = "mm",
   .doc = "How gradually an inclusion becomes what holds it: the width of its border.",
   .hard_min = 0, .hard_max = 50, .soft_min = 0, .soft_max = 4, .default_number = {0.03}};

static const sozai_parameter inclusion_rim = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_rim", .label = "Inclusion rim", .group = "inclusions", .unit = "mm",
   .doc = "How thick a rim of the second inclusions' colour the first ones have, in the mean; each "
   "one's from 0.4 to 1.6 of it.",
   .hard_min = 0, .hard_max = 500, .soft_min = 0, .soft_max = 10, .default_number = {0}};

static const sozai_parameter inclusion_cleavage = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_cleavage", .label = "Inclusion cleavage", .group = "inclusions", .unit = "",
   .doc = "How clear the lamellae of cleavage and twins are within inclusions, as in phenocrysts.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter inclusion_zoning = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_zoning", .label = "Inclusion zoning", .group = "inclusions", .unit = "",
   .doc = "How plain the zones of growth are within inclusions, lighter and darker ones along their outline, some "
   "four to the middle: as of zoned feldspars and nodules.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter inclusion_turbidity = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_turbidity", .label = "Inclusion turbidity", .group = "inclusions", .unit = "",
   .doc = "How clouded and flecked inclusions are within, as altered phenocrysts are.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter inclusion_opacity = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_opacity", .label = "Inclusion opacity", .group = "inclusions", .unit = "",
   .doc = "How much inclusions hide of what they lie in: 1 all, as chips and phenocrysts do; below, its "
   "grains, specks, beds and clouds are seen on within them, as in nodules, fossils and fragments of "
   "the same rock.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {1}};

static const sozai_parameter inclusion_relief = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "inclusion_relief", .label = "Inclusion relief", .group = "inclusions", .unit = "mm",
   .doc = "How far inclusions stand out of the face, as of washed aggregate: their tops, which are "
   "smoother than the finish. Below 0 they have weathered back so far.",
   .hard_min = -50, .hard_max = 50, .soft_min = -5, .soft_max = 8, .default_number = {0}};

static const sozai_parameter speck_size = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "speck_size", .label = "Speck size", .group = "specks", .unit = "mm",
   .doc = "Largest size of the specks.",
   .hard_min = 0.05, .hard_max = 50, .soft_min = 0.2, .soft_max = 6, .default_number = {1}};

static const sozai_parameter black_share = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "black_share", .label = "Black specks' share", .group = "specks", .unit = "",
   .doc = "Share of area: mica, hornblende, ore. Round or ragged specks leave room for some 0.3 to 0.45, flakes for less: where the two kinds "
   "ask for more, both get less, in proportion.",
   .hard_min = 0, .hard_max = 0.5, .soft_min = 0, .soft_max = 0.2, .default_number = {0}};

static const sozai_parameter white_share = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "white_share", .label = "White specks' share", .group = "specks", .unit = "",
   .doc = "Share of area: quartz, shell, calcite, laths of plagioclase; likewise.",
   .hard_min = 0, .hard_max = 0.5, .soft_min = 0, .soft_max = 0.4, .default_number = {0}};

static const sozai_parameter speck_stretch = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "speck_stretch", .label = "Speck stretch", .group = "specks", .unit = "",
   .doc = "How much longer they are along the bed than across it.",
   .hard_min = 0.2, .hard_max = 20, .soft_min = 1, .soft_max = 6, .default_number = {1}};

static const sozai_parameter speck_flatness = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "speck_flatness", .label = "Speck flatness", .group = "specks", .unit = "",
   .doc = "How flat they are: 0 as thick as broad, 1 flakes of a seventh of that, as of mica; each "
   "lies its own way.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter speck_raggedness = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "speck_raggedness", .label = "Speck raggedness", .group = "specks", .unit = "",
   .doc = "How frayed their outlines are: 0 smooth, as of crystals that grew freely, 1 as of mica that grew last, in "
   "what the others left.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.15}};

static const sozai_parameter speck_clustering = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "speck_clustering", .label = "Speck clustering", .group = "specks", .unit = "",
   .doc = "How much specks keep together: of some four specks' size, places have up to this part "
   "more or less of them.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter speck_aggregation = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "speck_aggregation", .label = "Speck aggregation", .group = "specks", .unit = "",
   .doc = "How often specks lie in clots of two, four or eight that touch, as mica does. Their share "
   "stays what it is.",
   .hard_min = 0, .hard_max = 0.9, .soft_min = 0, .soft_max = 0.8, .default_number = {0}};

static const sozai_parameter vein_spacing = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "vein_spacing", .label = "Vein spacing", .group = "veins", .unit = "mm",
   .doc = "From vein to vein, about.",
   .hard_min = 1, .hard_max = 10000, .soft_min = 20, .soft_max = 600, .default_number = {120}};

static const sozai_parameter vein_width = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "vein_width", .label = "Vein width", .group = "veins", .unit = "mm",
   .doc = "Greatest width; veins swell and pinch out. 0: none.",
   .hard_min = 0, .hard_max = 500, .soft_min = 0, .soft_max = 120, .default_number = {0}};

static const sozai_parameter vein_softness = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "vein_softness", .label = "Vein softness", .group = "veins", .unit = "mm",
   .doc = "How gradually a vein becomes the stone beside it.",
   .hard_min = 0, .hard_max = 500, .soft_min = 0, .soft_max = 50, .default_number = {1}};

static const sozai_parameter vein_warp = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "vein_warp", .label = "Vein warp", .group = "veins", .unit = "",
   .doc = "How contorted they are: straight and even at 0; at 1 a vein strays by as much as two stand "
   "apart, and they meet.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.5}};

static const sozai_parameter vein_crossing = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "vein_crossing", .label = "Vein crossing", .group = "veins", .unit = "",
   .doc = "How many of the finer veins there are that cross the first ones in two directions.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.5}};

static const sozai_parameter vein_variation = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "vein_variation", .label = "Vein variation", .group = "veins", .unit = "",
   .doc = "How streaked veins are along their way: streaks leave out up to this part of their colour, half of it in the mean.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter hole_size = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "hole_size", .label = "Hole size", .group = "holes", .unit = "mm",
   .doc = "Largest size across the bed of open pores and vugs.",
   .hard_min = 0.1, .hard_max = 500, .soft_min = 0.5, .soft_max = 40, .default_number = {6}};

static const sozai_parameter hole_share = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "hole_share", .label = "Holes' share", .group = "holes", .unit = "",
   .doc = "Share of area. There is room for some 0.2, of many small ones for 0.15, and no more comes.",
   .hard_min = 0, .hard_max = 0.4, .soft_min = 0, .soft_max = 0.2, .default_number = {0}};

static const sozai_parameter hole_stretch = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "hole_stretch", .label = "Hole stretch", .group = "holes", .unit = "",
   .doc = "How much longer they are along the bed.",
   .hard_min = 0.2, .hard_max = 20, .soft_min = 1, .soft_max = 8, .default_number = {1}};

static const sozai_parameter hole_bedding = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "hole_bedding", .label = "Hole bedding", .group = "holes", .unit = "",
   .doc = "How much they keep to certain beds, at 1 leaving others without any.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter hole_raggedness = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "hole_raggedness", .label = "Hole raggedness", .group = "holes", .unit = "",
   .doc = "How bent their outlines are: little of vesicles, much of vugs that water has eaten.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.5}};

static const sozai_parameter hole_fines = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "hole_fines", .label = "Pin-holes", .group = "holes", .unit = "",
   .doc = "How far small holes outnumber large ones: at 0 a fourth of them are less than half as large as "
   "the largest, at 1 half of them.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0}};

static const sozai_parameter hole_variation = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "hole_variation", .label = "Hole variation", .group = "holes", .unit = "",
   .doc = "How much lighter or darker than hole_colour a hole may be.",
   .hard_min = 0, .hard_max = 0.6, .soft_min = 0, .soft_max = 0.5, .default_number = {0}};

static const sozai_parameter base_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "base_colour", .label = "Base", .group = "colour", .unit = "",
   .doc = "The first mineral, or the ground mass.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.7686, 0.7529, 0.7294}, .default_text = "sRGB"};

static const sozai_parameter second_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "second_colour", .label = "Second mineral", .group = "colour", .unit = "",
   .doc = "Of the grains.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.5882, 0.5804, 0.5725}, .default_text = "sRGB"};

static const sozai_parameter third_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "third_colour", .label = "Third mineral", .group = "colour", .unit = "",
   .doc = "Of the grains.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.4314, 0.4157, 0.4}, .default_text = "sRGB"};

static const sozai_parameter bed_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "bed_colour", .label = "Beds", .group = "colour", .unit = "",
   .doc = "What layers shade the base into.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.6667, 0.5882, 0.4706}, .default_text = "sRGB"};

static const sozai_parameter inclusion_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "inclusion_colour", .label = "Inclusions", .group = "colour", .unit = "",
   .doc = "Of the first kind.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.8627, 0.8471, 0.8235}, .default_text = "sRGB"};

static const sozai_parameter inclusion_second_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "inclusion_second_colour", .label = "Second inclusions", .group = "colour", .unit = "",
   .doc = "Of the second kind.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.3529, 0.3137, 0.2745}, .default_text = "sRGB"};

static const sozai_parameter inclusion_third_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "inclusion_third_colour", .label = "Third inclusions", .group = "colour", .unit = "",
   .doc = "Of the third kind.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.5608, 0.3529, 0.2902}, .default_text = "sRGB"};

static const sozai_parameter black_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "black_colour", .label = "Black specks", .group = "colour", .unit = "",
   .doc = "Of the black specks.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.1098, 0.1059, 0.1059}, .default_text = "sRGB"};

static const sozai_parameter white_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "white_colour", .label = "White specks", .group = "colour", .unit = "",
   .doc = "Of the white specks.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.9333, 0.9255, 0.9098}, .default_text = "sRGB"};

static const sozai_parameter vein_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "vein_colour", .label = "Veins", .group = "colour", .unit = "",
   .doc = "Of the veins.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.4706, 0.4784, 0.4941}, .default_text = "sRGB"};

static const sozai_parameter hole_colour = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_COLOUR,
   .id = "hole_colour", .label = "Holes", .group = "colour", .unit = "",
   .doc = "What is seen of their depth.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.2745, 0.2275, 0.1804}, .default_text = "sRGB"};

static const sozai_parameter paper_texel = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "paper_texel", .label = "Texel", .group = "paper", .unit = "mm",
   .doc = "Side of a texel, a cube in space.",
   .hard_min = 0.01, .hard_max = 1000, .soft_min = 0.1, .soft_max = 10, .default_number = {1}};

static const sozai_parameter paper_base = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT3,
   .id = "paper_base", .label = "Paper's base", .group = "paper", .unit = "code",
   .doc = "R, G and B of display-referred sRGB, 8 bits.",
   .hard_min = 0, .hard_max = 255, .soft_min = 0, .soft_max = 255, .default_number = {50, 50, 50}};

static const sozai_parameter paper_variation = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT3,
   .id = "paper_variation", .label = "Paper's variation", .group = "paper", .unit = "code",
   .doc = "paper_rgb: the most that R, G and B each depart from the base.",
   .hard_min = 0, .hard_max = 255, .soft_min = 0, .soft_max = 100, .default_number = {30, 30, 30}};

static const sozai_parameter paper_lightness = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "paper_lightness", .label = "Lightness variation", .group = "paper", .unit = "code",
   .doc = "paper_lightness: the most that all three rise or fall together.",
   .hard_min = 0, .hard_max = 255, .soft_min = 0, .soft_max = 100, .default_number = {30}};

static const sozai_parameter paper_chroma = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "paper_chroma", .label = "Chroma variation", .group = "paper", .unit = "",
   .doc = "paper_lightness: the most that their departure from grey grows or shrinks, relative.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1, .default_number = {0.3}};

static const sozai_parameter paper_black = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "paper_black", .label = "Black texels", .group = "paper", .unit = "",
   .doc = "Their proportion; RGB 0, 0, 0.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 0.2, .default_number = {0}};

static const sozai_parameter paper_white = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "paper_white", .label = "White texels", .group = "paper", .unit = "",
   .doc = "Their proportion; RGB 255, 255, 255.",
   .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 0.2, .default_number = {0}};

static const char *const finish_choices[] = {"sawn", "polished", "honed", "flamed", "bush_hammered", "split",
                                             "riven"};

static const char *const finish_docs[] = {
   "sawn, flat and dull",
   "polished to a gloss",
   "ground to a satin",
   "spalled crystal by crystal under a flame",
   "dressed with the points of a bush hammer",
   "split across its grain, as it broke: facets that meet in ridges",
   "split along its cleavage, as slate and flags are: terraces of sheets that end in steps; faces across it, as `bed` says, show the sheets' edges"};

static const sozai_parameter finish = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_CHOICE,
   .id = "finish", .label = "Finish", .group = "finish", .unit = "",
   .doc = "What the mason left the face like.",
   .choices = finish_choices, .choice_docs = finish_docs, .choice_count = COUNT(finish_choices), .default_number = {1}};

static const sozai_parameter relief = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "relief", .label = "Relief", .group = "finish", .unit = "",
   .doc = "Multiplies the finish's height.",
   .hard_min = 0, .hard_max = 10, .soft_min = 0, .soft_max = 3, .default_number = {1}};

static const sozai_parameter roughness_scale = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "roughness_scale", .label = "Roughness", .group = "finish", .unit = "",
   .doc = "Multiplies the finish's roughness.",
   .hard_min = 0.05, .hard_max = 4, .soft_min = 0.3, .soft_max = 2, .default_number = {1}};

static const sozai_parameter ior = {
   .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_FLOAT,
   .id = "ior", .label = "Index of refraction", .group = "finish", .unit = "",
   .doc = "Of the mineral at the surface: quartz and feldspar 1.54, calcite 1.6.",
   .hard_min = 1, .hard_max = 3, .soft_min = 1.3, .soft_max = 1.8, .default_number = {1.54}};

const sozai_parameter *const stone_parameters[STONE_PARAMETERS] = {
   [P_SEED] = &seed,
   [P_OBJECT] = &object,
   [P_BED] = &bed,
   [P_OFFSET] = &offset,
   [P_MODE] = &colour_mode,
   [P_GRAIN_SIZE] = &grain_size,
   [P_GRAIN_GRADING] = &grain_grading,
   [P_GRAIN_STRETCH] = &grain_stretch,
   [P_GRAIN_INTERLOCK] = &grain_interlock,
   [P_GRAIN_BLUR] = &grain_blur,
   [P_SECOND_SHARE] = &second_share,
   [P_THIRD_SHARE] = &third_share,
   [P_VARIATION] = &grain_variation,
   [P_GRAIN_DEPTH] = &grain_depth,
   [P_GRAIN_CLUSTERING] = &grain_clustering,
   [P_GRAIN_SERIATE] = &grain_seriate,
   [P_CLEAVAGE] = &cleavage,
   [P_TURBIDITY] = &turbidity,
   [P_BED_THICKNESS] = &bed_thickness,
   [P_BED_CONTRAST] = &bed_contrast,
   [P_BED_WAVE] = &bed_wave,
   [P_BED_WAVELENGTH] = &bed_wavelength,
   [P_BED_PINCHING] = &bed_pinching,
   [P_MOTTLE] = &mottle,
   [P_MOTTLE_SIZE] = &mottle_size,
   [P_INCLUSION_SIZE] = &inclusion_size,
   [P_INCLUSION_SHARE] = &inclusion_share,
   [P_INCLUSION_SECOND_SHARE] = &inclusion_second_share,
   [P_INCLUSION_THIRD_SHARE] = &inclusion_third_share,
   [P_INCLUSION_GAP] = &inclusion_gap,
   [P_INCLUSION_ROUNDNESS] = &inclusion_roundness,
   [P_INCLUSION_CONTACT] = &inclusion_contact,
   [P_INCLUSION_GRADING] = &inclusion_grading,
   [P_INCLUSION_STRETCH] = &inclusion_stretch,
   [P_INCLUSION_INTERLOCK] = &inclusion_interlock,
   [P_INCLUSION_VARIATION] = &inclusion_variation,
   [P_INCLUSION_POLYMICT] = &inclusion_polymict,
   [P_INCLUSION_BLUR] = &inclusion_blur,
   [P_INCLUSION_RIM] = &inclusion_rim,
   [P_INCLUSION_CLEAVAGE] = &inclusion_cleavage,
   [P_INCLUSION_ZONING] = &inclusion_zoning,
   [P_INCLUSION_TURBIDITY] = &inclusion_turbidity,
   [P_INCLUSION_OPACITY] = &inclusion_opacity,
   [P_INCLUSION_RELIEF] = &inclusion_relief,
   [P_SPECK_SIZE] = &speck_size,
   [P_BLACK_SHARE] = &black_share,
   [P_WHITE_SHARE] = &white_share,
   [P_SPECK_STRETCH] = &speck_stretch,
   [P_SPECK_FLATNESS] = &speck_flatness,
   [P_SPECK_RAGGEDNESS] = &speck_raggedness,
   [P_SPECK_CLUSTERING] = &speck_clustering,
   [P_SPECK_AGGREGATION] = &speck_aggregation,
   [P_VEIN_SPACING] = &vein_spacing,
   [P_VEIN_WIDTH] = &vein_width,
   [P_VEIN_SOFTNESS] = &vein_softness,
   [P_VEIN_WARP] = &vein_warp,
   [P_VEIN_CROSSING] = &vein_crossing,
   [P_VEIN_VARIATION] = &vein_variation,
   [P_HOLE_SIZE] = &hole_size,
   [P_HOLE_SHARE] = &hole_share,
   [P_HOLE_STRETCH] = &hole_stretch,
   [P_HOLE_BEDDING] = &hole_bedding,
   [P_HOLE_RAGGEDNESS] = &hole_raggedness,
   [P_HOLE_FINES] = &hole_fines,
   [P_HOLE_VARIATION] = &hole_variation,
   [P_HOLE_DEPTH] = &laid_hole_depth,
   [P_BASE] = &base_colour,
   [P_SECOND] = &second_colour,
   [P_THIRD] = &third_colour,
   [P_BED_COLOUR] = &bed_colour,
   [P_INCLUSION] = &inclusion_colour,
   [P_INCLUSION_SECOND] = &inclusion_second_colour,
   [P_INCLUSION_THIRD] = &inclusion_third_colour,
   [P_BLACK] = &black_colour,
   [P_WHITE] = &white_colour,
   [P_VEIN] = &vein_colour,
   [P_HOLE] = &hole_colour,
   [P_PAPER_TEXEL] = &paper_texel,
   [P_PAPER_BASE] = &paper_base,
   [P_PAPER_VARIATION] = &paper_variation,
   [P_PAPER_LIGHTNESS] = &paper_lightness,
   [P_PAPER_CHROMA] = &paper_chroma,
   [P_PAPER_BLACK] = &paper_black,
   [P_PAPER_WHITE] = &paper_white,
   [P_PAPER_PATTERN] = &tile_pattern,
   [P_PAPER_LENGTH] = &tile_length,
   [P_PAPER_WIDTH] = &tile_width,
   [P_PAPER_LEVELS] = &tile_levels,
   [P_PAPER_DH] = &tile_dh,
   [P_PAPER_RELIEF] = &tile_relief,
   [P_PAPER_JOINT] = &tile_joint,
   [P_PAPER_WANDER] = &tile_wander,
   [P_PAPER_PARTS] = &tile_parts,
   [P_PAPER_REPAIR] = &tile_repair,
   [P_PAPER_JOINT_HEIGHT] = &tile_joint_height,
   [P_PAPER_JOINT_COLOUR] = &tile_joint_colour,
   [P_FINISH] = &finish,
   [P_RELIEF] = &relief,
   [P_ROUGHNESS] = &roughness_scale,
   [P_IOR] = &ior,
   [P_LAYOUT] = &laid_layout,
   [P_LENGTH] = &laid_stone_length,
   [P_WIDTH] = &laid_stone_width,
   [P_LENGTH_VARIATION] = &laid_length_variation,
   [P_STAGGER] = &laid_stagger,
   [P_CHEVRON_ANGLE] = &laid_chevron_angle,
   [P_ROTATION] = &laid_layout_rotation,
   [P_JOINT_WIDTH] = &laid_joint_width,
   [P_JOINT_DEPTH] = &laid_joint_depth,
   [P_JOINT_GRAIN] = &laid_joint_grain,
   [P_JOINT_COLOUR] = &laid_joint_colour,
   [P_WANDER] = &laid_joint_wander,
   [P_DIVISIONS] = &laid_joint_divisions,
   [P_CORNER] = &laid_corner_radius,
   [P_BEVEL] = &laid_bevel,
   [P_BEVEL_ANGLE] = &laid_bevel_angle,
   [P_ROUND] = &laid_edge_round,
   [P_ROUND_DROP] = &laid_edge_drop,
   [P_CHIPPING] = &laid_edge_chipping,
   [P_TILT] = &laid_tilt,
   [P_SETTLE] = &laid_settle,
   [P_CROWN] = &laid_crown,
   [P_TONE] = &laid_tone_spread,
   [P_TINT] = &laid_tint_spread,
   [P_UNDULATION] = &laid_undulation,
   [P_UNDULATION_SIZE] = &laid_undulation_size,
   [P_WEAR] = &laid_wear,
   [P_GRIME] = &laid_grime,
   [P_MOSS] = &laid_moss,
   [P_MOSS_SPREAD] = &laid_moss_spread,
   [P_MOSS_HEIGHT] = &laid_moss_height,
   [P_MOSS_COLOUR] = &laid_moss_colour,
   [P_WET] = &laid_wet,
   [P_WATER] = &laid_water_level};

static const sozai_channel channel_albedo = {
   .size = sizeof(sozai_channel), .first = STONE_ALBEDO, .components = 3,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "albedo", .unit = "", .suffixes = "rgb",
   .doc = "Diffuse reflectance, scene-linear, in the working space. Linear in the palette: above 1 where what varies meets a colour near white."};

static const sozai_channel channel_radiance = {
   .size = sizeof(sozai_channel), .first = STONE_RADIANCE, .components = 3,
   .needs = SOZAI_INPUT_POINT | SOZAI_INPUT_NORMAL | SOZAI_INPUT_LIGHT,
   .uses = SOZAI_INPUT_LIGHT_COLOUR | SOZAI_INPUT_VIEW | SOZAI_INPUT_FOOTPRINT,
   .id = "radiance", .unit = "", .suffixes = "rgb",
   .doc = "Towards the eye under the light, times light_colour: Lambert's below a surface of "
   "`specular` and `roughness` (GGX), about `normal`."};

static const sozai_channel channel_normal = {
   .size = sizeof(sozai_channel), .first = STONE_NORMAL, .components = 3,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "normal", .unit = "", .suffixes = "xyz",
   .doc = "Unit normal of the finished face, object space: from the exact gradient of `height`."};

static const sozai_channel channel_height = {
   .size = sizeof(sozai_channel), .first = STONE_HEIGHT, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "height", .unit = "mm", .suffixes = "",
   .doc = "Of the finished face over the face given, along its normal."};

static const sozai_channel channel_roughness = {
   .size = sizeof(sozai_channel), .first = STONE_ROUGHNESS, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "roughness", .unit = "", .suffixes = "",
   .doc = "GGX's alpha: the finish's, and the slopes that the footprint averages out."};

static const sozai_channel channel_specular = {
   .size = sizeof(sozai_channel), .first = STONE_SPECULAR, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "specular", .unit = "", .suffixes = "",
   .doc = "Reflectance at normal incidence; none where holes are."};

static const sozai_channel channel_speck = {
   .size = sizeof(sozai_channel), .first = STONE_SPECK, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "speck", .unit = "", .suffixes = "",
   .doc = "Share of the footprint that black and white specks cover."};

static const sozai_channel channel_grain = {
   .size = sizeof(sozai_channel), .first = STONE_GRAIN, .components = 1,
   .needs = SOZAI_INPUT_POINT, .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "grain", .unit = "", .suffixes = "",
   .doc = "A number between 0 and 1 for the crystal at the point: a mask, not filtered."};

static const sozai_channel channel_joint = {
   .size = sizeof(sozai_channel), .first = STONE_JOINT, .components = 1,
   .needs = SOZAI_INPUT_POINT, .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "joint", .unit = "", .suffixes = "",
   .doc = "Share of the footprint that is joint; 0 without a layout."};

static const sozai_channel channel_stone_id = {
   .size = sizeof(sozai_channel), .first = STONE_ID, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .id = "stone_id", .unit = "", .suffixes = "",
   .doc = "A whole number below 2^24, another for each stone of the layout; 0 without one."};

static const sozai_channel channel_stone_u = {
   .size = sizeof(sozai_channel), .first = STONE_U, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .id = "stone_u", .unit = "mm", .suffixes = "",
   .doc = "Place along the stone, joint's middle to joint's middle, from its corner; of arcs, fan, circles round the ring from its end, as long as the ring's middle is; "
   "of crazy, hexagon, octagon from the corner of a square about the stone, which its own corners do not reach and may cross. 0 without a layout."};

static const sozai_channel channel_stone_v = {
   .size = sizeof(sozai_channel), .first = STONE_V, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .id = "stone_v", .unit = "mm", .suffixes = "",
   .doc = "Place across the stone, likewise: of arcs and fan outwards, of circles inwards."};

static const sozai_channel channel_edge = {
   .size = sizeof(sozai_channel), .first = STONE_EDGE, .components = 1,
   .needs = SOZAI_INPUT_POINT,
   .id = "edge", .unit = "mm", .suffixes = "",
   .doc = "Distance to the stone's edge: positive within the stone, negative in the joint; 0 without a layout."};

static const sozai_channel channel_moss = {
   .size = sizeof(sozai_channel), .first = STONE_MOSS, .components = 1,
   .needs = SOZAI_INPUT_POINT, .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "moss", .unit = "", .suffixes = "",
   .doc = "Share of the footprint that moss covers."};

static const sozai_channel channel_wet = {
   .size = sizeof(sozai_channel), .first = STONE_WET, .components = 1,
   .needs = SOZAI_INPUT_POINT, .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "wet", .unit = "", .suffixes = "",
   .doc = "How wet the surface is: 0 dry; 1 under water."};

static const sozai_channel channel_occlusion = {
   .size = sizeof(sozai_channel), .first = STONE_OCCLUSION, .components = 1,
   .needs = SOZAI_INPUT_POINT, .uses = SOZAI_INPUT_NORMAL | SOZAI_INPUT_FOOTPRINT,
   .id = "occlusion", .unit = "", .suffixes = "",
   .doc = "Of the light of an even sky, what reaches the place past the stones' edges and the relief: 1 all."};

const sozai_channel *const stone_channels[] = {
   &channel_albedo, &channel_radiance, &channel_normal, &channel_height, &channel_roughness, &channel_specular, &channel_speck, &channel_grain,
   &channel_joint, &channel_stone_id, &channel_stone_u, &channel_stone_v, &channel_edge, &channel_moss, &channel_wet, &channel_occlusion};
/* clang-format on */
const uint32_t stone_channel_count = COUNT(stone_channels);
