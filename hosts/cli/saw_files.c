/* SPDX-License-Identifier: Apache-2.0
 *
 * A sawing plan as files: a recipe for every board, and what is known of them. */
#include "saw.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "json.h"
#include "quoted.h"

static const char *const cut_names[SAW_PLANS] = {"flat", "quarter", "rift", "rotary"};

/* Without the last digits of a sine, nor a minus before a zero. */
static double tidy(double x) { return round(x * 1e9) / 1e9 + 0.0; }

saw_cut saw_cut_of(const saw_work *w, const saw_board *b) {
  double along[2], out[2];
  saw_board_axes(b, along, out);
  double a = b->centre[0] * along[0] + b->centre[1] * along[1];
  double q = b->centre[0] * out[0] + b->centre[1] * out[1];
  saw_cut c = {.name = cut_names[b->plan],
               .height = 0.5 * w->log.length,
               .rotation = tidy(remainder(b->rotation, 360))};
  /* what cut_distance alone places, and what is left for cut_offset */
  double placed[2] = {0, 0};
  if (b->plan == SAW_LIVE) placed[1] = q;
  if (b->plan == SAW_QUARTER) placed[0] = a;
  if (b->plan == SAW_RIFT) placed[0] = placed[1] = 0.5 * (a + q);
  c.distance = tidy(b->plan == SAW_LIVE      ? q
                    : b->plan == SAW_QUARTER ? a
                    : b->plan == SAW_RIFT    ? (a + q) * sqrt(0.5)
                                             : hypot(b->centre[0], b->centre[1]));
  if (b->plan == SAW_ROTARY) return c;
  for (int i = 0; i < 2; i++)
    c.offset[2 * i] = tidy((a - placed[0]) * along[i] + (q - placed[1]) * out[i]);
  return c;
}

void saw_board_file(const saw_work *w, size_t i, char out[64]) {
  snprintf(out, 64, "board-%0*zu.sozai", w->plan.count > 99 ? 3 : 2, i + 1);
}

static FILE *open_file(const saw_folder *f, const char *name, failure *why) {
  char path[FOLDER_PATH];
  if (!saw_folder_file(f, name, path, why)) return NULL;
  FILE *to = fopen(path, "wbe");
  if (!to) fail(why, EXIT_FAILURE, "cannot write '%s': %s", path, strerror(errno));
  return to;
}

static bool close_file(const saw_folder *f, FILE *to, const char *name, failure *why) {
  bool bad = ferror(to) != 0;
  bad |= fclose(to) != 0;
  return !bad ||
         fail(why, EXIT_FAILURE, "cannot write '%s/%s': %s", f->path, name, strerror(errno));
}

/* ---- a board's recipe ---------------------------------------------------- */

static void put_number(FILE *to, const char *id, double number) {
  char text[40];
  number_text(text, sizeof text, number);
  fprintf(to, "  %s: %s\n", id, text);
}

static void put_list(FILE *to, const char *id, const double number[3]) {
  fprintf(to, "  %s: [", id);
  for (int i = 0; i < 3; i++) {
    char text[40];
    number_text(text, sizeof text, number[i]);
    fprintf(to, "%s%s", i ? ", " : "", text);
  }
  fputs("]\n", to);
}

