/* SPDX-License-Identifier: Apache-2.0 */
#include "bake.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "commands.h"
#include "ending.h"
#include "numbers.h"
#include "progress.h"
#include "session.h"
#include "ceilings.h"

/* What was asked for, as text where it needs more than a number. */
#define TILE 64
#define TILE_UNSAID UINT32_MAX

typedef struct request {
  session_options shared;
  const char *output, *outputs, *shape, *size, *resolution, *samples, *space, *shard, *udim;
  double scale;
  uint32_t bits, tile;
  bool mip, resume, merge;
} request;

/* ---- the surface ------------------------------------------------------------- */

static bool set_shape(recipe *r, const char *text, failure *why) {
  recipe_surface *s = &r->surface;
  if (strcmp(text, "plane") == 0 || strcmp(text, "board") == 0) {
    s->shape = *text == 'p' ? RECIPE_PLANE : RECIPE_BOARD;
    return true;
  }
  if (!strchr(text, '.'))
    return fail(why, EXIT_BAD_INPUT, "--shape: '%s' is not plane, board or a mesh's file", text);
  char *path = strdup(text);
  if (!path) return fail(why, EXIT_FAILURE, "out of memory");
  free(s->mesh);
  s->mesh = path;
  s->shape = RECIPE_MESH;
  return true;
}

static bool set_size(recipe *r, const char *text, failure *why) {
  double size[3] = {0};
  size_t count = numbers_read(text, 'x', size, 3);
  bool ok = count >= 2 && r->surface.shape != RECIPE_MESH;
  for (size_t i = 0; ok && i < count; i++) ok = size[i] >= 1e-3 && size[i] <= 1e6;
  if (!ok)
    return fail(why, EXIT_BAD_INPUT,
                "--size: '%s' is not WxH or WxHxT in mm, each from 0.001 to 1000000, of a plane or "
                "a board",
                text);
  if (r->surface.shape == RECIPE_NO_SHAPE) r->surface.shape = RECIPE_PLANE;
  memcpy(r->surface.size, size, sizeof size);
  memset(r->image.size, 0, sizeof r->image.size);
  return true;
}

static bool set_resolution(recipe *r, const char *text, failure *why) {
  double pixels[2] = {0};
  size_t count = numbers_read(text, 'x', pixels, 2);
  bool ok = count > 0;
  for (size_t i = 0; i < count; i++)
    ok = ok && pixels[i] >= 1 && pixels[i] <= BAKE_MOST_SIDE &&
         pixels[i] == (double)(uint32_t)pixels[i];
  if (!ok)
    return fail(why, EXIT_BAD_INPUT, "--res: '%.80s' is not N or WxH, whole numbers from 1 to %d",
                text, BAKE_MOST_SIDE);
  memset(r->image.resolution, 0, sizeof r->image.resolution);
  memcpy(r->image.resolution, pixels, sizeof pixels);
  return true;
}

static bool set_samples(recipe *r, const char *text, failure *why) {
  return recipe_image_set(&r->image, recipe_image_key("samples"), text, why) ||
         fail(why, EXIT_BAD_INPUT, "--samples: '%.40s' is not 1, 2, 4 or 8", text);
}

/* As render does. */
static bool saw(recipe *r, const request *q, const sozai_texture_info *info, failure *why) {
  return session_saw(r, info, q->shape ? q->shape : "plane", why);
}

static bool set_surface(recipe *r, const request *q, failure *why) {
  if (q->shape && !set_shape(r, q->shape, why)) return false;
  if (q->size && !set_size(r, q->size, why)) return false;
  if (q->scale > 0 && r->surface.shape != RECIPE_MESH)
    return fail(why, EXIT_BAD_INPUT, "--scale: only for a mesh's file; see --size");
  if (q->scale > 0) r->surface.scale = q->scale;
  return (!q->resolution || set_resolution(r, q->resolution, why)) &&
         (!q->samples || set_samples(r, q->samples, why));
}

/* ---- the job ------------------------------------------------------------------ */

