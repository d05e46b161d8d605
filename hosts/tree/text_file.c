/* SPDX-License-Identifier: Apache-2.0 */
#include "text_file.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cancel.h"

#define BUFFER ((size_t)1 << 18)
#define LONGEST 64 /* of a number */

bool text_open(text_file *t, const char *path, failure *why) {
  *t = (text_file){.path = path};
  t->buffer = malloc(BUFFER);
  if (!t->buffer) return fail(why, EXIT_FAILURE, "out of memory");
  t->to = fopen(path, "w");
  if (t->to) return true;
  fail(why, EXIT_FAILURE, "cannot write '%s': %s", path, strerror(errno));
  free(t->buffer);
  return false;
}

static void flush(text_file *t) {
  if (cancel_requested()) t->cancelled = true;
  if (!t->cancelled && t->used && fwrite(t->buffer, 1, t->used, t->to) != t->used) t->failed = true;
  t->used = 0;
}

static void put(text_file *t, const char *text, size_t length) {
  if (t->used + length > BUFFER) flush(t);
  if (length > BUFFER) length = BUFFER;
  memcpy(t->buffer + t->used, text, length);
  t->used += length;
  t->put += length;
}

void text_put(text_file *t, const char *text) { put(t, text, strlen(text)); }

static void digits(text_file *t, uint64_t number, int least) {
  char back[24];
  int n = 0;
  while (number || n < least) {
    back[n++] = (char)('0' + number % 10);
    number /= 10;
  }
  char out[24];
  for (int i = 0; i < n; i++) out[i] = back[n - 1 - i];
  put(t, out, (size_t)n);
}

static void fixed(text_file *t, double number, int places) {
  static const double scales[] = {1, 10, 100, 1e3, 1e4, 1e5, 1e6, 1e7};
  double scaled = round(fabs(number) * scales[places]);
  if (!(scaled < 9e15)) {
    char text[LONGEST];
    int n = snprintf(text, sizeof text, "%.9g", number);
    put(t, text, (size_t)n);
    return;
  }
  uint64_t whole = (uint64_t)scaled, unit = (uint64_t)scales[places];
  if (number < 0 && whole) put(t, "-", 1);
  digits(t, whole / unit, 1);
  uint64_t part = whole % unit;
  if (!part) return;
  while (part % 10 == 0) {
    part /= 10;
    places--;
  }
  put(t, ".", 1);
  digits(t, part, places);
}

void text_number(text_file *t, double number) { fixed(t, number, 3); }
void text_fine(text_file *t, double number) { fixed(t, number, 5); }
void text_finest(text_file *t, double number) { fixed(t, number, 7); }
void text_whole(text_file *t, uint64_t number) { digits(t, number, 1); }

bool text_close(text_file *t, failure *why) {
  flush(t);
  bool failed = fclose(t->to) != 0 || t->failed;
  free(t->buffer);
  if (t->cancelled) return fail(why, EXIT_FAILURE, "cancelled");
  return !failed || fail(why, EXIT_FAILURE, "cannot write '%s': %s", t->path, strerror(errno));
}
