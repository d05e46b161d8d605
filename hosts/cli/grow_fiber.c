/* SPDX-License-Identifier: Apache-2.0
 *
 * sozai grow fiber: an aggregate of fibre in a hull, into a file. */
#include "grow_fiber.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "aggregate.h"
#include "curve_files.h"
#include "ending.h"
#include "fiber_view.h"
#include "grown.h"
#include "progress.h"
#include "session.h"
#include "ceilings.h"

typedef struct fiber_options {
  const char *hull, *material, *output, *table;
  double scale; /* 0: not said */
  mesh solid;   /* that `hull` names */
  uint32_t level;
  bool verbose;
  option_texts params;
  fiber_view view;
} fiber_options;

/* Before any work is done. */
static bool check(const fiber_options *o, failure *why) {
  static const char *const endings[] = {".usda", ".hair", ".obj", ".pbrt",
                                        ".gltf", ".csv",  ".png", ".exr"};
  if (!o->output) return fail(why, EXIT_BAD_INPUT, "grow: no output is given: -o FILE");
  if (!o->hull) return fail(why, EXIT_BAD_INPUT, "grow: no hull is given: --hull MESH");
  bool known = false;
  for (size_t i = 0; i < sizeof endings / sizeof *endings; i++)
    known = known || ends_in(o->output, endings[i]);
  if (!known)
    return fail(why, EXIT_BAD_INPUT,
                "--output: '%s' ends in none of .usda, .hair, .obj, .pbrt, .gltf, .csv, .png, .exr",
                o->output);
  return grown_check_table(o->output, o->table, why);
}

static bool write_mesh(const sozai_geometry_1 *table, const sozai_geometry *g,
                       const sozai_detail *detail, const char *path, failure *why) {
  const sozai_mesh *m = NULL;
  int32_t code = table->mesh(g, detail, &m);
  if (code != SOZAI_OK) return growth_failed(table, code, why);
  bool ok = write_gltf(m, path, why);
  table->release_mesh(m);
  return ok;
}

static bool write_out(const void *options, const sozai_geometry_1 *table, const sozai_geometry *g,
                      session *s, const char *path, failure *why) {
  const fiber_options *o = options;
  sozai_table rows;
  if (ends_in(o->output, ".csv"))
    return growth_rows(table, g, o->table, &rows, why) && write_csv(&rows, path, why);
  if (grown_is_picture(o->output)) return fiber_view_write(&o->view, table, g, s, path, why);
  const sozai_detail detail = {.size = sizeof detail, .level = o->level};
  if (ends_in(o->output, ".gltf")) return write_mesh(table, g, &detail, path, why);
  const sozai_curves *c = NULL;
  int32_t code = table->curves(g, &detail, &c);
  if (code != SOZAI_OK) return growth_failed(table, code, why);
  progress_show(1, "writing");
  bool ok = ends_in(o->output, ".usda")   ? curves_write_usda(c, path, why)
            : ends_in(o->output, ".hair") ? curves_write_hair(c, path, why)
            : ends_in(o->output, ".pbrt") ? curves_write_pbrt(c, path, why)
                                          : curves_write_obj(c, path, why);
  table->release_curves(c);
  return ok;
}

static void report_fiber(const sozai_geometry_1 *table, const sozai_geometry *g, double seconds) {
  failure ignored = {0};
  sozai_table t;
  if (!growth_rows(table, g, "statistics", &t, &ignored)) return;
  progress_clear();
  fprintf(
      stderr,
      "sozai: %.0f strands of %.0f vertices, %.2f %% of vertices and %.2f %% of strands inside, "
      "%.0f iterations, packing %.4f, %.0f of %.0f contacts left; %.3f s\n",
      growth_number(&t, 0, "strands"), growth_number(&t, 0, "vertices"),
      100 * growth_number(&t, 0, "inside"), 100 * growth_number(&t, 0, "whole_inside"),
      growth_number(&t, 0, "iterations"), growth_number(&t, 0, "packing"),
      growth_number(&t, 0, "contacts"), growth_number(&t, 0, "contacts_first"), seconds);
}

static bool grow(const void *options, const sozai_geometry_1 *table, const sozai_host *host,
                 sozai_geometry **out, failure *why) {
  const fiber_options *o = options;
  return aggregate_grow(table, host, o->material, o->params.items, o->params.count, &o->solid, out,
                        why);
}

