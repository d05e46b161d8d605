/* SPDX-License-Identifier: Apache-2.0 */
#include "figures_fiber.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "aggregate.h"
#include "chart.h"
#include "fiber_view.h"

#define PAIRS 10

/* ---- one picture ------------------------------------------------------- */

typedef struct panel {
  const char *hull, *material;
  const char *values[PAIRS];
  double paper; /* iterations that the paper counts; 0: none given */
} panel;

static bool grow_panel(session *s, const sozai_geometry_1 *table, const panel *p,
                       sozai_geometry **g, failure *why) {
  mesh hull;
  size_t count = 0;
  while (count < PAIRS && p->values[count]) count++;
  if (!aggregate_hull(&hull, p->hull, 1, why)) return false;
  bool ok = aggregate_grow(table, &s->host.abi, p->material, p->values, count, &hull, g, why);
  mesh_free(&hull);
  return ok;
}

/* The paper's iterations are the slowest strand's: another seed's may be a tenth more or less, so
 * that what is compared is a mean. */
#define RUNS 16

static bool put_runs(session *s, const sozai_geometry_1 *table, const panel *p, json *j,
                     failure *why) {
  double sum = 0, square = 0;
  size_t last = 0;
  while (last < PAIRS && p->values[last]) last++;
  if (last == PAIRS) return fail(why, EXIT_FAILURE, "a panel has no room for a seed");
  for (int k = 1; k <= RUNS; k++) {
    panel run = *p;
    char seed[16];
    sozai_geometry *g = NULL;
    sozai_table t;
    snprintf(seed, sizeof seed, "seed=%d", k);
    run.values[last] = seed;
    if (!grow_panel(s, table, &run, &g, why)) return false;
    bool ok = growth_rows(table, g, "statistics", &t, why);
    double moves = ok ? growth_number(&t, 0, "iterations") : 0;
    table->release(g);
    if (!ok) return false;
    sum += moves / RUNS, square += moves * moves / RUNS;
  }
  json_number(j, "runs", RUNS);
  json_number(j, "iterations_mean", sum);
  json_number(j, "iterations_sd", sqrt(fmax(square - sum * sum, 0)));
  json_number(j, "paper_iterations", p->paper);
  return true;
}

static bool put_numbers(session *s, json *j, const sozai_geometry_1 *table, const sozai_geometry *g,
                        const panel *p, failure *why) {
  static const char *const columns[] = {"strands",        "vertices", "iterations",   "mean_moves",
                                        "inside_first",   "inside",   "whole_inside", "packing",
                                        "contacts_first", "contacts"};
  sozai_table t;
  if (!growth_rows(table, g, "statistics", &t, why)) return false;
  json_open(j, NULL, '{');
  json_text(j, "hull", p->hull);
  if (p->material) json_text(j, "material", p->material);
  for (size_t i = 0; i < sizeof columns / sizeof *columns; i++)
    json_number(j, columns[i], growth_number(&t, 0, columns[i]));
  bool ok = !(p->paper > 0) || put_runs(s, table, p, j, why);
  json_close(j, '}');
  return ok;
}

static bool put_film(plate *p, uint32_t i, const film *f, const session *s, failure *why) {
  size_t pixels = (size_t)f->width * f->height;
  float *planes = malloc(3 * pixels * sizeof *planes);
  if (!planes) return fail(why, EXIT_FAILURE, "out of memory");
  for (size_t k = 0; k < 3 * pixels; k++) planes[k % 3 * pixels + k / 3] = f->beauty[k];
  float *const rgb[3] = {planes, planes + pixels, planes + 2 * pixels};
  bool ok = plate_colour(p, i, rgb, s, why);
  free(planes);
  return ok;
}

static bool draw_panel(session *s, const sozai_geometry_1 *table, const panel *p,
                       const fiber_view *v, plate *out, uint32_t i, json *j, failure *why) {
  sozai_geometry *g = NULL;
  film f;
  if (!grow_panel(s, table, p, &g, why)) return false;
  bool ok = put_numbers(s, j, table, g, p, why) && fiber_view_render(v, table, g, s, &f, why);
  if (ok) {
    ok = put_film(out, i, &f, s, why);
    film_free(&f);
  }
  table->release(g);
  return ok;
}

/* ---- rows of pictures -------------------------------------------------- */

#define PANELS 4

typedef struct row {
  const char *name;
  uint32_t panels;
  panel panel[PANELS];
  fiber_view view;
} row;

#define VIEW(side, samples, from)                                                                  \
  { .size = {side, side}, .spp = samples, .bounces = 12, .smooth = 1, .camera = from, .zoom = 1.25 }
/* White on dark: on the studio's floor it would be white on white. */
#define WHITE                                                                                      \
  {                                                                                                \
    .size = {420, 420}, .spp = 32, .bounces = 40, .smooth = 2, .camera = "35,18,20", .zoom = 1.3,  \
    .no_floor = true                                                                               \
  }
