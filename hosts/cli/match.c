/* SPDX-License-Identifier: Apache-2.0
 *
 * Proposes a material's palette from a photograph: docs/match.md. */
#include "match.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "commands.h"
#include "ending.h"
#include "match_report.h"
#include "numbers.h"
#include "output_file.h"
#include "session.h"

#define DEFAULT_WIDTH 200 /* mm: a board's, photographed whole */
#define ENDING ".sozai"

typedef struct request {
  session_options shared;
  const char *material, *output, *space, *crop_text;
  double width; /* 0: not said */
  bool even_light;
  uint32_t crop[4];
  const match_material *entry;
} request;

/* ---- what was asked for ------------------------------------------------------ */

static bool find_material(request *q, const sozai_textures_1 *textures, failure *why) {
  char known[256] = "";
  for (uint32_t i = 0; i < match_material_count; i++) {
    const match_material *m = &match_materials[i];
    if (!textures->find(m->id)) continue;
    size_t used = strlen(known);
    snprintf(known + used, sizeof known - used, "%s%s", used ? ", " : "", m->id);
    if (strcmp(m->id, q->material) == 0) q->entry = m;
  }
  return q->entry || fail(why, EXIT_BAD_INPUT, "--material: '%.80s' cannot be matched; %s can",
                          q->material, *known ? known : "nothing");
}

static bool read_crop(request *q, failure *why) {
  double numbers[4];
  bool ok = numbers_read(q->crop_text, ',', numbers, 4) == 4;
  for (int i = 0; ok && i < 4; i++) {
    ok = numbers[i] >= (i < 2 ? 0 : 1) && numbers[i] <= 1e6 &&
         numbers[i] == (double)(uint32_t)numbers[i];
    if (ok) q->crop[i] = (uint32_t)numbers[i];
  }
  return ok || fail(why, EXIT_BAD_INPUT,
                    "--crop: '%s' is not X,Y,WIDTH,HEIGHT, whole numbers of pixels to 1000000",
                    q->crop_text);
}

static bool check_output(const request *q, failure *why) {
  if (!q->output || ends_in(q->output, ENDING)) return true;
  return fail(why, EXIT_BAD_INPUT, "--output: '%s' does not end in " ENDING, q->output);
}

/* ---- writing ------------------------------------------------------------------- */

static bool write_recipe(const request *q, const match_report *r, failure *why) {
  output_file o;
  if (!output_begin(&o, q->output, why)) return false;
  FILE *to = fopen(o.writing, "w");
  bool ok = to || fail(why, EXIT_FAILURE, "cannot write %s: %s", q->output, strerror(errno));
  if (ok) {
    match_write_recipe(to, r);
    ok = !ferror(to);
    ok = fclose(to) == 0 && ok;
    if (!ok) fail(why, EXIT_FAILURE, "cannot write %s: %s", q->output, strerror(errno));
  }
  if (ok) return output_commit(&o, why);
  output_discard(&o);
  return false;
}

/* A folder that cannot be written to is found before the work. */
static bool try_output(const request *q, failure *why) {
  output_file o;
  if (!q->output) return true;
  if (!output_begin(&o, q->output, why)) return false;
  output_discard(&o);
  return true;
}

/* ---- all of it ------------------------------------------------------------------- */

static bool match_photo(const request *q, session *s, recipe *r, photo *p, const char *path,
                        failure *why) {
  double width = q->width > 0 ? q->width : DEFAULT_WIDTH, pixel = width / p->full_width;
  board b;
  match_result result;
  board_init(&b, s->plugin.textures, &s->host, p->width, p->height, pixel);
  if (!match_run(&result, r, q->entry, p, &b, &s->colour, why)) return false;
  const sozai_colour_1 *service = s->colour.service;
  const match_report all = {.result = &result,
                            .recipe = r,
                            .photo = p,
                            .path = path,
                            .working =
                                service ? service->working_space(service->self) : "Linear Rec.709",
                            .width = pixel * p->width,
                            .pixel = pixel,
                            .width_assumed = q->width <= 0};
  if (q->output && !write_recipe(q, &all, why)) return false;
  match_print(stdout, &all, "");
  return output_printed(why);
}

