/* SPDX-License-Identifier: Apache-2.0 */
#include "describe.h"

#include <stdio.h>
#include "json.h"

static const char *buffer_name(uint32_t kind) {
  static const char *const names[] = {"", "table", "image", "mesh", "points"};
  return kind < sizeof names / sizeof names[0] ? names[kind] : "unknown";
}

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
  case SOZAI_KIND_INT:
    json_number(j, "default", p->default_number[0]);
    break;
  case SOZAI_KIND_BOOL:
    json_bool(j, "default", p->default_number[0] != 0);
    break;
  case SOZAI_KIND_CHOICE: {
    double index = p->default_number[0];
    if (index >= 0 && index < p->choice_count)
      json_text(j, "default", p->choices[(uint32_t)index]);
    else
      json_null(j, "default");
    break;
  }
  case SOZAI_KIND_FLOAT3:
  case SOZAI_KIND_COLOUR:
    json_triple(j, "default", p->default_number);
    break;
  case SOZAI_KIND_TEXT:
  case SOZAI_KIND_PATH:
  case SOZAI_KIND_IMAGE:
    json_text(j, "default", p->default_text);
    break;
  default:
    json_null(j, "default");
  }
}

static void json_parameter(json *j, const sozai_parameter *p) {
  json_open(j, NULL, '{');
  json_text(j, "id", p->id);
  json_text(j, "label", p->label);
  json_text(j, "group", p->group);
  json_text(j, "kind", describe_kind(p->kind));
  json_text(j, "unit", p->unit);
  json_text(j, "doc", p->doc);
  json_default(j, p);
  if (describe_has_range(p->kind)) {
    json_range(j, "hard_range", p->hard_min, p->hard_max);
    json_range(j, "soft_range", p->soft_min, p->soft_max);
  }
  if (p->kind == SOZAI_KIND_COLOUR) json_text(j, "colour_space", p->default_text);
  if (p->kind == SOZAI_KIND_BUFFER) json_text(j, "buffer_kind", buffer_name(p->buffer_kind));
  if (p->kind == SOZAI_KIND_IMAGE) json_number(j, "image_channels", p->default_number[0]);
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
  case SOZAI_KIND_INT:
    json_number(j, v->id, v->number[0]);
    break;
  case SOZAI_KIND_BOOL:
    json_bool(j, v->id, v->number[0] != 0);
    break;
  case SOZAI_KIND_FLOAT3:
    json_triple(j, v->id, v->number);
    break;
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
  case SOZAI_KIND_BUFFER:
    json_null(j, v->id);
    break;
  default:
    json_text(j, v->id, v->text);
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
  for (size_t i = 0; i < DESCRIBE_INPUTS; i++)
    if (inputs >> i & 1) json_text(j, NULL, describe_inputs[i]);
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

void describe_json(const sozai_texture_info *info) {
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
