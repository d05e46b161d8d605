/* SPDX-License-Identifier: Apache-2.0 */
#include "figures_tree.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "chart.h"
#include "growth.h"
#include "output_file.h"
#include "tree_view.h"

#define SIDE 520u
#define PI 3.14159265358979323846

/* What a plot shows: several trees of one kind, first-order branches alone. */
typedef struct kind {
  const char *name, *preset;
  const char *values[6];
  int trees;
  double mean, least, most, sd, a_up, a_down; /* the paper's; 0: not given */
} kind;

/* As trees are measured: the preset is section 6.1's example, which does not turn. */
#define MEASURED_SUGI "age=7", "orders=1", "azimuth=turning", "crown_scatter=0.15"
#define SUGI                                                                                       \
  "sugi_paper", { MEASURED_SUGI }
#define HINOKI                                                                                     \
  "hinoki", { "age=11", "orders=1", "crown_ratio=1", "crown_narrowing=0" }
static const kind kinds[] = {
    {"tree-02",
     "sugi_paper",
     {MEASURED_SUGI, "turning_spread=0", "branches_turn=2.081"},
     1,
     173,
     33,
     293,
     73,
     0,
     0},
    {"tree-03",
     "hinoki",
     {"age=11", "orders=1", "crown_ratio=1", "turning_spread=0"},
     1,
     164,
     52,
     244,
     52,
     0,
     0},
    {"tree-04", SUGI, 17, 0, 0, 0, 0, 0, 0},
    {"tree-05", HINOKI, 18, 0, 0, 0, 0, 0, 0},
    {"tree-06", SUGI, 17, 0, 0, 0, 0, 0.25, 0.26},
    {"tree-07", HINOKI, 18, 0, 0, 0, 0, 0.28, 0.28},
    {"tree-08", SUGI, 17, 0, 0, 0, 0, 0, 0},
    {"tree-09", "sugi_h4", {"age=5", "orders=1", "crown_ratio=1"}, 1, 0, 0, 0, 0, 0, 0},
    {"tree-10", "sugi_h4", {"age=5", "orders=1", "crown_ratio=1"}, 1, 0, 0, 0, 0, 0, 0},
    {"tree-11", HINOKI, 1, 0, 0, 0, 0, 0, 0},
    {"tree-12", "akamatsu", {"age=7", "orders=1", "crown_ratio=1"}, 1, 0, 0, 0, 0, 0, 0}};

static bool grow_one(session *s, const sozai_geometry_1 *table, const kind *k, int seed,
                     sozai_geometry **out, failure *why) {
  char text[32];
  const char *pairs[5];
  size_t count = 0;
  for (int i = 0; i < 4 && k->values[i]; i++) pairs[count++] = k->values[i];
  snprintf(text, sizeof text, "seed=%d", seed);
  pairs[count++] = text;
  return growth_grow(table, &s->host.abi, "tree", k->preset, pairs, count, NULL, out, why);
}

/* ---- measuring ---------------------------------------------------------- */

static const char *const measured[] = {"turns_year",     "branches_turn",  "divergence_mean",
                                       "divergence_min", "divergence_max", "divergence_sd",
                                       "crown_a",        "crown_a_up",     "crown_a_down"};
#define MEASURED (sizeof measured / sizeof *measured)

static void put_pair(json *j, const char *name, double got, double paper) {
  json_open(j, name, '{');
  json_number(j, "measured", got);
  if (paper > 0) json_number(j, "paper", paper);
  json_close(j, '}');
}

static void put_numbers(json *j, const kind *k, const double *sums) {
  bool sugi = strcmp(k->preset, "sugi_paper") == 0;
  const double paper[MEASURED] = {
      sugi ? 3.19 : 0, sugi ? 2.1 : 0, k->mean, k->least, k->most, k->sd, 0, k->a_up, k->a_down};
  json_text(j, "preset", k->preset);
  json_number(j, "trees", k->trees);
  for (size_t i = 0; i < MEASURED; i++) put_pair(j, measured[i], sums[i] / k->trees, paper[i]);
}

/* ---- drawing ------------------------------------------------------------ */

static void plot_plan(chart *c, const sozai_table *t, bool lines) {
  for (uint64_t i = 0; i < t->rows; i++) {
    double turn = growth_number(t, i, "azimuth") * PI / 180, l = growth_number(t, i, "length");
    if (lines) chart_line(c, 0, 0, l * sin(turn), l * cos(turn), 1.2, 0.8);
    chart_dot(c, l * sin(turn), l * cos(turn), lines ? 3 : 1.8, 1);
  }
}

