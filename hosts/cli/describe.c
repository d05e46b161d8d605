/* SPDX-License-Identifier: Apache-2.0 */
#include "commands.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "json.h"
#include "options.h"
#include "plugin.h"
#include "recipe.h"

static const char *const input_names[] = {"point",        "normal", "light",
                                          "light_colour", "view",   "footprint"};
#define INPUT_COUNT (sizeof input_names / sizeof input_names[0])

static const char *kind_name(uint32_t kind) {
  static const char *const names[] = {"string", "float",  "int",  "bool", "choice",
                                      "float3", "colour", "text", "path", "buffer"};
  return kind < sizeof names / sizeof names[0] ? names[kind] : "unknown";
}

static const char *buffer_name(uint32_t kind) {
  static const char *const names[] = {"", "table", "image", "mesh", "points"};
  return kind < sizeof names / sizeof names[0] ? names[kind] : "unknown";
}

/* Whether values of this kind are numbers with a range. */
static bool has_range(uint32_t kind) {
  return kind == SOZAI_KIND_FLOAT || kind == SOZAI_KIND_INT || kind == SOZAI_KIND_FLOAT3 ||
         kind == SOZAI_KIND_COLOUR;
}

static bool is_triple(uint32_t kind) {
  return kind == SOZAI_KIND_FLOAT3 || kind == SOZAI_KIND_COLOUR;
}

/* ---- JSON ------------------------------------------------------------- */

static void json_triple(json *j, const char *key, const double *number) {
  json_open(j, key, '[');
  for (int k = 0; k < 3; k++) json_number(j, NULL, number[k]);
  json_close(j, ']');
}

static void json_range(json *j, const char *key, double low, double high) {
  json_open(j, key, '[');
  json_number(j, NULL, low);
  json_number(j, NULL, high);
  json_close(j, ']');
}

static void json_default(json *j, const sozai_parameter *p) {
  switch (p->kind) {
  case SOZAI_KIND_FLOAT:
  case SOZAI_KIND_INT: json_number(j, "default", p->default_number[0]); break;
  case SOZAI_KIND_BOOL: json_bool(j, "default", p->default_number[0] != 0); break;
  case SOZAI_KIND_CHOICE: {
    double index = p->default_number[0];
    if (index >= 0 && index < p->choice_count)
      json_text(j, "default", p->choices[(uint32_t)index]);
    else
      json_null(j, "default");
    break;
  }
  case SOZAI_KIND_FLOAT3:
  case SOZAI_KIND_COLOUR: json_triple(j, "default", p->default_number); break;
  case SOZAI_KIND_TEXT:
  case SOZAI_KIND_PATH: json_text(j, "default", p->default_text); break;
  default: json_null(j, "default");
  }
}

static void json_parameter(json *j, const sozai_parameter *p) {
  json_open(j, NULL, '{');
  json_text(j, "id", p->id);
  json_text(j, "label", p->label);
  json_text(j, "group", p->group);
  json_text(j, "kind", kind_name(p->kind));
  json_text(j, "unit", p->unit);
  json_text(j, "doc", p->doc);
  json_default(j, p);
  if (has_range(p->kind)) {
    json_range(j, "hard_range", p->hard_min, p->hard_max);
    json_range(j, "soft_range", p->soft_min, p->soft_max);
  }
  if (p->kind == SOZAI_KIND_COLOUR) json_text(j, "colour_space", p->default_text);
  if (p->kind == SOZAI_KIND_BUFFER) json_text(j, "buffer_kind", buffer_name(p->buffer_kind));
  if (p->kind == SOZAI_KIND_CHOICE) {
    json_open(j, "choices", '[');
    for (uint32_t i = 0; i < p->choice_count; i++) {
      json_open(j, NULL, '{');
      json_text(j, "id", p->choices[i]);
      json_text(j, "doc", p->choice_docs ? p->choice_docs[i] : "");
      json_close(j, '}');
    }
    json_close(j, ']');
  }
  json_close(j, '}');
}

