/* SPDX-License-Identifier: Apache-2.0 */
#define _GNU_SOURCE /* strtod_l */
#include "numbers.h"

#include <ctype.h>
#include <locale.h>
#include <math.h>
#include <pthread.h>
#include <stdlib.h>

static locale_t c_locale;
static void make_locale(void) { c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0); }

/* The same whatever locale the program has set. */
static double to_double(const char *text, char **end) {
  static pthread_once_t once = PTHREAD_ONCE_INIT;
  pthread_once(&once, make_locale);
  return c_locale ? strtod_l(text, end, c_locale) : strtod(text, end);
}

/* strtod but for leading space and hexadecimal: in "0x10" the x parts two numbers. */
static bool read_one(const char **text, double *out) {
  const char *digits = *text;
  if (*digits == '-' || *digits == '+') digits++;
  if (!isdigit((unsigned char)*digits) && *digits != '.') return false;
  if (digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X')) {
    *out = 0;
    *text = digits + 1;
    return true;
  }
  char *end;
  *out = to_double(*text, &end);
  if (end == *text || !isfinite(*out)) return false;
  *text = end;
  return true;
}

bool number_read(const char *text, double *out) { return numbers_read(text, '\0', out, 1) == 1; }

size_t numbers_read(const char *text, char between, double *out, size_t most) {
  size_t count = 0;
  for (;;) {
    if (count == most || !read_one(&text, &out[count])) return 0;
    count++;
    if (*text == '\0') return count;
    if (*text != between) return 0;
    text++;
  }
}
