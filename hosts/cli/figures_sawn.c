/* SPDX-License-Identifier: Apache-2.0 */
#include "figures_sawn.h"

#include <math.h>
#include <stdlib.h>
#include "face.h"
#include "growth.h"
#include "plate.h"
#include "tree_view.h"

#define WIDTH 420u
#define HEIGHT 900u
#define PIXEL 0.75 /* mm, of the boards */
#define LOW 5000.0 /* mm up the stem, where the boards' middle is */
#define AGE "45"

/* The same stem three times: what `sozai saw` would cut through its heart, beside
 * it, and across. */
typedef struct board {
  const char *name, *cut, *distance;
} board;
static const board boards[] = {
    {"flat", "cut=flat", "cut_distance=60"},
    {"quarter", "cut=quarter", "cut_distance=100"},
    {"end", "cut=end", "cut_distance=0"},
};
#define BOARDS (sizeof boards / sizeof *boards)

static bool paint_tree(plate *p, const sozai_mesh *m, session *s, failure *why) {
  const tree_view view = {.size = {WIDTH, HEIGHT}, .spp = 16, .camera = "25,4,20", .zoom = 1.1};
  film f;
  if (!tree_view_render(&view, m, s, &f, why)) return false;
  size_t n = (size_t)f.width * f.height;
  float *planes = malloc(3 * n * sizeof *planes);
  bool ok = planes != NULL;
  if (!ok) fail(why, EXIT_FAILURE, "out of memory");
  if (ok) {
    float *rgb[3] = {planes, planes + n, planes + 2 * n};
    for (size_t i = 0; i < 3 * n; i++) rgb[i % 3][i / 3] = f.beauty[i];
    ok = plate_colour(p, 0, rgb, s, why);
  }
  free(planes);
  film_free(&f);
  return ok;
}

/* The branches that the generator says cross the flat board, against what is seen
 * there: a knot, and its pith at most 0.5 mm away. */
static void count_crossings(const face *f, const sozai_table *knots, json *j, failure *why) {
  const float *knot = face_channel(f, "knot", why), *reference = face_channel(f, "reference", why);
  if (!knot || !reference) return;
  size_t first = 0;
  while (f->components[first] != reference) first++;
  const float *across = f->components[first + 1];
  int said = 0, seen = 0;
  double off = 0;
  for (uint64_t i = 0; i < knots->rows; i++) {
    double azimuth = growth_number(knots, i, "azimuth"), z = f->view.centre[2] + 60;
    double u = z / sin(azimuth), x = u * cos(azimuth);
    double y =
        growth_number(knots, i, "height") - LOW + u * tan(growth_number(knots, i, "inclination"));
    int column = (int)floor(x / PIXEL + 0.5 * WIDTH), row = (int)floor(0.5 * HEIGHT - y / PIXEL);
    if (u < 0 || u > 150 || column < 0 || row < 0 || column >= (int)WIDTH || row >= (int)HEIGHT)
      continue;
    size_t at = (size_t)row * WIDTH + (size_t)column;
    said++;
    if (knot[at] < 0.5f) continue;
    seen++;
    off = fmax(off, fabs((double)reference[at] + (double)across[at]));
  }
  json_number(j, "branches_that_cross", said);
  json_number(j, "of_which_are_knots", seen);
  json_number(j, "farthest_from_pith_mm", off);
}

static bool paint_board(plate *p, uint32_t panel, const board *b, const sozai_table *knots,
                        session *s, json *j, failure *why) {
  const char *const parameters[] = {"tree=sugi",       "tree_age=" AGE,
                                    "log_height=5000", "pith_wander=0",
                                    "cut_height=0",    "cut_tilt=0",
                                    "cut_skew=0",      b->cut,
                                    b->distance,       NULL};
  const face_view view = {.right = {1, 0, 0},
                          .up = {0, 1, 0},
                          .light = {-0.4, 0.5, 0.77},
                          .width = WIDTH,
                          .height = HEIGHT,
                          .pixel = PIXEL};
  face f;
  if (!face_evaluate(&f, s, "wood", "knotty_sugi", parameters, &view, why)) return false;
  const float *knot = face_channel(&f, "knot", why), *albedo = face_channel(&f, "albedo", why);
  bool ok = knot && albedo;
  if (ok) {
    size_t first = 0, n = (size_t)WIDTH * HEIGHT;
    double share = 0;
    for (size_t i = 0; i < n; i++) share += (double)knot[i] / (double)n;
    while (f.components[first] != albedo) first++;
    json_open(j, b->name, '{');
    json_number(j, "knot_share", share);
    if (panel == 1) count_crossings(&f, knots, j, why);
    json_close(j, '}');
    ok = plate_colour(p, panel, f.components + first, s, why);
  }
  face_free(&f);
  return ok;
}

static bool draw(session *s, const char *folder, const char *name, json *j, failure *why) {
  static const char *const values[] = {"age=" AGE, "seed=1"};
  const sozai_geometry_1 *table = growth_table(s->plugin.entry, why);
  sozai_geometry *g = NULL;
  const sozai_mesh *m = NULL;
  sozai_table knots;
  plate p;
  if (!table || !plate_init(&p, BOARDS + 1, WIDTH, HEIGHT, why)) return false;
  bool ok = growth_grow(table, &s->host.abi, "tree", "sugi", values, 2, NULL, &g, why) &&
            growth_rows(table, g, "knots", &knots, why);
  if (ok) {
    int32_t code = table->mesh(g, NULL, &m);
    ok = code == SOZAI_OK || growth_failed(table, code, why);
  }
  ok = ok && paint_tree(&p, m, s, why);
  if (ok) json_number(j, "knots_in_the_stem", (double)knots.rows);
  for (uint32_t i = 0; ok && i < BOARDS; i++)
    ok = paint_board(&p, i + 1, &boards[i], &knots, s, j, why);
  ok = ok && plate_write(&p, folder, name, why);
  table->release_mesh(m);
  table->release(g);
  plate_free(&p);
  return ok;
}

const figure sawn_figures[] = {
    {"tree-sawn", "A sugi of 45 years, and its stem 5 m up: flat-sawn, quarter-sawn, across",
     draw}};
const size_t sawn_figure_count = sizeof sawn_figures / sizeof *sawn_figures;
