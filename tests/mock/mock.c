/* SPDX-License-Identifier: Apache-2.0
 *
 * A plugin of the sozai ABI whose every answer can be worked out by hand, for
 * the tests of programs that use the ABI. Its one texture, "wood", is a
 * checkerboard with a parameter of each common kind. */
#include <math.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "sozai.h"

#ifndef MOCK_ABI_MAJOR
#define MOCK_ABI_MAJOR SOZAI_ABI_MAJOR
#endif
#ifndef MOCK_INIT_RESULT
#define MOCK_INIT_RESULT SOZAI_OK
#endif
#ifndef MOCK_FACTORY
#define MOCK_FACTORY SOZAI_TEXTURES_1
#endif
#ifndef MOCK_ENTRY
#define MOCK_ENTRY sozai_entry
#endif

static _Thread_local char last_error_text[256] = "";

#define FAIL(code, ...) (snprintf(last_error_text, sizeof last_error_text, __VA_ARGS__), (code))

/* ---- what it describes ------------------------------------------------ */

enum { PITCH, RINGS, SHINY, CUT, TILT, TINT, NOTE, PARAMETER_COUNT };

static const char *const cuts[] = {"log", "flat", "quarter", "rift", "end"};
static const char *const cut_docs[] = {"the log", "tangential", "radial", "between", "across"};

#define PARAMETER(id_, kind_)                                                                      \
  .size = sizeof(sozai_parameter), .kind = kind_, .id = id_, .label = id_
static const sozai_parameter parameters[PARAMETER_COUNT] = {
    [PITCH] = {PARAMETER("pitch", SOZAI_KIND_FLOAT), .group = "checks", .unit = "mm",
               .doc = "Side of a \"check\".", .hard_min = 0.1, .hard_max = 1000, .soft_min = 1,
               .soft_max = 100, .default_number = {10}},
    [RINGS] = {PARAMETER("rings", SOZAI_KIND_INT), .group = "checks", .unit = "",
               .doc = "Does nothing.", .hard_min = 1, .hard_max = 500, .soft_min = 1,
               .soft_max = 100, .default_number = {40}},
    [SHINY] = {PARAMETER("shiny", SOZAI_KIND_BOOL), .group = "surface", .unit = "",
               .doc = "Adds a highlight."},
    [CUT] = {PARAMETER("cut", SOZAI_KIND_CHOICE), .group = "surface", .unit = "",
             .doc = "Which coordinates the checks run along.", .default_number = {0},
             .choices = cuts, .choice_docs = cut_docs, .choice_count = 5},
    [TILT] = {PARAMETER("tilt", SOZAI_KIND_FLOAT3), .group = "surface", .unit = "deg",
              .doc = "Does nothing.", .hard_min = -360, .hard_max = 360, .soft_min = -90,
              .soft_max = 90},
    [TINT] = {PARAMETER("tint", SOZAI_KIND_COLOUR), .group = "surface", .unit = "",
              .doc = "Of the light checks, taken as it is.", .hard_min = 0, .hard_max = 1,
              .soft_min = 0, .soft_max = 1, .default_number = {0.75, 0.5, 0.25},
              .default_text = "lin_rec709"},
    [NOTE] = {PARAMETER("note", SOZAI_KIND_TEXT), .group = "surface", .unit = "", .doc = "Kept.",
              .default_text = ""},
};

static const sozai_value oak_values[] = {
    {.id = "pitch", .kind = SOZAI_KIND_FLOAT, .number = {20}},
    {.id = "tint", .kind = SOZAI_KIND_COLOUR, .number = {0.5, 0.25, 0.125}},
};
static const sozai_value maple_values[] = {
    {.id = "cut", .kind = SOZAI_KIND_CHOICE, .text = "flat"},
    {.id = "shiny", .kind = SOZAI_KIND_BOOL, .number = {1}},
};
static const sozai_preset presets[] = {
    {sizeof(sozai_preset), 2, "mock_oak", "Mock oak", "Larger checks.", "none", oak_values},
    {sizeof(sozai_preset), 2, "mock_maple", "Mock maple", "Shiny.", "none", maple_values},
};
#define PRESET_COUNT 2

enum { ALBEDO, RADIANCE, FIBER, DIVE, TIME, LATEWOOD, VESSEL, REFERENCE, SPECULAR, ROUGHNESS };
#define CHANNEL_COUNT 10
#define COMPONENT_COUNT 17

