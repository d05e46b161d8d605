/* SPDX-License-Identifier: Apache-2.0 */
#include "output_file.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void forget(output_file *o) {
  free(o->path);
  free(o->writing);
  o->path = o->writing = NULL;
}

/* .NAME.PID.ENDING in the folder of path: the ending stays last, since image
 * formats are known by it. */
static char *temporary_name(const char *path) {
  const char *slash = strrchr(path, '/');
  int folder = slash ? (int)(slash + 1 - path) : 0;
  size_t size = strlen(path) + 32;
  char *name = malloc(size);
  if (name) snprintf(name, size, "%.*s.%ld.%s", folder, path, (long)getpid(), path + folder);
  return name;
}

bool output_begin(output_file *o, const char *path, failure *why) {
  memset(o, 0, sizeof *o);
  struct stat status;
  bool exists = stat(path, &status) == 0;
  if (!*path || path[strlen(path) - 1] == '/' || (exists && S_ISDIR(status.st_mode)))
    return fail(why, EXIT_BAD_INPUT, "cannot write '%s': not the name of a file", path);
  o->in_place = exists && !S_ISREG(status.st_mode);
  /* Resolved, so that what a link points to is replaced and not the link. */
  o->path = exists && !o->in_place ? realpath(path, NULL) : strdup(path);
  if (o->path) o->writing = o->in_place ? strdup(path) : temporary_name(o->path);
  if (!o->writing) {
    forget(o);
    return fail(why, EXIT_FAILURE, "out of memory");
  }
  if (o->in_place) return true;
  /* a new one: not through a link that someone has laid there */
  unlink(o->writing);
  int file = open(o->writing, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) {
    fail(why, EXIT_BAD_INPUT, "cannot write '%s': %s", path, strerror(errno));
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
  if (nobody_reads()) return fail(why, EXIT_CLOSED_PIPE, "%s", "");
  return fail(why, EXIT_FAILURE, "cannot write standard output");
}

bool output_printed(failure *why) {
  return (fflush(stdout) == 0 && !ferror(stdout)) || output_unprinted(why);
}
