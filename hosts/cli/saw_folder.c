/* SPDX-License-Identifier: Apache-2.0 */
#include "saw_folder.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define MOST_TRIES 10000

static bool cannot(const saw_folder *f, failure *why) {
  return fail(why, EXIT_BAD_INPUT, "--output: cannot write '%s': %s", f->path, strerror(errno));
}

static bool join(char out[FOLDER_PATH], const char *folder, const char *name, failure *why) {
  int n = snprintf(out, FOLDER_PATH, "%s/%s", folder, name);
  return (n > 0 && n < FOLDER_PATH) ||
         fail(why, EXIT_BAD_INPUT, "--output: '%.80s...' is too long a path", folder);
}

/* Within the folder or, where that is not there yet, beside it. Its name is its own, since the
 * folder's may be as long as names can be; one that another has, or has left, is passed over. */
static bool make_working(saw_folder *f, failure *why) {
  const char *slash = strrchr(f->path, '/');
  int length = f->existed ? (int)strlen(f->path) : slash ? (int)(slash - f->path) : -1;
  for (int i = 0; i < MOST_TRIES; i++) {
    int n = length < 0 ? snprintf(f->working, FOLDER_PATH, ".saw-%ld-%d", (long)getpid(), i)
                       : snprintf(f->working, FOLDER_PATH, "%.*s/.saw-%ld-%d", length, f->path,
                                  (long)getpid(), i);
    if (n < 0 || n >= FOLDER_PATH) {
      f->working[0] = '\0';
      return fail(why, EXIT_BAD_INPUT, "--output: '%.80s...' is too long a path", f->path);
    }
    if (mkdir(f->working, 0777) == 0) return true;
    if (errno != EEXIST) break;
  }
  f->working[0] = '\0';
  return cannot(f, why);
}

bool saw_folder_begin(saw_folder *f, const char *path, failure *why) {
  memset(f, 0, sizeof *f);
  size_t length = strlen(path);
  while (length > 1 && path[length - 1] == '/') length--;
  if (length == 0 || length >= FOLDER_PATH)
    return fail(why, EXIT_BAD_INPUT, "--output: '%.80s' is not the name of a folder", path);
  memcpy(f->path, path, length);
  struct stat status;
  f->existed = stat(f->path, &status) == 0;
  if (!f->existed && errno != ENOENT) return cannot(f, why);
  if (f->existed && !S_ISDIR(status.st_mode))
    return fail(why, EXIT_BAD_INPUT, "--output: '%s' is there and is no folder", f->path);
  return make_working(f, why);
}

bool saw_folder_file(const saw_folder *f, const char *name, char out[FOLDER_PATH], failure *why) {
  return join(out, f->working, name, why);
}

/* board-NN.sozai, as this command writes them */
static bool is_board(const char *name) {
  size_t n = strlen(name);
  if (n < 14 || strncmp(name, "board-", 6) != 0 || strcmp(name + n - 6, ".sozai") != 0)
    return false;
  for (const char *c = name + 6; c < name + n - 6; c++)
    if (!isdigit((unsigned char)*c)) return false;
  return true;
}

static void remove_stale(const saw_folder *f) {
  failure ignored;
  char path[FOLDER_PATH];
  struct stat status;
  if (!join(path, f->path, "saw.json", &ignored) || stat(path, &status) != 0) return;
  DIR *d = opendir(f->path);
  for (struct dirent *e; d && (e = readdir(d));) {
    if (!is_board(e->d_name)) continue;
    bool again = join(path, f->working, e->d_name, &ignored) && stat(path, &status) == 0;
    if (!again && join(path, f->path, e->d_name, &ignored)) unlink(path);
  }
  if (d) closedir(d);
}

/* false: a file could not be moved. */
static bool move_files(const saw_folder *f) {
  failure ignored;
  char from[FOLDER_PATH], to[FOLDER_PATH];
  DIR *d = opendir(f->working);
  bool ok = d != NULL;
  for (struct dirent *e; ok && (e = readdir(d));) {
    if (strcmp(e->d_name, ".") == 0 || strcmp(e->d_name, "..") == 0) continue;
    ok = join(from, f->working, e->d_name, &ignored) && join(to, f->path, e->d_name, &ignored) &&
         rename(from, to) == 0;
  }
  int code = errno;
  if (d) closedir(d);
  errno = code;
  return ok;
}

bool saw_folder_commit(saw_folder *f, failure *why) {
  bool ok = true;
  if (f->existed) {
    remove_stale(f);
    ok = move_files(f);
  } else {
    ok = rename(f->working, f->path) == 0;
  }
  if (!ok) cannot(f, why);
  saw_folder_discard(f);
  return ok;
}

void saw_folder_discard(saw_folder *f) {
  if (!f->working[0]) return;
  failure ignored;
  char path[FOLDER_PATH];
  DIR *d = opendir(f->working);
  for (struct dirent *e; d && (e = readdir(d));)
    if (strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0 &&
        join(path, f->working, e->d_name, &ignored))
      unlink(path);
  if (d) closedir(d);
  rmdir(f->working);
  f->working[0] = '\0';
}
