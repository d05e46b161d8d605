/* SPDX-License-Identifier: Apache-2.0 */
#include "identity_textures.h"

#include <stdio.h>

#define TEXTURES_MAX 256

static const plugin *host;
static sozai_texture *textures[TEXTURES_MAX];
static uint32_t texture_count, wood_count, stone_count;

/* Making them takes long: first all are counted, then those made that a block asks. */
static int counting;
static uint8_t asked[TEXTURES_MAX];

static int make(const char *id, const char *preset, const sozai_value *values, uint32_t count) {
  if (texture_count == TEXTURES_MAX) {
    fprintf(stderr, "more than %d textures\n", TEXTURES_MAX);
    return 1;
  }
  uint32_t own = texture_count++;
  if (counting || !asked[own]) return 0;
  int32_t r = host->textures->create(NULL, id, preset, values, count, &textures[own]);
  if (r == SOZAI_ERROR_UNSUPPORTED) return 77;
  if (r != SOZAI_OK) {
    fprintf(stderr, "create: %s\n", host->textures->last_error());
    return 1;
  }
  const sozai_texture_info *info = host->textures->info_of(textures[own]);
  if (info->component_count <= COMPONENTS && info->channel_count <= 32) return 0;
  fprintf(stderr, "%s has more than %u components or 32 channels\n", id, COMPONENTS);
  return 1;
}

static const char *const surfaces[] = {"smooth",  "band_sawn",   "circular_sawn",
                                       "planed",  "hand_planed", "sanded",
                                       "brushed", "charred",     "weathered"};
static const char *const finishes[] = {"raw", "oiled", "lacquered"};

/* Whose branches are knots. */
static const char *const trees[] = {"", "sugi", "akamatsu", "keyaki"};

/* Every fourth preset, with every kind of slope, surface, finish and tree. */
static int make_woods(void) {
  static const char *const cuts[] = {"log", "flat", "quarter", "rift", "end"};
  const sozai_texture_info *info = host->textures->find("wood");
  int r = info ? 0 : 1;
  for (uint32_t i = 0; !r && i <= info->preset_count; i += 4) {
    const sozai_value values[] = {
        {.id = "grain", .kind = SOZAI_KIND_CHOICE, .text = "compound"},
        {.id = "cut", .kind = SOZAI_KIND_CHOICE, .text = cuts[i / 4u % 5u]},
        {.id = "cut_rotation", .kind = SOZAI_KIND_FLOAT, .number = {i / 20u * 33.0}},
        {.id = "wave_irregularity", .kind = SOZAI_KIND_FLOAT, .number = {i / 4u % 3u * 0.3}},
        /* within reach of the points */
        {.id = "heartwood_years",
         .kind = SOZAI_KIND_FLOAT,
         .number = {10.0 + 10.0 * (i / 4u % 4u)}},
        {.id = "coat", .kind = SOZAI_KIND_FLOAT, .number = {i / 4u % 3u * 0.5}},
        {.id = "reflection",
         .kind = SOZAI_KIND_CHOICE,
         .text = i / 4u % 2u ? "fibre_cone" : "kawai"},
        {.id = "surface", .kind = SOZAI_KIND_CHOICE, .text = surfaces[i / 4u % 9u]},
        {.id = "finish", .kind = SOZAI_KIND_CHOICE, .text = finishes[i / 4u % 3u]},
        {.id = "age_years", .kind = SOZAI_KIND_FLOAT, .number = {i / 4u % 2u * 7.0}},
        {.id = "streak_share", .kind = SOZAI_KIND_FLOAT, .number = {i / 4u % 4u * 0.01}},
        {.id = "mark_angle", .kind = SOZAI_KIND_FLOAT, .number = {i % 3u * 30.0}},
        {.id = "tree", .kind = SOZAI_KIND_TEXT, .text = trees[i / 4u % 4u]},
        {.id = "log_height", .kind = SOZAI_KIND_FLOAT, .number = {2000.0 + 500.0 * (i % 7u)}}};
    r = make("wood", i ? info->presets[i - 1]->id : NULL, values, 14);
  }
  return r;
}