#define PAPER VIEW(360, 10, "35,12,20")
#define STEPS "mode=literal", "step=0.5", "count=2048"
#define STEP "halvings=0", "step=0.5", "count=2048"
#define STRAIGHT "phi_max=0", "theta_max=0"
#define BENT "phi_max=0", "theta_max=10.8"
#define WAVED "phi_max=0", "theta_min=-10.8", "theta_max=10.8"
#define COILED "phi_max=36", "theta_max=10.8"

static const row rows[] = {
    {"fiber-04", 2, {{"bunny", NULL, {"iterations=0"}, 0}, {"bunny", NULL, {"seed=1"}, 0}}, PAPER},
    {"fiber-06",
     4,
     {{"bunny", NULL, {STEPS, "iterations=5"}, 0},
      {"bunny", NULL, {STEPS, "iterations=10"}, 0},
      {"bunny", NULL, {STEPS, "iterations=15"}, 0},
      {"bunny", NULL, {STEPS, "iterations=20"}, 0}},
     PAPER},
    {"fiber-07-bunny",
     4,
     {{"bunny", NULL, {STEP, STRAIGHT}, 35},
      {"bunny", NULL, {STEP, BENT}, 54},
      {"bunny", NULL, {STEP, WAVED}, 37},
      {"bunny", NULL, {STEP, COILED}, 31}},
     PAPER},
    {"fiber-07-serpent",
     4,
     {{"serpent", NULL, {STEP, STRAIGHT}, 28},
      {"serpent", NULL, {STEP, BENT}, 37},
      {"serpent", NULL, {STEP, WAVED}, 27},
      {"serpent", NULL, {STEP, COILED}, 30}},
     PAPER},
    {"fiber-08",
     2,
     {{"bunny", NULL, {STEP, COILED, "length=20"}, 71},
      {"bunny", NULL, {STEP, COILED, "length=5"}, 17}},
     PAPER},
    {"fiber-09",
     2,
     {{"bunny", NULL, {"halvings=0", "step=0.5", COILED, "count=1024"}, 31},
      {"bunny", NULL, {"halvings=0", "step=0.5", COILED, "count=512"}, 32}},
     PAPER},
    {"fiber-dust",
     1,
     {{"lump:8",
       "dust",
       {"count=1500", "length=11", "diameter=26", "contact=bend", "rounds=10"},
       0}},
     VIEW(480, 40, "35,14,20")},
    {"fiber-felt",
     1,
     {{"box:7x1.2x7", "felt", {"count=0", "length=5", "vertices=48", "packing=0.1"}, 0}},
     VIEW(480, 32, "35,35,20")},
    {"fiber-cotton",
     1,
     {{"lump:4", "cotton", {"count=1800", "length=10", "vertices=48"}, 0}},
     WHITE},
    {"fiber-wool",
     1,
     {{"lump:5", "wool_merino", {"count=700", "length=20", "vertices=80"}, 0}},
     WHITE},
};

static bool draw_row(session *s, const char *folder, const char *name, json *j, failure *why) {
  const row *r = rows;
  while (strcmp(r->name, name) != 0) r++;
  const sozai_geometry_1 *table = growth_table(s->plugin.entry, why);
  plate p;
  if (!table || !plate_init(&p, r->panels, r->view.size[0], r->view.size[1], why)) return false;
  bool ok = true;
  json_open(j, "panels", '[');
  for (uint32_t i = 0; ok && i < r->panels; i++)
    ok = draw_panel(s, table, &r->panel[i], &r->view, &p, i, j, why);
  json_close(j, ']');
  ok = ok && plate_write(&p, folder, name, why);
  plate_free(&p);
  return ok;
}

/* ---- figure 2: single strands ------------------------------------------ */

#define SIDE 300u
#define STRANDS 500

static const char *const table_1[10][4] = {
    {"phi_max=0", "phi_min=0", "theta_max=0", "theta_min=0"},
    {"phi_max=0", "phi_min=0", "theta_max=3.6", "theta_min=3.6"},
    {"phi_max=0", "phi_min=0", "theta_max=7.2", "theta_min=7.2"},
    {"phi_max=3.6", "phi_min=3.6", "theta_max=3.6", "theta_min=3.6"},
    {"phi_max=7.2", "phi_min=7.2", "theta_max=3.6", "theta_min=3.6"},
    {"phi_max=10.8", "phi_min=10.8", "theta_max=3.6", "theta_min=3.6"},
    {"phi_max=0", "phi_min=0", "theta_max=3.6", "theta_min=-3.6"},
    {"phi_max=0", "phi_min=0", "theta_max=7.2", "theta_min=-7.2"},
    {"phi_max=0", "phi_min=0", "theta_max=7.2", "theta_min=-3.6"},
    {"phi_max=39.6", "phi_min=21", "theta_max=18", "theta_min=-3.6"}};

