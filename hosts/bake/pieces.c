/* SPDX-License-Identifier: Apache-2.0 */
#define _GNU_SOURCE /* flock */
#include "pieces.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include "checksum.h"
#include "job_text.h"

#define MAGIC 0x31656365697a6f73u /* its bytes: soziece1 */
#define ENDING ".pieces"
#define READ_SIZE (1 << 20)

typedef struct header {
  uint64_t magic, unit, bytes;
  uint64_t check; /* of the pixels and of the numbers above */
} header;

static uint64_t begin_check(const header *h) {
  const uint64_t numbers[2] = {h->unit, h->bytes};
  return checksum_bytes(MAGIC, numbers, sizeof numbers);
}

static bool out_of_memory(failure *why) { return fail(why, EXIT_FAILURE, "out of memory"); }

static char *join(const char *folder, const char *name) {
  size_t size = strlen(folder) + strlen(name) + 2;
  char *path = malloc(size);
  if (path) snprintf(path, size, "%s/%s", folder, name);
  return path;
}

/* ---- what is there --------------------------------------------------------- */

/* The pixels of a record, checked while they run past; READ_SIZE is a multiple of 8. */
static bool sound(FILE *file, const header *h, unsigned char *room) {
  uint64_t sum = begin_check(h);
  for (uint64_t left = h->bytes; left > 0;) {
    size_t part = left < READ_SIZE ? (size_t)left : READ_SIZE;
    if (fread(room, 1, part, file) != part) return false;
    sum = checksum_bytes(sum, room, part);
    left -= part;
  }
  return sum == h->check;
}

/* Records up to the first that is no good; *end: where that begins. */
static bool scan(pieces *p, uint32_t journal, uint64_t *end, failure *why) {
  FILE *file = fopen(p->names[journal], "rb");
  if (!file)
    return fail(why, EXIT_FAILURE, "cannot read %s: %s", p->names[journal], strerror(errno));
  unsigned char *room = malloc(READ_SIZE);
  header h;
  *end = 0;
  while (room && fread(&h, sizeof h, 1, file) == 1 && h.magic == MAGIC && h.unit < p->unit_count &&
         sound(file, &h, room)) {
    p->units[h.unit] = (piece){journal + 1, *end + sizeof h, h.bytes};
    *end += sizeof h + h.bytes;
  }
  free(room);
  fclose(file);
  return room || out_of_memory(why);
}

static bool add_name(pieces *p, char *path) {
  char **more = path ? realloc(p->names, (p->name_count + 1) * sizeof *more) : NULL;
  if (!more) {
    free(path);
    return false;
  }
  p->names = more;
  p->names[p->name_count++] = path;
  return true;
}

static bool is_journal(const char *name) {
  size_t length = strlen(name), tail = strlen(ENDING);
  return name[0] != '.' && length > tail && strcmp(name + length - tail, ENDING) == 0;
}

static int by_name(const void *a, const void *b) {
  return strcmp(*(char *const *)a, *(char *const *)b);
}

static bool list(pieces *p, failure *why) {
  DIR *folder = opendir(p->folder);
  if (!folder) return fail(why, EXIT_FAILURE, "cannot read %s: %s", p->folder, strerror(errno));
  bool ok = true;
  for (struct dirent *e; ok && (e = readdir(folder));)
    if (is_journal(e->d_name)) ok = add_name(p, join(p->folder, e->d_name)) || out_of_memory(why);
  closedir(folder);
  if (p->name_count > 0) qsort(p->names, p->name_count, sizeof *p->names, by_name);
  return ok;
}

/* ---- locks: one writer to a journal ------------------------------------------ */

