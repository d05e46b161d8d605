/* SPDX-License-Identifier: Apache-2.0 */
#include "saw_face.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "cancel.h"
#include "parallel.h"

#define BLOCK 512u /* points at once */

typedef struct row_job {
  const saw_face *face;
  float *rgb, *knot;
  uint32_t albedo, knots; /* indices of components */
  int32_t *results;       /* one to a row: no thread writes another's */
} row_job;

static void place_end(const saw_face *f, double x, double y, double point[3], double normal[3]) {
  point[0] = (x - 0.5 * f->width) * f->pixel;
  point[1] = 0;
  point[2] = (0.5 * f->height - y) * f->pixel;
  normal[0] = normal[2] = 0;
  normal[1] = -1;
}

static void place_board(const saw_face *f, double x, double y, double point[3], double normal[3]) {
  const saw_board *b = f->board;
  double along[2], out[2], a = (y - 0.5 * f->height) * f->pixel, t = 0.5 * b->thickness;
  saw_board_axes(b, along, out);
  point[0] = b->centre[0] + a * along[0] + t * out[0];
  point[1] = f->from + x * f->pixel;
  point[2] = b->centre[1] + a * along[1] + t * out[1];
  normal[0] = out[0];
  normal[1] = 0;
  normal[2] = out[1];
}

static void place_sheet(const saw_face *f, double x, double y, double point[3], double normal[3]) {
  const saw_board *b = f->board;
  double peeled = (f->from + x * f->pixel) * b->thickness / SAW_PI;
  double radius = sqrt(fmax(b->from * b->from - peeled, 0));
  double turns = (f->work->job.radius - radius) / b->thickness;
  double a = (0.25 + f->work->job.azimuth / 360 - fmod(turns, 1)) * 2 * SAW_PI;
  point[0] = radius * cos(a);
  point[1] = (f->height - y) * f->pixel;
  point[2] = radius * sin(a);
  normal[0] = cos(a);
  normal[1] = 0;
  normal[2] = sin(a);
}

saw_face saw_end_face(const saw_work *w, uint32_t pixels, double pixel) {
  return (saw_face){
      .width = pixels, .height = pixels, .pixel = pixel, .place = place_end, .work = w};
}

static uint32_t pixels_in(double length, double pixel) {
  return (uint32_t)fmax(1, floor(length / pixel + 0.5));
}

saw_face saw_board_face(const saw_work *w, const saw_board *b, double from, double length,
                        double pixel) {
  bool sheet = b->plan == SAW_ROTARY;
  return (saw_face){.width = pixels_in(length, pixel),
                    .height = pixels_in(sheet ? w->log.length : b->width, pixel),
                    .pixel = pixel,
                    .place = sheet ? place_sheet : place_board,
                    .work = w,
                    .board = b,
                    .from = from};
}

static int32_t evaluate_block(const row_job *job, uint32_t row, uint32_t first, uint32_t count,
                              float *const *out, uint32_t components) {
  const saw_face *f = job->face;
  float in[7][BLOCK];
  for (uint32_t i = 0; i < count; i++) {
    double point[3], normal[3];
    f->place(f, first + i + 0.5, row + 0.5, point, normal);
    for (int c = 0; c < 3; c++) {
      in[c][i] = (float)point[c];
      in[c + 3][i] = (float)normal[c];
    }
    in[6][i] = (float)f->pixel;
  }
  sozai_batch b = {
      .size = sizeof b, .count = count, .footprint = in[6], .out = out, .out_count = components};
  for (int c = 0; c < 3; c++) {
    b.point[c] = in[c];
    b.normal[c] = in[c + 3];
  }
  return f->work->session->plugin.textures->evaluate(f->work->texture, &b);
}

static void evaluate_row(void *context, uint32_t row) {
  const row_job *job = context;
  const saw_face *f = job->face;
  uint32_t components =
      f->work->session->plugin.textures->info_of(f->work->texture)->component_count;
  float rgb[3][BLOCK], knot[BLOCK];
  float **out = calloc(components, sizeof *out);
  job->results[row] = out ? SOZAI_OK : SOZAI_ERROR_MEMORY;
  for (uint32_t first = 0; out && first < f->width && !job->results[row]; first += BLOCK) {
    if (cancel_requested()) break;
    uint32_t count = f->width - first < BLOCK ? f->width - first : BLOCK;
    for (uint32_t c = 0; c < 3; c++) out[job->albedo + c] = job->rgb ? rgb[c] : NULL;
    out[job->knots] = job->knot ? knot : NULL;
    job->results[row] = evaluate_block(job, row, first, count, out, components);
    size_t at = (size_t)row * f->width + first;
    for (uint32_t i = 0; i < count; i++) {
      for (size_t c = 0; job->rgb && c < 3; c++) job->rgb[3 * (at + i) + c] = rgb[c][i];
      if (job->knot) job->knot[at + i] = knot[i];
    }
  }
  free(out);
}

static bool component(const sozai_texture_info *info, const char *id, uint32_t *out, failure *why) {
  for (uint32_t k = 0; k < info->channel_count; k++) {
    if (strcmp(info->channels[k]->id, id) != 0) continue;
    *out = info->channels[k]->first;
    return true;
  }
  return fail(why, EXIT_FAILURE, "%s has no channel %s", info->id, id);
}

bool saw_face_evaluate(const saw_face *f, float *rgb, float *knot, failure *why) {
  row_job job = {.face = f, .rgb = rgb, .knot = knot};
  const sozai_texture_info *info = f->work->session->plugin.textures->info_of(f->work->texture);
  if (!component(info, "albedo", &job.albedo, why) || !component(info, "knot", &job.knots, why))
    return false;
  job.results = calloc(f->height, sizeof *job.results);
  if (!job.results) return fail(why, EXIT_FAILURE, "out of memory");
  parallel_for(f->work->session->host.threads, f->height, evaluate_row, &job);
  bool ok = !cancel_requested() || fail(why, EXIT_FAILURE, "cancelled");
  for (uint32_t row = 0; ok && row < f->height; row++)
    ok = job.results[row] == SOZAI_OK ||
         fail(why, EXIT_FAILURE, "evaluate failed: %d", job.results[row]);
  free(job.results);
  return ok;
}

bool saw_knot_share(const saw_work *w, uint32_t count, float *const point[3], float *knot,
                    failure *why) {
  const sozai_textures_1 *textures = w->session->plugin.textures;
  const sozai_texture_info *info = textures->info_of(w->texture);
  uint32_t at = 0;
  if (!component(info, "knot", &at, why)) return false;
  float **out = calloc(info->component_count, sizeof *out);
  if (!out) return fail(why, EXIT_FAILURE, "out of memory");
  out[at] = knot;
  sozai_batch b = {.size = sizeof b,
                   .count = count,
                   .point = {point[0], point[1], point[2]},
                   .out = out,
                   .out_count = info->component_count};
  int32_t result = count ? textures->evaluate(w->texture, &b) : SOZAI_OK;
  free(out);
  return result == SOZAI_OK || fail(why, EXIT_FAILURE, "evaluate failed: %d", result);
}
