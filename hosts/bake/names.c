/* SPDX-License-Identifier: Apache-2.0 */
#include "names.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define UDIM "<UDIM>"
#define OUTPUT "<output>"

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

char *bake_folder_name(const char *path) { return fill_in(path, "UDIM", "output", ".bake"); }

bool bake_has_udim(const char *path) { return strstr(path, UDIM) != NULL; }
