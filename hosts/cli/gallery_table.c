/* SPDX-License-Identifier: Apache-2.0 */
#include "gallery_table.h"

#include <stddef.h>

#define TILE .shape = "plane", .camera = "front", .width = 200, .height = 150
#define FACE .shape = "plane", .camera = "front", .width = 960, .height = 640

#define LAID(id, label, species, mm, ...)                                                          \
  {                                                                                                \
    .name = "layout-" id, .title = label, .preset = species, .sheet = "layouts",                   \
    .params = {"layout=" id, __VA_ARGS__}, .shape = "plane", .camera = "front", .size = mm,        \
    .width = 400, .height = 400                                                                    \
  }

/* A surface under raking light, of two species, near and far. */
#define WORKED_(id, label, species, where, mm, cut_, a, b)                                         \
  {                                                                                                \
    .name = id "-" species "-" where, .title = label, .more = true, .preset = species,             \
    .sheet = "finishes", .params = {cut_, "cut_distance=70", "reflection=fibre_cone", a, b},       \
    .shape = "plane", .camera = "front", .size = mm, .light = "35,22", .sky = 0.7, .width = 640,   \
    .height = 440                                                                                  \
  }
#define WORKED(id, label, a, b)                                                                    \
  WORKED_(id, "Oak: " label, "oak", "near", "48x33", "cut=rift", a, b),                            \
      WORKED_(id, "Oak: " label, "oak", "far", "320x220", "cut=flat", a, b),                       \
      WORKED_(id, "Sugi: " label, "sugi", "near", "48x33", "cut=rift", a, b),                      \
      WORKED_(id, "Sugi: " label, "sugi", "far", "320x220", "cut=flat", a, b)

const shot_sheet gallery_sheets[GALLERY_SHEETS] = {
    {"gallery", 15},                                        /* five species, three cuts of each */
    {"stones", 5},         {"layouts", 6}, {"finishes", 4}, /* two species, near and far */
    {"macro", 3},                                           /* of a species its three faces */
    {"figured", 4},        {"fibers", 6},  {"knots", 4},
    {"stone-finishes", 6}, /* two stones in a row, three finishes of each */
    {"plies", 3},          {"trees", 6},
};

/* A finish of every stone, under light from the side. */
#define DRESSED(id, label)                                                                         \
  {                                                                                                \
    .name = "stone-" id, .title = label, .more = true, .material = "stone", .each_preset = true,   \
    .sheet = "stone-finishes", .params = {"finish=" id}, .shape = "plane", .camera = "front",      \
    .size = "120x90", .light = "35,30", .sky = 0.8, .width = 240, .height = 180                    \
  }

/* Two and a half metres before the eye and beyond, or so. */
#define PAVED(id, label, only_all, stone, a, b, c, d, sun)                                         \
  {                                                                                                \
    .name = "paving-" id, .title = label, .more = only_all, .material = "stone", .preset = stone,  \
    .params = {a, b, c, d}, .shape = "plane", .size = "5000x9000", .camera = "-90,20,30",          \
    .light = sun, .zoom = 4, .ahead = -2500, .width = 960, .height = 540                           \
  }

#define TREE(species, label, years, only_all)                                                      \
  {                                                                                                \
    .name = "tree-" species, .title = label " of " years " years", .more = only_all,               \
    .material = "tree", .preset = species, .sheet = "trees", .params = {"age=" years},             \
    .width = 300, .height = 400                                                                    \
  }

/* 8 mm across, 0.02 mm to a pixel */
#define MACRO(species, face, words)                                                                \
  {                                                                                                \
    .name = "macro-" species "-" face, .title = words, .more = true, .preset = species,            \
    .sheet = "macro", .params = {"cut=" face, "cut_distance=90", "cell_contrast=0.9"},             \
    .shape = "plane", .camera = "front", .size = "8x5.6", .width = 400, .height = 280              \
  }
#define MACROS(species, words)                                                                     \
  MACRO(species, "end", words ", end grain, 8 mm across"),                                         \
      MACRO(species, "quarter", words ", radial face"),                                            \
      MACRO(species, "flat", words ", tangential face")

