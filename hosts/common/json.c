/* SPDX-License-Identifier: Apache-2.0 */
#include "json.h"

#include <math.h>
#include <stdlib.h>
#include "utf8.h"

static void write_string(FILE *to, const char *text) {
  fputc('"', to);
  for (const unsigned char *s = (const unsigned char *)text; *s;) {
    int length = utf8_length(s);
    if (length == 0) {
      fputs("\\ufffd", to);
      s++;
      continue;
    }
    if (*s == '"' || *s == '\\')
      fprintf(to, "\\%c", *s);
    else if (*s == '\n')
      fputs("\\n", to);
    else if (*s < 0x20 || *s == 0x7f)
      fprintf(to, "\\u%04x", *s);
    else
      fwrite(s, 1, (size_t)length, to);
    s += length;
  }
  fputc('"', to);
}

/* The comma, newline, indentation and name that go before a value. */
static void begin(json *j, const char *key) {
  if (j->depth > 0) {
    if (!j->first) fputc(',', j->to);
    fprintf(j->to, "\n%*s", 2 * j->depth, "");
  }
  j->first = false;
  if (!key) return;
  write_string(j->to, key);
  fputs(": ", j->to);
}

void json_open(json *j, const char *key, char bracket) {
  begin(j, key);
  fputc(bracket, j->to);
  j->depth++;
  j->first = true;
}

void json_close(json *j, char bracket) {
  j->depth--;
  if (!j->first) fprintf(j->to, "\n%*s", 2 * j->depth, "");
  fputc(bracket, j->to);
  j->first = false;
  if (j->depth == 0) fputc('\n', j->to);
}

void json_text(json *j, const char *key, const char *text) {
  begin(j, key);
  write_string(j->to, text ? text : "");
}

void number_text(char *text, size_t size, double number) {
  for (int digits = 6; digits <= 17;
       digits++) { /* %g drops zeros, but with few digits writes 1e+01 */
    snprintf(text, size, "%.*g", digits, number);
    if (strtod(text, NULL) == number) return;
  }
}

void json_number(json *j, const char *key, double number) {
  if (!isfinite(number)) {
    json_null(j, key);
    return;
  }
  char text[40];
  number_text(text, sizeof text, number);
  begin(j, key);
  fputs(text, j->to);
}

void json_bool(json *j, const char *key, bool value) {
  begin(j, key);
  fputs(value ? "true" : "false", j->to);
}

void json_null(json *j, const char *key) {
  begin(j, key);
  fputs("null", j->to);
}
