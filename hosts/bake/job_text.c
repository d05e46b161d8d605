/* SPDX-License-Identifier: Apache-2.0 */
#include "job_text.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool write_new(const char *path, const char *text) {
  FILE *file = fopen(path, "wb");
  if (!file) return false;
  bool ok = fwrite(text, 1, strlen(text), file) == strlen(text);
  return fclose(file) == 0 && ok;
}

bool job_text_write(const char *path, const char *text, bool replace, failure *why) {
  char host[64] = "", temporary[4096];
  gethostname(host, sizeof host - 1); /* one folder may have writers on many */
  int length = snprintf(temporary, sizeof temporary, "%s.%s.%ld", path, host, (long)getpid());
  bool ok = length > 0 && (size_t)length < sizeof temporary && write_new(temporary, text);
  if (ok && replace) ok = rename(temporary, path) == 0;
  if (ok && !replace) ok = link(temporary, path) == 0 || errno == EEXIST;
  int error = errno;
  unlink(temporary);
  return ok || fail(why, EXIT_FAILURE, "cannot write %s: %s", path, strerror(error));
}

static char *read_whole(const char *path) {
  FILE *file = fopen(path, "rb");
  if (!file) return NULL;
  char *text = NULL;
  size_t used = 0, room = 0;
  for (;;) {
    if (used + 4096 > room) {
      room = 2 * room + 8192;
      char *more = realloc(text, room);
      if (!more) break;
      text = more;
    }
    size_t count = fread(text + used, 1, 4095, file);
    used += count;
    if (count == 0) break;
  }
  if (text) text[used] = '\0';
  fclose(file);
  return text;
}

bool job_text_check(const char *path, const char *text, failure *why) {
  char *there = read_whole(path);
  if (!there) return fail(why, EXIT_BAD_INPUT, "cannot read %s: %s", path, strerror(errno));
  const char *a = there, *b = text;
  for (;;) {
    size_t m = strcspn(a, "\n"), n = strcspn(b, "\n");
    if (m != n || memcmp(a, b, m) != 0) {
      fail(why, EXIT_BAD_INPUT, "%s is of another bake: '%.*s' there, '%.*s' here", path,
           (int)(m < 160 ? m : 160), a, (int)(n < 160 ? n : 160), b);
      free(there);
      return false;
    }
    a += m, b += n;
    if (!*a || !*b) break;
    a++, b++;
  }
  bool same = !*a && !*b;
  free(there);
  return same || fail(why, EXIT_BAD_INPUT, "%s is of another bake", path);
}