static void json_value(json *j, const sozai_value *v) {
  switch (v->kind) {
  case SOZAI_KIND_FLOAT:
  case SOZAI_KIND_INT: json_number(j, v->id, v->number[0]); break;
  case SOZAI_KIND_BOOL: json_bool(j, v->id, v->number[0] != 0); break;
  case SOZAI_KIND_FLOAT3: json_triple(j, v->id, v->number); break;
  case SOZAI_KIND_COLOUR:
    if (!v->text) {
      json_triple(j, v->id, v->number);
      break;
    }
    json_open(j, v->id, '{');
    json_triple(j, "rgb", v->number);
    json_text(j, "colour_space", v->text);
    json_close(j, '}');
    break;
  case SOZAI_KIND_BUFFER: json_null(j, v->id); break;
  default: json_text(j, v->id, v->text);
  }
}

static void json_preset(json *j, const sozai_preset *p) {
  json_open(j, NULL, '{');
  json_text(j, "id", p->id);
  json_text(j, "label", p->label);
  json_text(j, "doc", p->doc);
  json_text(j, "source", p->source);
  json_open(j, "values", '{');
  for (uint32_t i = 0; i < p->value_count; i++) json_value(j, &p->values[i]);
  json_close(j, '}');
  json_close(j, '}');
}

static void json_inputs(json *j, const char *key, uint32_t inputs) {
  json_open(j, key, '[');
  for (size_t i = 0; i < INPUT_COUNT; i++)
    if (inputs >> i & 1) json_text(j, NULL, input_names[i]);
  json_close(j, ']');
}

static void json_channel(json *j, const sozai_channel *c) {
  json_open(j, NULL, '{');
  json_text(j, "id", c->id);
  json_text(j, "unit", c->unit);
  json_text(j, "doc", c->doc);
  json_number(j, "first", c->first);
  json_number(j, "components", c->components);
  json_text(j, "suffixes", c->suffixes);
  json_inputs(j, "needs", c->needs);
  json_inputs(j, "uses", c->uses);
  json_close(j, '}');
}

static void print_json(const sozai_texture_info *info) {
  json j = {.to = stdout};
  json_open(&j, NULL, '{');
  json_text(&j, "id", info->id);
  json_text(&j, "label", info->label);
  json_text(&j, "doc", info->doc);
  json_number(&j, "revision", info->revision);
  json_open(&j, "parameters", '[');
  for (uint32_t i = 0; i < info->parameter_count; i++) json_parameter(&j, info->parameters[i]);
  json_close(&j, ']');
  json_open(&j, "presets", '[');
  for (uint32_t i = 0; i < info->preset_count; i++) json_preset(&j, info->presets[i]);
  json_close(&j, ']');
  json_open(&j, "channels", '[');
  for (uint32_t i = 0; i < info->channel_count; i++) json_channel(&j, info->channels[i]);
  json_close(&j, ']');
  json_close(&j, '}');
}

/* ---- text ------------------------------------------------------------- */

static void print_number(double number) {
  char text[40];
  number_text(text, sizeof text, number);
  fputs(text, stdout);
}

static void print_triple(const double *number) {
  for (int k = 0; k < 3; k++) {
    if (k) putchar(' ');
    print_number(number[k]);
  }
}

static void print_default(const sozai_parameter *p) {
  switch (p->kind) {
  case SOZAI_KIND_BOOL: fputs(p->default_number[0] != 0 ? "true" : "false", stdout); break;
  case SOZAI_KIND_CHOICE:
    if (p->default_number[0] >= 0 && p->default_number[0] < p->choice_count)
      fputs(p->choices[(uint32_t)p->default_number[0]], stdout);
    break;
  case SOZAI_KIND_TEXT:
  case SOZAI_KIND_PATH: printf("\"%s\"", p->default_text ? p->default_text : ""); break;
  case SOZAI_KIND_BUFFER: fputs("none", stdout); break;
  default:
    if (is_triple(p->kind))
      print_triple(p->default_number);
    else
      print_number(p->default_number[0]);
  }
  if (p->kind == SOZAI_KIND_COLOUR && p->default_text) printf(" @ %s", p->default_text);
}

