/* SPDX-License-Identifier: Apache-2.0 */
#include "quoted.h"

#include "utf8.h"

static void print_character(FILE *to, const char *text, int length) {
  uint32_t code = utf8_code((const unsigned char *)text, length);
  if (utf8_plain(code))
    fwrite(text, 1, (size_t)length, to);
  else
    fprintf(to, "\\u%04x", (unsigned)code);
}

void print_quoted(FILE *to, const char *text) {
  fputc('"', to);
  for (; *text; text++) {
    unsigned char c = (unsigned char)*text;
    int length = utf8_length((const unsigned char *)text);
    if (length > 1) {
      print_character(to, text, length);
      text += length - 1;
    } else if (c == '"' || c == '\\')
      fprintf(to, "\\%c", c);
    else if (c < 0x20 || c == 0x7f)
      fprintf(to, "\\x%02x", c);
    else
      fputc(c, to);
  }
  fputc('"', to);
}
