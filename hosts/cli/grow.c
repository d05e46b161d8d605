/* SPDX-License-Identifier: Apache-2.0
 *
 * sozai grow tree: a tree into a file. */
#include "commands.h"
#include "grow_fiber.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "ending.h"
#include "grown.h"
#include "progress.h"
#include "session.h"
#include "tree_view.h"
#include "ceilings.h"

#define USUAL_SPECIES "sugi"

typedef struct grow_options {
  const char *species, *age, *field, *output, *table;
  char *field_text; /* what is in the file `field` */
  uint32_t level;
  bool curves, verbose;
  option_texts params;
  tree_view view;
} grow_options;

/* Before any work is done. */
static bool check(const grow_options *o, const char *what, failure *why) {
  if (strcmp(what, "tree") != 0)
    return fail(why, EXIT_BAD_INPUT,
                "grow: there is no '%s' to grow; there are tree and, named "
                "before any option, fiber",
                what);
  if (!o->output) return fail(why, EXIT_BAD_INPUT, "grow: no output is given: -o FILE");
  const char *endings = ".obj, .gltf, .usda, .field, .csv, .png, .exr";
  bool known = ends_in(o->output, ".obj") || ends_in(o->output, ".gltf") ||
               ends_in(o->output, ".usda") || ends_in(o->output, ".field") ||
               ends_in(o->output, ".csv") || grown_is_picture(o->output);
  if (!known)
    return fail(why, EXIT_BAD_INPUT, "--output: '%s' ends in none of %s", o->output, endings);
  if (o->curves && !ends_in(o->output, ".usda"))
    return fail(why, EXIT_BAD_INPUT, "--curves: only .usda holds curves, not '%s'", o->output);
  return grown_check_table(o->output, o->table, why);
}

static bool write_geometry(const void *options, const sozai_geometry_1 *table,
                           const sozai_geometry *g, session *s, const char *path, failure *why) {
  const grow_options *o = options;
  sozai_table rows;
  if (ends_in(o->output, ".field"))
    return growth_rows(table, g, "nodes", &rows, why) && write_field(&rows, path, why);
  if (ends_in(o->output, ".csv"))
    return growth_rows(table, g, o->table, &rows, why) && write_csv(&rows, path, why);
  const sozai_detail detail = {.size = sizeof detail, .level = o->level};
  if (o->curves) {
    const sozai_curves *c = NULL;
    int32_t code = table->curves(g, &detail, &c);
    if (code != SOZAI_OK) return growth_failed(table, code, why);
    bool ok = write_usda(NULL, c, path, why);
    table->release_curves(c);
    return ok;
  }
  const sozai_mesh *m = NULL;
  int32_t code = table->mesh(g, &detail, &m);
  if (code != SOZAI_OK) return growth_failed(table, code, why);
  progress_show(1, "writing");
  bool ok = grown_is_picture(o->output)   ? tree_view_write(&o->view, m, s, path, why)
            : ends_in(o->output, ".obj")  ? write_obj(m, path, why)
            : ends_in(o->output, ".gltf") ? write_gltf(m, path, why)
                                          : write_usda(m, NULL, path, why);
  if (ok && o->verbose) {
    progress_clear();
    fprintf(stderr, "sozai: %llu points, %llu triangles\n", (unsigned long long)m->point_count,
            (unsigned long long)m->triangle_count);
  }
  table->release_mesh(m);
  return ok;
}

static void report_tree(const sozai_geometry_1 *table, const sozai_geometry *g, double seconds) {
  failure ignored = {0};
  sozai_table t;
  if (!growth_rows(table, g, "statistics", &t, &ignored)) return;
  static const char *const orders[] = {"first_order", "second_order", "third_order",
                                       "fourth_order"};
  double sum = 1;
  progress_clear();
  fprintf(stderr, "sozai: %.2f m", growth_number(&t, 0, "height") / 1000);
  for (int i = 0; i < 4; i++) {
    double n = growth_number(&t, 0, orders[i]);
    sum += n;
    fprintf(stderr, ", %s %.0f", orders[i], n);
  }
  fprintf(stderr, "; %.1f ms, %.2f million branches/s\n", seconds * 1e3, sum / seconds / 1e6);
}

static bool grow(const void *options, const sozai_geometry_1 *table, const sozai_host *host,
                 sozai_geometry **out, failure *why) {
  const grow_options *o = options;
  return growth_grow(table, host, "tree", o->species, o->params.items, o->params.count,
                     o->field_text, out, why) ||
         growth_name_field(o->field, why);
}

/* To the plugin an empty text is none, and it would grow any tree. */
static bool read_field(grow_options *o, failure *why) {
  if (!growth_read_text(o->field, &o->field_text, why)) return false;
  if (*o->field_text) return true;
  free(o->field_text);
  return fail(why, EXIT_BAD_INPUT, "--field: '%s' is empty: there is no trunk", o->field);
}

