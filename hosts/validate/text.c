/* SPDX-License-Identifier: Apache-2.0 */
#include "text.h"

#include <string.h>

#include "utf8.h"

bool utf8_valid(const char *text) {
  for (const unsigned char *s = (const unsigned char *)text; *s;) {
    int n = utf8_length(s);
    if (n == 0) return false;
    s += n;
  }
  return true;
}

bool one_line(const char *text) {
  for (const unsigned char *s = (const unsigned char *)text; *s; s++)
    if (*s < 0x20 || *s == 0x7f) return false;
  return true;
}

bool id_valid(const char *text, const char *more) {
  if (!(*text >= 'a' && *text <= 'z')) return false;
  for (; *text; text++)
    if (!((*text >= 'a' && *text <= 'z') || (*text >= '0' && *text <= '9') || *text == '_' ||
          strchr(more, *text)))
      return false;
  return true;
}
