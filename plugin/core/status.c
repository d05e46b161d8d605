/* SPDX-License-Identifier: Apache-2.0 */
#define _GNU_SOURCE
#include "status.h"

#include <locale.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "float_mode.h"

static _Thread_local char message[1024];
static locale_t c_locale;

int status_open(void) {
  if (!c_locale) c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
  return c_locale != (locale_t)0;
}

void status_close(void) {
  if (c_locale) freelocale(c_locale);
  c_locale = (locale_t)0;
}

static void print_in_c(char *out, size_t size, const char *format, va_list list) {
  locale_t before = c_locale ? uselocale(c_locale) : (locale_t)0;
  float_mode_all mode = float_mode_enter_all();
  vsnprintf(out, size, format, list);
  float_mode_leave_all(mode);
  if (before) uselocale(before);
}

/* Bytes of the UTF-8 character at s, 0 when it is none or cut off. */
static size_t character(const unsigned char *s) {
  if (s[0] < 0x80) return 1;
  size_t n = s[0] >= 0xf0 ? 4 : s[0] >= 0xe0 ? 3 : 2;
  if (s[0] < 0xc2 || s[0] > 0xf4) return 0;
  for (size_t i = 1; i < n; i++)
    if ((s[i] & 0xc0) != 0x80) return 0;
  if ((s[0] == 0xe0 && s[1] < 0xa0) || (s[0] == 0xed && s[1] > 0x9f)) return 0;
  if ((s[0] == 0xf0 && s[1] < 0x90) || (s[0] == 0xf4 && s[1] > 0x8f)) return 0;
  return n;
}

/* Whether a terminal or a log would take it for more than text: ASCII's controls, those
 * from U+0080 to U+009F, and U+2028 and U+2029, which end lines as well. */
static int steers(const unsigned char *s, size_t n) {
  if (n == 1) return s[0] < 0x20 || s[0] == 0x7f;
  if (n == 2) return s[0] == 0xc2 && s[1] < 0xa0;
  return n == 3 && s[0] == 0xe2 && s[1] == 0x80 && (s[2] == 0xa8 || s[2] == 0xa9);
}

/* A message repeats what the host handed in, which may hold line ends, a
 * terminal's controls, or a character that "%.80s" cut in two. One line of
 * UTF-8 comes out, no longer than what came. */
static void make_line(char *text) {
  unsigned char *out = (unsigned char *)text;
  for (const unsigned char *s = out; *s;) {
    size_t n = character(s);
    if (n == 0 || steers(s, n)) {
      *out++ = n ? ' ' : '?';
    } else {
      memmove(out, s, n);
      out += n;
    }
    s += n ? n : 1;
  }
  *out = 0;
}

int32_t fail(int32_t code, const char *format, ...) {
  va_list list;
  va_start(list, format);
  print_in_c(message, sizeof message, format, list);
  make_line(message);
  va_end(list);
  return code;
}

const char *fail_message(void) { return message; }

int read_number(const char *text, const char *end, double *out) {
  char copy[512];
  size_t n = (size_t)(end - text);
  if (n == 0 || n >= sizeof copy) return 0;
  memcpy(copy, text, n);
  copy[n] = 0;
  char *stop;
  float_mode_all mode = float_mode_enter_all();
  *out = c_locale ? strtod_l(copy, &stop, c_locale) : strtod(copy, &stop);
  float_mode_leave_all(mode);
  return *stop == 0;
}

sozai_host host_copy(const sozai_host *host) {
  sozai_host h;
  memset(&h, 0, sizeof h);
  if (host) memcpy(&h, host, whole_members(host->size, sizeof h, PAIR_AT(sozai_host, limit_count)));
  return h;
}

void *host_alloc(const sozai_host *host, size_t size, size_t align) {
  void *p;
  if (host && host->alloc && host->free) {
    p = host->alloc(host->user, size, align);
  } else {
    p = aligned_alloc(align, (size + align - 1) / align * align);
  }
  if (p) {
    memset(p, 0, size);
  } else {
    fail(SOZAI_ERROR_MEMORY, "out of memory: %zu bytes could not be had", size);
  }
  return p;
}

void host_free(const sozai_host *host, void *memory, size_t size, size_t align) {
  if (!memory) return;
  if (host && host->alloc && host->free) {
    host->free(host->user, memory, size, align);
  } else {
    free(memory);
  }
}

void host_log(const sozai_host *host, int32_t severity, const char *format, ...) {
  if (!host || !host->log) return;
  char text[1024];
  va_list list;
  va_start(list, format);
  print_in_c(text, sizeof text, format, list);
  make_line(text);
  va_end(list);
  host->log(host->user, severity, text);
}
