/* SPDX-License-Identifier: Apache-2.0
 *
 * Values to settings and back, for every kind of parameter: defaults, presets,
 * text, and every refusal with the message that goes with it.
 */
#include <locale.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "allocator.h"
#include "core/status.h"
#include "every_kind.h"

#include <cmocka.h> /* last: it has a macro named fail */

static allocator memory;
static sozai_host host;
static settings now;

static int32_t make(const char *preset, const sozai_value *values, uint32_t count) {
  return settings_make(&now, &host, &every_kind, preset, values, count);
}

static void done(void) {
  settings_free(&now, &host);
  assert_int_equal(memory.live, 0);
  assert_int_equal(memory.wrong, 0);
}

static sozai_value text(const char *id, const char *s) {
  return (sozai_value){.id = id, .kind = SOZAI_KIND_STRING, .text = s};
}

static sozai_value number(const char *id, uint32_t kind, double x) {
  return (sozai_value){.id = id, .kind = kind, .number = {x, x, x}};
}

static sozai_value kept(const char *id) {
  sozai_value v;
  assert_int_equal(settings_value(&now, &every_kind, id, &v), SOZAI_OK);
  assert_string_equal(v.id, id);
  return v;
}

/* Refused with that code, and the message has every one of the words. */
static void refused(sozai_value v, int32_t code, const char *words) {
  int32_t r = make(NULL, &v, 1);
  char copy[512];
  snprintf(copy, sizeof copy, "%s", words);
  if (r != code) fail_msg("%s: %d, not %d (%s)", v.id ? v.id : "?", r, code, fail_message());
  for (char *w = strtok(copy, "|"); w; w = strtok(NULL, "|")) {
    if (!strstr(fail_message(), w)) fail_msg("\"%s\" does not say \"%s\"", fail_message(), w);
  }
  assert_null(now.list);
  done();
}

/* ---- defaults and presets --------------------------------------------- */

static void defaults(void **unused) {
  (void)unused;
  assert_int_equal(make(NULL, NULL, 0), SOZAI_OK);
  assert_int_equal(now.count, K_COUNT);
  assert_true(kept("width").number[0] == 1.25);
  assert_true(kept("count").number[0] == 7);
  assert_true(kept("hollow").number[0] == 1);
  assert_string_equal(kept("shape").text, "square");
  assert_true(kept("shape").number[0] == 1);
  assert_true(kept("offset").number[2] == 3);
  assert_string_equal(kept("tint").text, "sRGB");
  assert_true(kept("tint").number[1] == 0.25);
  assert_string_equal(kept("name").text, "nobody");
  assert_string_equal(kept("file").text, "");
  assert_null(kept("table").buffer);
  sozai_value v;
  assert_int_equal(settings_value(&now, &every_kind, "none", &v), SOZAI_ERROR_UNKNOWN);
  done();
}

static void presets(void **unused) {
  (void)unused;
  const sozai_value twice[] = {number("width", SOZAI_KIND_FLOAT, 3),
                               number("width", SOZAI_KIND_FLOAT, 4)};
  assert_int_equal(make("small", twice, 2), SOZAI_OK);
  assert_true(kept("width").number[0] == 4); /* values go on top; the later counts */
  assert_string_equal(kept("shape").text, "ring");
  assert_string_equal(kept("tint").text, "lin_rec709");
  assert_true(kept("count").number[0] == 7);
  done();
  assert_int_equal(make("large", NULL, 0), SOZAI_ERROR_UNKNOWN);
  assert_non_null(strstr(fail_message(), "large"));
  assert_int_equal(make("broken", NULL, 0), SOZAI_ERROR_RANGE);
  assert_int_equal(make(NULL, NULL, 1), SOZAI_ERROR_ARGUMENT);
  done();
}

/* ---- numbers ----------------------------------------------------------- */

static void numbers(void **unused) {
  (void)unused;
  const sozai_value all[] = {
      number("width", SOZAI_KIND_INT, 3), number("count", SOZAI_KIND_INT, 4294967295.0),
      number("hollow", SOZAI_KIND_BOOL, 0), number("offset", SOZAI_KIND_FLOAT3, -100)};
  assert_int_equal(make(NULL, all, 4), SOZAI_OK);
  assert_true(kept("width").number[0] == 3 && kept("width").kind == SOZAI_KIND_FLOAT);
  assert_true(kept("count").number[0] == 4294967295.0);
  assert_true(kept("hollow").number[0] == 0);
  assert_true(kept("offset").number[1] == -100);
  done();
  sozai_value v = number("width", SOZAI_KIND_FLOAT, -0.0);
  assert_int_equal(make(NULL, &v, 1), SOZAI_OK);
  assert_true(kept("width").number[0] == 0.0);
  done();
  v = number("width", SOZAI_KIND_FLOAT, 4.9e-324);
  assert_int_equal(make(NULL, &v, 1), SOZAI_OK);
  done();
}

