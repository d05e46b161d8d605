/* SPDX-License-Identifier: Apache-2.0 */
#include "folder_lock.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include "folder.h"

/* Others may take the folder away between any two steps: so often is it tried again. */
#define TRIES 100

static bool cannot(const folder_lock *l, failure *why) {
  return fail(why, EXIT_BAD_INPUT, "cannot write %s: %s", l->path, strerror(errno));
}

static bool flocked(int file, int how) {
  return flock(file, how | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

/* Whether the path still leads to the file, which its last holder may have removed. */
static bool current(const folder_lock *l) {
  struct stat mine, there;
  return fstat(l->file, &mine) == 0 && stat(l->path, &there) == 0 && mine.st_ino == there.st_ino &&
         mine.st_dev == there.st_dev;
}

static void drop(folder_lock *l) {
  if (l->file >= 0) close(l->file);
  l->file = -1;
}

bool folder_lock_take(folder_lock *l, const char *folder, bool make, bool alone, failure *why) {
  size_t size = strlen(folder) + sizeof "/lock";
  l->file = -1;
  l->path = malloc(size);
  if (!l->path) return fail(why, EXIT_FAILURE, "out of memory");
  snprintf(l->path, size, "%s/lock", folder);
  for (int i = 0; i < TRIES; i++) {
    if (make && !folder_make(folder))
      return fail(why, EXIT_BAD_INPUT, "cannot make the folder %s for the pieces: %s", folder,
                  strerror(errno));
    l->file = open(l->path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (l->file < 0 && (errno != ENOENT || !make)) return cannot(l, why);
    if (l->file < 0) continue;
    if (!flocked(l->file, alone ? LOCK_EX : LOCK_SH)) {
      drop(l);
      return fail(why, EXIT_BAD_INPUT, "%s is in use by another bake", folder);
    }
    if (current(l)) return true;
    drop(l);
  }
  return fail(why, EXIT_FAILURE, "%s: other bakes make and remove it all the time", folder);
}

bool folder_lock_alone(folder_lock *l) { return l->file >= 0 && flocked(l->file, LOCK_EX); }

void folder_lock_end(folder_lock *l, bool remove) {
  if (remove && l->file >= 0) {
    unlink(l->path);
    char *slash = strrchr(l->path, '/');
    if (slash) *slash = '\0';
    rmdir(l->path); /* stays where something else is in it */
  }
  drop(l);
  free(l->path);
  l->path = NULL;
}
