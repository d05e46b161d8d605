/* SPDX-License-Identifier: Apache-2.0 */
#include "describe_job.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "checksum.h"
#include "display.h"

/* ---- the job ------------------------------------------------------------------- */

/* One line: what a text has of line breaks does not break it. */
static void print_text(FILE *to, const char *text) {
  for (; text && *text; text++) fputc(*text == '\n' || *text == '\r' ? ' ' : *text, to);
}

/* A parameter's picture is "PATH @ SPACE, ..."; of any other path all is path. */
static void print_file(FILE *to, const char *text) {
  char path[4096];
  const char *at = strstr(text, " @ ");
  size_t length = at ? (size_t)(at - text) : strlen(text);
  uint64_t sum;
  if (length == 0 || length >= sizeof path) return;
  memcpy(path, text, length);
  path[length] = '\0';
  if (checksum_file(path, &sum)) fprintf(to, " (%016" PRIx64 ")", sum);
}

static void print_value(FILE *to, const sozai_parameter *p, const sozai_value *v) {
  fprintf(to, "%s: ", p->id);
  switch (p->kind) {
  case SOZAI_KIND_FLOAT3:
  case SOZAI_KIND_COLOUR:
    fprintf(to, "%.17g %.17g %.17g ", v->number[0], v->number[1], v->number[2]);
    print_text(to, v->text);
    break;
  case SOZAI_KIND_PATH:
  case SOZAI_KIND_IMAGE:
    print_text(to, v->text);
    if (v->text) print_file(to, v->text);
    break;
  case SOZAI_KIND_CHOICE:
  case SOZAI_KIND_TEXT:
    print_text(to, v->text);
    break;
  default:
    fprintf(to, "%.17g", v->number[0]);
  }
  fputc('\n', to);
}

static void print_material(FILE *to, const bake_job *job) {
  const sozai_texture_info *info = job->textures->info_of(job->texture);
  fprintf(to, "material: %s %u\n", info->id, info->revision);
  for (uint32_t i = 0; i < info->parameter_count; i++) {
    sozai_value v = {0};
    if (job->textures->value(job->texture, info->parameters[i]->id, &v) == SOZAI_OK)
      print_value(to, info->parameters[i], &v);
  }
}

/* As it was read, and not its file: a glTF's points are in files beside it. */
static uint64_t sum_mesh(const mesh *m) {
  size_t points = m->point_count, corners = 3 * (size_t)m->triangle_count;
  uint64_t sum = checksum_bytes(0, m->points, 3 * points * sizeof *m->points);
  sum = checksum_bytes(sum, m->normals, 3 * points * sizeof *m->normals);
  sum = checksum_bytes(sum, m->uvs, 2 * points * sizeof *m->uvs);
  return checksum_bytes(sum, m->indices, corners * sizeof *m->indices);
}

static void print_ground(FILE *to, const bake_job *job) {
  const surface_shape *shape = surface_shape_of(job->ground->surface);
  const recipe_surface *asked = &job->recipe->surface;
  fprintf(to, "surface: %d, %.17g x %.17g mm", asked->shape, shape->size[0], shape->size[1]);
  fprintf(to, ", thickness %.17g, wrap %d\n", asked->size[2], job->recipe->image.wrap);
  if (shape->samples > 1) fprintf(to, "samples: %u\n", shape->samples);
  if (!job->ground->atlas) return;
  fprintf(to, "mesh: %016" PRIx64 ", scale %.17g\ntiles:", sum_mesh(atlas_mesh(job->ground->atlas)),
          asked->scale);
  for (uint32_t i = 0; i < job->ground->count; i++) fprintf(to, " %d", job->ground->tiles[i]);
  fputc('\n', to);
}

static void print_files(FILE *to, const bake_job *job) {
  const bake_outputs *o = job->outputs;
  uint64_t sum;
  for (uint32_t i = 0; i < o->file_count; i++) {
    fprintf(to, "file %u:", i);
    for (uint32_t k = 0; k < o->files[i].layer_count; k++) {
      const bake_layer *l = &o->files[i].layers[k];
      fprintf(to, " %s=%u/%d/%d", l->name, l->component, l->type, l->code);
    }
    fputc('\n', to);
  }
  const char *working = "";
  float xy[8];
  display_working(job->colour, &working, xy);
  fprintf(to, "colour: from %s to %s", working, o->space ? o->space : working);
  const sozai_colour_1 *s = job->colour->service;
  if (s && checksum_file(s->config_name(s->self), &sum)) fprintf(to, " (%016" PRIx64 ")", sum);
  fputc('\n', to);
}

char *bake_describe_job(const bake_job *job, const bake_plan *plan, failure *why) {
  char *text = NULL;
  size_t size = 0;
  FILE *to = open_memstream(&text, &size);
  bool ok = to != NULL;
  if (to) {
    fprintf(to, "sozai bake: 1\npicture: %u x %u, %u levels, bands of %u, tiles of %u\n",
            plan->width, plan->height, plan->level_count, plan->band, job->tile);
    print_files(to, job);
    print_ground(to, job);
    print_material(to, job);
    if (fclose(to) != 0 && ok) ok = fail(why, EXIT_FAILURE, "out of memory");
  } else
    fail(why, EXIT_FAILURE, "out of memory");
  if (ok) return text;
  free(text);
  return NULL;
}

/* ---- the files ------------------------------------------------------------------- */

static void describe_colour(const bake_job *job, image_colour *to, float xy[8]) {
  const bake_outputs *o = job->outputs;
  const sozai_display_1 *d = job->colour->display;
  if (!o->space) {
    if (display_working(job->colour, &to->space, xy)) to->chromaticities = xy;
    return;
  }
  to->space = o->space;
  to->srgb = strcasecmp(o->space, "sRGB") == 0;
  if (d && d->chromaticities(d->self, o->space, xy, NULL, 0) == SOZAI_OK) to->chromaticities = xy;
}

static void add_word(writer_spec *spec, bake_words *words, const char *name, const char *text) {
  if (text && *text) words->words[spec->word_count++] = (bake_word){name, text};
}

void bake_describe_file(const bake_job *job, const bake_file *file, writer_spec *spec,
                        bake_words *words) {
  static const char *const wraps[] = {NULL, "black,black", "clamp,clamp", "periodic,periodic",
                                      "mirror,mirror"};
  const surface_shape *shape = surface_shape_of(job->ground->surface);
  const char *wrap = job->ground->atlas ? "clamp,clamp" : wraps[job->recipe->image.wrap];
  spec->colour = (image_colour){0};
  if (file->colours) describe_colour(job, &spec->colour, words->xy);
  spec->words = words->words;
  spec->word_count = 0;
  add_word(spec, words, "sozai_material", job->recipe->material);
  add_word(spec, words, "sozai_preset", job->recipe->preset);
  add_word(spec, words, "sozai_output", file->output);
  add_word(spec, words, "wrapmodes", wrap);
  if (spec->level_count > 1) add_word(spec, words, "textureformat", "Plain Texture");
  for (int k = 0; k < 2; k++) spec->mm_per_pixel[k] = (float)(shape->size[k] / shape->pixels[k]);
}
