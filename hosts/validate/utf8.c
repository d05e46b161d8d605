/* SPDX-License-Identifier: Apache-2.0 */
#include "utf8.h"

#include <string.h>

static int length_at(const unsigned char *s) {
  if (s[0] < 0x80) return 1;
  int n = s[0] >= 0xf0 ? 4 : s[0] >= 0xe0 ? 3 : 2;
  if (s[0] < 0xc2 || s[0] > 0xf4) return 0;
  for (int i = 1; i < n; i++)
    if ((s[i] & 0xc0) != 0x80) return 0;
  if ((s[0] == 0xe0 && s[1] < 0xa0) || (s[0] == 0xed && s[1] > 0x9f)) return 0;
  if ((s[0] == 0xf0 && s[1] < 0x90) || (s[0] == 0xf4 && s[1] > 0x8f)) return 0;
  return n;
}

bool utf8_valid(const char *text) {
  for (const unsigned char *s = (const unsigned char *)text; *s;) {
    int n = length_at(s);
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