static void numbers_refused(void **unused) {
  (void)unused;
  refused(number("width", SOZAI_KIND_FLOAT, 40.001), SOZAI_ERROR_RANGE, "width|40.001|-2.5|40");
  refused(number("width", SOZAI_KIND_FLOAT, -2.6), SOZAI_ERROR_RANGE, "width|-2.6|-2.5|40");
  refused(number("width", SOZAI_KIND_FLOAT, (double)NAN), SOZAI_ERROR_RANGE, "width|nan|-2.5|40");
  refused(number("width", SOZAI_KIND_FLOAT, (double)INFINITY), SOZAI_ERROR_RANGE, "width|inf");
  refused(number("width", SOZAI_KIND_FLOAT, 1e30), SOZAI_ERROR_RANGE, "width|1e+30");
  refused(number("count", SOZAI_KIND_INT, 1.5), SOZAI_ERROR_KIND, "count|1.5|whole");
  refused(number("count", SOZAI_KIND_INT, 4294967296.0), SOZAI_ERROR_RANGE, "count|4294967296");
  refused(number("count", SOZAI_KIND_INT, (double)NAN), SOZAI_ERROR_RANGE, "count|nan");
  refused(number("count", SOZAI_KIND_INT, -1e300), SOZAI_ERROR_RANGE, "count|-1e+300");
  refused(number("count", SOZAI_KIND_FLOAT, 1), SOZAI_ERROR_KIND, "count|an int|a float");
  refused(number("hollow", SOZAI_KIND_BOOL, 2), SOZAI_ERROR_RANGE, "hollow|2|0 to 1");
  refused(number("hollow", SOZAI_KIND_BOOL, 0.5), SOZAI_ERROR_KIND, "hollow|0.5");
  refused(number("hollow", SOZAI_KIND_INT, 1), SOZAI_ERROR_KIND, "hollow|a bool|an int");
  refused(number("shape", SOZAI_KIND_INT, 1), SOZAI_ERROR_KIND, "shape|a choice|an int");
  refused(number("width", 77, 1), SOZAI_ERROR_KIND, "width|unknown");
  refused(number(NULL, SOZAI_KIND_FLOAT, 1), SOZAI_ERROR_ARGUMENT, "value 0");
  refused(number("breadth", SOZAI_KIND_FLOAT, 1), SOZAI_ERROR_UNKNOWN, "breadth|every");
  sozai_value v = {.id = "offset", .kind = SOZAI_KIND_FLOAT3, .number = {0, 0, 101}};
  refused(v, SOZAI_ERROR_RANGE, "offset|101|-100 to 100");
  v = (sozai_value){.id = "tint", .kind = SOZAI_KIND_COLOUR, .number = {0, (double)NAN, 0}};
  refused(v, SOZAI_ERROR_RANGE, "tint|nan|0 to 1");
}

/* ---- text -------------------------------------------------------------- */

typedef struct {
  const char *id, *text;
  double number[3];
  const char *kept;
} reading;

