/* SPDX-License-Identifier: Apache-2.0 */
#include "face.h"

#include <stdlib.h>
#include <string.h>
#include "parallel.h"

#define INPUTS 10 /* point, normal, light, footprint */

typedef struct row_job {
  const face *face;
  const sozai_textures_1 *textures;
  const sozai_texture *texture;
  int32_t *results; /* one to a row: no thread writes another's */
} row_job;

static void fill_row(const face_view *v, uint32_t row, float *in) {
  const double n[3] = {v->right[1] * v->up[2] - v->right[2] * v->up[1],
                       v->right[2] * v->up[0] - v->right[0] * v->up[2],
                       v->right[0] * v->up[1] - v->right[1] * v->up[0]};
  double b = (0.5 * v->height - row - 0.5) * v->pixel;
  for (uint32_t x = 0; x < v->width; x++) {
    double a = (x + 0.5 - 0.5 * v->width) * v->pixel;
    for (int c = 0; c < 3; c++) {
      in[(size_t)c * v->width + x] = (float)(v->centre[c] + a * v->right[c] + b * v->up[c]);
      in[(size_t)(c + 3) * v->width + x] = (float)n[c];
      in[(size_t)(c + 6) * v->width + x] = (float)v->light[c];
    }
    in[(size_t)9 * v->width + x] = (float)v->pixel;
  }
}

static void evaluate_row(void *context, uint32_t row) {
  const row_job *job = context;
  const face *f = job->face;
  size_t width = f->view.width;
  float *in = malloc(INPUTS * width * sizeof *in);
  float **out = malloc(f->info->component_count * sizeof *out);
  job->results[row] = SOZAI_ERROR_MEMORY;
  if (in && out) {
    fill_row(&f->view, row, in);
    for (uint32_t k = 0; k < f->info->component_count; k++) out[k] = f->components[k] + row * width;
    sozai_batch b = {.size = sizeof b,
                     .count = f->view.width,
                     .footprint = in + 9 * width,
                     .out = out,
                     .out_count = f->info->component_count};
    for (size_t c = 0; c < 3; c++) {
      b.point[c] = in + c * width;
      b.normal[c] = in + (c + 3) * width;
      b.light[c] = in + (c + 6) * width;
    }
    job->results[row] = job->textures->evaluate(job->texture, &b);
  }
  free(in);
  free(out);
}

static bool allocate(face *f, failure *why) {
  size_t pixels = (size_t)f->view.width * f->view.height;
  f->components = calloc(f->info->component_count, sizeof *f->components);
  for (uint32_t k = 0; f->components && k < f->info->component_count; k++) {
    f->components[k] = calloc(pixels, sizeof(float));
    if (!f->components[k]) return fail(why, EXIT_FAILURE, "out of memory");
  }
  return f->components || fail(why, EXIT_FAILURE, "out of memory");
}

static bool evaluate_all(face *f, session *s, const sozai_texture *texture, failure *why) {
  int32_t *results = calloc(f->view.height, sizeof *results);
  if (!results) return fail(why, EXIT_FAILURE, "out of memory");
  row_job job = {f, s->plugin.textures, texture, results};
  parallel_for(s->host.threads, f->view.height, evaluate_row, &job);
  bool ok = true;
  for (uint32_t row = 0; ok && row < f->view.height; row++)
    ok = results[row] == SOZAI_OK || fail(why, EXIT_FAILURE, "evaluate failed: %d", results[row]);
  free(results);
  return ok;
}

bool face_evaluate(face *f, session *s, const char *material, const char *preset,
                   const char *const *parameters, const face_view *view, failure *why) {
  memset(f, 0, sizeof *f);
  f->view = *view;
  recipe r;
  sozai_texture *texture = NULL;
  if (!recipe_open(&r, material, why)) return false;
  bool ok = !preset || recipe_set_preset(&r, preset, why);
  for (; ok && *parameters; parameters++) ok = recipe_set_pair(&r, *parameters, why);
  ok = ok && recipe_create(&r, s->plugin.textures, &s->host.abi, &texture, why);
  recipe_free(&r);
  if (ok) {
    f->info = s->plugin.textures->info_of(texture);
    ok = allocate(f, why) && evaluate_all(f, s, texture, why);
  }
  s->plugin.textures->destroy(texture);
  if (!ok) face_free(f);
  return ok;
}

void face_free(face *f) {
  for (uint32_t k = 0; f->components && k < f->info->component_count; k++) free(f->components[k]);
  free(f->components);
  memset(f, 0, sizeof *f);
}

const float *face_channel(const face *f, const char *id, failure *why) {
  for (uint32_t k = 0; k < f->info->channel_count; k++) {
    const sozai_channel *c = f->info->channels[k];
    if (strcmp(c->id, id) == 0) return f->components[c->first];
  }
  fail(why, EXIT_FAILURE, "%s has no channel %s", f->info->id, id);
  return NULL;
}
