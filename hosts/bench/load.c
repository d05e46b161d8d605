/* SPDX-License-Identifier: Apache-2.0 */
#define _XOPEN_SOURCE 700 /* realpath */
#include "load.h"

#include <errno.h>
#include <limits.h>
#include <spawn.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include "numbers.h"
#include "scratch.h"

extern char **environ;

static bool start(const char *plugin_path, int output, pid_t *child, failure *why) {
  char *arguments[] = {(char *)(uintptr_t)SOZAI_BENCH_LOAD, (char *)(uintptr_t)plugin_path, NULL};
  posix_spawn_file_actions_t actions;
  if (posix_spawn_file_actions_init(&actions) != 0) return fail(why, EXIT_FAILURE, "out of memory");
  int error = posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  if (error == 0) error = posix_spawn(child, arguments[0], &actions, NULL, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ||
         fail(why, EXIT_FAILURE, "cannot start %s: %s", arguments[0], strerror(error));
}

static size_t read_all(int from, char *text, size_t size) {
  size_t used = 0;
  while (used + 1 < size) {
    ssize_t more = read(from, text + used, size - 1 - used);
    if (more < 0 && errno == EINTR) continue;
    if (more <= 0) break;
    used += (size_t)more;
  }
  text[used] = '\0';
  return used;
}

bool load_once(const char *plugin_path, double *ns, failure *why) {
  int ends[2];
  if (pipe(ends) != 0) return fail(why, EXIT_FAILURE, "no pipe: %s", strerror(errno));
  pid_t child;
  bool ok = start(plugin_path, ends[1], &child, why);
  close(ends[1]);
  char text[64] = "";
  if (ok) {
    read_all(ends[0], text, sizeof text);
    int status;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    text[strcspn(text, "\n")] = '\0';
    ok = number_read(text, ns) || fail(why, EXIT_FAILURE, "loading in a fresh process failed");
  }
  close(ends[0]);
  return ok;
}

bool load_alone(const char *plugin_path, double *ns, failure *why) {
  scratch s = {0};
  char whole[PATH_MAX];
  if (!realpath(plugin_path, whole))
    return fail(why, EXIT_FAILURE, "%s: %s", plugin_path, strerror(errno));
  if (!scratch_open(&s, "sozai.so", why)) return false;
  bool ok = symlink(whole, s.file) == 0 ||
            fail(why, EXIT_FAILURE, "no link in %s: %s", s.folder, strerror(errno));
  ok = ok && load_once(s.file, ns, why);
  scratch_close(&s);
  return ok;
}