#define LIT (SOZAI_INPUT_POINT | SOZAI_INPUT_NORMAL | SOZAI_INPUT_LIGHT)
#define CHANNEL(first_, count_, needs_, uses_, id_, unit_, suffixes_)                              \
  { sizeof(sozai_channel), first_, count_, needs_, uses_, 0, id_, unit_, suffixes_, "A channel." }
static const sozai_channel channels[CHANNEL_COUNT] = {
    [ALBEDO] = CHANNEL(0, 3, SOZAI_INPUT_POINT, SOZAI_INPUT_FOOTPRINT, "albedo", "", "rgb"),
    [RADIANCE] =
        CHANNEL(3, 3, LIT, SOZAI_INPUT_LIGHT_COLOUR | SOZAI_INPUT_VIEW, "radiance", "", "rgb"),
    [FIBER] = CHANNEL(6, 3, SOZAI_INPUT_POINT, 0, "fiber", "", "xyz"),
    [DIVE] = CHANNEL(9, 1, SOZAI_INPUT_POINT | SOZAI_INPUT_NORMAL, 0, "dive", "rad", ""),
    [TIME] = CHANNEL(10, 1, SOZAI_INPUT_POINT, 0, "time", "years", ""),
    [LATEWOOD] = CHANNEL(11, 1, SOZAI_INPUT_POINT, 0, "latewood", "", ""),
    [VESSEL] = CHANNEL(12, 1, SOZAI_INPUT_POINT, 0, "vessel", "", ""),
    [REFERENCE] = CHANNEL(13, 2, SOZAI_INPUT_POINT, 0, "reference", "mm", "xz"),
    [SPECULAR] = CHANNEL(15, 1, SOZAI_INPUT_POINT, 0, "specular", "", ""),
    [ROUGHNESS] = CHANNEL(16, 1, SOZAI_INPUT_POINT, 0, "roughness", "", ""),
};

static const sozai_parameter *const parameter_list[PARAMETER_COUNT] = {
    &parameters[0], &parameters[1], &parameters[2], &parameters[3],
    &parameters[4], &parameters[5], &parameters[6]};
static const sozai_preset *const preset_list[] = {&presets[0], &presets[1]};
static const sozai_channel *const channel_list[] = {
    &channels[0], &channels[1], &channels[2], &channels[3], &channels[4],
    &channels[5], &channels[6], &channels[7], &channels[8], &channels[9]};
static const sozai_texture_info wood = {sizeof(sozai_texture_info),
                                        1,
                                        "wood",
                                        "Mock wood",
                                        "A checkerboard.",
                                        parameter_list,
                                        preset_list,
                                        channel_list,
                                        PARAMETER_COUNT,
                                        PRESET_COUNT,
                                        CHANNEL_COUNT,
                                        COMPONENT_COUNT};

static uint32_t count(void) { return 1; }
static const sozai_texture_info *info(uint32_t index) { return index == 0 ? &wood : NULL; }
static const sozai_texture_info *find(const char *id) {
  return id && strcmp(id, wood.id) == 0 ? &wood : NULL;
}

/* ---- textures --------------------------------------------------------- */

struct sozai_texture {
  double numbers[PARAMETER_COUNT][3];
  char note[64];
};

static int find_parameter(const char *id) {
  for (int i = 0; i < PARAMETER_COUNT; i++)
    if (strcmp(parameters[i].id, id) == 0) return i;
  return -1;
}

static int32_t set_choice(sozai_texture *t, int i, const char *text) {
  for (uint32_t k = 0; k < parameters[i].choice_count; k++)
    if (text && strcmp(parameters[i].choices[k], text) == 0) {
      t->numbers[i][0] = k;
      return SOZAI_OK;
    }
  return FAIL(SOZAI_ERROR_RANGE, "%s: '%s' is none of log, flat, quarter, rift, end",
              parameters[i].id, text ? text : "");
}

static int wanted_numbers(uint32_t kind) {
  return kind == SOZAI_KIND_FLOAT3 || kind == SOZAI_KIND_COLOUR ? 3 : 1;
}

