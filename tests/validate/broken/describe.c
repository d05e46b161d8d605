/* SPDX-License-Identifier: Apache-2.0
 * What there is. */
#include <stddef.h>

#include "plugin.h"

#define PARAMETER(of, name, in, ...)                                                               \
  {                                                                                                \
    .size = sizeof(sozai_parameter), .kind = SOZAI_KIND_##of, .id = name, .label = name,           \
    .group = in, .unit = "", .doc = "A parameter.", __VA_ARGS__                                    \
  }

static const char *const patterns[] = {"checks", "stripes"};
static const char *const pattern_docs[] = {"squares", "bands"};

#ifdef UNORDERED_RANGE
#define SCALE_SOFT .soft_min = 100, .soft_max = 1
#else
#define SCALE_SOFT .soft_min = 1, .soft_max = 100
#endif
#ifdef DEFAULT_OUT_OF_RANGE
#define SCALE_DEFAULT                                                                              \
  { 2000 }
#else
#define SCALE_DEFAULT                                                                              \
  { 20 }
#endif
#ifdef DUPLICATE_ID
#define LEVELS_ID "scale"
#else
#define LEVELS_ID "levels"
#endif
#ifdef CAPITAL_ID
#define SMOOTH_ID "Smooth"
#else
#define SMOOTH_ID "smooth"
#endif
#ifdef SPLIT_GROUP
#define PATTERN_GROUP "notes"
#else
#define PATTERN_GROUP "look"
#endif
#ifdef CHOICE_PAST
#define PATTERN_COUNT 1
#define PATTERN_DEFAULT                                                                            \
  { 1 }
#else
#define PATTERN_COUNT 2
#define PATTERN_DEFAULT                                                                            \
  { 0 }
#endif
#ifdef NULL_TEXT
#define NOTE_DOC NULL
#else
#define NOTE_DOC "Words."
#endif

static const sozai_parameter parameters[P_COUNT] = {
    PARAMETER(FLOAT, "scale", "look", .hard_min = 0.5, .hard_max = 1000, SCALE_SOFT,
              .default_number = SCALE_DEFAULT),
    PARAMETER(INT, LEVELS_ID, "look", .hard_min = 1, .hard_max = 8, .soft_min = 1, .soft_max = 8,
              .default_number = {3}),
    PARAMETER(BOOL, SMOOTH_ID, "look", .default_number = {1}, .hard_min = 0, .hard_max = 1),
    PARAMETER(CHOICE, "pattern", PATTERN_GROUP, .choices = patterns, .choice_docs = pattern_docs,
              .choice_count = PATTERN_COUNT, .default_number = PATTERN_DEFAULT),
    PARAMETER(FLOAT3, "offset", "look", .hard_min = -1000, .hard_max = 1000, .soft_min = -10,
              .soft_max = 10),
    PARAMETER(COLOUR, "tint", "look", .hard_min = 0, .hard_max = 1, .soft_min = 0, .soft_max = 1,
              .default_number = {0.5, 0.4, 0.3}, .default_text = "sRGB"),
    {.size = sizeof(sozai_parameter),
     .kind = SOZAI_KIND_TEXT,
     .id = "note",
     .label = "note",
     .group = "notes",
     .unit = "",
     .doc = NOTE_DOC,
     .default_text = ""},
    PARAMETER(BUFFER, "weights", "notes", .buffer_kind = SOZAI_BUFFER_TABLE),
};
static const sozai_parameter *const parameter_list[P_COUNT] = {
    &parameters[0], &parameters[1], &parameters[2], &parameters[3],
    &parameters[4], &parameters[5], &parameters[6], &parameters[7]};

#ifdef PRESET_OF_UNKNOWN
#define RED_ID "hue"
#else
#define RED_ID "tint"
#endif
static const sozai_value wide_values[] = {
    {.id = "scale", .kind = SOZAI_KIND_FLOAT, .number = {80}},
    {.id = "pattern", .kind = SOZAI_KIND_CHOICE, .text = "stripes"}};
