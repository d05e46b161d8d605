/* SPDX-License-Identifier: Apache-2.0 */
#include "commands.h"

#include <stdio.h>
#include <stdlib.h>
#include "json.h"
#include "options.h"
#include "plugin.h"

static void print_text(const sozai_textures_1 *textures) {
  for (uint32_t i = 0; i < textures->count(); i++) {
    const sozai_texture_info *info = textures->info(i);
    printf("%s  %s\n", info->id, info->label);
    for (uint32_t k = 0; k < info->preset_count; k++)
      printf("  %-24s %s\n", info->presets[k]->id, info->presets[k]->label);
  }
}

static void print_json(const sozai_textures_1 *textures) {
  json j = {.to = stdout};
  json_open(&j, NULL, '[');
  for (uint32_t i = 0; i < textures->count(); i++) {
    const sozai_texture_info *info = textures->info(i);
    json_open(&j, NULL, '{');
    json_text(&j, "id", info->id);
    json_text(&j, "label", info->label);
    json_open(&j, "presets", '[');
    for (uint32_t k = 0; k < info->preset_count; k++) {
      json_open(&j, NULL, '{');
      json_text(&j, "id", info->presets[k]->id);
      json_text(&j, "label", info->presets[k]->label);
      json_close(&j, '}');
    }
    json_close(&j, ']');
    json_close(&j, '}');
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
  if (as_json)
    print_json(p.textures);
  else
    print_text(p.textures);
  plugin_close(&p);
  if (fflush(stdout) == 0 && !ferror(stdout)) return 0;
  fail(&why, EXIT_FAILURE, "cannot write standard output");
  return report(&why);
}
