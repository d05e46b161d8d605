/* SPDX-License-Identifier: Apache-2.0
 * Writing JSON: commas, escapes and indentation. */
#ifndef SOZAI_HOSTS_JSON_H
#define SOZAI_HOSTS_JSON_H

#include <stdbool.h>
#include <stdio.h>

typedef struct json {
  FILE *to;
  int depth;
  bool first; /* nothing yet at this depth */
} json;

/* key: the member's name within an object; NULL within an array, or at the top. */
void json_open(json *j, const char *key, char bracket); /* '{' or '[' */
void json_close(json *j, char bracket);                 /* '}' or ']' */
void json_text(json *j, const char *key, const char *text);
/* In the fewest digits that read back the same; not finite: null. */
void json_number(json *j, const char *key, double number);
void json_bool(json *j, const char *key, bool value);
void json_null(json *j, const char *key);

/* The number's text, in those digits. */
void number_text(char *text, size_t size, double number);

#endif
