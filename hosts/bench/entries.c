/* SPDX-License-Identifier: Apache-2.0 */
#include "entries.h"

/* clang-format off */
#define FULL(label, size, set) {.name = label, .batch = size, .wood = {.cpu = set}}
#define FULL_ON(set) FULL("wood.full.batch1024@" set, 1024, set), \
  FULL("wood.full.batch16@" set, 16, set), FULL("wood.full.batch1@" set, 1, set)
#define ALONE(label, ...) {.name = "wood." label ".batch1024", .batch = 1024, __VA_ARGS__}
#define MASKED(label, inactive) ALONE("masked_" label, .masked = (inactive) + 1)
#define CHANNEL(id) ALONE(id, .channel = id)
#define GRAIN(id) ALONE("grain_" id, .channel = "albedo", .wood = {.grain = id})
#define POROSITY(id) ALONE("porosity_" id, .channel = "albedo", .wood = {.porosity = id})
#define FOOTPRINT(mm) ALONE("footprint_" #mm, .footprint = (float)(mm))
#define LAYOUT(id) ALONE("layout_" id, .wood = {.layout = id})
#define FLOOR(mm) ALONE("floor_" #mm, .footprint = (float)(mm), .wood = {.layout = "strip"})
#define SURFACE(id) ALONE("surface_" id, .wood = {.surface = id})
#define STONE(label, size, set, ...) \
  {.name = "stone." label, .batch = size, .wood = {.cpu = set, .stone = "inada"}, __VA_ARGS__}
