/* SPDX-License-Identifier: Apache-2.0 */
#include "board.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "cancel.h"
#include "parallel.h"

#define MOST_POINTS 400000.0 /* the error of a variance is then well below a percent */
#define INPUTS 7             /* point, normal, footprint */

typedef struct row_job {
  const board *board;
  const sozai_texture *texture;
  uint32_t columns;
  uint32_t first; /* of albedo's components */
  float *rgb;
  int32_t *results; /* one to a row: no thread writes another's */
} row_job;

void board_init(board *b, const sozai_textures_1 *textures, const host *h, uint32_t width,
                uint32_t height, double pixel) {
  double step = ceil(sqrt((double)width * height / MOST_POINTS));
  *b = (board){textures, h, width, height, pixel, step < 1 ? 1 : (uint32_t)step};
}

static uint32_t columns_of(const board *b) { return (b->width + b->step - 1) / b->step; }
static uint32_t rows_of(const board *b) { return (b->height + b->step - 1) / b->step; }

uint64_t board_points(const board *b) { return (uint64_t)columns_of(b) * rows_of(b); }

static void fill_row(const row_job *job, uint32_t row, float *in) {
  const board *b = job->board;
  size_t n = job->columns;
  memset(in, 0, INPUTS * n * sizeof *in);
  double y = (0.5 * b->height - (double)row * b->step - 0.5) * b->pixel;
  for (size_t i = 0; i < n; i++) {
    in[i] = (float)(((double)(i * b->step) + 0.5 - 0.5 * b->width) * b->pixel);
    in[n + i] = (float)y;
    in[5 * n + i] = 1;
    in[6 * n + i] = (float)b->pixel;
  }
}

static void evaluate_row(void *context, uint32_t row) {
  const row_job *job = context;
  size_t n = job->columns;
  job->results[row] = SOZAI_ERROR_CANCELLED;
  if (cancel_requested()) return;
  job->results[row] = SOZAI_ERROR_MEMORY;
  float *in = malloc((INPUTS + 3) * n * sizeof *in);
  float **out = calloc(job->first + 3, sizeof *out);
  if (in && out) {
    fill_row(job, row, in);
    sozai_batch batch = {.size = sizeof batch,
                         .count = job->columns,
                         .footprint = in + 6 * n,
                         .out = out,
                         .out_count = job->first + 3};
    for (size_t k = 0; k < 3; k++) {
      batch.point[k] = in + k * n;
      batch.normal[k] = in + (3 + k) * n;
      out[job->first + k] = in + (INPUTS + k) * n;
    }
    job->results[row] = job->board->textures->evaluate(job->texture, &batch);
    for (size_t i = 0; i < 3 * n; i++)
      job->rgb[(size_t)row * 3 * n + i] = in[(INPUTS + i % 3) * n + i / 3];
  }
  free(in);
  free(out);
}

static bool find_albedo(const sozai_texture_info *info, uint32_t *first, failure *why) {
  for (uint32_t i = 0; i < info->channel_count; i++) {
    const sozai_channel *c = info->channels[i];
    if (strcmp(c->id, "albedo") != 0 || c->components != 3) continue;
    *first = c->first;
    return true;
  }
  return fail(why, EXIT_FAILURE, "%s has no channel albedo", info->id);
}

static bool evaluate(const board *b, const sozai_texture *texture, float *rgb, failure *why) {
  uint32_t rows = rows_of(b);
  row_job job = {.board = b, .texture = texture, .columns = columns_of(b), .rgb = rgb};
  if (!find_albedo(b->textures->info_of(texture), &job.first, why)) return false;
  job.results = calloc(rows, sizeof *job.results);
  if (!job.results) return fail(why, EXIT_FAILURE, "out of memory");
  parallel_for(b->host->threads, rows, evaluate_row, &job);
  bool ok = true;
  for (uint32_t row = 0; ok && row < rows; row++)
    ok = job.results[row] == SOZAI_OK ||
         fail(why, EXIT_FAILURE,
              job.results[row] == SOZAI_ERROR_CANCELLED ? "cancelled" : "evaluate failed");
  free(job.results);
  return ok;
}

bool board_albedo(const board *b, const recipe *r, float **out, failure *why) {
  sozai_texture *texture = NULL;
  *out = NULL;
  if (!recipe_create(r, b->textures, &b->host->abi, &texture, why)) return false;
  float *rgb = malloc(3 * board_points(b) * sizeof *rgb);
  bool ok = rgb ? evaluate(b, texture, rgb, why) : fail(why, EXIT_FAILURE, "out of memory");
  b->textures->destroy(texture);
  if (ok)
    *out = rgb;
  else
    free(rgb);
  return ok;
}