static void read_text_forms(void **unused) {
  (void)unused;
  static const reading forms[] = {
      {"width", "1.5", {1.5}, NULL},
      {"width", "  -2.5e0 ", {-2.5}, NULL},
      {"width", "12", {12}, NULL},
      {"width", "0x1p3", {8}, NULL},
      {"count", "12", {12}, NULL},
      {"hollow", "true", {1}, NULL},
      {"hollow", "off", {0}, NULL},
      {"hollow", "no", {0}, NULL},
      {"hollow", "1", {1}, NULL},
      {"shape", "ring", {2}, "ring"},
      {"offset", "1 2 3", {1, 2, 3}, NULL},
      {"offset", "1,-2.5, 3", {1, -2.5, 3}, NULL},
      {"tint", "#ff8000", {1, 128 / 255.0, 0}, "sRGB"},
      {"tint", "#C08040 @ ACEScg", {192 / 255.0, 128 / 255.0, 64 / 255.0}, "ACEScg"},
      {"tint", "0.2 0.1 0.05 @ ACES - ACEScg", {0.2, 0.1, 0.05}, "ACES - ACEScg"},
      {"tint", "0.2 0.1 0.05", {0.2, 0.1, 0.05}, "sRGB"},
      {"name", " kept as it is @ ", {0}, " kept as it is @ "},
      {"file", "/a b/c.exr", {0}, "/a b/c.exr"}};
  for (size_t i = 0; i < sizeof forms / sizeof *forms; i++) {
    sozai_value v = text(forms[i].id, forms[i].text);
    if (make(NULL, &v, 1)) fail_msg("\"%s\": %s", forms[i].text, fail_message());
    v = kept(forms[i].id);
    for (int c = 0; c < 3; c++) {
      if (fabs(v.number[c] - forms[i].number[c]) > 1e-15 && c < 1 + 2 * (v.kind > 4 && v.kind < 7))
        fail_msg("\"%s\": number %d is %.17g", forms[i].text, c, v.number[c]);
    }
    if (forms[i].kept) assert_string_equal(v.text, forms[i].kept);
    done();
  }
}

static void text_refused(void **unused) {
  (void)unused;
  refused(text("width", "wide"), SOZAI_ERROR_KIND, "width|wide|a number");
  refused(text("width", ""), SOZAI_ERROR_KIND, "width|a number");
  refused(text("width", "1 2"), SOZAI_ERROR_KIND, "width|1 2");
  refused(text("width", "1.5mm"), SOZAI_ERROR_KIND, "width|1.5mm");
  refused(text("width", "1;5"), SOZAI_ERROR_KIND, "width|1;5");
  refused(text("width", "nan"), SOZAI_ERROR_RANGE, "width|nan|-2.5");
  refused(text("width", "inf"), SOZAI_ERROR_RANGE, "width|inf");
  refused(text("width", "1e400"), SOZAI_ERROR_RANGE, "width|inf");
  refused(text("width", "41"), SOZAI_ERROR_RANGE, "width|41|-2.5 to 40");
  refused(text("count", "1.5"), SOZAI_ERROR_KIND, "count|1.5");
  refused(text("hollow", "maybe"), SOZAI_ERROR_KIND, "hollow|maybe|true or false");
  refused(text("shape", "oval"), SOZAI_ERROR_RANGE, "shape|oval|round, square, ring");
  refused(text("offset", "1 2"), SOZAI_ERROR_KIND, "offset|1 2|three numbers");
  refused(text("offset", "1 2 3 4"), SOZAI_ERROR_KIND, "offset|1 2 3 4");
  refused(text("offset", "1 2 3 @ ACEScg"), SOZAI_ERROR_KIND, "offset|@");
  refused(text("offset", "#102030"), SOZAI_ERROR_KIND, "offset|#102030");
  refused(text("offset", "1 2 300"), SOZAI_ERROR_RANGE, "offset|300");
  refused(text("tint", "#12345"), SOZAI_ERROR_KIND, "tint|#12345|#rrggbb");
  refused(text("tint", "#1234567"), SOZAI_ERROR_KIND, "tint|#1234567");
  refused(text("tint", "#12345g"), SOZAI_ERROR_KIND, "tint|#12345g");
  refused(text("tint", "0.1 0.2 0.3 @"), SOZAI_ERROR_KIND, "tint|space");
  refused(text("tint", "0.1 0.2 1.5"), SOZAI_ERROR_RANGE, "tint|1.5|0 to 1");
  refused(text("table", "1 2 3"), SOZAI_ERROR_KIND, "table|buffer");
  refused(text("width", NULL), SOZAI_ERROR_ARGUMENT, "width|NULL");
  refused((sozai_value){.id = "name", .kind = SOZAI_KIND_TEXT}, SOZAI_ERROR_ARGUMENT, "name|NULL");
  refused((sozai_value){.id = "shape", .kind = SOZAI_KIND_CHOICE}, SOZAI_ERROR_ARGUMENT, "shape");
  refused((sozai_value){.id = "name", .kind = SOZAI_KIND_PATH, .text = "x"}, SOZAI_ERROR_KIND,
          "name|text|a path");
}