#define STONE_ON(set) STONE("full.batch1024@" set, 1024, set), STONE("full.batch1@" set, 1, set)
#define STONE_FOOTPRINT(mm) STONE("footprint_" #mm ".batch1024", 1024, NULL, .footprint = (float)(mm))
#define STONE_OF(id) {.name = "stone." id ".batch1024", .batch = 1024, .wood = {.stone = id}}
#define STONE_AFAR(id, mm) \
  {.name = "stone." id "_" #mm ".batch1024", .batch = 1024, .footprint = (float)(mm), .wood = {.stone = id}}
#define FIBER(label, size, set, ...) \
  {.name = "fiber." label, .batch = size, .wood = {.cpu = set, .fiber = "felt"}, __VA_ARGS__}
#define FIBER_ON(set) FIBER("full.batch1024@" set, 1024, set), FIBER("full.batch1@" set, 1, set)
#define FIBER_FOOTPRINT(mm) FIBER("footprint_" #mm ".batch1024", 1024, NULL, .footprint = (float)(mm))
#define CLOTH(id, mm) \
  {.name = "fiber." id "_" #mm ".batch1024", .batch = 1024, .footprint = (float)(mm), .wood = {.fiber = id}}
#define FIBER_OF(id) {.name = "fiber." id ".batch1024", .batch = 1024, .wood = {.fiber = id}}
#define READ(called, of, which, given, mm, outputs, apart) \
  {.name = "oiio." called, .kind = ENTRY_TILE, .tile = {of, which, given, mm, outputs, apart, 0}}
#define TILE(called, ...) READ("tile." called, __VA_ARGS__, "albedo", false)
/* in so many parts across a texel, and down */
#define PARTS(called, of, which, mm, side) \
  {.name = "oiio.tile." called, .kind = ENTRY_TILE, .tile = {of, which, NULL, mm, "albedo", false, side}}
/* what the shaders of hosts/osl and the nodes of hosts/blender read: a normal where there is relief */
#define WOOD "albedo,fiber"
#define RELIEF "albedo,fiber,normal"
#define STONES "albedo,roughness,normal"
#define LOOK(called, of, look, ...) READ("look." called, of, __VA_ARGS__, look, false), \
  READ("look_apart." called, of, __VA_ARGS__, look, true)
/* clang-format on */

const entry entries[] = {
    FULL("wood.full.batch1024", 1024, NULL),
    FULL("wood.full.batch16", 16, NULL),
    FULL("wood.full.batch1", 1, NULL),
#if defined(__x86_64__)
    FULL_ON("avx512"),
    FULL_ON("avx2"),
    FULL_ON("sse2"),
#elif defined(__aarch64__)
    FULL_ON("neon"),
#endif
    FULL_ON("scalar"),
    MASKED("none", 0),
    MASKED("half", 50),
    MASKED("all", 100),
    CHANNEL("albedo"),
    CHANNEL("radiance"),
    CHANNEL("fiber"),
    CHANNEL("dive"),
    CHANNEL("time"),
    CHANNEL("latewood"),
    CHANNEL("vessel"),
    CHANNEL("reference"),
    GRAIN("straight"),
    GRAIN("spiral"),
    GRAIN("wavy"),
    GRAIN("interlocked"),
    POROSITY("none"),
    POROSITY("diffuse"),
    POROSITY("semi_ring"),
    POROSITY("ring"),
    FOOTPRINT(0.01),
    FOOTPRINT(0.0625),
    FOOTPRINT(0.1),
    FOOTPRINT(0.3),
    FOOTPRINT(1),
    FOOTPRINT(3),
    FOOTPRINT(10),
    FOOTPRINT(30),
    FOOTPRINT(100),
    ALONE("rays_none", .wood = {.no_rays = true}),
    ALONE("pigment", .wood = {.pigmented = true}),
    ALONE("reflection_kawai", .channel = "radiance", .wood = {.reflection = "kawai"}),
    ALONE("reflection_cone", .channel = "radiance", .wood = {.reflection = "fibre_cone"}),
    ALONE("section", .wood = {.pictured = true}),
    ALONE("section_end", .channel = "albedo",
          .wood = {.pictured = true, .cut = "end", .grain = "straight"}),
    /* as many as a sugi's, 25 to a metre of the stem, and four times that */
    ALONE("knots_20", .wood = {.knots = 20, .knots_metre = 25}),
    ALONE("knots_2000", .wood = {.knots = 2000, .knots_metre = 25}),
    ALONE("knots_dense", .wood = {.knots = 2000, .knots_metre = 100}),
    SURFACE("smooth"),
    SURFACE("band_sawn"),
    SURFACE("circular_sawn"),
    SURFACE("planed"),
    SURFACE("hand_planed"),
    SURFACE("sanded"),
    SURFACE("brushed"),
    SURFACE("charred"),
    SURFACE("weathered"),
    LAYOUT("strip"),
    LAYOUT("herringbone"),
    LAYOUT("versailles"),
    /* boards, from a metre or so to across a hall */
    FLOOR(1),
    FLOOR(10),
    FLOOR(100),
    FLOOR(300),
    /* plies: of one at a time, then of more and more under a footprint */
    ALONE("plies_face", .wood = {.plied = true}),
    ALONE("plies_edge", .wood = {.plied = true, .edge = true}),
    ALONE("plies_edge_1", .footprint = 1, .wood = {.plied = true, .edge = true}),
    ALONE("plies_edge_10", .footprint = 10, .wood = {.plied = true, .edge = true}),
    STONE("full.batch1024", 1024, NULL),
    STONE("full.batch1", 1, NULL),
#if defined(__x86_64__)
    STONE_ON("avx512"),
    STONE_ON("avx2"),
    STONE_ON("sse2"),
#elif defined(__aarch64__)
    STONE_ON("neon"),
#endif
    STONE_ON("scalar"),
    STONE_FOOTPRINT(0.3),
    STONE_FOOTPRINT(1),
    STONE_FOOTPRINT(3),
    STONE_FOOTPRINT(10),
    STONE_FOOTPRINT(100),
    STONE_OF("carrara"),
    STONE_OF("travertino"),
    STONE_OF("terrazzo"),
    /* cells counted; corners in parts; all but the stones' shade its mean */
    STONE_AFAR("ishidatami", 20),
    STONE_AFAR("granite_fan", 50),
    STONE_AFAR("ishidatami", 100),
    STONE_AFAR("teppei", 30),
    /* little contrast: cells counted early; clusters told; and veins in strips */
    STONE_AFAR("gabbro", 10),
    STONE_AFAR("inada", 50),
    STONE_AFAR("rosso_levanto", 20),
    STONE_AFAR("carrara", 50),
    {.name = "stone.create", .kind = ENTRY_CREATE, .wood = {.stone = "travertino"}},
    FIBER("full.batch1024", 1024, NULL),
    FIBER("full.batch1", 1, NULL),
#if defined(__x86_64__)
    FIBER_ON("avx512"),
    FIBER_ON("avx2"),
    FIBER_ON("sse2"),
#elif defined(__aarch64__)
    FIBER_ON("neon"),
#endif
    FIBER_ON("scalar"),
    FIBER_FOOTPRINT(0.002),
    FIBER_FOOTPRINT(0.01),
    FIBER_FOOTPRINT(0.1),
    FIBER_FOOTPRINT(1),
    FIBER_FOOTPRINT(10),
    FIBER_OF("cotton"),
    FIBER_OF("denim"),
    FIBER_OF("flannel"),
    FIBER_OF("fleece"),
    /* yarns in 2 x 2 parts, and in 3 x 3 */
    CLOTH("denim", 0.2),
    CLOTH("denim", 1),
    {.name = "fiber.albedo.batch1024",
     .batch = 1024,
     .channel = "albedo",
     .wood = {.fiber = "felt"}},
    {.name = "fiber.create", .kind = ENTRY_CREATE, .wood = {.fiber = "denim"}},
    {.name = "tree.grow.sugi_paper", .kind = ENTRY_TREE, .tree = "sugi_paper"},
    {.name = "tree.grow.sugi", .kind = ENTRY_TREE, .tree = "sugi"},
    {.name = "tree.grow_mesh.sugi_paper", .kind = ENTRY_TREE_MESH, .tree = "sugi_paper"},
    {.name = "tree.branches.sugi_paper", .kind = ENTRY_TREE_BRANCHES, .tree = "sugi_paper"},
    {.name = "tree.branches.sugi", .kind = ENTRY_TREE_BRANCHES, .tree = "sugi"},
    {.name = "fiber.place", .kind = ENTRY_FIBER_PLACE},
    {.name = "fiber.fit", .kind = ENTRY_FIBER_FIT},
    {.name = "fiber.fit.threads2", .kind = ENTRY_FIBER_THREADS},
    {.name = "wood.threads2.batch1024", .kind = ENTRY_THREADS, .batch = 1024},
    {.name = "wood.create", .kind = ENTRY_CREATE},
    {.name = "wood.create.brushed", .kind = ENTRY_CREATE, .wood = {.surface = "brushed"}},
    TILE("keyaki", "wood", "keyaki", "cut: flat", 0.0625),
    TILE("keyaki_0.5mm", "wood", "keyaki", "cut: flat", 0.5),
    TILE("mizunara", "wood", "mizunara", "cut: flat", 0.0625),
    TILE("sugi", "wood", "sugi", "cut: flat", 0.0625),
    TILE("buna", "wood", "buna", "cut: flat", 0.0625),
    TILE("mizunara_strip", "wood", "mizunara", "layout: strip", 0.5),
    TILE("inada", "stone", "inada", NULL, 0.0625),
    TILE("inada_0.5mm", "stone", "inada", NULL, 0.5),
    TILE("carrara", "stone", "carrara", NULL, 0.25),
    TILE("travertino", "stone", "travertino", NULL, 0.25),
    TILE("terrazzo", "stone", "terrazzo", NULL, 0.0625),
    TILE("felt", "fiber", "felt", NULL, 0.0625),
    TILE("felt_0.5mm", "fiber", "felt", NULL, 0.5),
    TILE("denim", "fiber", "denim", NULL, 0.125),
    PARTS("denim_samples_4", "fiber", "denim", 0.125, 4),
    LOOK("keyaki", "wood", WOOD, "keyaki", "cut: flat", 0.0625),
    LOOK("keyaki_0.5mm", "wood", WOOD, "keyaki", "cut: flat", 0.5),
    LOOK("mizunara", "wood", WOOD, "mizunara", "cut: flat", 0.0625),
    LOOK("sugi", "wood", WOOD, "sugi", "cut: flat", 0.0625),
    LOOK("buna", "wood", WOOD, "buna", "cut: flat", 0.0625),
    LOOK("mizunara_strip", "wood", RELIEF, "mizunara", "layout: strip", 0.5),
    LOOK("keyaki_planed", "wood", RELIEF, "keyaki", "cut: flat, surface: planed", 0.0625),
    LOOK("inada", "stone", STONES, "inada", NULL, 0.0625),
    LOOK("inada_0.5mm", "stone", STONES, "inada", NULL, 0.5),
    LOOK("carrara", "stone", STONES, "carrara", NULL, 0.25),
    LOOK("travertino", "stone", STONES, "travertino", NULL, 0.25),
    LOOK("terrazzo", "stone", STONES, "terrazzo", NULL, 0.0625),
    {.name = "wood.load", .kind = ENTRY_LOAD},
    {.name = "wood.load_alone", .kind = ENTRY_LOAD_ALONE},
};
const size_t entry_count = sizeof entries / sizeof entries[0];
