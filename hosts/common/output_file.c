/* SPDX-License-Identifier: Apache-2.0 */
#include "output_file.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define MOST_LINKS 40 /* as the system has it */
#define MOST_TRIES 10000
#define LONGEST_ENDING 16

static void forget(output_file *o) {
  free(o->path);
  free(o->writing);
  o->path = o->writing = NULL;
}

static bool cannot(const char *path, const char *reason, failure *why) {
  return fail(why, EXIT_BAD_INPUT, "cannot write '%s': %s", path, reason);
}

/* ---- links ----------------------------------------------------------------- */

/* What is written at a link, from the link's own folder; NULL, as errno says: it is none. */
static char *read_link(const char *path) {
  char to[PATH_MAX];
  ssize_t length = readlink(path, to, sizeof to - 1);
  if (length < 0) return NULL;
  to[length] = '\0';
  const char *slash = strrchr(path, '/');
  int folder = *to != '/' && slash ? (int)(slash + 1 - path) : 0;
  size_t size = (size_t)folder + (size_t)length + 1;
  char *whole = malloc(size);
  if (whole) snprintf(whole, size, "%.*s%s", folder, path, to);
  return whole;
}

/* Of a link to nothing: where a file would come to be. The system has followed it and
 * found its end, so that this ends too. NULL, as errno says. */
static char *follow(const char *path) {
  char *at = strdup(path);
  for (int i = 0; at && i < MOST_LINKS; i++) {
    char *next = read_link(at);
    if (!next && (errno == EINVAL || errno == ENOENT)) return at;
    free(at);
    at = next;
  }
  if (at) errno = ELOOP;
  free(at);
  return NULL;
}

static bool is_folder(const char *path) {
  struct stat status;
  return stat(path, &status) == 0 && S_ISDIR(status.st_mode);
}

static bool has_folder(const char *path) {
  const char *slash = strrchr(path, '/');
  char *folder = slash ? strndup(path, (size_t)(slash + 1 - path)) : strdup(".");
  bool has = folder && is_folder(folder);
  free(folder);
  return has;
}

static char *not_there(const char *path, failure *why) {
  char *at = follow(path);
  if (!at) {
    cannot(path, strerror(errno), why);
    return NULL;
  }
  if (strcmp(at, path) == 0) return at; /* what is no link fails where it is opened */
  const char *wrong = at[strlen(at) - 1] == '/' ? "not the name of a file"
                      : !has_folder(at)         ? "whose folder is not there"
                                                : NULL;
  if (!wrong) return at;
  fail(why, EXIT_BAD_INPUT, "cannot write '%s': a link to '%s', %s", path, at, wrong);
  free(at);
  return NULL;
}

char *output_target(const char *path, failure *why) {
  struct stat status;
  bool exists = stat(path, &status) == 0;
  int error = exists ? 0 : errno;
  if (!*path || path[strlen(path) - 1] == '/' || (exists && S_ISDIR(status.st_mode))) {
    cannot(path, "not the name of a file", why);
    return NULL;
  }
  if (error == ENOENT) return not_there(path, why);
  char *real = exists ? realpath(path, NULL) : NULL;
  if (real) return real;
  cannot(path,
         error == ELOOP ? "a link that leads back to itself, or through too many others"
                        : strerror(error ? error : errno),
         why);
  return NULL;
}

/* ---- files ----------------------------------------------------------------- */

/* .sozai-PID-N.ENDING in the folder of path: short, since the file's own name may be as
 * long as a name can be. The ending is that of `asked`, since image formats are known by
 * it; what is longer is no format's. */
static char *temporary_name(const char *path, const char *asked, unsigned n) {
  const char *slash = strrchr(path, '/'), *from = strrchr(asked, '/');
  const char *ending = strrchr(from ? from : asked, '.');
  if (!ending || strlen(ending) > LONGEST_ENDING) ending = "";
  int folder = slash ? (int)(slash + 1 - path) : 0;
  size_t size = (size_t)folder + LONGEST_ENDING + 48;
  char *name = malloc(size);
  if (name) snprintf(name, size, "%.*s.sozai-%ld-%u%s", folder, path, (long)getpid(), n, ending);
  return name;
}

/* A new one, never through a link that someone has laid there: other machines write to the
 * folder under the same number, and a run that was killed has left its own. */
static int open_temporary(output_file *o, const char *asked) {
  int file = -1;
  for (unsigned n = 0; file < 0 && n < MOST_TRIES; n++) {
    free(o->writing);
    o->writing = temporary_name(o->path, asked, n);
    if (!o->writing) return -1;
    file = open(o->writing, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0 && errno != EEXIST) break;
  }
  return file;
}

static bool out_of_memory(output_file *o, failure *why) {
  forget(o);
  return fail(why, EXIT_FAILURE, "out of memory");
}

bool output_begin(output_file *o, const char *path, failure *why) {
  memset(o, 0, sizeof *o);
  struct stat status;
  bool exists = stat(path, &status) == 0 && !S_ISDIR(status.st_mode);
  /* (without a name: /dev/stdout, of a file that has been removed) */
  o->in_place = exists && (!S_ISREG(status.st_mode) || status.st_nlink == 0);
  if (o->in_place) {
    o->path = strdup(path);
    o->writing = strdup(path);
    return (o->path && o->writing) || out_of_memory(o, why);
  }
  o->path = output_target(path, why);
  if (!o->path) return false;
  int file = open_temporary(o, path);
  if (!o->writing) return out_of_memory(o, why);
  if (file < 0) {
    cannot(path, strerror(errno), why);
    forget(o);
    return false;
  }
  /* whom the one before was open to, and nobody else; it is still to be written */
  if (exists) fchmod(file, (status.st_mode & 0777) | S_IRUSR | S_IWUSR);
  close(file);
  return true;
}

bool output_commit(output_file *o, failure *why) {
  if (!o->in_place && rename(o->writing, o->path) != 0) {
    fail(why, EXIT_FAILURE, "cannot write '%s': %s", o->path, strerror(errno));
    output_discard(o);
    return false;
  }
  forget(o);
  return true;
}

bool output_failed(output_file *o, failure *why) {
  if (!o->in_place) failure_rename(why, o->writing, o->path);
  output_discard(o);
  return false;
}

void output_discard(output_file *o) {
  if (o->writing && !o->in_place) unlink(o->writing);
  forget(o);
}

/* The one that read it has seen enough, as of `| head`. */
static bool nobody_reads(void) {
  struct pollfd out = {.fd = STDOUT_FILENO};
  return poll(&out, 1, 0) == 1 && (out.revents & POLLERR);
}

bool output_unprinted(failure *why) {
  int error = errno;
  if (nobody_reads()) return fail(why, EXIT_CLOSED_PIPE, "%s", "");
  return fail(why, EXIT_FAILURE, "cannot write standard output: %s",
              error ? strerror(error) : "a part of it was not taken");
}

bool output_printed(failure *why) {
  bool flushed = fflush(stdout) == 0;
  if (flushed && !ferror(stdout)) return true;
  if (flushed) errno = 0; /* it failed earlier, and errno is of something else since */
  return output_unprinted(why);
}