/* Rays in two layers, and the cells in them. */
static int make_crowded(void) {
  static const char *const presets[] = {"plane", "silky_oak"};
  static const char *const cuts[] = {"quarter", "flat", "end"};
  int r = 0;
  for (uint32_t i = 0; !r && i < 6; i++) {
    const sozai_value values[] = {
        {.id = "cut", .kind = SOZAI_KIND_CHOICE, .text = cuts[i % 3u]},
        {.id = "cell_contrast", .kind = SOZAI_KIND_FLOAT, .number = {0.7}},
        {.id = "tree", .kind = SOZAI_KIND_TEXT, .text = trees[i % 2u ? 3 : 0]},
        {.id = "log_height", .kind = SOZAI_KIND_FLOAT, .number = {2000}}};
    r = make("wood", presets[i / 3u], values, sizeof values / sizeof *values);
  }
  return r;
}

/* Each way of finding a unit, with everything that a layout can have. */
static int make_layouts(void) {
  static const char *const layouts[] = {"strip",   "herringbone", "versailles", "hexagon",
                                        "ashlar",  "crazy",       "arcs",       "circles",
                                        "chevron", "end_grain"};
  static const char *const flips[] = {"random", "alternate", "none"};
  const sozai_texture_info *info = host->textures->find("wood");
  int r = info ? 0 : 1;
  for (uint32_t i = 0; !r && i < sizeof layouts / sizeof *layouts; i++) {
    const sozai_value values[] = {
        {.id = "layout", .kind = SOZAI_KIND_CHOICE, .text = layouts[i]},
        {.id = "layout_rotation", .kind = SOZAI_KIND_FLOAT, .number = {17.0 * i}},
        {.id = "bevel", .kind = SOZAI_KIND_FLOAT, .number = {0.5 * i}},
        {.id = "cupping", .kind = SOZAI_KIND_FLOAT, .number = {i % 2u * 0.7}},
        {.id = "board_flip", .kind = SOZAI_KIND_CHOICE, .text = flips[i % 3u]},
        {.id = "grain", .kind = SOZAI_KIND_CHOICE, .text = "compound"},
        {.id = "reflection", .kind = SOZAI_KIND_CHOICE, .text = i % 2u ? "fibre_cone" : "kawai"},
        {.id = "surface", .kind = SOZAI_KIND_CHOICE, .text = surfaces[(i + 1u) % 9u]},
        {.id = "tree", .kind = SOZAI_KIND_TEXT, .text = trees[i % 4u]}};
    r = make("wood", info->presets[i % info->preset_count]->id, values, 9);
  }
  return r;
}

/* Every preset, every finish, layout and weather, and both of the paper's modes of colour, with a
 * tile and without. The stride takes the first few blocks to stones of all kinds. */
