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
  uint32_t first, components; /* of the channel */
  float *values;
  int32_t *results; /* one to a row: no thread writes another's */
} row_job;

void board_init(board *b, const sozai_textures_1 *textures, const host *h, uint32_t width,
                uint32_t height, double pixel) {
  double step = ceil(sqrt((double)width * height / MOST_POINTS));
  *b = (board){textures, h, width, height, pixel, step < 1 ? 1 : (uint32_t)step, 1};
}

static uint32_t columns_of(const board *b) { return (b->width + b->step - 1) / b->step; }
static uint32_t rows_of(const board *b) { return (b->height + b->step - 1) / b->step; }

uint64_t board_points(const board *b) { return (uint64_t)columns_of(b) * rows_of(b) * b->faces; }

/* Mm: from one face to the next. */
static double aside(const board *b) { return 1.5 * b->width * b->pixel; }

static void fill_row(const row_job *job, uint32_t row, float *in) {
  const board *b = job->board;
  size_t n = job->columns;
  memset(in, 0, INPUTS * n * sizeof *in);
  double y = (0.5 * b->height - (double)(row % rows_of(b)) * b->step - 0.5) * b->pixel;
  double x = aside(b) * (row / rows_of(b));
  for (size_t i = 0; i < n; i++) {
    in[i] = (float)(((double)(i * b->step) + 0.5 - 0.5 * b->width) * b->pixel + x);
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
  size_t components = job->components;
  float *in = malloc((INPUTS + components) * n * sizeof *in);
  float **out = calloc(job->first + components, sizeof *out);
  if (in && out) {
    fill_row(job, row, in);
    sozai_batch batch = {.size = sizeof batch,
                         .count = job->columns,
                         .footprint = in + 6 * n,
                         .out = out,
                         .out_count = job->first + job->components};
    for (size_t k = 0; k < 3; k++) {
      batch.point[k] = in + k * n;
      batch.normal[k] = in + (3 + k) * n;
    }
    for (size_t k = 0; k < components; k++) out[job->first + k] = in + (INPUTS + k) * n;
    job->results[row] = job->board->textures->evaluate(job->texture, &batch);
    for (size_t i = 0; i < components * n; i++)
      job->values[row * components * n + i] = in[(INPUTS + i % components) * n + i / components];
  }
  free(in);
  free(out);
}

static const sozai_channel *find_channel(const sozai_texture_info *info, const char *id,
                                         failure *why) {
  for (uint32_t i = 0; i < info->channel_count; i++)
    if (strcmp(info->channels[i]->id, id) == 0) return info->channels[i];
  fail(why, EXIT_FAILURE, "%s has no channel %s", info->id, id);
  return NULL;
}

static bool evaluate(row_job *job, failure *why) {
  const board *b = job->board;
  uint32_t rows = rows_of(b) * b->faces;
  job->results = calloc(rows, sizeof *job->results);
  if (!job->results) return fail(why, EXIT_FAILURE, "out of memory");
  parallel_for(b->host->threads, rows, evaluate_row, job);
  bool ok = true;
  for (uint32_t row = 0; ok && row < rows; row++)
    ok = job->results[row] == SOZAI_OK ||
         fail(why, EXIT_FAILURE, "%s",
              job->results[row] == SOZAI_ERROR_CANCELLED ? "cancelled" : "evaluate failed");
  free(job->results);
  return ok;
}

bool board_channel(const board *b, recipe *r, const char *channel, float **out, failure *why) {
  sozai_texture *texture = NULL;
  *out = NULL;
  if (!recipe_create(r, b->textures, &b->host->abi, &texture, why)) return false;
  row_job job = {.board = b, .texture = texture, .columns = columns_of(b)};
  const sozai_channel *c = find_channel(b->textures->info_of(texture), channel, why);
  bool ok = c != NULL;
  if (ok) {
    job.first = c->first;
    job.components = c->components;
    job.values = malloc(c->components * board_points(b) * sizeof(float));
    ok = job.values ? evaluate(&job, why) : fail(why, EXIT_FAILURE, "out of memory");
  }
  b->textures->destroy(texture);
  if (ok)
    *out = job.values;
  else
    free(job.values);
  return ok;
}
