/* SPDX-License-Identifier: Apache-2.0 */
#include "render.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "commands.h"
#include "ending.h"
#include "job_options.h"
#include "output_file.h"
#include "pictures.h"
#include "session.h"
#include "ceilings.h"

#define PICTURE_EXR 0
#define PICTURE_PNG 1

/* What was asked for, as text where it needs more than a number. */
typedef struct request {
  session_options shared;
  job_options look;
  const char *output, *cut, *channels;
  double bevel, scale, zoom, exposure, light_size, sky;
  uint32_t resolution[2], spp, bits;
  bool no_floor;
} request;

static bool picture_kind(const char *path, int *kind, failure *why) {
  if (!path) return fail(why, EXIT_BAD_INPUT, "render: no output is given: -o FILE.exr or .png");
  *kind = ends_in(path, ".exr") ? PICTURE_EXR : PICTURE_PNG;
  if (*kind == PICTURE_EXR || ends_in(path, ".png")) return true;
  return fail(why, EXIT_BAD_INPUT, "--output: '%s' ends neither in .exr nor in .png", path);
}

static bool all_channels(render_job *job, const sozai_texture_info *info) {
  for (uint32_t i = 0; i < info->channel_count && i < RENDER_MOST_CHANNELS; i++)
    job->channels[job->channel_count++] = i;
  return true;
}

/* A mesh's, as said here, else as its .sozai file says. */
static bool fill_scale(render_job *job, const request *q, const recipe *r, failure *why) {
  if (!isnan(q->bevel) && job->shape != SHAPE_BOARD)
    return fail(why, EXIT_BAD_INPUT, "--bevel: only for a board");
  if (q->scale > 0 && job->shape != SHAPE_MESH)
    return fail(why, EXIT_BAD_INPUT, "--scale: only for a mesh's file; see --size");
  job->mesh_scale = q->scale > 0                             ? q->scale
                    : !q->look.shape && r->surface.scale > 0 ? r->surface.scale
                                                             : 1;
  return true;
}

static bool fill_job(render_job *job, const request *q, const recipe *r, int kind,
                     const sozai_texture_info *info, failure *why) {
  if (!isnan(q->bevel)) job->bevel = q->bevel;
  job->zoom = q->zoom;
  job->light_size = q->light_size;
  job->sky = q->sky;
  job->floor = !q->no_floor;
  job->spp = q->spp;
  job->width = q->resolution[0];
  job->height = q->resolution[1];
  if (!job_options_apply(job, &q->look, &r->surface, why) || !fill_scale(job, q, r, why))
    return false;
  if (!q->channels) return kind == PICTURE_PNG || all_channels(job, info); /* a PNG has no layers */
  return session_channels(info, q->channels, job->channels, RENDER_MOST_CHANNELS,
                          &job->channel_count, why);
}

static bool write_picture(const film *f, const session *s, const request *q, int kind,
                          const char *path, failure *why) {
  if (kind == PICTURE_EXR) return film_write_exr(f, path, &s->colour, why);
  return film_write_png(f, path, &s->colour, &s->shown, isnan(q->exposure) ? 0 : q->exposure,
                        q->bits ? q->bits : 8, why);
}

static bool render_to(const render_job *job, const session *s, const request *q, int kind,
                      failure *why) {
  output_file o;
  /* what cannot be written is told before it is rendered, not after */
  if (!pictures_load(why) || !output_begin(&o, q->output, why)) return false;
  film f;
  bool ok = render(job, &f, why);
  if (ok) {
    ok = write_picture(&f, s, q, kind, o.writing, why);
    film_free(&f);
  }
  if (ok) return output_commit(&o, why);
  return output_failed(&o, why);
}

static bool render_recipe(session *s, recipe *r, const request *q, int kind, failure *why) {
  const sozai_texture_info *info = recipe_info(r, s->plugin.textures, s->plugin.geometry, why);
  sozai_texture *texture = NULL;
  if (!info || !recipe_create(r, s->plugin.textures, &s->host.abi, &texture, why)) return false;
  render_job job;
  render_job_init(&job, s->plugin.textures, texture);
  job.threads = s->host.threads;
  bool ok = fill_job(&job, q, r, kind, info, why) && render_to(&job, s, q, kind, why);
  s->plugin.textures->destroy(texture);
  return ok;
}

static bool saw(recipe *r, const request *q, const session *s, failure *why) {
  if (q->cut) return recipe_set(r, "cut", q->cut, 0, why);
  const sozai_texture_info *info = recipe_info(r, s->plugin.textures, s->plugin.geometry, why);
  return info && session_saw(r, info, q->look.shape ? q->look.shape : "board", why);
}

/* What would have no effect was meant otherwise. */
static bool check(const request *q, int kind, failure *why) {
  const display_choice *shown = &q->shared.shown;
  const struct {
    const char *option;
    bool given;
    int kind; /* of the pictures that it is for */
  } rows[] = {{"channels", q->channels != NULL, PICTURE_EXR},
              {"exposure", !isnan(q->exposure), PICTURE_PNG},
              {"bits", q->bits != 0, PICTURE_PNG},
              {"display", shown->display != NULL, PICTURE_PNG},
              {"view", shown->view != NULL, PICTURE_PNG},
              {"look", shown->look != NULL, PICTURE_PNG}};
  for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
    if (rows[i].given && rows[i].kind != kind)
      return fail(why, EXIT_BAD_INPUT, "--%s: only for %s, which '%s' is not", rows[i].option,
                  kind == PICTURE_PNG ? "an EXR" : "a PNG", q->output);
  if (q->bits != 0 && q->bits != 8 && q->bits != 16)
    return fail(why, EXIT_BAD_INPUT, "--bits: %u is neither 8 nor 16", q->bits);
  for (size_t i = 0; q->cut && i < q->shared.params.count; i++)
    if (strncmp(q->shared.params.items[i], "cut=", 4) == 0)
      return fail(why, EXIT_BAD_INPUT, "--cut: '%s' and -p %s say it twice", q->cut,
                  q->shared.params.items[i]);
  return true;
}

