/* SPDX-License-Identifier: Apache-2.0
 *
 * sozai saw: a log of a grown tree into boards. */
#include "saw.h"

#include <stdlib.h>
#include <string.h>
#include "cancel.h"
#include "commands.h"
#include "json.h"
#include "progress.h"
#include "ceilings.h"

/* What each board's recipe says for itself, or the log's options do. */
static const char *const own[] = {
    "cut",        "cut_distance", "cut_height", "cut_rotation", "cut_offset", "veneer_thickness",
    "cut_tilt",   "cut_skew",     "layout",     "tree",         "tree_age",   "tree_field",
    "log_height", "knot_size",    "seed",       "knots",        "knot_radii", "stem_rings"};

static bool find_plan(const char *name, int *out, failure *why) {
  for (int i = 0; i < SAW_PLANS; i++) {
    if (strcmp(name, saw_plan_names[i]) != 0) continue;
    *out = i;
    return true;
  }
  return fail(why, EXIT_BAD_INPUT,
              "--plan: there is no plan '%.80s'; there is live, quarter, rift, rotary", name);
}

/* Before any work is done. */
static bool check(saw_work *w, const session_options *shared, failure *why) {
  const saw_options *o = &w->options;
  if (!o->species && !o->field)
    return fail(why, EXIT_BAD_INPUT, "saw: no tree is given: --species NAME or --field FILE");
  if (!o->output) return fail(why, EXIT_BAD_INPUT, "saw: no folder is given: -o DIR");
  for (size_t i = 0; i < shared->params.count; i++)
    for (size_t k = 0; k < sizeof own / sizeof own[0]; k++) {
      size_t length = strlen(own[k]);
      const char *pair = shared->params.items[i];
      if (strncmp(pair, own[k], length) == 0 && pair[length] == '=')
        return fail(why, EXIT_BAD_INPUT, "-p %s: the plan says that itself; see sozai saw --help",
                    own[k]);
    }
  if (!find_plan(o->plan, &w->job.plan, why)) return false;
  bool rotary = w->job.plan == SAW_ROTARY;
  w->job.thickness = o->thickness > 0 ? o->thickness : rotary ? 2 : 27;
  if (rotary && o->kerf >= 0)
    return fail(why, EXIT_BAD_INPUT, "--kerf: a knife takes nothing; not for --plan rotary");
  w->job.kerf = rotary ? 0 : o->kerf >= 0 ? o->kerf : 3;
  w->job.width = o->width;
  w->job.azimuth = o->azimuth;
  return true;
}

/* ---- the wood -------------------------------------------------------------- */

static bool choose_wood(const saw_work *w, recipe *r, failure *why) {
  const saw_options *o = &w->options;
  if (o->wood) return recipe_set_preset(r, o->wood, why);
  if (!o->species)
    return fail(why, EXIT_BAD_INPUT,
                "--wood: a field table does not say of what wood it is; name one of `sozai list`: "
                "--wood PRESET, or --species NAME");
  const sozai_texture_info *info = w->session->plugin.textures->find("wood");
  for (uint32_t i = 0; info && i < info->preset_count; i++)
    if (strcmp(info->presets[i]->id, o->species) == 0) return recipe_set_preset(r, o->species, why);
  return fail(why, EXIT_BAD_INPUT,
              "--wood: wood has no preset '%.80s'; name one of `sozai list`: --wood PRESET",
              o->species);
}

static bool set_number(recipe *r, const char *id, double number, failure *why) {
  char text[40];
  number_text(text, sizeof text, number);
  return recipe_set(r, id, text, 0, why);
}

static bool make_recipe(const saw_work *w, recipe *r, const option_texts *params, failure *why) {
  const saw_options *o = &w->options;
  return choose_wood(w, r, why) && session_params_here(r, params, why) &&
         (!o->species || recipe_set(r, "tree", o->species, 0, why)) &&
         (!w->field || recipe_set(r, "tree_field", w->field, 0, why)) &&
         set_number(r, "tree_age", o->age, why) && set_number(r, "seed", o->seed, why) &&
         set_number(r, "log_height", o->log_height, why) &&
         set_number(r, "knot_size", o->knot_size, why);
}

/* ---- the tree --------------------------------------------------------------- */