static FILE *open_locked(const char *path, failure *why) {
  FILE *file = fopen(path, "ab");
  if (!file) {
    fail(why, EXIT_FAILURE, "cannot write %s: %s", path, strerror(errno));
    return NULL;
  }
  if (flock(fileno(file), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return file;
  fclose(file); /* file systems without locks have none to respect */
  fail(why, EXIT_BAD_INPUT, "%s is being written by another bake", path);
  return NULL;
}

bool pieces_lock(pieces *p, failure *why) {
  return folder_lock_alone(&p->lock) ||
         fail(why, EXIT_BAD_INPUT,
              "%s is in use by another bake; what is done is kept in it, --resume goes on",
              p->folder);
}

/* ---- beginning ---------------------------------------------------------------- */

/* Only what a bake leaves there, so that a folder with anything else in it stays. */
static bool clear(pieces *p, failure *why) {
  for (uint32_t i = 0; i < p->name_count; i++) {
    FILE *mine = open_locked(p->names[i], why);
    if (!mine) return false;
    unlink(p->names[i]);
    fclose(mine);
    free(p->names[i]);
  }
  p->name_count = 0;
  return true;
}

static bool begin(pieces *p, const char *job, int mode, failure *why) {
  if (mode == PIECES_MERGE && access(p->folder, R_OK | X_OK) != 0)
    return fail(why, EXIT_BAD_INPUT, "there are no pieces to merge: %s: %s", p->folder,
                strerror(errno));
  /* who begins anew, or puts together, is there alone from the first; who adds is one of many */
  if (!folder_lock_take(&p->lock, p->folder, mode != PIECES_MERGE, mode != PIECES_RESUME, why))
    return false;
  if (!list(p, why) || (mode == PIECES_FRESH && !clear(p, why))) return false;
  char *path = join(p->folder, "bake.txt");
  if (!path) return out_of_memory(why);
  bool ok = mode == PIECES_FRESH || (mode == PIECES_RESUME && access(path, F_OK) != 0)
                ? job_text_write(path, job, mode == PIECES_FRESH, why)
                : true;
  ok = ok && job_text_check(path, job, why);
  free(path);
  uint64_t end;
  for (uint32_t i = 0; ok && i < p->name_count; i++) ok = scan(p, i, &end, why);
  return ok;
}

bool pieces_open(pieces *p, const char *folder, const char *job, uint64_t unit_count, int mode,
                 failure *why) {
  memset(p, 0, sizeof *p);
  p->lock.file = -1;
  p->unit_count = unit_count;
  p->folder = strdup(folder);
  p->units = calloc(unit_count + 1, sizeof *p->units);
  bool ok = p->folder && p->units ? begin(p, job, mode, why) : out_of_memory(why);
  if (!ok) pieces_close(p, false);
  return ok;
}

/* ---- writing -------------------------------------------------------------------- */

/* Its index; where it is none of those listed, it is added. */
static bool find_own(pieces *p, const char *path, uint32_t *index, failure *why) {
  for (*index = 0; *index < p->name_count; ++*index)
    if (strcmp(p->names[*index], path) == 0) return true;
  return add_name(p, strdup(path)) || out_of_memory(why);
}

bool pieces_write_as(pieces *p, uint32_t worker, uint32_t of, failure *why) {
  char name[64];
  snprintf(name, sizeof name, "%u-of-%u" ENDING, worker, of);
  char *path = join(p->folder, name);
  uint32_t index = 0;
  bool ok = path ? find_own(p, path, &index, why) : out_of_memory(why);
  free(path);
  if (!ok || !(p->writing = open_locked(p->names[index], why))) return false;
  p->reading_index = index;
  /* Again, now that nobody else writes it: what follows the last good record goes. */
  if (!scan(p, index, &p->written, why)) return false;
  if (ftruncate(fileno(p->writing), (off_t)p->written) == 0) return true;
  return fail(why, EXIT_FAILURE, "cannot write %s: %s", p->names[index], strerror(errno));
}

static bool append(pieces *p, const header *h, const void *pixels) {
  return fwrite(h, sizeof *h, 1, p->writing) == 1 &&
         (h->bytes == 0 || fwrite(pixels, (size_t)h->bytes, 1, p->writing) == 1) &&
         fflush(p->writing) == 0;
}

static bool has_any(const pieces *p) {
  for (uint64_t i = 0; i < p->unit_count; i++)
    if (p->units[i].journal) return true;
  return false;
}

bool pieces_add(pieces *p, uint64_t unit, const void *pixels, uint64_t bytes, failure *why) {
  header h = {.magic = MAGIC, .unit = unit, .bytes = bytes};
  h.check = checksum_bytes(begin_check(&h), pixels, (size_t)bytes);
  if (!append(p, &h, pixels)) {
    int error = errno;
    if (ftruncate(fileno(p->writing), (off_t)p->written) != 0) error = errno;
    return fail(why, EXIT_FAILURE, "cannot write to %s: %s; %s", p->folder, strerror(error),
                has_any(p) ? "what is done is kept, --resume goes on" : "nothing is done yet");
  }
  p->units[unit] = (piece){p->reading_index + 1, p->written + sizeof h, bytes};
  p->written += sizeof h + bytes;
  return true;
}

/* ---- reading -------------------------------------------------------------------- */

bool pieces_has(const pieces *p, uint64_t unit) { return p->units[unit].journal != 0; }

static bool turn_to(pieces *p, uint32_t journal, failure *why) {
  if (p->reading && p->reading_index == journal) return true;
  if (p->reading) fclose(p->reading);
  p->reading = fopen(p->names[journal], "rb");
  p->reading_index = journal;
  return p->reading
             ? true
             : fail(why, EXIT_FAILURE, "cannot read %s: %s", p->names[journal], strerror(errno));
}

bool pieces_read(pieces *p, uint64_t unit, void *pixels, uint64_t bytes, failure *why) {
  const piece *u = &p->units[unit];
  if (!turn_to(p, u->journal - 1, why)) return false;
  header h;
  if (u->bytes == bytes && fseeko(p->reading, (off_t)(u->offset - sizeof h), SEEK_SET) == 0 &&
      fread(&h, sizeof h, 1, p->reading) == 1 &&
      (bytes == 0 || fread(pixels, (size_t)bytes, 1, p->reading) == 1) &&
      h.check == checksum_bytes(begin_check(&h), pixels, (size_t)bytes))
    return true;
  return fail(why, EXIT_FAILURE, "%s is damaged: remove it and bake again",
              p->names[u->journal - 1]);
}

/* ---- the end ---------------------------------------------------------------------- */

/* Of journals that were found or written; alone only. */
static bool all_empty(const pieces *p) {
  struct stat status;
  for (uint32_t i = 0; i < p->name_count; i++)
    if (stat(p->names[i], &status) == 0 && status.st_size > 0) return false;
  return true;
}

/* Journals that others have begun since. */
static bool list_again(pieces *p) {
  failure unused;
  for (uint32_t i = 0; i < p->name_count; i++) free(p->names[i]);
  p->name_count = 0;
  return list(p, &unused);
}

bool pieces_worthless(pieces *p) {
  return folder_lock_alone(&p->lock) && list_again(p) && all_empty(p);
}

void pieces_close(pieces *p, bool remove) {
  if (p->reading) fclose(p->reading);
  for (uint32_t i = 0; i < p->name_count; i++) {
    if (remove) unlink(p->names[i]);
    free(p->names[i]);
  }
  if (p->writing) fclose(p->writing);
  char *text = remove ? join(p->folder, "bake.txt") : NULL;
  if (text) unlink(text);
  free(text);
  folder_lock_end(&p->lock, remove);
  free(p->names);
  free(p->units);
  free(p->folder);
  memset(p, 0, sizeof *p);
  p->lock.file = -1;
}