static bool render_named(const char *name, const request *q, failure *why) {
  session s;
  recipe r;
  int kind = PICTURE_EXR;
  if (!picture_kind(q->output, &kind, why) || !check(q, kind, why) ||
      !session_open(&s, &q->shared, why))
    return false;
  bool ok = session_recipe(&r, name, &q->shared, why);
  if (ok) {
    ok = saw(&r, q, &s, why) && render_recipe(&s, &r, q, kind, why);
    recipe_free(&r);
  }
  session_close(&s);
  return ok;
}

int run_render(int argc, char **argv) {
  failure why = {0};
  request q = {.bevel = NAN, .zoom = 1, .light_size = 4, .sky = 1, .spp = 32, .exposure = NAN};
  if (!session_options_init(&q.shared, argc, &why)) return report(&why);
  const option options[] = {
      {"output", 'o', OPTION_TEXT, &q.output, "FILE", "picture to write: .exr (layers) or .png", 0,
       0},
      SESSION_TEXTURE_OPTIONS(q.shared),
      {"shape", 0, OPTION_TEXT, &q.look.shape, "SHAPE",
       "board (default), sphere, plane or a mesh's file", 0, 0},
      {"size", 0, OPTION_TEXT, &q.look.size, "WxHxT",
       "in mm: board WxHxT (H along the grain), plane WxH, sphere D", 0, 0},
      {"bevel", 0, OPTION_NUMBER, &q.bevel, "MM", "radius of a board's edges (default: 1)", 0, 1e5},
      {"scale", 0, OPTION_NUMBER, &q.scale, "MM", "mm per unit of a mesh (default: 1)", 1e-6, 1e6},
      {"up", 0, OPTION_TEXT, &q.look.up, "AXIS", "y or z (default: z; for a mesh, y)", 0, 0},
      {"cut", 0, OPTION_TEXT, &q.cut, "CUT",
       "how it lies in the log, as -p cut= (default: flat, " BOARD_FROM_PITH
       " mm from the pith, for a\n"
       "                               board or plane that no file describes, else the\n"
       "                               file's, else log)",
       0, 0},
      {"res", 0, OPTION_SIZE, &q.resolution, "WxH",
       "pixels (default: 1024x768; a face's proportions from the front)", 1, VIEW_MOST_SIDE},
      {"spp", 0, OPTION_COUNT, &q.spp, "N", "samples per pixel (default: 32)", 1,
       VIEW_MOST_SAMPLES},
      {"camera", 0, OPTION_TEXT, &q.look.camera, "VIEW",
       "front, or azimuth,elevation[,angle of view] (default: -32,42,24)", 0, 0},
      {"target", 0, OPTION_TEXT, &q.look.target, "X,Y,Z", "what the camera looks at, in mm", 0, 0},
      {"zoom", 0, OPTION_NUMBER, &q.zoom, "F", "magnify about the picture's middle", 1e-3, 1e6},
      {"light", 0, OPTION_TEXT, &q.look.light, "AZ,EL",
       "where the key light stands, in degrees (default: 75,48)", 0, 0},
      {"light-size", 0, OPTION_NUMBER, &q.light_size, "DEG",
       "how far across it is: softness of the shadow (default: 4)", 0, 60},
      {"sky", 0, OPTION_NUMBER, &q.sky, "F", "strength of the sky (default: 1)", 0, 1000},
      {"no-floor", 0, OPTION_FLAG, &q.no_floor, NULL, "no floor and no backdrop", 0, 0},
      {"channels", 0, OPTION_TEXT, &q.channels, "A,B", "layers of an EXR (default: all)", 0, 0},
      SESSION_DISPLAY_OPTIONS(q.shared),
      {"exposure", 0, OPTION_NUMBER, &q.exposure, "EV", "stops brighter, for PNG (default: 0)", -30,
       30},
      {"bits", 0, OPTION_COUNT, &q.bits, "N", "8 or 16 to a channel, for PNG (default: 8)", 8, 16},
      SESSION_RUN_OPTIONS(q.shared)};
  static const char *const positional[] = {"material or .sozai file"};
  const command_line line = {
      .usage = "render <material|file.sozai> -o FILE [options]",
      .about = "Renders a material in a small studio.\n\n"
               "Azimuths turn from +x, counter-clockwise seen from above; elevations rise from\n"
               "the floor. A board lies with its length along +y and its face up, along +z.\n",
      .options = options,
      .option_count = sizeof options / sizeof options[0],
      .positional = positional,
      .positional_count = 1};
  const char *name = NULL;
  int parsed = options_parse(&line, argc, argv, &name, &why);
  int code = 0;
  if (parsed == OPTIONS_BAD || (parsed == OPTIONS_RUN && !render_named(name, &q, &why)))
    code = report(&why);
  session_options_free(&q.shared);
  return code;
}