static void long_text(void **unused) {
  (void)unused;
  char *s = malloc(1u << 20);
  assert_non_null(s);
  memset(s, 'x', (1u << 20) - 1);
  s[(1u << 20) - 1] = 0;
  refused(text("name", s), SOZAI_ERROR_LIMIT, "name|1048575|text_bytes, 65536");
  refused((sozai_value){.id = "tint", .kind = SOZAI_KIND_COLOUR, .text = s}, SOZAI_ERROR_LIMIT,
          "tint|1048575");
  s[65536] = 0;
  refused(text("width", s), SOZAI_ERROR_KIND, "width|xxxx");
  refused(text("shape", s), SOZAI_ERROR_RANGE, "shape|round");
  refused(text(s, "1"), SOZAI_ERROR_UNKNOWN, "xxxx");
  memset(s, '1', 600);
  s[600] = 0;
  refused(text("width", s), SOZAI_ERROR_KIND, "width|1111");
  s[200] = 0;
  refused(text("width", s), SOZAI_ERROR_RANGE, "width|40");
  memset(s, 'x', 65536);
  s[65536] = 0;
  sozai_value v = text("name", s);
  assert_int_equal(make(NULL, &v, 1), SOZAI_OK);
  assert_string_equal(kept("name").text, s);
  assert_ptr_not_equal(kept("name").text, s);
  free(s);
  done();
}

/* Numbers are read and written as in C, whatever the program's locale. */
static void other_locale(void **unused) {
  (void)unused;
  static const char *const names[] = {"sozai_comma.UTF-8", "de_DE.UTF-8", "de_DE.utf8",
                                      "fr_FR.UTF-8", "de_DE"};
  size_t k = 0;
  while (k < 5 && !setlocale(LC_ALL, names[k])) k++;
  if (k == 5) {
    print_message("no locale with a decimal comma on this machine\n");
    skip();
  }
  assert_string_equal(localeconv()->decimal_point, ",");
  sozai_value v = text("width", "1.5");
  int32_t r = make(NULL, &v, 1);
  double read = r ? 0.0 : kept("width").number[0];
  if (!r) done();
  v = text("width", "40.5");
  int32_t out = make(NULL, &v, 1);
  const char *still = setlocale(LC_ALL, NULL);
  int same = strcmp(still, names[k]) == 0;
  setlocale(LC_ALL, "C");
  assert_int_equal(r, SOZAI_OK);
  assert_true(read == 1.5);
  assert_int_equal(out, SOZAI_ERROR_RANGE);
  assert_non_null(strstr(fail_message(), "40.5 is outside -2.5 to 40"));
  assert_true(same);
}

/* ---- messages ---------------------------------------------------------- */

static void says(const char *text, const char *want) {
  /* in brackets: cmocka has a macro of that name */
  assert_int_equal((fail)(SOZAI_ERROR_FILE, "%s", text), SOZAI_ERROR_FILE);
  assert_string_equal(fail_message(), want);
}

static void one_line_of_text(void **unused) {
  (void)unused;
  says("plain, na\xc3\xafve \xe2\x80\xa6", "plain, na\xc3\xafve \xe2\x80\xa6");
  says("\n\r\t\x1b[31m\x7f.", "    [31m .");
  /* controls in two bytes: a terminal may take U+009B for the beginning of a command */
  says("\xc2\x80\xc2\x85\xc2\x9b"
       "2J\xc2\x9f.",
       "   2J .");
  says("a\xe2\x80\xa8"
       "b\xe2\x80\xa9"
       "c",
       "a b c");
  /* their neighbours are text */
  says("\xc2\xa0\xe2\x80\xa7\xe2\x80\xaa", "\xc2\xa0\xe2\x80\xa7\xe2\x80\xaa");
  says("\xc2", "?");
  says("\xff\xe2\x80.", "???.");
}

static int start(void **unused) {
  (void)unused;
  host = allocator_host(&memory);
  return status_open() ? 0 : -1;
}

static int stop(void **unused) {
  (void)unused;
  status_close();
  return 0;
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(defaults),        cmocka_unit_test(presets),
      cmocka_unit_test(numbers),         cmocka_unit_test(numbers_refused),
      cmocka_unit_test(read_text_forms), cmocka_unit_test(text_refused),
      cmocka_unit_test(long_text),       cmocka_unit_test(other_locale),
      cmocka_unit_test(one_line_of_text)};
  return cmocka_run_group_tests(tests, start, stop);
}