static bool write_board(const saw_work *w, size_t i, const saw_folder *f, failure *why) {
  char name[64];
  saw_board_file(w, i, name);
  FILE *to = open_file(f, name, why);
  if (!to) return false;
  const saw_board *b = &w->plan.boards[i];
  saw_cut c = saw_cut_of(w, b);
  bool sheet = b->plan == SAW_ROTARY;
  fprintf(to, "# %s %zu of %zu, %s-sawn\nmaterial: wood\npreset: ", sheet ? "Sheet" : "Board",
          i + 1, w->plan.count, saw_plan_names[b->plan]);
  print_quoted(to, w->wood->preset);
  fputs("\nparams:\n", to);
  for (size_t k = 0; k < w->wood->param_count; k++) {
    fprintf(to, "  %s: ", w->wood->params[k].id);
    print_quoted(to, w->wood->params[k].text);
    fputc('\n', to);
  }
  fprintf(to, "  cut: %s\n", c.name);
  put_number(to, "cut_distance", c.distance);
  put_number(to, "cut_height", c.height);
  put_number(to, "cut_rotation", c.rotation);
  put_number(to, "cut_tilt", 0);
  put_number(to, "cut_skew", 0);
  if (sheet)
    put_number(to, "veneer_thickness", b->thickness);
  else
    put_list(to, "cut_offset", c.offset);
  const double size[3] = {tidy(b->width), w->log.length, b->thickness};
  fprintf(to, "surface:\n  shape: %s\n", sheet ? "plane" : "board");
  put_list(to, "size", size);
  return close_file(f, to, name, why);
}

/* ---- the plan ------------------------------------------------------------- */

static void put_array(json *j, const char *key, const double *number, int count) {
  json_open(j, key, '[');
  for (int i = 0; i < count; i++) json_number(j, NULL, number[i]);
  json_close(j, ']');
}

static void put_board(json *j, const saw_work *w, size_t i) {
  const saw_board *b = &w->plan.boards[i];
  saw_cut c = saw_cut_of(w, b);
  char name[64];
  saw_board_file(w, i, name);
  json_open(j, NULL, '{');
  json_number(j, "board", (double)(i + 1));
  json_text(j, "file", name);
  json_text(j, "cut", c.name);
  json_number(j, "cut_distance", c.distance);
  json_number(j, "cut_height", c.height);
  json_number(j, "cut_rotation", c.rotation);
  put_array(j, "cut_offset", c.offset, 3);
  put_array(j, "size", (const double[3]){tidy(b->width), w->log.length, b->thickness}, 3);
  put_array(j, "middle",
            (const double[3]){tidy(b->centre[0]), 0.5 * w->log.length, tidy(b->centre[1])}, 3);
  if (b->plan == SAW_ROTARY) put_array(j, "knife_radius", (const double[2]){b->from, b->to}, 2);
  json_number(j, "knots", w->crossing[i]);
  json_number(j, "knot_share", w->share[i]);
  json_close(j, '}');
}

static bool write_plan(const saw_work *w, const saw_folder *f, failure *why) {
  FILE *to = open_file(f, "saw.json", why);
  if (!to) return false;
  const saw_options *o = &w->options;
  json j = {.to = to, .first = true};
  json_open(&j, NULL, '{');
  json_text(&j, "species", o->species ? o->species : "");
  if (o->field) json_text(&j, "field", o->field);
  json_number(&j, "age", o->age);
  json_number(&j, "seed", o->seed);
  json_text(&j, "wood", w->wood->preset);
  json_text(&j, "plan", saw_plan_names[w->job.plan]);
  json_number(&j, "log_height", w->log.base);
  json_number(&j, "log_length", w->log.length);
  json_number(&j, "radius_lower", w->lower);
  json_number(&j, "radius_upper", w->job.radius);
  json_number(&j, "thickness", w->job.thickness);
  json_number(&j, "kerf", w->job.kerf);
  json_number(&j, "azimuth", w->job.azimuth);
  json_number(&j, "yield_percent", w->yield);
  json_open(&j, "boards", '[');
  for (size_t i = 0; i < w->plan.count; i++) put_board(&j, w, i);
  json_close(&j, ']');
  json_close(&j, '}');
  fputc('\n', to);
  return close_file(f, to, "saw.json", why);
}

bool saw_write_files(const saw_work *w, const saw_folder *f, failure *why) {
  for (size_t i = 0; i < w->plan.count; i++)
    if (!write_board(w, i, f, why)) return false;
  return write_plan(w, f, why);
}