static bool measure_log(saw_work *w, failure *why) {
  const saw_options *o = &w->options;
  w->log = (saw_log){
      .stem = &w->stem, .base = o->log_height, .length = o->log_length, .knot_size = o->knot_size};
  double top = o->log_height + o->log_length, age = w->stem.age;
  w->lower = saw_stem_radius(&w->stem, o->log_height, age);
  w->job.radius = saw_stem_radius(&w->stem, top, age);
  double tall = saw_stem_height(&w->stem);
  if (top >= tall)
    return fail(
        why, EXIT_BAD_INPUT,
        "--log-length: the log ends %.9g mm above the ground, and the tree, %.9g years old, "
        "is %.0f mm high",
        top, o->age, tall);
  if (w->job.radius < 20)
    return fail(why, EXIT_BAD_INPUT,
                "--log-length: the log's upper end, %.9g mm above the ground, has a radius of %.1f "
                "mm; at least 20 mm",
                top, w->job.radius);
  return true;
}

static bool make_plan(saw_work *w, failure *why) {
  if (!measure_log(w, why) || !saw_plan_make(&w->plan, &w->job, why)) return false;
  w->yield = 100 * saw_area(&w->plan) * w->log.length / saw_log_volume(&w->log);
  return true;
}

static bool saw_into(saw_work *w, failure *why) {
  saw_folder f;
  if (!saw_folder_begin(&f, w->options.output, why)) return false;
  bool ok = true;
  for (size_t i = 0; ok && i < w->plan.count; i++) {
    ok = saw_measure_knots(w, i, why);
    progress_show(0.5f * (float)(i + 1) / (float)w->plan.count, "sawing");
  }
  ok = ok && saw_write_files(w, &f, why) && saw_write_picture(w, &f, why);
  if (ok && cancel_requested()) ok = fail(why, EXIT_FAILURE, "cancelled");
  progress_clear();
  if (ok) return saw_folder_commit(&f, why);
  failure_rename(why, f.working, f.path);
  saw_folder_discard(&f);
  return false;
}

/* Knots stand about the pith, which wanders. */
static void find_pith(saw_work *w) {
  const sozai_wood_1 *woods = w->session->plugin.entry->get_factory(SOZAI_WOOD_1);
  float y[SAW_PITH];
  for (int i = 0; i < SAW_PITH; i++) y[i] = (float)(w->log.length * i / (SAW_PITH - 1));
  if (woods) woods->pith(w->texture, SAW_PITH, y, w->log.pith[0], w->log.pith[1]);
}

static bool saw_log_up(saw_work *w, recipe *r, failure *why) {
  const sozai_textures_1 *textures = w->session->plugin.textures;
  sozai_texture *texture = NULL;
  w->wood = r;
  if (!recipe_create(r, textures, &w->session->host.abi, &texture, why)) return false;
  w->texture = texture;
  find_pith(w);
  bool ok = recipe_is_text(r, why) && saw_into(w, why);
  textures->destroy(texture);
  return ok;
}

static bool grow_and_saw(saw_work *w, const session_options *shared, failure *why) {
  const saw_options *o = &w->options;
  const sozai_geometry_1 *table = growth_table(w->session->plugin.entry, why);
  if (!table) return false;
  char age[64], seed[64];
  snprintf(age, sizeof age, "age=%.17g", o->age);
  snprintf(seed, sizeof seed, "seed=%u", o->seed);
  const char *const pairs[] = {age, seed, "orders=1"};
  sozai_geometry *g = NULL;
  recipe r;
  if (!growth_grow(table, &w->session->host.abi, "tree", o->species, pairs, 3, w->field, &g, why))
    return growth_name_field(o->field, why);
  bool ok = recipe_open(&r, "wood", why);
  if (ok) {
    ok = saw_stem_read(&w->stem, table, g, why) && make_recipe(w, &r, &shared->params, why) &&
         make_plan(w, why) && saw_log_up(w, &r, why);
    recipe_free(&r);
  }
  table->release(g);
  return ok;
}

