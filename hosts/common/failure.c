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