/* The direction in which points spread most, square to `not` if given. */
static void widest(const float *p, uint64_t count, const double middle[3], const double *other,
                   double out[3]) {
  double m[3][3] = {{0}};
  for (uint64_t i = 0; i < count; i++) {
    double d[3], along = 0;
    for (int a = 0; a < 3; a++) d[a] = (double)p[3 * i + (uint64_t)a] - middle[a];
    for (int a = 0; other && a < 3; a++) along += d[a] * other[a];
    for (int a = 0; other && a < 3; a++) d[a] -= along * other[a];
    for (int a = 0; a < 3; a++)
      for (int b = 0; b < 3; b++) m[a][b] += d[a] * d[b];
  }
  double v[3] = {0.57, 0.61, 0.55};
  for (int k = 0; k < 200; k++) {
    double n[3] = {0, 0, 0}, l = 0;
    for (int a = 0; a < 3; a++) {
      for (int b = 0; b < 3; b++) n[a] += m[a][b] * v[b];
      l += n[a] * n[a];
    }
    for (int a = 0; l > 1e-18 && a < 3; a++) v[a] = n[a] / sqrt(l);
  }
  memcpy(out, v, sizeof v);
}

static void plot_strand(chart *c, const float *p, uint64_t count) {
  double middle[3] = {0, 0, 0}, up[3], side[3], last[2] = {0, 0};
  for (uint64_t i = 0; i < 3 * count; i++) middle[i % 3] += (double)p[i] / (double)count;
  widest(p, count, middle, NULL, up);
  widest(p, count, middle, up, side);
  for (uint64_t i = 0; i < count; i++) {
    double at[2] = {0, 0};
    for (uint64_t a = 0; a < 3; a++) {
      at[0] += ((double)p[3 * i + a] - middle[a]) * side[a];
      at[1] += ((double)p[3 * i + a] - middle[a]) * up[a];
    }
    if (i) chart_line(c, last[0], last[1], at[0], at[1], 3, 1);
    memcpy(last, at, sizeof at);
  }
}

static double end_to_end(const sozai_curves *c) {
  double sum = 0;
  for (uint64_t i = 0; i < c->curve_count; i++) {
    const float *a = c->points + 3 * c->first[i], *b = c->points + 3 * (c->first[i + 1] - 1);
    double square = 0;
    for (int k = 0; k < 3; k++)
      square += ((double)b[k] - (double)a[k]) * ((double)b[k] - (double)a[k]);
    sum += sqrt(square) / 10 / (double)c->curve_count;
  }
  return sum;
}

static bool draw_strand(session *s, const sozai_geometry_1 *table, int k, plate *p, json *j,
                        failure *why) {
  panel one = {.hull = "box:400x400x400", .values = {"count=500", "iterations=0"}};
  for (int i = 0; i < 4; i++) one.values[2 + i] = table_1[k][i];
  sozai_geometry *g = NULL;
  const sozai_curves *c = NULL;
  chart plot;
  if (!grow_panel(s, table, &one, &g, why)) return false;
  int32_t code = table->curves(g, NULL, &c);
  bool ok =
      code == SOZAI_OK ? chart_init(&plot, SIDE / 2, SIDE, why) : growth_failed(table, code, why);
  if (ok) {
    plot.low[0] = -3, plot.high[0] = 3, plot.low[1] = -6, plot.high[1] = 6;
    plot_strand(&plot, c->points + 3 * c->first[3], c->first[4] - c->first[3]);
    plate_ink(p, (uint32_t)k, plot.share);
    chart_free(&plot);
    json_open(j, NULL, '{');
    const char name[2] = {(char)('a' + k), 0};
    json_text(j, "row", name);
    json_number(j, "end_to_end", end_to_end(c));
    json_close(j, '}');
  }
  table->release_curves(c);
  table->release(g);
  return ok;
}

static bool draw_strands(session *s, const char *folder, const char *name, json *j, failure *why) {
  const sozai_geometry_1 *table = growth_table(s->plugin.entry, why);
  plate p;
  if (!table || !plate_init(&p, 10, SIDE / 2, SIDE, why)) return false;
  bool ok = true;
  json_open(j, "strands", '[');
  for (int k = 0; ok && k < 10; k++) ok = draw_strand(s, table, k, &p, j, why);
  json_close(j, ']');
  ok = ok && plate_write(&p, folder, name, why);
  plate_free(&p);
  return ok;
}

const figure fiber_figures[] = {
    {"fiber-02", "Strands of table 1, a to j", draw_strands},
    {"fiber-04", "First placement, and after fitting", draw_row},
    {"fiber-06", "After 5, 10, 15 and 20 iterations, literally as the paper", draw_row},
    {"fiber-07-bunny", "Crimps a to d", draw_row},
    {"fiber-07-serpent", "Crimps e to h, in a tube", draw_row},
    {"fiber-08", "Lengths 20 and 5", draw_row},
    {"fiber-09", "1024 and 512 strands", draw_row},
    {"fiber-dust", "A dust bunny, 16 mm", draw_row},
    {"fiber-felt", "A felt swatch of 7 mm", draw_row},
    {"fiber-cotton", "A lock of cotton, 8 mm", draw_row},
    {"fiber-wool", "A tuft of Merino, 10 mm", draw_row},
};
const size_t fiber_figure_count = sizeof fiber_figures / sizeof fiber_figures[0];