/* Text into numbers: as many as the kind takes, and nothing after them. */
static int32_t read_numbers(int i, const char *text, double *number) {
  const char *at = text;
  for (int k = 0; k < wanted_numbers(parameters[i].kind); k++) {
    char *end;
    number[k] = strtod(at, &end);
    if (end == at) return FAIL(SOZAI_ERROR_KIND, "%s: cannot read '%s'", parameters[i].id, text);
    at = end;
  }
  return *at ? FAIL(SOZAI_ERROR_KIND, "%s: cannot read '%s'", parameters[i].id, text) : SOZAI_OK;
}

static int32_t set_numbers(sozai_texture *t, int i, const double *number) {
  const sozai_parameter *p = &parameters[i];
  for (int k = 0; k < wanted_numbers(p->kind); k++) {
    if (!(number[k] >= p->hard_min && number[k] <= p->hard_max))
      return FAIL(SOZAI_ERROR_RANGE, "%s: %g is outside %g to %g", p->id, number[k], p->hard_min,
                  p->hard_max);
    t->numbers[i][k] = number[k];
  }
  return SOZAI_OK;
}

static int32_t set_value(sozai_texture *t, const sozai_value *v) {
  if (!v->id) return FAIL(SOZAI_ERROR_ARGUMENT, "a value has no parameter's id");
  int i = find_parameter(v->id);
  if (i < 0) return FAIL(SOZAI_ERROR_UNKNOWN, "wood has no parameter '%s'", v->id);
  bool is_text = v->kind == SOZAI_KIND_STRING;
  switch (parameters[i].kind) {
  case SOZAI_KIND_CHOICE:
    return set_choice(t, i, v->text);
  case SOZAI_KIND_TEXT:
    snprintf(t->note, sizeof t->note, "%s", v->text);
    return SOZAI_OK;
  case SOZAI_KIND_BOOL:
    if (is_text && strcmp(v->text, "true") != 0 && strcmp(v->text, "false") != 0)
      return FAIL(SOZAI_ERROR_KIND, "%s: '%s' is neither true nor false", v->id, v->text);
    t->numbers[i][0] = is_text ? strcmp(v->text, "true") == 0 : v->number[0];
    return SOZAI_OK;
  default: {
    double number[3] = {v->number[0], v->number[1], v->number[2]};
    int32_t result = is_text ? read_numbers(i, v->text, number) : SOZAI_OK;
    return result == SOZAI_OK ? set_numbers(t, i, number) : result;
  }
  }
}

static int32_t set_values(sozai_texture *t, const sozai_value *values, uint32_t value_count) {
  int32_t result = SOZAI_OK;
  for (uint32_t i = 0; i < value_count && result == SOZAI_OK; i++)
    result = set_value(t, &values[i]);
  return result;
}

static int32_t set_preset(sozai_texture *t, const char *id) {
  for (int i = 0; i < PRESET_COUNT; i++)
    if (strcmp(presets[i].id, id) == 0)
      return set_values(t, presets[i].values, presets[i].value_count);
  return FAIL(SOZAI_ERROR_UNKNOWN, "wood has no preset '%s'", id);
}

static int32_t create(const sozai_host *host, const char *texture_id, const char *preset,
                      const sozai_value *values, uint32_t value_count, sozai_texture **out) {
  (void)host;
  *out = NULL;
  if (!find(texture_id))
    return FAIL(SOZAI_ERROR_UNKNOWN, "there is no texture '%s'", texture_id ? texture_id : "");
  sozai_texture *t = calloc(1, sizeof *t);
  if (!t) return FAIL(SOZAI_ERROR_MEMORY, "out of memory");
  for (int i = 0; i < PARAMETER_COUNT; i++)
    memcpy(t->numbers[i], parameters[i].default_number, sizeof t->numbers[i]);
  int32_t result = preset ? set_preset(t, preset) : SOZAI_OK;
  if (result == SOZAI_OK) result = set_values(t, values, value_count);
  if (result == SOZAI_OK)
    *out = t;
  else
    free(t);
  return result;
}

static void destroy(sozai_texture *t) { free(t); }

/* ---- answers ---------------------------------------------------------- */

static float read_at(const float *const *arrays, int k, uint32_t i, float otherwise) {
  float x = arrays[k] ? arrays[k][i] : otherwise;
  return isfinite(x) ? x : isnan(x) ? 0 : copysignf(1e6f, x);
}

