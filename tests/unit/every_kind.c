/* SPDX-License-Identifier: Apache-2.0 */
#include "every_kind.h"

#define P(kind_, id_) .size = sizeof(sozai_parameter), .kind = kind_, .id = id_, .unit = ""

static const char *const shapes[] = {"round", "square", "ring"};

static const sozai_parameter width = {P(SOZAI_KIND_FLOAT, "width"), .hard_min = -2.5,
                                      .hard_max = 40, .default_number = {1.25}};
static const sozai_parameter count = {P(SOZAI_KIND_INT, "count"), .hard_min = -3,
                                      .hard_max = 4294967295, .default_number = {7}};
static const sozai_parameter hollow = {P(SOZAI_KIND_BOOL, "hollow"), .hard_min = 0, .hard_max = 1,
                                       .default_number = {1}};
static const sozai_parameter shape = {P(SOZAI_KIND_CHOICE, "shape"), .choices = shapes,
                                      .choice_docs = shapes, .choice_count = 3,
                                      .default_number = {1}};
static const sozai_parameter offset = {P(SOZAI_KIND_FLOAT3, "offset"), .hard_min = -100,
                                       .hard_max = 100, .default_number = {1, 2, 3}};
static const sozai_parameter tint = {P(SOZAI_KIND_COLOUR, "tint"), .hard_min = 0, .hard_max = 1,
                                     .default_number = {0.5, 0.25, 0.125}, .default_text = "sRGB"};
static const sozai_parameter name = {P(SOZAI_KIND_TEXT, "name"), .default_text = "nobody"};
static const sozai_parameter file = {P(SOZAI_KIND_PATH, "file"), .default_text = ""};
static const sozai_parameter table = {P(SOZAI_KIND_BUFFER, "table"),
                                      .buffer_kind = SOZAI_BUFFER_TABLE};
static const sozai_parameter image = {P(SOZAI_KIND_BUFFER, "image"),
                                      .buffer_kind = SOZAI_BUFFER_IMAGE};
static const sozai_parameter mesh = {P(SOZAI_KIND_BUFFER, "mesh"),
                                     .buffer_kind = SOZAI_BUFFER_MESH};
static const sozai_parameter points = {P(SOZAI_KIND_BUFFER, "points"),
                                       .buffer_kind = SOZAI_BUFFER_POINTS};

static const sozai_parameter picture = {P(SOZAI_KIND_IMAGE, "picture"),
                                        .default_number = {3, SOZAI_WRAP_CLAMP}, .default_text = "",
                                        .buffer_kind = SOZAI_BUFFER_IMAGE};

static const sozai_parameter *const parameters[K_COUNT] = {
    [K_FLOAT] = &width,    [K_INT] = &count,   [K_BOOL] = &hollow, [K_CHOICE] = &shape,
    [K_FLOAT3] = &offset,  [K_COLOUR] = &tint, [K_TEXT] = &name,   [K_PATH] = &file,
    [K_TABLE] = &table,    [K_IMAGE] = &image, [K_MESH] = &mesh,   [K_POINTS] = &points,
    [K_PICTURE] = &picture};

static const sozai_value small_values[] = {
    {.id = "width", .kind = SOZAI_KIND_FLOAT, .number = {0.5}},
    {.id = "shape", .kind = SOZAI_KIND_CHOICE, .text = "ring"},
    {.id = "tint", .kind = SOZAI_KIND_COLOUR, .number = {0.1, 0.2, 0.3}, .text = "lin_rec709"}};
static const sozai_preset small = {
    .size = sizeof(sozai_preset), .value_count = 3, .id = "small", .values = small_values};
static const sozai_value broken_values[] = {
    {.id = "width", .kind = SOZAI_KIND_FLOAT, .number = {41}}};
static const sozai_preset broken = {
    .size = sizeof(sozai_preset), .value_count = 1, .id = "broken", .values = broken_values};
static const sozai_preset *const presets[] = {&small, &broken};

const sozai_texture_info every_kind = {.size = sizeof(sozai_texture_info),
                                       .id = "every",
                                       .parameters = parameters,
                                       .presets = presets,
                                       .parameter_count = K_COUNT,
                                       .preset_count = 2};
