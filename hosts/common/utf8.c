/* SPDX-License-Identifier: Apache-2.0 */
#include "utf8.h"

int utf8_length(const unsigned char *s) {
  if (s[0] < 0x80) return 1;
  int length = s[0] >= 0xf0 ? 4 : s[0] >= 0xe0 ? 3 : 2;
  if (s[0] < 0xc2 || s[0] > 0xf4) return 0;
  for (int i = 1; i < length; i++)
    if ((s[i] & 0xc0) != 0x80) return 0;
  if (s[0] == 0xe0 && s[1] < 0xa0) return 0;
  if (s[0] == 0xed && s[1] > 0x9f) return 0;
  if (s[0] == 0xf0 && s[1] < 0x90) return 0;
  if (s[0] == 0xf4 && s[1] > 0x8f) return 0;
  return length;
}

uint32_t utf8_code(const unsigned char *s, int length) {
  uint32_t code = s[0] & (0x7fu >> length);
  for (int i = 1; i < length; i++) code = code << 6 | (s[i] & 0x3f);
  return code;
}

bool utf8_whole(const char *text) {
  for (int n; *text; text += n)
    if ((n = utf8_length((const unsigned char *)text)) == 0) return false;
  return true;
}

bool utf8_plain(uint32_t code) {
  bool control = code < 0xa0 || code == 0xfeff || code == 0xfffe || code == 0xffff;
  return !control && code != 0x2028 && code != 0x2029;
}
