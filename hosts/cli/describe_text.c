/* SPDX-License-Identifier: Apache-2.0 */
#include "describe.h"

#include <stdio.h>
#include <string.h>
#include "json.h"

static bool is_triple(uint32_t kind) {
  return kind == SOZAI_KIND_FLOAT3 || kind == SOZAI_KIND_COLOUR;
}

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
  case SOZAI_KIND_BOOL:
    fputs(p->default_number[0] != 0 ? "true" : "false", stdout);
    break;
  case SOZAI_KIND_CHOICE:
    if (p->default_number[0] >= 0 && p->default_number[0] < p->choice_count)
      fputs(p->choices[(uint32_t)p->default_number[0]], stdout);
    break;
  case SOZAI_KIND_TEXT:
  case SOZAI_KIND_PATH:
  case SOZAI_KIND_IMAGE:
    printf("\"%s\"", p->default_text ? p->default_text : "");
    break;
  case SOZAI_KIND_BUFFER:
    fputs("none", stdout);
    break;
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
  printf("   %s", describe_kind(p->kind));
  if (describe_has_range(p->kind)) {
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
  for (size_t i = 0; i < DESCRIBE_INPUTS; i++)
    if (inputs >> i & 1) printf(" %s", describe_inputs[i]);
}

static void print_channel(const sozai_channel *c) {
  printf("  %s", c->id);
  if (c->components > 1) printf(" (%s)", c->suffixes);
  if (*c->unit) printf(" [%s]", c->unit);
  print_inputs("needs", c->needs);
  print_inputs("uses", c->uses);
  printf("\n      %s\n", c->doc);
}

void describe_text(const sozai_texture_info *info) {
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