static bool read_shard(bake_job *job, const request *q, failure *why) {
  job->what = q->merge ? BAKE_MERGE : q->shard ? BAKE_SHARD : BAKE_ALL;
  job->resume = q->resume;
  if (q->merge && (q->shard || q->resume))
    return fail(why, EXIT_BAD_INPUT, "--merge goes with neither --shard nor --resume");
  if (!q->shard) return true;
  double part[2];
  if (numbers_read(q->shard, '/', part, 2) == 2 && part[1] >= 1 && part[1] <= BAKE_MOST_SHARDS &&
      part[0] >= 1 && part[0] <= part[1] && part[0] == (double)(uint32_t)part[0] &&
      part[1] == (double)(uint32_t)part[1]) {
    job->shard = (uint32_t)part[0];
    job->shards = (uint32_t)part[1];
    return true;
  }
  return fail(why, EXIT_BAD_INPUT, "--shard: '%s' is not I/N, I from 1 to N, N to %d", q->shard,
              BAKE_MOST_SHARDS);
}

static bool check_job(const bake_job *job, const request *q, failure *why) {
  const uint32_t *pixels = surface_shape_of(job->ground->surface)->pixels;
  if (pixels[0] > BAKE_MOST_SIDE || pixels[1] > BAKE_MOST_SIDE)
    return fail(why, EXIT_BAD_INPUT, "--res: %ux%u pixels are more than %d a side", pixels[0],
                pixels[1], BAKE_MOST_SIDE);
  if (q->mip && (job->outputs->format != BAKE_EXR || job->tile == 0))
    return fail(why, EXIT_BAD_INPUT, "--mip: only an EXR with tiles holds mipmaps");
  if (q->tile != TILE_UNSAID && q->tile != 0 && job->outputs->format == BAKE_PNG)
    return fail(why, EXIT_BAD_INPUT, "--tile: a PNG has no tiles");
  if (job->tile % 16 != 0)
    return fail(why, EXIT_BAD_INPUT, "--tile: %u is not a multiple of 16", job->tile);
  return true;
}

static void warn_of_mesh(const bake_ground *g) {
  char text[512];
  if (!g->atlas || !atlas_warning(g->atlas, text, sizeof text)) return;
  progress_clear();
  fprintf(stderr, "sozai: warning: %s\n", text);
}

static bool bake_on(bake_job *job, const request *q, failure *why) {
  job->tile = job->outputs->format == BAKE_PNG ? 0 : q->tile == TILE_UNSAID ? TILE : q->tile;
  job->mipmaps = q->mip;
  job->path = q->output;
  if (!read_shard(job, q, why) || !check_job(job, q, why)) return false;
  warn_of_mesh(job->ground);
  return bake_run(job, why);
}

static bool bake_texture(bake_job *job, session *s, const recipe *r, const request *q,
                         failure *why) {
  bool exr = ends_in(q->output, ".exr");
  uint32_t usual = !exr                                     ? 0
                   : r->image.format == RECIPE_FORMAT_HALF  ? 16
                   : r->image.format == RECIPE_FORMAT_FLOAT ? 32
                                                            : 0;
  bake_choice choice = {.path = q->output,
                        .names = q->outputs ? q->outputs : r->image.outputs,
                        .space = q->space,
                        .bits = q->bits ? q->bits : usual,
                        .tangent = r->image.normals == RECIPE_NORMALS_TANGENT};
  bake_outputs outputs;
  if (!bake_outputs_open(&outputs, s->plugin.textures->info_of(job->texture), &choice, &s->colour,
                         why))
    return false;
  bake_ground ground;
  bool ok = bake_ground_open(&ground, r, job->textures, job->texture, q->udim, why);
  if (ok) {
    job->outputs = &outputs;
    job->ground = &ground;
    ok = bake_on(job, q, why);
    bake_ground_close(&ground);
  }
  bake_outputs_close(&outputs);
  return ok;
}

static bool bake_recipe(session *s, recipe *r, const request *q, failure *why) {
  const sozai_texture_info *info = recipe_info(r, s->plugin.textures, s->plugin.geometry, why);
  sozai_texture *texture = NULL;
  if (!info || !set_surface(r, q, why) || !saw(r, q, info, why) ||
      !recipe_create(r, s->plugin.textures, &s->host.abi, &texture, why))
    return false;
  bake_job job = {.textures = s->plugin.textures,
                  .texture = texture,
                  .recipe = r,
                  .colour = &s->colour,
                  .threads = s->host.threads};
  bool ok = bake_texture(&job, s, r, q, why);
  s->plugin.textures->destroy(texture);
  return ok;
}

