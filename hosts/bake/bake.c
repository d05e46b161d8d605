/* SPDX-License-Identifier: Apache-2.0 */
#include "bake.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "cancel.h"
#include "describe_job.h"
#include "units.h"
#include "merge.h"
#include "names.h"
#include "output_file.h"
#include "pieces.h"
#include "plan.h"
#include "progress.h"

#define BAND_OF_SCANLINES 64
#define BATCH (1u << 18) /* texels evaluated between two looks at the disk */
#define MOST_UNITS 256   /* in a batch */

static bool out_of_memory(failure *why) { return fail(why, EXIT_FAILURE, "out of memory"); }

static bake_plan plan_of(const bake_job *job) {
  const uint32_t *pixels = surface_shape_of(job->ground->surface)->pixels;
  return (bake_plan){.width = pixels[0],
                     .height = pixels[1],
                     .picture_count = job->ground->count,
                     .level_count = job->mipmaps ? bake_plan_levels(pixels[0], pixels[1]) : 1,
                     .band = job->tile > 0 ? job->tile : BAND_OF_SCANLINES};
}

/* ---- evaluating ------------------------------------------------------------- */

typedef struct batch {
  uint64_t index[MOST_UNITS];
  bake_unit units[MOST_UNITS];
  uint8_t *pixels[MOST_UNITS];
  uint32_t count;
} batch;

static void forget(batch *b) {
  for (uint32_t i = 0; i < b->count; i++) free(b->pixels[i]);
  b->count = 0;
}

static bool is_mine(const bake_job *job, uint64_t unit) {
  return job->what != BAKE_SHARD || unit % job->shards == job->shard - 1;
}

/* The next units that are mine and not there yet. */
static bool fill(batch *b, const bake_job *job, const bake_plan *plan, const pieces *p,
                 uint64_t *next, failure *why) {
  uint64_t texels = 0;
  for (; *next < p->unit_count && b->count < MOST_UNITS && texels < BATCH; ++*next) {
    if (!is_mine(job, *next) || pieces_has(p, *next)) continue;
    bake_unit u = bake_plan_unit(plan, *next);
    uint8_t *pixels = malloc((size_t)bake_unit_bytes(job->outputs, &u) + 1);
    if (!pixels) return out_of_memory(why);
    b->index[b->count] = *next;
    b->units[b->count] = u;
    b->pixels[b->count++] = pixels;
    texels += (uint64_t)u.width * u.rows;
  }
  return true;
}

static bool keep(const batch *b, const bake_job *job, pieces *p, failure *why) {
  for (uint32_t i = 0; i < b->count; i++)
    if (!pieces_add(p, b->index[i], b->pixels[i], bake_unit_bytes(job->outputs, &b->units[i]), why))
      return false;
  return true;
}

static uint64_t count_there(const pieces *p) {
  uint64_t count = 0;
  for (uint64_t i = 0; i < p->unit_count; i++) count += pieces_has(p, i);
  return count;
}

static bool cancelled(const pieces *p, failure *why) {
  if (count_there(p) == 0) return fail(why, EXIT_FAILURE, "cancelled; nothing was done yet");
  return fail(why, EXIT_FAILURE, "cancelled; what is done is kept in %s, --resume goes on",
              p->folder);
}

static bool evaluate_missing(const bake_job *job, const bake_plan *plan, pieces *p, failure *why) {
  bake_source source = {job->textures, job->texture, job->ground, job->outputs, job->threads};
  batch *b = calloc(1, sizeof *b);
  bool ok = b ? true : out_of_memory(why);
  for (uint64_t next = 0; ok && next < p->unit_count;) {
    ok = fill(b, job, plan, p, &next, why) &&
         bake_evaluate(&source, b->units, b->count, b->pixels, why) && keep(b, job, p, why);
    forget(b);
    if (cancel_requested()) ok = cancelled(p, why);
    progress_show((float)next / (float)p->unit_count, "baking");
  }
  if (b) forget(b);
  free(b);
  return ok;
}

/* ---- the whole ---------------------------------------------------------------- */

static bool can_be_written(const char *name, failure *why) {
  struct stat status;
  if (stat(name, &status) == 0 && !S_ISREG(status.st_mode))
    return fail(why, EXIT_BAD_INPUT, "cannot write '%s': not a file", name);
  char *target = output_target(name, why);
  free(target);
  return target != NULL;
}

/* Before hours of work. */
static bool check_names(const bake_job *job, failure *why) {
  if (job->ground->count > 1 && !bake_has_udim(job->path))
    return fail(why, EXIT_BAD_INPUT,
                "--output: the mesh has %u UDIM tiles: put <UDIM> into '%s', or name one tile with "
                "--udim",
                job->ground->count, job->path);
  bool ok = true;
  for (uint32_t i = 0; ok && i < job->outputs->file_count; i++) {
    int udim = job->ground->tiles ? job->ground->tiles[0] : 1001;
    char *name = bake_file_name(job->path, udim, job->outputs->files[i].output);
    ok = name ? can_be_written(name, why) : out_of_memory(why);
    free(name);
  }
  return ok;
}

static bool open_pieces(const bake_job *job, const bake_plan *plan, pieces *p, failure *why) {
  char *folder = bake_folder_name(job->path);
  char *text = bake_describe_job(job, plan, why);
  int mode = job->what == BAKE_MERGE                  ? PIECES_MERGE
             : job->what == BAKE_SHARD || job->resume ? PIECES_RESUME
                                                      : PIECES_FRESH;
  bool ok = text && (folder || out_of_memory(why)) &&
            pieces_open(p, folder, text, bake_plan_units(plan), mode, why);
  free(folder);
  free(text);
  return ok;
}

static void say_what_is_there(const pieces *p) {
  uint64_t there = count_there(p);
  if (there > 0)
    fprintf(stderr, "sozai: %llu of %llu pieces are there already\n", (unsigned long long)there,
            (unsigned long long)p->unit_count);
}

bool bake_run(const bake_job *job, failure *why) {
  bake_plan plan = plan_of(job);
  pieces p;
  if (!check_names(job, why) || !open_pieces(job, &plan, &p, why)) return false;
  bool ok = true;
  if (job->resume) say_what_is_there(&p);
  if (job->what == BAKE_ALL) ok = pieces_write_as(&p, 1, 1, why);
  if (job->what == BAKE_SHARD) ok = pieces_write_as(&p, job->shard, job->shards, why);
  if (job->what != BAKE_MERGE) ok = ok && evaluate_missing(job, &plan, &p, why);
  if (job->what != BAKE_SHARD) ok = ok && bake_merge(job, &plan, &p, why);
  progress_clear();
  /* Pieces that are worth nothing do not stay. */
  bool remove = ok ? job->what != BAKE_SHARD : job->what == BAKE_ALL && pieces_worthless(&p);
  pieces_close(&p, remove);
  return ok;
}
