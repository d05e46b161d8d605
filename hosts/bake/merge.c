/* SPDX-License-Identifier: Apache-2.0
 *
 * The files of a picture are written side by side, so that every piece is read
 * once. They grow within the folder of the pieces, and are moved to their
 * names from there. */
#include "merge.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "cancel.h"
#include "describe_job.h"
#include "units.h"
#include "names.h"
#include "output_file.h"
#include "progress.h"
#include "writer.h"

typedef struct merging {
  const bake_job *job;
  const bake_plan *plan;
  pieces *pieces;
  bake_writer **writers; /* one to a file of the picture */
  char **growing;        /* the names they grow under */
  uint8_t *pixels;       /* of a unit */
} merging;

static bool out_of_memory(failure *why) { return fail(why, EXIT_FAILURE, "out of memory"); }

static const char *ending_of(const char *path) { return strrchr(path, '.'); }

/* ---- one picture's files ------------------------------------------------------- */

static bool open_writers(merging *m, failure *why) {
  const bake_outputs *o = m->job->outputs;
  for (uint32_t i = 0; i < o->file_count; i++) {
    size_t size = strlen(m->pieces->folder) + strlen(m->job->path) + 32;
    if (!(m->growing[i] = malloc(size))) return out_of_memory(why);
    snprintf(m->growing[i], size, "%s/file-%u%s", m->pieces->folder, i, ending_of(m->job->path));
    bake_words words;
    writer_spec spec = {.width = m->plan->width,
                        .height = m->plan->height,
                        .level_count = m->plan->level_count,
                        .tile = m->job->tile,
                        .file = &o->files[i]};
    bake_describe_file(m->job, &o->files[i], &spec, &words);
    if (!(m->writers[i] = writer_open(m->growing[i], &spec, why))) return false;
  }
  return true;
}

static bool write_unit(merging *m, const bake_unit *u, failure *why) {
  const bake_outputs *o = m->job->outputs;
  const uint8_t *from = m->pixels;
  for (uint32_t i = 0; i < o->file_count; i++) {
    if (u->row == 0 && u->level > 0 && !writer_next_level(m->writers[i], u->width, u->height, why))
      return false;
    if (!writer_rows(m->writers[i], u->row, u->rows, from, why)) return false;
    from += (size_t)u->width * u->rows * o->files[i].pixel_bytes;
  }
  return true;
}

static bool cannot_write(const char *name, int error, failure *why) {
  return fail(why, EXIT_FAILURE, "cannot write '%s': %s", name, strerror(error));
}

static bool copy_bytes(FILE *from, FILE *to) {
  char room[1 << 16];
  size_t count;
  while ((count = fread(room, 1, sizeof room, from)) > 0)
    if (fwrite(room, 1, count, to) != count) return false;
  return !ferror(from);
}

/* To another file system, where a link leads to one. */
static bool copy_to(const char *from_name, const char *name, failure *why) {
  output_file o;
  if (!output_begin(&o, name, why)) return false;
  FILE *from = fopen(from_name, "rb"), *to = from ? fopen(o.writing, "wb") : NULL;
  bool ok = to && copy_bytes(from, to);
  int error = errno;
  if (to && fclose(to) != 0 && ok) {
    error = errno;
    ok = false;
  }
  if (from) fclose(from);
  if (ok) return output_commit(&o, why);
  output_discard(&o);
  return cannot_write(name, error, why);
}

static bool move_to(const char *from, const char *name, failure *why) {
  char *target = output_target(name, why);
  if (!target) return false;
  bool moved = rename(from, target) == 0;
  int error = moved ? 0 : errno;
  free(target);
  if (error == EXDEV) return copy_to(from, name, why);
  return moved || cannot_write(name, error, why);
}

static bool give_names(merging *m, uint32_t picture, failure *why) {
  const bake_job *job = m->job;
  bool ok = true;
  for (uint32_t i = 0; ok && i < job->outputs->file_count; i++) {
    int udim = job->ground->tiles ? job->ground->tiles[picture] : 1001;
    char *name = bake_file_name(job->path, udim, job->outputs->files[i].output);
    if (!name) return out_of_memory(why);
    ok = move_to(m->growing[i], name, why);
    free(name);
  }
  return ok;
}

static bool write_picture(merging *m, uint32_t picture, failure *why) {
  uint64_t each = m->pieces->unit_count / m->plan->picture_count;
  if (!open_writers(m, why)) return false;
  for (uint64_t i = picture * each; i < (picture + (uint64_t)1) * each; i++) {
    bake_unit u = bake_plan_unit(m->plan, i);
    if (cancel_requested())
      return fail(why, EXIT_FAILURE, "cancelled; the pieces are kept in %s", m->pieces->folder);
    if (!pieces_read(m->pieces, i, m->pixels, bake_unit_bytes(m->job->outputs, &u), why) ||
        !write_unit(m, &u, why))
      return false;
    progress_show((float)i / (float)m->pieces->unit_count, "writing");
  }
  for (uint32_t i = 0; i < m->job->outputs->file_count; i++) {
    bake_writer *w = m->writers[i];
    m->writers[i] = NULL;
    if (!writer_close(w, why)) return false;
  }
  return give_names(m, picture, why);
}

static void forget_picture(merging *m) {
  for (uint32_t i = 0; i < m->job->outputs->file_count; i++) {
    writer_drop(m->writers[i]);
    if (m->growing[i]) unlink(m->growing[i]);
    free(m->growing[i]);
    m->writers[i] = NULL;
    m->growing[i] = NULL;
  }
}

/* ---- all pictures --------------------------------------------------------------- */

static bool complete(const pieces *p, failure *why) {
  uint64_t missing = 0, first = 0;
  for (uint64_t i = p->unit_count; i-- > 0;)
    if (!pieces_has(p, i)) missing++, first = i;
  if (missing == 0) return true;
  return fail(why, EXIT_FAILURE,
              "%llu of %llu pieces are not in %s, the first is %llu: let all shards end well, or "
              "bake the rest with --resume",
              (unsigned long long)missing, (unsigned long long)p->unit_count, p->folder,
              (unsigned long long)first);
}

static uint64_t largest_unit(const bake_job *job, const bake_plan *plan) {
  bake_unit u = bake_plan_unit(plan, 0);
  return bake_unit_bytes(job->outputs, &u);
}

bool bake_merge(const bake_job *job, const bake_plan *plan, pieces *p, failure *why) {
  if (!complete(p, why) || !pieces_lock(p, why)) return false;
  merging m = {.job = job, .plan = plan, .pieces = p};
  m.writers = calloc(job->outputs->file_count, sizeof *m.writers);
  m.growing = calloc(job->outputs->file_count, sizeof *m.growing);
  m.pixels = malloc((size_t)largest_unit(job, plan) + 1);
  bool ok = m.writers && m.growing && m.pixels ? true : out_of_memory(why);
  for (uint32_t i = 0; ok && i < plan->picture_count; i++) {
    ok = write_picture(&m, i, why);
    forget_picture(&m);
  }
  free(m.writers);
  free(m.growing);
  free(m.pixels);
  return ok;
}