static bool bake_named(const char *name, const request *q, failure *why) {
  session s;
  recipe r;
  if (!q->output)
    return fail(why, EXIT_BAD_INPUT, "bake: no output is given: -o FILE.exr, .tif or .png");
  if (!session_open(&s, &q->shared, why)) return false;
  bool ok = session_recipe(&r, name, &q->shared, why);
  if (ok) {
    ok = bake_recipe(&s, &r, q, why);
    recipe_free(&r);
  }
  session_close(&s);
  return ok;
}

int run_bake(int argc, char **argv) {
  failure why = {0};
  request q = {.tile = TILE_UNSAID};
  if (!session_options_init(&q.shared, argc, &why)) return report(&why);
  const option options[] = {
      {"output", 'o', OPTION_TEXT, &q.output, "FILE",
       "picture to write: .exr, .tif or .png; with <UDIM> or <output> in it, several", 0, 0},
      SESSION_TEXTURE_OPTIONS(q.shared),
      {"outputs", 0, OPTION_TEXT, &q.outputs, "A,B",
       "albedo,roughness,... (default: EXR all, else albedo)", 0, 0},
      {"shape", 0, OPTION_TEXT, &q.shape, "SHAPE",
       "plane (default), board or a mesh's file; boards and planes are sawn flat without -p cut=",
       0, 0},
      {"size", 0, OPTION_TEXT, &q.size, "WxH[xT]",
       "of a plane or board, in mm (default: 1000x1000)", 0, 0},
      {"scale", 0, OPTION_NUMBER, &q.scale, "MM", "mm per unit of a mesh (default: 1)", 1e-6, 1e6},
      {"res", 0, OPTION_TEXT, &q.resolution, "N or WxH", "pixels (default: 4096 the longer side)",
       0, 0},
      {"samples", 0, OPTION_TEXT, &q.samples, "N",
       "parts of a texel across and down, 1, 2, 4 or 8 (default: 1)", 0, 0},
      {"udim", 0, OPTION_TEXT, &q.udim, "1001,1002", "tiles of a mesh (default: all it has)", 0, 0},
      {"mip", 0, OPTION_FLAG, &q.mip, NULL, "all levels of a mipmap, in an EXR", 0, 0},
      {"tile", 0, OPTION_COUNT, &q.tile, "N",
       "side of the tiles of EXR and TIFF; 0: scanlines (default: 64)", 0, 1024},
      {"bits", 0, OPTION_COUNT, &q.bits, "N",
       "8, 16 or 32 to a number (default: EXR half colours, float else; TIFF 16, PNG 8)", 8, 32},
      {"space", 0, OPTION_TEXT, &q.space, "NAME",
       "colour space of colours (default: working space; sRGB in integers)", 0, 0},
      {"shard", 0, OPTION_TEXT, &q.shard, "I/N", "bake the I-th of N shares, for --merge", 0, 0},
      {"merge", 0, OPTION_FLAG, &q.merge, NULL, "write the picture from the shares", 0, 0},
      {"resume", 0, OPTION_FLAG, &q.resume, NULL,
       "go on where a bake was stopped; a share always does", 0, 0},
      SESSION_RUN_OPTIONS(q.shared)};
  static const char *const positional[] = {"material or .sozai file"};
  const command_line line = {
      .usage = "bake <material|file.sozai> -o FILE [options]",
      .about = "Evaluates a surface into pictures.\n\n"
               "What is finished is kept in the folder FILE.bake until all of it is. --shard I/N\n"
               "bakes a share of the work there, on this machine or another; the same command\n"
               "with --merge in its place writes the picture: the same bytes as in one run.\n",
      .options = options,
      .option_count = sizeof options / sizeof options[0],
      .positional = positional,
      .positional_count = 1};
  const char *name = NULL;
  int parsed = options_parse(&line, argc, argv, &name, &why);
  int code = 0;
  if (parsed == OPTIONS_BAD || (parsed == OPTIONS_RUN && !bake_named(name, &q, &why)))
    code = report(&why);
  session_options_free(&q.shared);
  return code;
}