static void print_parameter(const sozai_parameter *p) {
  printf("  %s = ", p->id);
  print_default(p);
  if (*p->unit) printf(" %s", p->unit);
  printf("   %s", kind_name(p->kind));
  if (has_range(p->kind)) {
    fputs(" from ", stdout);
    print_number(p->hard_min);
    fputs(" to ", stdout);
    print_number(p->hard_max);
    if (p->soft_min != p->hard_min || p->soft_max != p->hard_max) {
      fputs(", usually ", stdout);
      print_number(p->soft_min);
      fputs(" to ", stdout);
      print_number(p->soft_max);
    }
  }
  printf("\n      %s\n", p->doc);
  for (uint32_t i = 0; p->kind == SOZAI_KIND_CHOICE && i < p->choice_count; i++)
    printf("        %-14s %s\n", p->choices[i], p->choice_docs ? p->choice_docs[i] : "");
}

static void print_inputs(const char *label, uint32_t inputs) {
  if (!inputs) return;
  printf("; %s", label);
  for (size_t i = 0; i < INPUT_COUNT; i++)
    if (inputs >> i & 1) printf(" %s", input_names[i]);
}

static void print_channel(const sozai_channel *c) {
  printf("  %s", c->id);
  if (c->components > 1) printf(" (%s)", c->suffixes);
  if (*c->unit) printf(" [%s]", c->unit);
  print_inputs("needs", c->needs);
  print_inputs("uses", c->uses);
  printf("\n      %s\n", c->doc);
}

static void print_text(const sozai_texture_info *info) {
  printf("%s: %s\n%s\n", info->id, info->label, info->doc);
  const char *group = "";
  for (uint32_t i = 0; i < info->parameter_count; i++) {
    const sozai_parameter *p = info->parameters[i];
    if (i == 0 || strcmp(group, p->group) != 0) printf("\nparameters: %s\n", p->group);
    group = p->group;
    print_parameter(p);
  }
  puts("\npresets");
  for (uint32_t i = 0; i < info->preset_count; i++) {
    const sozai_preset *p = info->presets[i];
    printf("  %s: %s\n      %s\n      Source: %s\n", p->id, p->label, p->doc, p->source);
  }
  puts("\nchannels");
  for (uint32_t i = 0; i < info->channel_count; i++) print_channel(info->channels[i]);
}

int run_describe(int argc, char **argv) {
  bool as_json = false;
  const option options[] = {{"json", 0, OPTION_FLAG, &as_json, NULL, "as JSON", 0, 0}};
  static const char *const positional[] = {"material"};
  const command_line line = {
      .usage = "describe <material> [--json]",
      .about = "A material's parameters, presets and channels.\n",
      .options = options,
      .option_count = sizeof options / sizeof options[0],
      .positional = positional,
      .positional_count = 1};
  failure why = {0};
  const char *name = NULL;
  int parsed = options_parse(&line, argc, argv, &name, &why);
  if (parsed == OPTIONS_DONE) return 0;
  plugin p;
  if (parsed == OPTIONS_BAD || !plugin_open(&p, &why)) return report(&why);
  recipe r;
  const sozai_texture_info *info = NULL;
  if (recipe_open(&r, name, &why)) {
    info = recipe_info(&r, p.textures, &why);
    if (info && as_json) print_json(info);
    if (info && !as_json) print_text(info);
    recipe_free(&r);
  }
  plugin_close(&p);
  if (!info) return report(&why);
  if (fflush(stdout) == 0 && !ferror(stdout)) return 0;
  fail(&why, EXIT_FAILURE, "cannot write standard output");
  return report(&why);
}
