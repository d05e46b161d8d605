/* SPDX-License-Identifier: Apache-2.0
 *
 * sozai grow tree: a tree into a file. */
#include "commands.h"
#include "grow_fiber.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "cancel.h"
#include "ending.h"
#include "growth.h"
#include "output_file.h"
#include "parallel.h"
#include "progress.h"
#include "session.h"
#include "tree_view.h"
#include "ceilings.h"

typedef struct grow_options {
  const char *species, *age, *field, *output, *table;
  uint32_t level;
  bool curves, verbose;
  option_texts params;
  uint32_t threads;
  tree_view view;
} grow_options;

static bool is_picture(const char *path) { return ends_in(path, ".png") || ends_in(path, ".exr"); }

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
               ends_in(o->output, ".csv") || is_picture(o->output);
  if (!known)
    return fail(why, EXIT_BAD_INPUT, "--output: '%s' ends in none of %s", o->output, endings);
  if (o->curves && !ends_in(o->output, ".usda"))
    return fail(why, EXIT_BAD_INPUT, "--curves: only .usda holds curves, not '%s'", o->output);
  if ((o->table != NULL) != ends_in(o->output, ".csv"))
    return fail(why, EXIT_BAD_INPUT, "--table: goes with an output in .csv, and .csv with it");
  return true;
}

static bool write_geometry(const grow_options *o, const sozai_geometry_1 *table,
                           const sozai_geometry *g, const char *path, session *s, failure *why) {
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
  bool ok = is_picture(o->output)         ? tree_view_write(&o->view, m, s, path, why)
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

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static bool grow_into(const grow_options *o, session *s, const char *field, failure *why) {
  const sozai_geometry_1 *table = growth_table(s->plugin.entry, why);
  output_file file;
  if (!table || !output_begin(&file, o->output, why)) return false;
  sozai_geometry *g = NULL;
  double begin = now();
  bool ok = growth_grow(table, &s->host.abi, "tree", o->species, o->params.items, o->params.count,
                        field, &g, why);
  if (ok && o->verbose) report_tree(table, g, now() - begin);
  ok = ok && write_geometry(o, table, g, file.writing, s, why);
  table->release(g);
  if (ok && cancel_requested()) ok = fail(why, EXIT_FAILURE, "cancelled");
  progress_clear();
  if (ok) return output_commit(&file, why);
  output_discard(&file);
  return false;
}

/* Only pictures want colour, whose service takes a while to open. */
static bool open_for(const grow_options *o, session *s, const session_options *shared,
                     failure *why) {
  if (is_picture(o->output)) return session_open(s, shared, why);
  memset(s, 0, sizeof *s);
  if (!plugin_open(&s->plugin, why)) return false;
  uint32_t threads = shared->threads ? shared->threads : parallel_default_threads();
  host_init(&s->host, threads, shared->verbose, NULL, NULL);
  if (limits_give(s->plugin.entry, &s->host.abi, why)) return true;
  session_close(s);
  return false;
}

static bool grow(grow_options *o, const session_options *shared, const char *what, failure *why) {
  if (!check(o, what, why)) return false;
  char *field = NULL;
  if (o->field && !growth_read_text(o->field, &field, why)) return false;
  session s;
  bool ok = open_for(o, &s, shared, why);
  if (ok) {
    ok = grow_into(o, &s, field, why);
    session_close(&s);
  }
  free(field);
  return ok;
}

int run_grow(int argc, char **argv) {
  if (argc > 1 && strcmp(argv[1], "fiber") == 0) return run_grow_fiber(argc, argv);
  failure why = {0};
  session_options shared;
  if (!session_options_init(&shared, argc + 1, &why)) return report(&why);
  grow_options o = {.view = TREE_VIEW_DEFAULT};
  const option options[] = {
      {"output", 'o', OPTION_TEXT, &o.output, "FILE",
       ".obj, .gltf, .usda; .field, a field table; .csv, a table; .png, .exr, a view", 0, 0},
      {"species", 0, OPTION_TEXT, &o.species, "NAME", "a preset: see sozai list (default: sugi)", 0,
       0},
      {"age", 0, OPTION_TEXT, &o.age, "YEARS", "the same as -p age=YEARS", 0, 0},
      {"param", 'p', OPTION_PAIRS, &shared.params, "NAME=VALUE",
       "set a parameter; any number of these", 0, 0},
      {"field", 0, OPTION_TEXT, &o.field, "FILE", "a measured tree's field table", 0, 0},
      {"level", 0, OPTION_COUNT, &o.level, "N", "of detail: 0 is all, each more about half", 0, 8},
      {"curves", 0, OPTION_FLAG, &o.curves, NULL, "curves in place of a mesh, in .usda", 0, 0},
      {"table", 0, OPTION_TEXT, &o.table, "NAME", "which table a .csv takes: see describe tree", 0,
       0},
      {"res", 0, OPTION_SIZE, o.view.size, "WxH", "pixels of a view", 1, VIEW_MOST_SIDE},
      {"spp", 0, OPTION_COUNT, &o.view.spp, "N", "samples a pixel of a view", 1, VIEW_MOST_SAMPLES},
      {"camera", 0, OPTION_TEXT, &o.view.camera, "AZ,EL[,ANGLE]", "of a view, degrees", 0, 0},
      {"target", 0, OPTION_TEXT, &o.view.target, "X,Y,Z", "a view's middle, mm", 0, 0},
      {"zoom", 0, OPTION_NUMBER, &o.view.zoom, "X", "1: the whole tree", 0.01, 10000},
      SESSION_DISPLAY_OPTIONS(shared),
      SESSION_RUN_OPTIONS(shared)};
  static const char *const positional[] = {"generator"};
  const command_line line = {
      .usage = "grow tree -o FILE [options]",
      .about = "Grows a tree and writes it to a file; `sozai grow fiber --help` for fibre.\n",
      .options = options,
      .option_count = sizeof options / sizeof options[0],
      .positional = positional,
      .positional_count = 1};
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
  if (parsed == OPTIONS_BAD || (parsed == OPTIONS_RUN && !grow(&o, &shared, what, &why)))
    code = report(&why);
  session_options_free(&shared);
  return code;
}