#define STONE_STRIDE 12u
static int make_stones(void) {
  static const char *const worked[] = {"split", "flamed", "bush_hammered",
                                       "sawn",  "honed",  "polished"};
  static const char *const modes[] = {"paper_rgb", "paper_lightness"};
  static const char *const beds[] = {"x", "y", "z"};
  static const char *const layouts[] = {"none", "fan",    "crazy", "chidori", "hexagon",
                                        "arcs", "ashlar", "stack", "circles", "herringbone"};
  static const char *const patterns[] = {"igeta", "chidori"};
  const sozai_texture_info *info = host->textures->find("stone");
  int r = info ? 0 : 1;
  for (uint32_t i = 0; !r && i < info->preset_count; i++) {
    const sozai_value values[] = {
        {.id = "finish", .kind = SOZAI_KIND_CHOICE, .text = worked[i % 6u]},
        {.id = "bed", .kind = SOZAI_KIND_CHOICE, .text = beds[i / 6 % 3u]},
        {.id = "layout", .kind = SOZAI_KIND_CHOICE, .text = layouts[i % 10u]},
        {.id = "stone_length", .kind = SOZAI_KIND_FLOAT},
        {.id = "stone_width", .kind = SOZAI_KIND_FLOAT},
        {.id = "joint_width", .kind = SOZAI_KIND_FLOAT, .number = {9}},
        {.id = "joint_wander", .kind = SOZAI_KIND_FLOAT, .number = {i % 2u * 0.045}},
        {.id = "corner_radius", .kind = SOZAI_KIND_FLOAT, .number = {4.0 + i % 3u}},
        {.id = "edge_round", .kind = SOZAI_KIND_FLOAT, .number = {5}},
        {.id = "bevel", .kind = SOZAI_KIND_FLOAT, .number = {i % 2u * 2.0}},
        {.id = "tilt", .kind = SOZAI_KIND_FLOAT, .number = {2}},
        {.id = "moss", .kind = SOZAI_KIND_FLOAT, .number = {i % 4u * 0.2}},
        {.id = "wet", .kind = SOZAI_KIND_FLOAT, .number = {i % 2u * 0.7}},
        {.id = "water_level", .kind = SOZAI_KIND_FLOAT, .number = {i % 3u ? -1000.0 : -2.0}},
        {.id = "wear", .kind = SOZAI_KIND_FLOAT, .number = {i % 2u * 0.5}},
        /* every third has its own holes and veins */
        {.id = "hole_share", .kind = SOZAI_KIND_FLOAT, .number = {i % 2u * 0.05}},
        {.id = "vein_width", .kind = SOZAI_KIND_FLOAT, .number = {i % 2u ? 0.0 : 4.0}}};
    uint32_t count = sizeof values / sizeof *values;
    r = make("stone", info->presets[i]->id, values, i % 3u ? count : count - 2);
  }
  for (int i = 0; !r && i < 2; i++) {
    const sozai_value values[] = {
        {.id = "colour_mode", .kind = SOZAI_KIND_CHOICE, .text = modes[i]},
        {.id = "paper_black", .kind = SOZAI_KIND_FLOAT, .number = {0.1}},
        {.id = "paper_white", .kind = SOZAI_KIND_FLOAT, .number = {0.1}},
        {.id = "paper_pattern", .kind = SOZAI_KIND_CHOICE, .text = patterns[i]}};
    r = make("stone", NULL, values, 3);
    if (!r) r = make("stone", NULL, values, 4);
  }
  return r;
}

/* Every preset of fibre, along each axis, matted, standing and woven. */
static int make_fibers(void) {
  static const char *const along[] = {"x", "y", "z"};
  static const char *const weaves[] = {"plain",     "basket",    "twill_2_1",
                                       "twill_3_1", "twill_2_2", "satin"};
  const sozai_texture_info *info = host->textures->find("fiber");
  int r = info ? 0 : 1;
  for (uint32_t i = 0; !r && i < info->preset_count; i++) {
    const sozai_value values[] = {
        {.id = "axis", .kind = SOZAI_KIND_CHOICE, .text = along[i % 3u]},
        {.id = "weave", .kind = SOZAI_KIND_CHOICE, .text = weaves[i % 6u]},
        {.id = "flyaway", .kind = SOZAI_KIND_FLOAT, .number = {i % 4u * 0.05}},
        {.id = "elevation", .kind = SOZAI_KIND_FLOAT, .number = {i % 5u * 15.0}}};
    r = make("fiber", info->presets[i]->id, values, sizeof values / sizeof *values);
  }
  return r;
}

static int make_all(void) {
  texture_count = 0;
  int r = make_woods();
  if (!r) r = make_layouts();
  if (!r) r = make_crowded();
  wood_count = texture_count;
  if (!r) r = make_stones();
  stone_count = texture_count - wood_count;
  return r ? r : make_fibers();
}

/* A block's texture: of six blocks four are wood's, one a stone's and one a fibre's. */
static uint32_t number_of(uint64_t block) {
  uint64_t six = block / 6, of = block % 6;
  uint32_t others = wood_count + stone_count;
  if (of == 3) return wood_count + (uint32_t)(six * STONE_STRIDE % stone_count);
  if (of == 5) return others + (uint32_t)(six % (texture_count - others));
  return (uint32_t)((4 * six + of - (of == 4)) % wood_count);
}

int textures_make(const plugin *p, uint64_t blocks) {
  host = p;
  counting = 1;
  int r = make_all();
  for (uint64_t block = 0; !r && block < blocks; block++) asked[number_of(block)] = 1;
  counting = 0;
  return r ? r : make_all();
}

sozai_texture *texture_of(uint64_t block) { return textures[number_of(block)]; }

void textures_free(void) {
  for (uint32_t i = 0; i < texture_count; i++)
    if (textures[i]) host->textures->destroy(textures[i]);
}
