/* SPDX-License-Identifier: Apache-2.0 */
#define _POSIX_C_SOURCE 200809L /* mkdtemp */
#include "scratch.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

bool scratch_open(scratch *s, const char *file_name, failure *why) {
  const char *parent = getenv("TMPDIR");
  if (!parent || !*parent) parent = "/tmp";
  int length = snprintf(s->folder, sizeof s->folder, "%s/sozai-bench-XXXXXX", parent);
  if (length < 0 || (size_t)length >= sizeof s->folder) {
    s->folder[0] = '\0';
    return fail(why, EXIT_FAILURE, "TMPDIR is too long");
  }
  if (!mkdtemp(s->folder)) {
    s->folder[0] = '\0';
    return fail(why, EXIT_FAILURE, "no temporary folder in %s: %s", parent, strerror(errno));
  }
  snprintf(s->file, sizeof s->file, "%s/%.40s", s->folder, file_name);
  return true;
}

void scratch_close(scratch *s) {
  if (!s->folder[0]) return;
  unlink(s->file);
  rmdir(s->folder);
  s->folder[0] = '\0';
}
