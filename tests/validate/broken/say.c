/* SPDX-License-Identifier: Apache-2.0
 * What went wrong, and the host's services. */
#define _GNU_SOURCE
#include <locale.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plugin.h"

static locale_t c_locale;
#ifdef SHARED_ERROR
static char message[400];
#else
static _Thread_local char message[400];
#endif

bool say_open(void) {
  if (!c_locale) c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
  return c_locale != (locale_t)0;
}

void say_close(void) {
  if (c_locale) freelocale(c_locale);
  c_locale = (locale_t)0;
}

/* One line of ASCII, whatever the host's texts hold. */
int32_t say(int32_t code, const char *format, ...) {
#ifdef EMPTY_ERROR
  if (code == SOZAI_ERROR_RANGE) {
    message[0] = '\0';
    return code;
  }
#endif
  va_list list;
  va_start(list, format);
  locale_t before = c_locale ? uselocale(c_locale) : (locale_t)0;
#ifdef COMMA_WRITTEN
  if (before) uselocale(before);
#endif
  vsnprintf(message, sizeof message, format, list);
  if (before) uselocale(before);
  va_end(list);
#ifndef TWO_LINE_ERROR
  for (char *c = message; *c; c++)
    if ((unsigned char)*c < 0x20 || (unsigned char)*c > 0x7e) *c = '?';
#endif
  return code;
}

const char *said(void) { return message; }

bool number_of(const char *text, const char **end, double *out) {
  char *stop;
#ifdef COMMA_READ
  *out = strtod(text, &stop);
#else
  *out = strtod_l(text, &stop, c_locale);
#endif
#ifdef TEXT_AS_FLOAT
  *out = (float)*out;
#endif
  *end = stop;
  return stop != text;
}

sozai_host host_of(const sozai_host *given) {
  sozai_host h;
  memset(&h, 0, sizeof h);
  if (given) memcpy(&h, given, given->size < sizeof h ? given->size : sizeof h);
  return h;
}

void *take(const sozai_host *h, uint64_t size) {
  bool own = h->alloc && h->free;
  void *memory = own ? h->alloc(h->user, size, 16) : malloc(size);
#ifdef MEMORY_TRUSTED
  memset(memory, 0, size);
#else
  if (memory) memset(memory, 0, size);
#endif
  if (!memory) say(SOZAI_ERROR_MEMORY, "out of memory");
  return memory;
}

void give_back(const sozai_host *h, void *memory, uint64_t size) {
  if (!memory) return;
#ifdef FREE_OF_ANOTHER_SIZE
  size += 16;
#endif
  if (h->alloc && h->free)
    h->free(h->user, memory, size, 16);
  else
    free(memory);
}

bool host_cancels(const sozai_host *h, float fraction) {
#ifdef PERCENT
  fraction *= 100;
#endif
#ifdef SERVICE_TRUSTED
  return h->progress(h->user, fraction, "plain") != 0;
#endif
#ifdef CANCEL_IGNORED
  if (h->progress) h->progress(h->user, fraction, "plain");
  return false;
#endif
  return h->progress && h->progress(h->user, fraction, "plain") != 0;
}

typedef struct {
  void (*task)(void *, uint32_t);
  void *context;
  unsigned char *ran;
} once;

static void run_once(void *context, uint32_t i) {
  const once *o = context;
  if (!o->ran[i]) o->task(o->context, i);
  o->ran[i] = 1;
}

void run_all(const sozai_host *h, uint32_t count, void (*task)(void *, uint32_t), void *context) {
#ifdef REFUSAL_IGNORED
  if (h->parallel) {
    h->parallel(h->user, count, task, context);
    return;
  }
#endif
#ifdef POOL_TRUSTED
  if (h->parallel && h->parallel(h->user, count, task, context) == 0) return;
  for (uint32_t i = 0; i < count; i++) task(context, i);
#else
  once o = {task, context, calloc(count, 1)};
  if (o.ran && h->parallel) h->parallel(h->user, count, run_once, &o);
  for (uint32_t i = 0; o.ran && i < count; i++) run_once(&o, i);
  free(o.ran);
#endif
}
