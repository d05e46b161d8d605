/* SPDX-License-Identifier: Apache-2.0 */
#include "failure.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

bool fail(failure *why, int exit_code, const char *format, ...) {
  char text[sizeof why->text];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  /* Messages of other libraries may end in newlines or hold some, and what a file says may be
   * anything: one line only, and nothing that steers a terminal. */
  size_t length = strlen(text);
  while (length > 0 && (text[length - 1] == '\n' || text[length - 1] == ' ')) text[--length] = '\0';
  for (size_t i = 0; i < length; i++)
    if ((unsigned char)text[i] < ' ' || text[i] == 0x7f) text[i] = ' ';
  memcpy(why->text, text, length + 1);
  why->exit_code = exit_code;
  return false;
}

void failure_rename(failure *why, const char *from, const char *to) {
  char text[sizeof why->text];
  size_t used = 0, length = strlen(from), new_length = strlen(to);
  for (const char *at = why->text; *at && used + 1 < sizeof text;) {
    if (strncmp(at, from, length) != 0) {
      text[used++] = *at++;
      continue;
    }
    size_t room = sizeof text - 1 - used, n = new_length < room ? new_length : room;
    memcpy(text + used, to, n);
    used += n;
    at += length;
  }
  text[used] = '\0';
  memcpy(why->text, text, used + 1);
}