static const sozai_value red_values[] = {
    {.id = RED_ID, .kind = SOZAI_KIND_COLOUR, .number = {0.7, 0.2, 0.1}}};
static const sozai_preset presets[] = {
    {sizeof(sozai_preset), 2, "wide", "Wide", "Bands.", "none", wide_values},
    {sizeof(sozai_preset), 1, "red", "Red", "Squares.", "none", red_values}};
static const sozai_preset *const preset_list[] = {&presets[0], &presets[1]};

#define POINT SOZAI_INPUT_POINT
#define CHANNEL(at, n, needs_, uses_, name, letters)                                               \
  { sizeof(sozai_channel), at, n, needs_, uses_, 0, name, "", letters, "A channel." }
#ifdef OVERLAPPING_CHANNELS
#define FACE_FIRST C_HEIGHT
#else
#define FACE_FIRST C_FACE
#endif
#ifdef NEEDS_AND_USES
#define HEIGHT_USES POINT
#else
#define HEIGHT_USES 0
#endif
static const sozai_channel channels[] = {
    CHANNEL(C_ALBEDO, 3, POINT, SOZAI_INPUT_FOOTPRINT, "albedo", "rgb"),
    CHANNEL(C_RADIANCE, 3, POINT | SOZAI_INPUT_NORMAL | SOZAI_INPUT_LIGHT,
            SOZAI_INPUT_LIGHT_COLOUR | SOZAI_INPUT_VIEW | SOZAI_INPUT_FOOTPRINT, "radiance", "rgb"),
    CHANNEL(C_HEIGHT, 1, POINT, HEIGHT_USES, "height", ""),
    CHANNEL(FACE_FIRST, 1, POINT, SOZAI_INPUT_NORMAL, "face", "")};
static const sozai_channel *const channel_list[] = {&channels[0], &channels[1], &channels[2],
                                                    &channels[3]};

#ifdef LARGER_STRUCT
#define INFO_SIZE (sizeof(sozai_texture_info) + 8)
#else
#define INFO_SIZE sizeof(sozai_texture_info)
#endif
char plain_label[] = "Plain";
#define PLAIN                                                                                      \
  {                                                                                                \
    INFO_SIZE, 1, "plain", plain_label, "Squares or bands.", parameter_list, preset_list,          \
        channel_list, P_COUNT, 2, 4, COMPONENTS                                                    \
  }
static const sozai_texture_info plain = PLAIN;

const sozai_texture_info *plain_info(void) { return &plain; }

/* ---- the generator ------------------------------------------------------------------ */

static const sozai_parameter rod_parameters[G_COUNT] = {
    PARAMETER(FLOAT, "length", "shape", .hard_min = 10, .hard_max = 1000, .soft_min = 10,
              .soft_max = 200, .default_number = {100}),
    PARAMETER(INT, "sides", "shape", .hard_min = 3, .hard_max = 64, .soft_min = 3, .soft_max = 16,
              .default_number = {8})};
static const sozai_parameter *const rod_list[G_COUNT] = {&rod_parameters[0], &rod_parameters[1]};
static const sozai_value short_values[] = {
    {.id = "length", .kind = SOZAI_KIND_FLOAT, .number = {20}}};
static const sozai_preset rod_preset = {sizeof(sozai_preset), 1, "short", "Short", "", "",
                                        short_values};
static const sozai_preset *const rod_presets[] = {&rod_preset};
static const sozai_column columns[] = {{"y", "mm", "Height."}, {"radius", "mm", "Of the rod."}};
static const sozai_table_info rings = {sizeof rings, 2, "rings", "Radii.", columns};
static const sozai_table_info *const tables[] = {&rings};
static const sozai_generator_info rod = {
    sizeof rod, 1, "rod", "Rod", "A round rod.", rod_list, rod_presets, tables, G_COUNT, 1, 1, 0};

const sozai_generator_info *rod_info(void) { return &rod; }
