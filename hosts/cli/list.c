/* SPDX-License-Identifier: Apache-2.0 */
#include "commands.h"

#include <stdio.h>
#include <stdlib.h>
#include "json.h"
#include "options.h"
#include "output_file.h"
#include "plugin.h"

/* grown: a texture may have the same name. */
static void print_presets(const char *id, const char *label, const sozai_preset *const *presets,
                          uint32_t count, bool grown) {
  printf("%s  %s", id, label);
  if (grown) printf("  (grown: sozai grow %s)", id);
  putchar('\n');
  for (uint32_t k = 0; k < count; k++) printf("  %-24s %s\n", presets[k]->id, presets[k]->label);
}

static void print_text(const sozai_textures_1 *textures, const sozai_geometry_1 *geometry) {
  for (uint32_t i = 0; i < textures->count(); i++) {
    const sozai_texture_info *info = textures->info(i);
    print_presets(info->id, info->label, info->presets, info->preset_count, false);
  }
  for (uint32_t i = 0; geometry && i < geometry->count(); i++) {
    const sozai_generator_info *info = geometry->info(i);
    print_presets(info->id, info->label, info->presets, info->preset_count, true);
  }
}

static void json_presets(json *j, const char *id, const char *label,
                         const sozai_preset *const *presets, uint32_t count, bool grown) {
  json_open(j, NULL, '{');
  json_text(j, "id", id);
  json_text(j, "label", label);
  json_bool(j, "grown", grown);
  json_open(j, "presets", '[');
  for (uint32_t k = 0; k < count; k++) {
    json_open(j, NULL, '{');
    json_text(j, "id", presets[k]->id);
    json_text(j, "label", presets[k]->label);
    json_close(j, '}');
  }
  json_close(j, ']');
  json_close(j, '}');
}

static void print_json(const sozai_textures_1 *textures, const sozai_geometry_1 *geometry) {
  json j = {.to = stdout};
  json_open(&j, NULL, '[');
  for (uint32_t i = 0; i < textures->count(); i++) {
    const sozai_texture_info *info = textures->info(i);
    json_presets(&j, info->id, info->label, info->presets, info->preset_count, false);
  }
  for (uint32_t i = 0; geometry && i < geometry->count(); i++) {
    const sozai_generator_info *info = geometry->info(i);
    json_presets(&j, info->id, info->label, info->presets, info->preset_count, true);
  }
  json_close(&j, ']');
}

int run_list(int argc, char **argv) {
  bool as_json = false;
  const option options[] = {{"json", 0, OPTION_FLAG, &as_json, NULL, "as JSON", 0, 0}};
  const command_line line = {.usage = "list [--json]",
                             .about = "The materials there are, and their presets.\n",
                             .options = options,
                             .option_count = sizeof options / sizeof options[0]};
  failure why = {0};
  int parsed = options_parse(&line, argc, argv, NULL, &why);
  if (parsed == OPTIONS_DONE) return 0;
  plugin p;
  if (parsed == OPTIONS_BAD || !plugin_open(&p, &why)) return report(&why);
  const sozai_geometry_1 *geometry = p.geometry;
  if (as_json)
    print_json(p.textures, geometry);
  else
    print_text(p.textures, geometry);
  plugin_close(&p);
  return output_printed(&why) ? 0 : report(&why);
}