/* Upslope to the left, downslope to the right, as the paper has it. */
static void plot_profile(chart *c, const sozai_table *t) {
  for (uint64_t i = 0; i < t->rows; i++) {
    double turn = growth_number(t, i, "azimuth");
    double side = turn > 90 && turn < 270 ? 1 : -1;
    chart_dot(c, side * growth_number(t, i, "length"), growth_number(t, i, "height"), 1.8, 1);
  }
}

static void plot_curve(chart *c, double a_up, double a_down) {
  for (int i = 0; i < 100; i++) {
    double z = i / 100.0, y = (i + 1) / 100.0;
    chart_line(c, -a_up * sqrt(1 - z), z, -a_up * sqrt(1 - y), y, 1.5, 0.7);
    chart_line(c, a_down * sqrt(1 - z), z, a_down * sqrt(1 - y), y, 1.5, 0.7);
  }
}

static void plot_turning(chart *c, const sozai_table *t, bool years) {
  for (uint64_t i = 0; i < t->rows; i++) {
    double turn = growth_number(t, i, "turning"), z = growth_number(t, i, "height");
    chart_dot(c, turn, z, years ? 3 : 1.6, 1);
    if (!years || i == 0) continue;
    double before = growth_number(t, i - 1, "turning");
    chart_line(c, before, growth_number(t, i - 1, "height"), turn, z, 1.2, 0.6);
    if (growth_number(t, i, "year") > growth_number(t, i - 1, "year"))
      chart_line(c, (before + turn) / 2, 0, (before + turn) / 2, 1, 1, 0.35);
  }
}

static void frame_chart(chart *c, int figure) {
  if (figure <= 5) {
    c->low[0] = c->low[1] = -0.6;
    c->high[0] = c->high[1] = 0.6;
    chart_line(c, -0.6, 0, 0.6, 0, 1, 0.3);
    chart_line(c, 0, -0.6, 0, 0.6, 1, 0.3);
  } else if (figure <= 7) {
    c->low[0] = -0.6, c->high[0] = 0.6, c->low[1] = 0, c->high[1] = 1.02;
    chart_line(c, 0, 0, 0, 1, 1, 0.3);
  } else {
    c->low[0] = -100, c->high[0] = figure == 8 || figure == 11 ? 12500 : 7500;
    c->low[1] = 0, c->high[1] = 1.02;
    if (figure == 12) c->high[0] = 2800;
    for (double x = 0; x < c->high[0]; x += 360) chart_line(c, x, 0, x, 0.012, 1, 0.6);
  }
}

static bool draw_plot(session *s, const char *folder, const char *name, json *j, failure *why) {
  const kind *k = kinds;
  while (strcmp(k->name, name) != 0) k++;
  int figure = atoi(name + 5);
  const sozai_geometry_1 *table = growth_table(s->plugin.entry, why);
  plate p;
  chart c;
  if (!table || !plate_init(&p, 1, SIDE, SIDE, why)) return false;
  if (!chart_init(&c, SIDE, SIDE, why)) {
    plate_free(&p);
    return false;
  }
  double sums[MEASURED] = {0};
  bool ok = true;
  frame_chart(&c, figure);
  for (int i = 0; ok && i < k->trees; i++) {
    sozai_geometry *g = NULL;
    sozai_table turning, numbers;
    ok = grow_one(s, table, k, figure == 10 ? 13 : i + (k->trees == 1 ? 9 : 2), &g, why) &&
         growth_rows(table, g, "turning", &turning, why) &&
         growth_rows(table, g, "statistics", &numbers, why);
    for (size_t n = 0; ok && n < MEASURED; n++) sums[n] += growth_number(&numbers, 0, measured[n]);
    if (ok && figure <= 5) plot_plan(&c, &turning, k->trees == 1);
    if (ok && (figure == 6 || figure == 7)) plot_profile(&c, &turning);
    if (ok && figure >= 8) plot_turning(&c, &turning, k->trees == 1);
    table->release(g);
  }
  if (ok && (figure == 6 || figure == 7)) plot_curve(&c, sums[7] / k->trees, sums[8] / k->trees);
  if (ok) {
    put_numbers(j, k, sums);
    plate_ink(&p, 0, c.share);
    ok = plate_write(&p, folder, name, why);
  }
  chart_free(&c);
  plate_free(&p);
  return ok;
}

