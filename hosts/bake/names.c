/* SPDX-License-Identifier: Apache-2.0 */
#include "names.h"

#include <inttypes.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "checksum.h"

#define UDIM "<UDIM>"
#define OUTPUT "<output>"
#define ENDING ".bake"

static char *fill_in(const char *path, const char *udim, const char *output, const char *end) {
  size_t size = 1 + strlen(end);
  for (const char *at = path; *at; at++) size += *at != '<' ? 1 : strlen(udim) + strlen(output) + 1;
  char *name = malloc(size), *to = name;
  if (!name) return NULL;
  while (*path) {
    const char *word = strncmp(path, UDIM, strlen(UDIM)) == 0       ? udim
                       : strncmp(path, OUTPUT, strlen(OUTPUT)) == 0 ? output
                                                                    : NULL;
    if (!word) {
      *to++ = *path++;
      continue;
    }
    path += word == udim ? strlen(UDIM) : strlen(OUTPUT);
    memcpy(to, word, strlen(word));
    to += strlen(word);
  }
  memcpy(to, end, strlen(end) + 1);
  return name;
}

char *bake_file_name(const char *path, int udim, const char *output) {
  char number[16];
  snprintf(number, sizeof number, "%d", udim);
  return fill_in(path, number, output ? output : "", "");
}

/* A picture's name may be as long as names can be, and the folder's is longer: a sum stands for the
 * rest of it then, the same in every share. */
static void shorten(char *path, const char *end) {
  char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
  size_t length = strlen(name), room = NAME_MAX - strlen(end) - 17;
  if (length <= NAME_MAX) return;
  uint64_t sum = checksum_bytes(0, name, length);
  while (((unsigned char)name[room] & 0xc0) == 0x80) room--; /* not within a character */
  snprintf(name + room, length + 1 - room, "-%016" PRIx64 "%s", sum, end);
}

char *bake_folder_name(const char *path) {
  char *name = fill_in(path, "UDIM", "output", ENDING);
  if (name) shorten(name, ENDING);
  return name;
}

bool bake_has_udim(const char *path) { return strstr(path, UDIM) != NULL; }
