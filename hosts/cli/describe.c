/* SPDX-License-Identifier: Apache-2.0 */
#include "describe.h"

#include <stdio.h>
#include <stdlib.h>
#include "commands.h"
#include "options.h"
#include "plugin.h"
#include "recipe.h"

const char *const describe_inputs[DESCRIBE_INPUTS] = {"point",        "normal", "light",
                                                      "light_colour", "view",   "footprint"};

const char *describe_kind(uint32_t kind) {
  static const char *const names[] = {"string", "float", "int",  "bool",   "choice", "float3",
                                      "colour", "text",  "path", "buffer", "image"};
  return kind < sizeof names / sizeof names[0] ? names[kind] : "unknown";
}

bool describe_has_range(uint32_t kind) {
  return kind == SOZAI_KIND_FLOAT || kind == SOZAI_KIND_INT || kind == SOZAI_KIND_FLOAT3 ||
         kind == SOZAI_KIND_COLOUR;
}

int run_describe(int argc, char **argv) {
  bool as_json = false;
  const option options[] = {{"json", 0, OPTION_FLAG, &as_json, NULL, "as JSON", 0, 0}};
  static const char *const positional[] = {"material"};
  const command_line line = {.usage = "describe <material> [--json]",
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
    if (info && as_json) describe_json(info);
    if (info && !as_json) describe_text(info);
    recipe_free(&r);
  }
  plugin_close(&p);
  if (!info) return report(&why);
  if (fflush(stdout) == 0 && !ferror(stdout)) return 0;
  fail(&why, EXIT_FAILURE, "cannot write standard output");
  return report(&why);
}