/* As it can be written to a file anywhere. */
static bool open_recipe(recipe *r, const request *q, const sozai_textures_1 *textures,
                        failure *why) {
  if (!recipe_open(r, q->material, why)) return false;
  const char *preset = q->shared.preset;
  bool ok = (!preset || recipe_set_preset(r, preset, why)) &&
            session_params_here(r, &q->shared.params, why) && recipe_settle(r, textures, why) &&
            (!q->output || recipe_is_text(r, why));
  if (!ok) recipe_free(r);
  return ok;
}

static bool match_with(request *q, session *s, const char *path, failure *why) {
  recipe r;
  photo p;
  if (!find_material(q, s->plugin.textures, why) || !try_output(q, why)) return false;
  const photo_options options = {.space = q->space,
                                 .crop = q->crop_text ? q->crop : NULL,
                                 .specks = q->entry->shares[0] != NULL,
                                 .even_light = q->even_light};
  if (!open_recipe(&r, q, s->plugin.textures, why)) return false;
  bool ok = photo_read(&p, path, &options, &s->colour, why);
  if (ok) {
    ok = match_photo(q, s, &r, &p, path, why);
    photo_free(&p);
  }
  recipe_free(&r);
  return ok;
}

static bool match_named(request *q, const char *path, failure *why) {
  session s;
  if (!check_output(q, why) || (q->crop_text && !read_crop(q, why))) return false;
  if (!session_open(&s, &q->shared, why)) return false;
  bool ok = match_with(q, &s, path, why);
  session_close(&s);
  return ok;
}

int run_match(int argc, char **argv) {
  failure why = {0};
  request q = {.material = "wood"};
  if (!session_options_init(&q.shared, argc, &why)) return report(&why);
  const option options[] = {
      {"output", 'o', OPTION_TEXT, &q.output, "FILE", ".sozai file to write", 0, 0},
      {"material", 0, OPTION_TEXT, &q.material, "NAME", "whose palette to propose (default: wood)",
       0, 0},
      SESSION_TEXTURE_OPTIONS(q.shared),
      {"width", 0, OPTION_NUMBER, &q.width, "MM",
       "how much the photograph shows from left to right (default: 200)", 0.1, 100000},
      {"space", 0, OPTION_TEXT, &q.space, "NAME",
       "its colour space (default: what the config's file rules say)", 0, 0},
      {"crop", 0, OPTION_TEXT, &q.crop_text, "X,Y,W,H",
       "the part to go by: pixels from the top left", 0, 0},
      {"even-light", 0, OPTION_FLAG, &q.even_light, NULL,
       "divide out light that varies slowly over it", 0, 0},
      SESSION_RUN_OPTIONS(q.shared)};
  static const char *const positional[] = {"photograph"};
  const command_line line = {
      .usage = "match PHOTO [--material NAME] [-o FILE.sozai] [options]",
      .about =
          "Proposes a material's palette from a photograph: colours with which a face of the\n"
          "photograph's size has its mean and covariance of colour. Prints both for the\n"
          "photograph and for the material with the palette, which -o writes to a file.\n"
          "Of a stone it finds how much its second mineral and its specks cover as well.\n\n"
          "The preset and parameters say how the material is built; a colour, share or brightness\n"
          "among them is kept. Wood is sawn flat unless -p cut= says otherwise.\n",
      .options = options,
      .option_count = sizeof options / sizeof options[0],
      .positional = positional,
      .positional_count = 1};
  const char *path = NULL;
  int parsed = options_parse(&line, argc, argv, &path, &why);
  int code = 0;
  if (parsed == OPTIONS_BAD || (parsed == OPTIONS_RUN && !match_named(&q, path, &why)))
    code = report(&why);
  session_options_free(&q.shared);
  return code;
}