#define FIGURED(id, species, face, words, az)                                                      \
  {                                                                                                \
    .name = "figured-" id, .title = words, .preset = species, .sheet = "figured",                  \
    .params = {"cut=" face, "cut_distance=140", "reflection=fibre_cone"}, .shape = "plane",        \
    .camera = "front", .light = az, .sky = 0.3, .size = "210x140", .width = 600, .height = 400     \
  }

#define FIBERS(id, fiber, words, mm)                                                               \
  { .name = "fiber-" id, .title = words, .material = "fiber", .preset = fiber, .size = mm, FACE }

/* A block about as large as a hand, with the heart in one corner. */
#define KNOTTY_BLOCK(species, wood, of, years, above, at, size_, words)                            \
  {                                                                                                \
    .name = "knots-" species, .title = words, .preset = wood, .sheet = "knots",                    \
    .params = {"tree=" of, "tree_age=" years, "log_height=" above, "cut_offset=" at,               \
               "knot_size=" size_},                                                                \
    .size = "170x260x170", .camera = "-40,28,20", .width = 480, .height = 400                      \
  }
#define KNOTTY(id, wood, words, area, ...)                                                         \
  {                                                                                                \
    .name = "knots-" id, .title = words, .preset = wood, .sheet = "knots",                         \
    .params = {__VA_ARGS__}, .shape = "plane", .size = area, .camera = "front", .width = 480,      \
    .height = 400                                                                                  \
  }

/* A sample of a panel, its face up, and its edge near. */
#define PANEL(id, panel, words, mm, middle)                                                        \
  {                                                                                                \
    .name = "plies-" id, .title = words, .preset = panel, .sheet = "plies",                        \
    .params = {"face_height=" middle, "reflection=fibre_cone"}, .size = "90x120x" mm,              \
    .camera = "-52,26,20", .width = 600, .height = 400                                             \
  }
#define PANEL_EDGE(id, panel, words, mm, middle, from, closer)                                     \
  {                                                                                                \
    .name = "plies-" id "-edge", .title = words, .preset = panel, .sheet = "plies",                \
    .params = {"face_height=" middle}, .size = "80x80x" mm, .camera = from, .light = "-60,40",     \
    .zoom = closer, .width = 600, .height = 400                                                    \
  }

/* Panels have no cut: their face, an edge and a section stand in for the three. */
#define GLUED(id, words, a, b, mm, of, from, az, closer)                                           \
  {                                                                                                \
    .name = id, .title = words, .each_preset = true, .with = "construction", .sheet = "gallery",   \
    .params = {a, b}, .size = mm, .shape = of, .camera = from, .light = az, .zoom = closer,        \
    .width = 200, .height = 150                                                                    \
  }

/* What follows is a section of the page; a sheet may show all of it. */
#define HEADING(words, of_all)                                                                     \
  { .heading = words, .sheet = of_all }

