/* SPDX-License-Identifier: Apache-2.0 */
#include "describe.h"

#include <stdio.h>
#include <stdlib.h>
#include "commands.h"
#include "options.h"
#include "output_file.h"
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

/* What a generator has in common with a texture: all but channels. */
static sozai_texture_info as_texture(const sozai_generator_info *g) {
  return (sozai_texture_info){.size = sizeof(sozai_texture_info),
                              .revision = g->revision,
                              .id = g->id,
                              .label = g->label,
                              .doc = g->doc,
                              .parameters = g->parameters,
                              .presets = g->presets,
                              .parameter_count = g->parameter_count,
                              .preset_count = g->preset_count};
}

static void print_tables(const sozai_generator_info *g) {
  puts("\ntables");
  for (uint32_t i = 0; i < g->table_count; i++) {
    const sozai_table_info *t = g->tables[i];
    printf("  %s: %s\n", t->id, t->doc);
    for (uint32_t k = 0; k < t->column_count; k++)
      printf("    %-18s %-8s %s\n", t->columns[k].id, t->columns[k].unit, t->columns[k].doc);
  }
}

int run_describe(int argc, char **argv) {
  bool as_json = false, as_grown = false;
  const option options[] = {{"json", 0, OPTION_FLAG, &as_json, NULL, "as JSON", 0, 0},
                            {"grown", 0, OPTION_FLAG, &as_grown, NULL,
                             "what `sozai grow` makes, where a texture has the same name", 0, 0}};
  static const char *const positional[] = {"material"};
  const command_line line = {.usage = "describe <material> [--json] [--grown]",
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
  const sozai_geometry_1 *geometry = p.geometry;
  const sozai_generator_info *grown = geometry ? geometry->find(name) : NULL;
  if (!as_grown && p.textures->find(name)) grown = NULL;
  if (as_grown && !grown)
    fail(&why, EXIT_BAD_INPUT, "unknown thing to grow '%s': sozai list names them", name);
  if (grown) {
    const sozai_texture_info shared = as_texture(grown);
    if (as_json)
      describe_json(&shared);
    else {
      describe_text(&shared);
      print_tables(grown);
    }
  }
  if (!grown && !as_grown && recipe_open(&r, name, &why)) {
    info = recipe_info(&r, p.textures, p.geometry, &why);
    if (info && as_json) describe_json(info);
    if (info && !as_json) describe_text(info);
    recipe_free(&r);
  }
  plugin_close(&p);
  if (!info && !grown) return report(&why);
  return output_printed(&why) ? 0 : report(&why);
}
