/* SPDX-License-Identifier: Apache-2.0
 *
 * Which colour config is in force, what it offers, and whether it has what the
 * materials ask of it. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "colour_report.h"
#include "output_file.h"
#include "commands.h"

static const char *why_chosen(const session *s, const session_options *o) {
  if (!s->colour.service) return "there is no colour service beside the plugin";
  if (o->config) return "given with --config";
  const char *environment = getenv("OCIO");
  return environment && *environment ? "$OCIO" : "shipped with sozai";
}

static bool ask_materials(colour_report *r, const session *s, failure *why) {
  const sozai_textures_1 *textures = s->plugin.textures;
  r->uses = calloc(textures->count() + 1, sizeof *r->uses);
  if (!r->uses) return fail(why, EXIT_FAILURE, "out of memory");
  bool ok = true;
  for (uint32_t i = 0; ok && i < textures->count(); i++) {
    colour_use *u = &r->uses[r->use_count++];
    u->what = textures->info(i)->id;
    ok = spaces_of_texture(&u->spaces, textures->info(i), r->colour, why);
  }
  return ok;
}

/* Unlike create(), which stops at the first space that is missing. */
static bool check_names(const recipe *q, const sozai_texture_info *info, failure *why) {
  uint32_t i = 0;
  while (q->preset && i < info->preset_count && strcmp(info->presets[i]->id, q->preset) != 0) i++;
  if (q->preset && i == info->preset_count)
    return fail(why, EXIT_BAD_INPUT, "%s has no preset '%.80s'; see sozai list", info->id,
                q->preset);
  for (size_t k = 0; k < q->param_count; k++) {
    i = 0;
    while (i < info->parameter_count && strcmp(info->parameters[i]->id, q->params[k].id) != 0) i++;
    if (i == info->parameter_count)
      return fail(why, EXIT_BAD_INPUT, "%s has no parameter '%.80s'; see sozai describe %s",
                  info->id, q->params[k].id, info->id);
  }
  return true;
}

static bool ask_recipe(colour_report *r, const session *s, const session_options *o,
                       const char *name, failure *why) {
  recipe q;
  r->uses = calloc(1, sizeof *r->uses);
  if (!r->uses) return fail(why, EXIT_FAILURE, "out of memory");
  if (!session_recipe(&q, name, o, why)) return false;
  const sozai_texture_info *info = recipe_info(&q, s->plugin.textures, s->plugin.geometry, why);
  r->uses[0].what = name;
  r->use_count = 1;
  bool ok = info && check_names(&q, info, why) &&
            spaces_of_recipe(&r->uses[0].spaces, &q, info, r->colour, why);
  recipe_free(&q);
  return ok;
}

static bool print_report(const char *name, const session_options *o, bool as_json, failure *why) {
  session s;
  if (!session_open(&s, o, why)) return false;
  const sozai_colour_1 *service = s.colour.service;
  colour_report r = {.colour = &s.colour, .chosen = why_chosen(&s, o)};
  r.config = service ? service->config_name(service->self) : "none: the sRGB formula";
  r.has_chromaticities = display_working(&s.colour, &r.working, r.xy);
  bool ok = name ? ask_recipe(&r, &s, o, name, why) : ask_materials(&r, &s, why);
  if (ok) (as_json ? colour_print_json : colour_print_text)(&r);
  for (size_t i = 0; i < r.use_count; i++) spaces_free(&r.uses[i].spaces);
  free(r.uses);
  session_close(&s);
  return ok && output_printed(why);
}

int run_colour(int argc, char **argv) {
  failure why = {0};
  session_options shared;
  if (!session_options_init(&shared, argc, &why)) return report(&why);
  bool as_json = false;
  const option options[] = {{"json", 0, OPTION_FLAG, &as_json, NULL, "as JSON", 0, 0},
                            SESSION_TEXTURE_OPTIONS(shared),
                            {"config", 0, OPTION_TEXT, &shared.config, "FILE",
                             "OpenColorIO config (default: $OCIO, else the shipped one)", 0, 0}};
  static const char *const positional[] = {"material or .sozai file"};
  const command_line line = {
      .usage = "colour [material|file.sozai] [--config FILE] [--json]",
      .about = "The colour config in force, what it offers, and the spaces that the materials'\n"
               "defaults and presets name in it; of one material or file, the spaces that its\n"
               "values name.\n",
      .options = options,
      .option_count = sizeof options / sizeof options[0],
      .positional = positional,
      .positional_count = 1,
      .optional_count = 1};
  const char *name = NULL;
  int parsed = options_parse(&line, argc, argv, &name, &why);
  if (parsed == OPTIONS_RUN && !name && (shared.preset || shared.params.count)) {
    fail(&why, EXIT_BAD_INPUT, "colour: --preset and --param need a material or .sozai file");
    parsed = OPTIONS_BAD;
  }
  int code = 0;
  if (parsed == OPTIONS_BAD ||
      (parsed == OPTIONS_RUN && !print_report(name, &shared, as_json, &why)))
    code = report(&why);
  session_options_free(&shared);
  return code;
}