const shot gallery_shots[] = {
    HEADING("Wood", "gallery"),
    {.name = "flat",
     .title = "flat-sawn, 120 mm across",
     .each_preset = true,
     .own_log = true,
     .aside = 32,
     .without = "construction",
     .sheet = "gallery",
     .params = {"cut=flat"},
     .size = "120x90",
     TILE},
    {.name = "quarter",
     .title = "quarter-sawn, 120 mm across",
     .each_preset = true,
     .own_log = true,
     .without = "construction",
     .sheet = "gallery",
     .params = {"cut=quarter"},
     .size = "120x90",
     TILE},
    {.name = "end",
     .title = "end grain, 32 mm across",
     .each_preset = true,
     .own_log = true,
     .without = "construction",
     .sheet = "gallery",
     .params = {"cut=end"},
     .size = "32x24",
     TILE},
    GLUED("face", "the face, 400 mm across", NULL, NULL, "400x300", "plane", "front", NULL, 0),
    GLUED("edge", "the long edge, 28 mm across", "sheet_thickness=18", "face_height=9", "80x80x18",
          NULL, "0,3,10", "30,40", 3.2),
    GLUED("section", "across the face's grain", "sheet_thickness=18", "face_height=9", "80x80x18",
          NULL, "-90,3,10", "-60,40", 3.2),
    HEADING("Grain", NULL),
    {.name = "block",
     .title = "Mizunara, an end-grain block",
     .preset = "mizunara",
     .params = {"cut=end"},
     .size = "90x90x45",
     .width = 960,
     .height = 720},
    {.name = "sphere",
     .more = true,
     .title = "Keyaki, a turned sphere",
     .preset = "keyaki",
     .params = {"cut=flat", "cut_distance=50"},
     .shape = "sphere",
     .size = "80",
     .width = 960,
     .height = 720},
    {.name = "pores",
     .title = "Mizunara, end grain, 12 mm across",
     .preset = "mizunara",
     .params = {"cut=end"},
     .size = "12x8",
     FACE},
    {.name = "streaks",
     .title = "Mizunara, flat-sawn, 36 mm across: the same vessels, cut along",
     .preset = "mizunara",
     .params = {"cut=flat"},
     .size = "36x24",
     FACE},
    {.name = "spiral-diffuse",
     .title = "Spiral grain, slope 0.12, diffuse-porous (onigurumi's colours), quarter-sawn",
     .preset = "onigurumi",
     .params = {"cut=quarter", "grain=spiral", "spiral_slope=0.12", "porosity=diffuse"},
     .size = "120x80",
     FACE},
    {.name = "spiral-ring",
     .title = "Spiral grain, slope 0.12, ring-porous, flat-sawn",
     .preset = "keyaki",
     .params = {"cut=flat", "grain=spiral", "spiral_slope=0.12"},
     .size = "120x80",
     FACE},
    {.name = "wavy-diffuse",
     .title = "Wavy grain, slope 0.20 over 40 mm, diffuse-porous, flat-sawn",
     .preset = "makaba",
     .params = {"cut=flat", "grain=wavy", "wave_slope=0.2", "wave_length=40"},
     .size = "120x80",
     FACE},
    {.name = "wavy-ring",
     .title = "Wavy grain, slope 0.20 over 40 mm, ring-porous, flat-sawn",
     .preset = "keyaki",
     .params = {"cut=flat", "grain=wavy", "wave_slope=0.2", "wave_length=40"},
     .size = "120x80",
     FACE},
    {.name = "interlocked",
     .title = "Interlocked grain: ribbon figure on a quarter-sawn face",
     .preset = "makaba",
     .params = {"cut=quarter", "cut_distance=180", "grain=interlocked", "specular=0.2"},
     .sky = 0.3,
     .size = "240x160",
     .light = "90,72",
     FACE},
    {.name = "maple-light-1",
     .title = "Itayakaede, wavy grain, lit from up the stem",
     .preset = "itayakaede",
     .params = {"cut=quarter", "cut_distance=140"},
     .sky = 0.3,
     .size = "180x120",
     .light = "90,74",
     FACE},
    {.name = "maple-light-2",
     .title = "The same, lit from straight above",
     .preset = "itayakaede",
     .params = {"cut=quarter", "cut_distance=140"},
     .sky = 0.3,
     .size = "180x120",
     .light = "90,90",
     FACE},
    {.name = "maple-light-3",
     .title = "The same, lit from down the stem: the bands move",
     .preset = "itayakaede",
     .params = {"cut=quarter", "cut_distance=140"},
     .sky = 0.3,
     .size = "180x120",
     .light = "-90,74",
     FACE},
    HEADING("Figure", "figured"),
    FIGURED("curly", "curly_maple", "quarter", "Curly maple, quarter-sawn", "90,66"),
    FIGURED("fiddleback", "sycamore", "quarter", "Fiddleback sycamore, quarter-sawn", "90,66"),
    FIGURED("quilted", "quilted_maple", "flat", "Quilted maple, flat-sawn", "80,60"),
    FIGURED("birdseye", "birdseye_maple", "flat", "Bird's-eye maple, flat-sawn", "70,55"),
    FIGURED("ribbon", "sapele", "quarter", "Sapele, quarter-sawn: ribbon stripe", "90,60"),
    FIGURED("pommele", "pommele_sapele", "flat", "Pommele sapele, flat-sawn", "80,60"),
    FIGURED("spalted", "spalted_beech", "flat", "Spalted beech, flat-sawn", "75,48"),
    FIGURED("spalted-end", "spalted_beech", "end", "Spalted beech, end grain", "75,48"),
    HEADING("Knots", "knots"),
    KNOTTY_BLOCK("pine", "akamatsu", "akamatsu", "45", "9790", "10,0,30", "1",
                 "Akamatsu of 45 years"),
    KNOTTY_BLOCK("sugi", "knotty_sugi", "sugi", "45", "5210", "45,0,45", "0.5", "Sugi of 45 years"),
    KNOTTY_BLOCK("keyaki", "keyaki", "keyaki", "70", "3150", "0,0,20", "0.5", "Keyaki of 70 years"),
    KNOTTY_BLOCK("cherry", "cherry", "cherry", "50", "4320", "10,0,40", "0.5",
                 "Yamazakura of 50 years"),
    KNOTTY("panel", "knotty_pine", "Knotty pine, a panel 1.2 m across", "1200x1000", "layout=strip",
           "board_width=140", "board_length=1800"),
    KNOTTY("board", "knotty_sugi", "Sugi, flat-sawn, 0.7 m of a board", "720x600", "cut=flat",
           "cut_distance=70"),
    KNOTTY("spike", "knotty_pine", "A knot cut along", "240x200", "cut=quarter", "cut_distance=100",
           "cut_rotation=114.2", "cut_height=80"),
    KNOTTY("veneer", "knotty_pine", "Pine peeled off the log, 1.2 m of the sheet", "1200x1000",
           "cut=rotary", "cut_distance=110"),
    HEADING("Plywood, laminated veneer, blockboard", "plies"),
    PANEL("birch", "birch_plywood", "Birch plywood, 18 mm of 13 plies", "18", "9"),
    PANEL("lauan", "lauan_plywood", "Lauan plywood, 12 mm of five", "12", "6"),
    PANEL("walnut", "walnut_plywood", "Walnut plywood, sliced face", "19", "9.5"),
    PANEL("sugi", "sugi_plywood", "Sugi plywood, structural", "12", "6"),
    PANEL("larch", "larch_lvl", "Larch laminated veneer lumber", "45", "22.5"),
    PANEL("pine", "pine_blockboard", "Pine blockboard", "19", "9.5"),
    PANEL_EDGE("birch", "birch_plywood", "Birch plywood's edge, 22 mm across", "18", "9",
               "-90,3,10", 4),
    PANEL_EDGE("lauan", "lauan_plywood", "Lauan plywood's edge", "12", "6", "-90,3,10", 4),
    PANEL_EDGE("larch", "larch_lvl", "The lumber's end", "45", "22.5", "-90,3,10", 1.8),
    {.name = "plies-face",
     .title = "A birch plywood face, 0.9 m across",
     .preset = "birch_plywood",
     .sheet = "plies",
     .shape = "plane",
     .size = "900x600",
     .camera = "front",
     .width = 600,
     .height = 400},
    {.name = "plies-book",
     .title = "Book-matched walnut, 0.9 m across",
     .preset = "walnut_plywood",
     .sheet = "plies",
     .shape = "plane",
     .size = "900x600",
     .camera = "front",
     .width = 600,
     .height = 400},
    {.name = "plies-stack",
     .title = "Four sheets glued up, a block",
     .preset = "birch_plywood",
     .sheet = "plies",
     .params = {"sheets=4", "face_height=36"},
     .size = "90x110x72",
     .camera = "-40,28,20",
     .width = 600,
     .height = 400},
    HEADING("Layouts", "layouts"),
    LAID("strip", "Strip floor, oak", "mizunara", "1600x1600", "bevel=0.6", NULL, NULL),
    LAID("running", "Running bond", "mizunara", "1600x1600", "stagger=0.5", NULL, NULL),
    LAID("herringbone", "Herringbone", "mizunara", "1200x1200", NULL, NULL, NULL),
    LAID("herringbone_90", "Herringbone along the room", "keyaki", "1200x1200", NULL, NULL, NULL),
    LAID("herringbone_double", "Double herringbone", "mizunara", "1200x1200", NULL, NULL, NULL),
    LAID("chevron", "Chevron", "mizunara", "1200x1200", NULL, NULL, NULL),
    LAID("basket", "Basket weave", "keyaki", "900x900", NULL, NULL, NULL),
    LAID("windmill", "Windmill", "mizunara", "1000x1000", NULL, NULL, NULL),
    LAID("versailles", "Parquet de Versailles", "mizunara", "1600x1600", NULL, NULL, NULL),
    LAID("igeta", "Igeta", "hinoki", "1000x1000", "joint_width=2", NULL, NULL),
    LAID("stack", "Stack bond", "keyaki", "1000x1000", "board_length=300", "board_width=150",
         "joint_width=2"),
    LAID("chidori", "Chidori, staggered by half", "keyaki", "800x800", "joint_width=2", NULL, NULL),
    LAID("english", "English bond", "sugi", "600x600", "joint_width=4", NULL, NULL),
    LAID("flemish", "Flemish bond", "sugi", "600x600", "joint_width=4", NULL, NULL),
    LAID("hexagon", "Hexagons", "mizunara", "800x800", "joint_width=1", NULL, NULL),
    LAID("octagon", "Octagon and dot", "mizunara", "800x800", "joint_width=1", NULL, NULL),
    LAID("end_grain", "End-grain blocks", "mizunara", "400x400", NULL, NULL, NULL),
    LAID("butcher", "Butcher block", "makaba", "600x600", NULL, NULL, NULL),
    LAID("ashlar", "Random ashlar", "hinoki", "1600x1600", "joint_width=4", NULL, NULL),
    LAID("crazy", "Crazy paving, of end grain", "karamatsu", "900x900", "cut=end", "end_checks=1",
         "end_check_width=3", "end_check_length=150"),
    LAID("arcs", "Segmental arcs of end-grain setts", "mizunara", "1600x1600", "cut=end", NULL,
         NULL),
    LAID("circles", "Rings of end-grain setts", "mizunara", "1600x1600", "cut=end", NULL, NULL),
    LAID("fan", "European fans of end-grain setts", "mizunara", "1800x1800", "cut=end", NULL, NULL),
    HEADING("Surfaces and finishes", "finishes"),
    WORKED("smooth", "smooth", "surface=smooth", NULL),
    WORKED("band_sawn", "band-sawn", "surface=band_sawn", NULL),
    WORKED("circular_sawn", "circular-sawn", "surface=circular_sawn", NULL),
    WORKED("planed", "planed", "surface=planed", NULL),
    WORKED("hand_planed", "hand-planed", "surface=hand_planed", NULL),
    WORKED("sanded", "sanded, P80", "surface=sanded", "sanding_grit=80"),
    WORKED("brushed", "brushed", "surface=brushed", NULL),
    WORKED("charred", "charred", "surface=charred", NULL),
    WORKED("weathered", "weathered", "surface=weathered", NULL),
    WORKED("oiled", "planed and oiled", "finish=oiled", "surface=planed"),
    WORKED("lacquered", "lacquered", "finish=lacquered", NULL),
    HEADING("Wood near by", "macro"),
    MACROS("white_oak", "White oak"),
    MACROS("keyaki", "Keyaki"),
    MACROS("sugi", "Sugi"),
    MACROS("black_walnut", "Black walnut"),
    MACROS("akamatsu", "Akamatsu"),
    HEADING("Stone", "stones"),
    {.name = "stone",
     .title = "300 mm across",
     .material = "stone",
     .each_preset = true,
     .sheet = "stones",
     .size = "300x225",
     .shape = "plane",
     .camera = "front",
     .width = 320,
     .height = 240},
    DRESSED("polished", "polished"),
    DRESSED("flamed", "flamed"),
    DRESSED("split", "split"),
    {.name = "stone-ball",
     .more = true,
     .title = "a ball of 120 mm",
     .material = "stone",
     .each_preset = true,
     .shape = "sphere",
     .size = "120",
     .width = 320,
     .height = 240},
    {.name = "stone-near",
     .title = "Inada granite, 30 mm across",
     .material = "stone",
     .preset = "inada",
     .size = "30x20",
     FACE},
    {.name = "stone-flamed",
     .more = true,
     .title = "Inada granite, flamed, lit from the side",
     .material = "stone",
     .preset = "inada",
     .params = {"finish=flamed"},
     .size = "60x40",
     .light = "30,20",
     .sky = 0.3,
     FACE},
    {.name = "stone-hammered",
     .more = true,
     .title = "The same, bush hammered",
     .material = "stone",
     .preset = "inada",
     .params = {"finish=bush_hammered"},
     .size = "60x40",
     .light = "30,20",
     .sky = 0.3,
     FACE},
    {.name = "stone-paper",
     .more = true,
     .title = "Yamanaka and Nagaoka's colours of figure 6: RGB 50 varied by 30, a texel to 2 mm",
     .material = "stone",
     .params = {"colour_mode=paper_rgb", "paper_texel=2"},
     .size = "120x80",
     FACE},
    HEADING("Paving", NULL),
    PAVED("fan", "Granite setts in fans, wet, under a low sun", false, "granite_fan", "wet=0.85",
          "water_level=-7", "settle=5", "undulation=4", "75,20"),
    PAVED("chidori", "A path of granite staggered by half, with moss", false, "ishidatami",
          "moss=0.55", "joint_width=14", "joint_depth=5", "joint_wander=0.015", "70,28"),
    PAVED("porphyry", "Porphyry setts in arcs", true, "porphyry", "grime=0.2", NULL, NULL, NULL,
          "70,32"),
    PAVED("block", "Belgian block", true, "belgian_block", "moss=0.3", NULL, NULL, NULL, "110,30"),
    PAVED("basalt", "Basalt setts after rain", true, "basalt_setts", "wet=0.7", "water_level=-6",
          "undulation=6", NULL, "35,32"),
    PAVED("brick", "Brick pavers in herringbone", true, "brick_paver", "grime=0.15", NULL, NULL,
          NULL, "60,35"),
    {.name = "paving-near",
     .more = true,
     .title = "Moss in the joints of a path, 400 mm across",
     .material = "stone",
     .preset = "ishidatami",
     .params = {"moss=0.5", "joint_width=14", "joint_depth=5", "joint_wander=0.015"},
     .size = "400x267",
     .light = "60,30",
     FACE},
    HEADING("Trees", "trees"),
    TREE("sugi", "Sugi", "30", false),
    TREE("akamatsu", "Akamatsu", "40", false),
    TREE("keyaki", "Keyaki", "60", false),
    TREE("cherry", "Yamazakura", "40", false),
    TREE("shirakaba", "Shirakaba", "40", false),
    TREE("momiji", "Iroha-momiji", "50", false),
    TREE("hinoki", "Hinoki", "30", true),
    TREE("kuromatsu", "Kuromatsu", "70", true),
    TREE("karamatsu", "Karamatsu", "30", true),
    TREE("todomatsu", "Todomatsu", "30", true),
    TREE("norway_spruce", "Norway spruce", "50", true),
    TREE("scots_pine", "Scots pine", "40", true),
    TREE("douglas_fir", "Douglas fir", "30", true),
    TREE("buna", "Buna", "80", true),
    TREE("mizunara", "Mizunara", "80", true),
    HEADING("Fiber", "fibers"),
    FIBERS("felt", "felt", "Wool felt, 3 mm across", "3x2"),
    FIBERS("felt-arm", "felt_grey", "Melange felt at arm's length, 120 mm across", "120x80"),
    FIBERS("cotton", "cotton", "Cotton, 4 mm across", "4x2.67"),
    FIBERS("fleece", "fleece", "Polyester fleece, 12 mm across", "12x8"),
    FIBERS("denim", "denim", "Denim, 9 mm across", "9x6"),
    FIBERS("linen", "linen", "Linen, 9 mm across", "9x6"),
    FIBERS("burlap", "burlap", "Burlap, 30 mm across", "30x20"),
    {.name = "fiber-velvet",
     .more = true,
     .title = "Velvet on a ball of 50 mm",
     .material = "fiber",
     .preset = "velvet",
     .shape = "sphere",
     .size = "50",
     .width = 960,
     .height = 720},
    {.name = "fiber",
     .more = true,
     .title = "8 mm across",
     .material = "fiber",
     .each_preset = true,
     .sheet = "fibers",
     .size = "8x6",
     TILE},
};

const uint32_t gallery_shot_count = sizeof gallery_shots / sizeof gallery_shots[0];