static bool make(fiber_options *o, const session_options *shared, failure *why) {
  if (!check(o, why)) return false;
  if (o->scale > 0 && !aggregate_hull_is_file(o->hull))
    return fail(why, EXIT_BAD_INPUT,
                "--scale: only for a mesh's file, which '%s' is not; it is made in mm", o->hull);
  if (!aggregate_hull(&o->solid, o->hull, o->scale > 0 ? o->scale : 1, why)) return false;
  const grown_file file = {.output = o->output,
                           .options = o,
                           .verbose = o->verbose,
                           .grow = grow,
                           .report = report_fiber,
                           .write = write_out};
  bool ok = grown_make(&file, shared, why);
  mesh_free(&o->solid);
  return ok;
}

#define VIEWS ".png .exr"

/* An EXR is scene-linear: no display is in it. Colours are a view's alone, which shows every
 * strand. */
static const option_use uses[] = {
    {"level", ".usda .hair .obj .pbrt .gltf"},
    {"res", VIEWS},
    {"spp", VIEWS},
    {"bounces", VIEWS},
    {"camera", VIEWS},
    {"target", VIEWS},
    {"light", VIEWS},
    {"zoom", VIEWS},
    {"display", ".png"},
    {"view", ".png"},
    {"look", ".png"},
    {"config", VIEWS},
};

int run_grow_fiber(int argc, char **argv) {
  failure why = {0};
  session_options shared;
  if (!session_options_init(&shared, argc, &why)) return report(&why);
  fiber_options o = {.view = FIBER_VIEW_DEFAULT};
  const option options[] = {
      {"output", 'o', OPTION_TEXT, &o.output, "FILE",
       ".usda, .hair, .obj, .pbrt: curves; .gltf: tubes; .csv, a table; .png, .exr, a view", 0, 0},
      {"hull", 0, OPTION_TEXT, &o.hull, "MESH",
       "a mesh's file; or one made here: bunny, serpent, ball, lump[:RADIUS], slab, box:WxHxD", 0,
       0},
      {"scale", 0, OPTION_NUMBER, &o.scale, "X", "mm to a unit of the mesh's file (default: 1)",
       1e-6, 1e6},
      {"material", 0, OPTION_TEXT, &o.material, "NAME", "a preset: see sozai list (default: none)",
       0, 0},
      {"preset", 0, OPTION_TEXT, &o.material, "NAME", "the same as --material", 0, 0},
      {"param", 'p', OPTION_PAIRS, &shared.params, "NAME=VALUE",
       "set a parameter; any number of these", 0, 0},
      {"level", 0, OPTION_COUNT, &o.level, "N",
       "of detail: 0 (default) is all, each more about half", 0, 8},
      {"table", 0, OPTION_TEXT, &o.table, "NAME", "which table a .csv takes: statistics, strands",
       0, 0},
      {"res", 0, OPTION_SIZE, o.view.size, "WxH", "pixels of a view (default: 768x768)", 1,
       VIEW_MOST_SIDE},
      {"spp", 0, OPTION_COUNT, &o.view.spp, "N", "samples a pixel of a view (default: 32)", 1,
       VIEW_MOST_SAMPLES},
      {"bounces", 0, OPTION_COUNT, &o.view.bounces, "N", "of light, strand to strand (default: 12)",
       0, 256},
      {"camera", 0, OPTION_TEXT, &o.view.camera, "AZ,EL[,ANGLE]",
       "of a view, degrees (default: 35,18,20)", 0, 0},
      {"target", 0, OPTION_TEXT, &o.view.target, "X,Y,Z",
       "a view's middle, mm (default: the aggregate's)", 0, 0},
      {"light", 0, OPTION_TEXT, &o.view.light, "AZ,EL",
       "where a view's light comes from, degrees (default: the studio's)", 0, 0},
      {"zoom", 0, OPTION_NUMBER, &o.view.zoom, "X", "1: the whole aggregate (default: 1)", 0.01,
       10000},
      SESSION_DISPLAY_OPTIONS(shared),
      SESSION_RUN_OPTIONS(shared)};
  static const char *const positional[] = {"generator"};
  bool given[sizeof options / sizeof options[0]] = {false};
  const command_line line = {.name = "grow fiber",
                             .usage = "grow fiber --hull MESH -o FILE [options]",
                             .about =
                                 "Packs crimped fibres into a hull and writes them to a file.\n",
                             .options = options,
                             .option_count = sizeof options / sizeof options[0],
                             .positional = positional,
                             .positional_count = 1,
                             .given = given};
  const char *what = NULL;
  int parsed = options_parse(&line, argc, argv, &what, &why);
  o.params = shared.params;
  o.verbose = shared.verbose;
  int code = 0;
  if (parsed == OPTIONS_BAD ||
      (parsed == OPTIONS_RUN &&
       (!options_fit(&line, uses, sizeof uses / sizeof uses[0], o.output, &why) ||
        !make(&o, &shared, &why))))
    code = report(&why);
  session_options_free(&shared);
  return code;
}