static bool make(grow_options *o, const session_options *shared, const char *what, failure *why) {
  if (!check(o, what, why)) return false;
  if (o->field && !read_field(o, why)) return false;
  const grown_file file = {.output = o->output,
                           .options = o,
                           .verbose = o->verbose,
                           .grow = grow,
                           .report = report_tree,
                           .write = write_geometry};
  bool ok = grown_make(&file, shared, why);
  free(o->field_text);
  return ok;
}

#define VIEWS ".png .exr"

/* An EXR is scene-linear: no display is in it. Colours are a view's alone. */
static const option_use uses[] = {
    {"level", ".obj .gltf .usda " VIEWS},
    {"res", VIEWS},
    {"spp", VIEWS},
    {"camera", VIEWS},
    {"target", VIEWS},
    {"zoom", VIEWS},
    {"display", ".png"},
    {"view", ".png"},
    {"look", ".png"},
    {"config", VIEWS},
};

int run_grow(int argc, char **argv) {
  if (argc > 1 && strcmp(argv[1], "fiber") == 0) return run_grow_fiber(argc, argv);
  failure why = {0};
  session_options shared;
  if (!session_options_init(&shared, argc + 1, &why)) return report(&why);
  grow_options o = {.species = USUAL_SPECIES, .view = TREE_VIEW_DEFAULT};
  const option options[] = {
      {"output", 'o', OPTION_TEXT, &o.output, "FILE",
       ".obj, .gltf, .usda; .field, a field table; .csv, a table; .png, .exr, a view", 0, 0},
      {"species", 0, OPTION_TEXT, &o.species, "NAME",
       "a preset: see sozai list (default: " USUAL_SPECIES ")", 0, 0},
      {"preset", 0, OPTION_TEXT, &o.species, "NAME", "the same as --species", 0, 0},
      {"age", 0, OPTION_TEXT, &o.age, "YEARS", "the same as -p age=YEARS (default: the preset's)",
       0, 0},
      {"param", 'p', OPTION_PAIRS, &shared.params, "NAME=VALUE",
       "set a parameter; any number of these", 0, 0},
      {"field", 0, OPTION_TEXT, &o.field, "FILE", "a measured tree's field table", 0, 0},
      {"level", 0, OPTION_COUNT, &o.level, "N",
       "of detail: 0 (default) is all, 1 about a half, 2 a sixth, then half each", 0, 8},
      {"curves", 0, OPTION_FLAG, &o.curves, NULL, "curves in place of a mesh, in .usda", 0, 0},
      {"table", 0, OPTION_TEXT, &o.table, "NAME", "which table a .csv takes: see describe tree", 0,
       0},
      {"res", 0, OPTION_SIZE, o.view.size, "WxH", "pixels of a view (default: 768x1024)", 1,
       VIEW_MOST_SIDE},
      {"spp", 0, OPTION_COUNT, &o.view.spp, "N", "samples a pixel of a view (default: 16)", 1,
       VIEW_MOST_SAMPLES},
      {"camera", 0, OPTION_TEXT, &o.view.camera, "AZ,EL[,ANGLE]",
       "of a view, degrees (default: 25,4,20)", 0, 0},
      {"target", 0, OPTION_TEXT, &o.view.target, "X,Y,Z",
       "a view's middle, mm (default: the tree's)", 0, 0},
      {"zoom", 0, OPTION_NUMBER, &o.view.zoom, "X", "1: the whole tree (default: 1.15)", 0.01,
       10000},
      SESSION_DISPLAY_OPTIONS(shared),
      SESSION_RUN_OPTIONS(shared)};
  static const char *const positional[] = {"generator"};
  bool given[sizeof options / sizeof options[0]] = {false};
  const command_line line = {
      .usage = "grow tree -o FILE [options]",
      .about = "Grows a tree and writes it to a file; `sozai grow fiber --help` for fibre.\n",
      .options = options,
      .option_count = sizeof options / sizeof options[0],
      .positional = positional,
      .positional_count = 1,
      .given = given};
  const char *what = NULL;
  int parsed = options_parse(&line, argc, argv, &what, &why);
  int code = 0;
  char age[64];
  if (parsed == OPTIONS_RUN) {
    if (o.age) {
      snprintf(age, sizeof age, "age=%.50s", o.age);
      shared.params.items[shared.params.count++] = age;
    }
    o.params = shared.params;
    o.verbose = shared.verbose;
  }
  if (parsed == OPTIONS_BAD ||
      (parsed == OPTIONS_RUN &&
       (!options_fit(&line, uses, sizeof uses / sizeof uses[0], o.output, &why) ||
        !make(&o, &shared, what, &why))))
    code = report(&why);
  session_options_free(&shared);
  return code;
}