/* ---- views -------------------------------------------------------------- */

typedef struct scene_of {
  const char *name, *preset, *values[4];
  tree_view view;
} scene_of;

#define FROM(c, z, t)                                                                              \
  { .size = {540, 720}, .spp = 8, .camera = c, .zoom = z, .target = t }
static const scene_of views[] = {
    {"tree-20", "cherry_paper", {"age=12"}, FROM("-90,4,20", 1.15, NULL)},
    {"tree-21", "cherry_paper", {"age=12"}, FROM("0,4,20", 1.15, NULL)},
    {"tree-23", "sugi_paper", {"age=7", "orders=2"}, FROM("25,3,20", 1.15, NULL)},
    {"tree-24", "sugi_paper", {"age=7", "orders=3"}, FROM("25,3,20", 1.15, NULL)},
    {"tree-25", "sugi_paper", {"age=7"}, FROM("25,3,20", 1.15, NULL)},
    {"tree-26", "sugi_paper", {"age=7"}, FROM("25,3,20", 6, "0,1500,300")},
    {"tree-27", "sugi", {"age=7"}, FROM("25,3,20", 3.5, "0,1500,200")}};

static bool write_view(const scene_of *v, const sozai_mesh *m, session *s, const char *folder,
                       failure *why) {
  char path[4096];
  output_file o;
  int n = snprintf(path, sizeof path, "%s/%s.png", folder, v->name);
  if (n < 0 || (size_t)n >= sizeof path)
    return fail(why, EXIT_BAD_INPUT, "'%s' is too long a path", folder);
  if (!output_begin(&o, path, why)) return false;
  if (tree_view_write(&v->view, m, s, o.writing, why)) return output_commit(&o, why);
  return output_failed(&o, why);
}

static bool draw_view(session *s, const char *folder, const char *name, json *j, failure *why) {
  const scene_of *v = views;
  while (strcmp(v->name, name) != 0) v++;
  const sozai_geometry_1 *table = growth_table(s->plugin.entry, why);
  size_t count = 0;
  while (count < 4 && v->values[count]) count++;
  sozai_geometry *g = NULL;
  sozai_table t;
  const sozai_mesh *m = NULL;
  bool ok = table &&
            growth_grow(table, &s->host.abi, "tree", v->preset, v->values, count, NULL, &g, why) &&
            growth_rows(table, g, "statistics", &t, why);
  if (!ok) return false;
  int32_t code = table->mesh(g, NULL, &m);
  ok = code == SOZAI_OK || growth_failed(table, code, why);
  if (ok) {
    static const char *const orders[] = {"first_order", "second_order", "third_order",
                                         "fourth_order"};
    json_text(j, "preset", v->preset);
    json_number(j, "height_mm", growth_number(&t, 0, "height"));
    for (int i = 0; i < 4; i++) json_number(j, orders[i], growth_number(&t, 0, orders[i]));
    json_number(j, "triangles", (double)m->triangle_count);
    ok = write_view(v, m, s, folder, why);
  }
  table->release_mesh(m);
  table->release(g);
  return ok;
}

const figure tree_figures[] = {
    {"tree-02", "Branches of a sugi from above, length over tree height", draw_plot},
    {"tree-03", "Branches of a hinoki from above", draw_plot},
    {"tree-04", "Branches of 17 sugi from above", draw_plot},
    {"tree-05", "Branches of 18 hinoki from above", draw_plot},
    {"tree-06", "The crown's curve of 17 sugi, upslope to the left", draw_plot},
    {"tree-07", "The crown's curve of 18 hinoki", draw_plot},
    {"tree-08", "Height against turning of 17 sugi", draw_plot},
    {"tree-09", "Height against turning of a 5-year sugi, years parted by lines", draw_plot},
    {"tree-10", "Height against turning of another", draw_plot},
    {"tree-11", "Height against turning of a hinoki", draw_plot},
    {"tree-12", "Height against turning of a species with whorls (akamatsu)", draw_plot},
    {"tree-20", "A cherry from the south", draw_view},
    {"tree-21", "A cherry from the east", draw_view},
    {"tree-23", "The sugi model to the second order", draw_view},
    {"tree-24", "The sugi model to the third order", draw_view},
    {"tree-25", "The sugi model to the fourth order", draw_view},
    {"tree-26", "The sugi model, near", draw_view},
    {"tree-27", "A 7-year sugi, near", draw_view},
};
const size_t tree_figure_count = sizeof tree_figures / sizeof tree_figures[0];
