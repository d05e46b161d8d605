/* SPDX-License-Identifier: Apache-2.0 */
#include "commands.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "options.h"

#define PROGRAM "sozai-validate"

/* The program of that name beside this one. This one has a renderer's
 * libraries loaded, among which a plugin cannot be judged. */
int run_validate(int argc, char **argv) {
  failure why = {0};
  char path[PATH_MAX];
  (void)argc;
  ssize_t length = readlink("/proc/self/exe", path, sizeof path - 1);
  path[length > 0 ? length : 0] = '\0';
  char *slash = strrchr(path, '/');
  if (!slash || (size_t)(slash + 1 - path) + sizeof PROGRAM > sizeof path) {
    fail(&why, EXIT_FAILURE, "validate: this program's own place is not known");
    return report(&why);
  }
  memcpy(slash + 1, PROGRAM, sizeof PROGRAM);
  execv(path, argv);
  fail(&why, EXIT_FAILURE, "validate: cannot run %s: %s", path, strerror(errno));
  return report(&why);
}
