/* SPDX-License-Identifier: Apache-2.0 */
#include "verdict.h"

#include <stdarg.h>
#include <stdio.h>

#include "check.h"

static verdict *own;

void verdict_to(verdict *v) { own = v; }

void verdict_chance(void) {
  if (own) atomic_store_explicit(&own->chance, true, memory_order_relaxed);
}

void asked(void) {
  if (own) atomic_fetch_add_explicit(&own->asked, 1, memory_order_relaxed);
}

bool enough(void) { return own && atomic_load(&own->failures) >= VERDICT_LINES; }

static void add(atomic_uint *count, char lines[VERDICT_LINES][VERDICT_LINE], const char *format,
                va_list list) {
  unsigned at = atomic_fetch_add(count, 1);
  if (at < VERDICT_LINES) vsnprintf(lines[at], VERDICT_LINE, format, list);
}

void failed(const char *format, ...) {
  va_list list;
  va_start(list, format);
  if (own) add(&own->failures, own->failure, format, list);
  va_end(list);
}

void verdict_fail(verdict *v, const char *format, ...) {
  va_list list;
  va_start(list, format);
  add(&v->failures, v->failure, format, list);
  va_end(list);
}

void warned(const char *format, ...) {
  va_list list;
  va_start(list, format);
  if (own) add(&own->warnings, own->warning, format, list);
  va_end(list);
}

void skipped(const char *format, ...) {
  va_list list;
  va_start(list, format);
  if (own) vsnprintf(own->skip, sizeof own->skip, format, list);
  va_end(list);
}

void doing(const char *format, ...) {
  va_list list;
  va_start(list, format);
  if (own) vsnprintf(own->doing, sizeof own->doing, format, list);
  va_end(list);
}
