/* SPDX-License-Identifier: Apache-2.0
 * Writing text fast: millions of numbers, in the fewest digits that keep
 * 1/1000 mm, and a write that fails is noticed once, at the end. */
#ifndef SOZAI_HOSTS_TEXT_FILE_H
#define SOZAI_HOSTS_TEXT_FILE_H

#include <stddef.h>
#include <stdint.h>
#include "failure.h"

typedef struct text_file {
  void *to; /* FILE */
  const char *path;
  char *buffer;
  size_t used;
  uint64_t put; /* bytes so far */
  bool failed, cancelled;
} text_file;

bool text_open(text_file *t, const char *path, failure *why);
void text_put(text_file *t, const char *text);
void text_number(text_file *t, double number); /* three decimals at most */
void text_fine(text_file *t, double number);   /* five */
void text_finest(text_file *t, double number); /* seven */
void text_whole(text_file *t, uint64_t number);
/* false: something was not written, or the user asked to stop. */
bool text_close(text_file *t, failure *why);

#endif