static void answer(const sozai_texture *t, const sozai_batch *b, uint32_t i, float *out) {
  float p[3], n[3], l[3], colour[3];
  for (int k = 0; k < 3; k++) {
    p[k] = read_at(b->point, k, i, 0);
    n[k] = read_at(b->normal, k, i, k == 2);
    l[k] = read_at(b->light, k, i, k == 2);
    colour[k] = read_at(b->light_colour, k, i, 1);
  }
  int across = t->numbers[CUT][0] == 4 ? 2 : 0;
  float pitch = (float)t->numbers[PITCH][0];
  bool light = fmodf(floorf(p[across] / pitch) + floorf(p[1] / pitch), 2) == 0;
  float cosine = fmaxf(0, n[0] * l[0] + n[1] * l[1] + n[2] * l[2]);
  for (int k = 0; k < 3; k++) {
    out[k] = light ? (float)t->numbers[TINT][k] : 0.125f;
    out[3 + k] = colour[k] * cosine * (out[k] + (t->numbers[SHINY][0] != 0 ? 0.5f : 0));
    out[6 + k] = k == 1;
  }
  out[9] = n[1];
  out[10] = sqrtf(p[0] * p[0] + p[2] * p[2]);
  out[11] = light ? 0 : 1;
  out[12] = 0;
  out[13] = p[0];
  out[14] = p[2];
  out[15] = 0.5f;
  out[16] = 0.25f;
}

static bool wants(const sozai_batch *b, const sozai_channel *c) {
  for (uint32_t k = c->first; k < c->first + c->components; k++)
    if (k < b->out_count && b->out[k]) return true;
  return false;
}

static int32_t evaluate(const sozai_texture *t, const sozai_batch *b) {
  uint32_t have = (b->point[0] ? SOZAI_INPUT_POINT : 0) | (b->normal[0] ? SOZAI_INPUT_NORMAL : 0) |
                  (b->light[0] ? SOZAI_INPUT_LIGHT : 0);
  for (int c = 0; c < CHANNEL_COUNT; c++)
    if (wants(b, &channels[c]) && (channels[c].needs & ~have))
      return FAIL(SOZAI_ERROR_ARGUMENT, "channel %s lacks an input", channels[c].id);
  for (uint32_t i = 0; i < b->count; i++) {
    if (b->active && !b->active[i]) continue;
    float out[COMPONENT_COUNT];
    answer(t, b, i, out);
    for (uint32_t k = 0; k < COMPONENT_COUNT && k < b->out_count; k++)
      if (b->out[k]) b->out[k][i] = out[k];
  }
  return SOZAI_OK;
}

static int32_t value(const sozai_texture *t, const char *id, sozai_value *out) {
  int i = find_parameter(id);
  if (i < 0) return FAIL(SOZAI_ERROR_UNKNOWN, "wood has no parameter '%s'", id);
  *out = (sozai_value){.id = parameters[i].id, .kind = parameters[i].kind};
  memcpy(out->number, t->numbers[i], sizeof out->number);
  if (i == CUT) out->text = cuts[(int)t->numbers[CUT][0]];
  if (i == NOTE) out->text = t->note;
  return SOZAI_OK;
}

static const sozai_texture_info *info_of(const sozai_texture *t) { return t ? &wood : NULL; }
static uint64_t bytes(const sozai_texture *t) { return sizeof *t; }
static const char *instruction_set(const sozai_texture *t) {
  (void)t;
  return "scalar";
}
static const char *last_error(void) { return last_error_text; }

static const sozai_textures_1 textures = {count,     info,  find,    create, destroy,
                                          evaluate,  value, info_of, bytes,  instruction_set,
                                          last_error};

/* ---- entry ------------------------------------------------------------ */

static atomic_int uses;

static int32_t init(const char *path) {
  (void)path;
  if (MOCK_INIT_RESULT == SOZAI_OK) atomic_fetch_add(&uses, 1);
  return MOCK_INIT_RESULT;
}
static void deinit(void) { atomic_fetch_sub(&uses, 1); }
static const void *get_factory(const char *id) {
  return atomic_load(&uses) > 0 && id && strcmp(id, MOCK_FACTORY) == 0 ? &textures : NULL;
}

__attribute__((visibility("default")))
const sozai_entry_v1 MOCK_ENTRY = {MOCK_ABI_MAJOR, SOZAI_ABI_MINOR, init, deinit, get_factory};