static bool saw(saw_work *w, const session_options *shared, failure *why) {
  session s;
  const char *field = w->options.field;
  if (!check(w, shared, why) || (field && !growth_read_text(field, &w->field, why))) return false;
  if (field && !*w->field)
    return fail(why, EXIT_BAD_INPUT, "--field: '%s' is empty: there is no trunk", field);
  if (!session_open(&s, shared, why)) return false;
  w->session = &s;
  bool ok = grow_and_saw(w, shared, why);
  session_close(&s);
  if (ok)
    fprintf(stderr, "sozai: %zu %s%s, %.1f %% of the log\n", w->plan.count,
            w->job.plan == SAW_ROTARY ? "sheet" : "board", w->plan.count == 1 ? "" : "s", w->yield);
  return ok;
}

int run_saw(int argc, char **argv) {
  failure why = {0};
  session_options shared;
  saw_work *w = calloc(1, sizeof *w);
  if (!w) return fail(&why, EXIT_FAILURE, "out of memory"), report(&why);
  if (!session_options_init(&shared, argc, &why)) {
    free(w);
    return report(&why);
  }
  saw_options *o = &w->options;
  *o = (saw_options){.plan = "live",
                     .age = 45,
                     .log_height = 3000,
                     .log_length = 2400,
                     .kerf = -1,
                     .knot_size = 1,
                     .seed = 1,
                     .size = {1760, 960}};
  const option options[] = {
      {"output", 'o', OPTION_TEXT, &o->output, "DIR",
       "folder for log.png, saw.json and board-01.sozai, ...", 0, 0},
      {"species", 0, OPTION_TEXT, &o->species, "NAME", "a tree: a preset of describe tree", 0, 0},
      {"preset", 0, OPTION_TEXT, &o->species, "NAME", "the same as --species", 0, 0},
      {"field", 0, OPTION_TEXT, &o->field, "FILE",
       "a measured tree's field table (docs/tree.md), with --species of that species", 0, 0},
      {"age", 0, OPTION_NUMBER, &o->age, "YEARS", "of the tree when felled (default: 45)", 1, 300},
      {"seed", 0, OPTION_COUNT, &o->seed, "N", "which tree (default: 1)", 0, 4294967295.0},
      {"wood", 0, OPTION_TEXT, &o->wood, "PRESET", "of wood (default: the tree's own)", 0, 0},
      {"log-height", 0, OPTION_NUMBER, &o->log_height, "MM",
       "of the log's lower end above the ground (default: 3000)", 0, 100000},
      {"log-length", 0, OPTION_NUMBER, &o->log_length, "MM", "(default: 2400)", 50, 20000},
      {"plan", 0, OPTION_TEXT, &o->plan, "PLAN", "live (default), quarter, rift or rotary", 0, 0},
      {"thickness", 0, OPTION_NUMBER, &o->thickness, "MM",
       "of the boards (default: 27; of veneer, 2)", 0.1, 1000},
      {"width", 0, OPTION_NUMBER, &o->width, "MM", "of the boards at most (default: the log's)", 5,
       1e6},
      {"kerf", 0, OPTION_NUMBER, &o->kerf, "MM", "what a cut takes (default: 3)", 0, 100},
      {"azimuth", 0, OPTION_NUMBER, &o->azimuth, "DEG", "turns the log on the saw (default: 0)",
       -36000, 36000},
      {"knot-size", 0, OPTION_NUMBER, &o->knot_size, "X", "factor of the knots' radii (default: 1)",
       0.1, 3},
      {"param", 'p', OPTION_PAIRS, &shared.params, "NAME=VALUE",
       "set a parameter of wood; any number of these", 0, 0},
      {"res", 0, OPTION_SIZE, o->size, "WxH", "pixels of log.png (default: 1760x960)", 320,
       VIEW_MOST_SIDE},
      SESSION_DISPLAY_OPTIONS(shared),
      SESSION_RUN_OPTIONS(shared)};
  const command_line line = {.usage = "saw --species NAME|--field FILE -o DIR [options]",
                             .about =
                                 "Saws a log of a grown tree into boards, each a .sozai file, and "
                                 "draws the log with\nits cuts and the boards' faces.\n",
                             .options = options,
                             .option_count = sizeof options / sizeof options[0]};
  int parsed = options_parse(&line, argc, argv, NULL, &why), code = 0;
  if (parsed == OPTIONS_BAD || (parsed == OPTIONS_RUN && !saw(w, &shared, &why)))
    code = report(&why);
  session_options_free(&shared);
  free(w->field);
  free(w);
  return code;
}
