/* SPDX-License-Identifier: Apache-2.0
 *
 * What may not cross the C boundary: exceptions, prints, half results.
 */
#define _GNU_SOURCE /* fegetexcept */
#include "library.h"

#include <fenv.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef int32_t (*conversion)(void *, const char *, float *, uint64_t, char *, size_t);

static const float colour[3] = {0.1f, 0.2f, 0.3f};

static void unknown_space(void **state) {
  const sozai_colour_1 *s = colour_of(state);
  const conversion both[] = {s->to_working, s->from_working};
  for (int i = 0; i < 2; i++) {
    float rgb[3] = {0.1f, 0.2f, 0.3f};
    char message[512] = "";
    assert_int_equal(both[i](s->self, "Utopia RGB", rgb, 1, message, sizeof message),
                     SOZAI_ERROR_COLOUR);
    assert_contains(message, "Utopia RGB");
    assert_contains(message, s->config_name(s->self));
    assert_memory_equal(rgb, colour, sizeof rgb);
  }
}

static void arguments(void **state) {
  const sozai_colour_1 *s = colour_of(state);
  const conversion both[] = {s->to_working, s->from_working};
  float rgb[3] = {0.1f, 0.2f, 0.3f};
  for (int i = 0; i < 2; i++) {
    assert_int_equal(both[i](s->self, NULL, rgb, 1, NULL, 0), SOZAI_ERROR_ARGUMENT);
    assert_int_equal(both[i](s->self, "sRGB", NULL, 1, NULL, 0), SOZAI_ERROR_ARGUMENT);
    assert_int_equal(both[i](NULL, "sRGB", rgb, 1, NULL, 0), SOZAI_ERROR_ARGUMENT);
    assert_int_equal(both[i](s->self, "sRGB", NULL, 0, NULL, 0), SOZAI_OK);
    assert_int_equal(both[i](s->self, "sRGB", rgb, 0, NULL, 0), SOZAI_OK);
    assert_int_equal(both[i](s->self, "", rgb, 1, NULL, 0), SOZAI_ERROR_COLOUR);
  }
  const sozai_display_1 *d = display_of(state);
  assert_int_equal(d->to_display(d->self, NULL, NULL, NULL, NULL, 0, NULL, 0), SOZAI_OK);
  assert_int_equal(d->to_display(d->self, NULL, NULL, NULL, NULL, 1, NULL, 0),
                   SOZAI_ERROR_ARGUMENT);
  assert_int_equal(d->size, sizeof *d);
  assert_memory_equal(rgb, colour, sizeof rgb);
  assert_int_equal(s->size, sizeof *s);
}

/* Any room will do; what fits is terminated, and cut between characters. */
static void message_room(void **state) {
  const sozai_colour_1 *s = colour_of(state);
  const char *space = "\xE6\x9C\xA8\xE6\x9D\x90"; /* two characters of three bytes */
  char full[512];
  float rgb[3] = {0};
  s->to_working(s->self, space, rgb, 1, full, sizeof full);
  assert_contains(full, space);
  assert_int_equal(s->to_working(s->self, space, rgb, 1, NULL, 10), SOZAI_ERROR_COLOUR);
  assert_int_equal(s->to_working(s->self, space, rgb, 1, full, 0), SOZAI_ERROR_COLOUR);
  char line[512];
  s->to_working(s->self, "two\nlines\t", rgb, 1, line, sizeof line);
  assert_contains(line, "two lines ");
  for (size_t room = 1; room < 40; room++) {
    char cut[41];
    memset(cut, 'x', sizeof cut);
    s->to_working(s->self, space, rgb, 1, cut, room);
    size_t length = strlen(cut);
    assert_true(length < room && length + 3 >= room);
    assert_memory_equal(cut, full, length);
    assert_int_not_equal((unsigned char)full[length] & 0xC0, 0x80);
    assert_int_equal(cut[room], 'x');
  }
}

static void bad_optimisation_flags(void **state) {
  (void)state;
  static const char *const bad[] = {"banana", "99999999999999999999999"};
  for (size_t i = 0; i < 2; i++) {
    service both = service_open(NULL);
    const sozai_colour_1 *s = both.colour;
    const sozai_display_1 *d = both.display;
    float rgb[3] = {0.1f, 0.2f, 0.3f};
    char message[512] = "";
    setenv("OCIO_OPTIMIZATION_FLAGS", bad[i], 1);
    int32_t result = s->to_working(s->self, "sRGB", rgb, 1, message, sizeof message);
    int32_t display = d->to_display(d->self, NULL, NULL, NULL, rgb, 1, NULL, 0);
    float xy[8];
    int32_t primaries = d->chromaticities(d->self, "ACEScg", xy, NULL, 0);
    /* A config whose spaces have to be tried out at once. */
    sozai_services *services = NULL;
    char of_open[512] = "";
    int32_t open =
        library_open(SOZAI_TEST_DATA "/configs/rendering.ocio", &services, of_open, sizeof of_open);
    library_factory()->close(services);
    unsetenv("OCIO_OPTIMIZATION_FLAGS");
    print_message("%s\n", message);
    assert_int_equal(result, SOZAI_ERROR_COLOUR);
    assert_int_equal(display, SOZAI_ERROR_COLOUR);
    assert_int_equal(primaries, SOZAI_ERROR_COLOUR);
    print_message("%s\n", of_open);
    assert_int_equal(open, SOZAI_ERROR_COLOUR);
    assert_contains(of_open, "OCIO_OPTIMIZATION_FLAGS");
    assert_contains(of_open, "rendering.ocio");
    assert_contains(message, "OCIO_OPTIMIZATION_FLAGS");
    assert_contains(message, bad[i]);
    assert_memory_equal(rgb, colour, sizeof rgb);
    /* A failure is not remembered. */
    assert_int_equal(s->to_working(s->self, "sRGB", rgb, 1, NULL, 0), SOZAI_OK);
    service_close(both);
  }
}

static void only_finite_numbers_come_out(void **state) {
  const sozai_colour_1 *s = colour_of(state);
  static const char *const spaces[] = {"sRGB",        "ACEScg", "ACEScct",
                                       "CIE XYZ D65", "Raw",    "sRGB - Display"};
  const conversion both[] = {s->to_working, s->from_working};
  const float hard[] = {NAN, INFINITY, -INFINITY, 3.4e38f, -3.4e38f, 1e-42f, 0.5f};
  const int n = sizeof hard / sizeof *hard;
  for (size_t k = 0; k < 6; k++)
    for (int d = 0; d < 2; d++)
      for (int i = 0; i < n * n * n; i++) {
        float rgb[3] = {hard[i % n], hard[i / n % n], hard[i / n / n]};
        assert_int_equal(both[d](s->self, spaces[k], rgb, 1, NULL, 0), SOZAI_OK);
        for (int c = 0; c < 3; c++) assert_true(isfinite(rgb[c]));
      }
  float rgb[3] = {NAN, 0.5f, 1};
  assert_int_equal(s->to_working(s->self, "sRGB", rgb, 1, NULL, 0), SOZAI_OK);
  assert_true(rgb[0] == 0);
  assert_float_equal(rgb[1], 0.21404114, 1e-6);
}

/* OpenColorIO would warn of this config on standard error. */
static void prints_nothing(void **state) {
  (void)state;
  fflush(NULL);
  FILE *caught = tmpfile();
  int out = dup(1), err = dup(2);
  dup2(fileno(caught), 1);
  dup2(fileno(caught), 2);
  sozai_services *services = NULL;
  int32_t result = library_open(SOZAI_TEST_DATA "/configs/doubled.ocio", &services, NULL, 0);
  const sozai_colour_1 *s = library_factory()->get(services, SOZAI_COLOUR_1);
  float rgb[3] = {0};
  int32_t failing = s ? s->to_working(s->self, "lost", rgb, 1, NULL, 0) : 0;
  library_factory()->close(services);
  static const char *const bad[] = {"unfit",           "malformed",      "no_linear",
                                    "circular_spaces", "circular_looks", "circular_view",
                                    "circular_alias"};
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    char path[1024];
    snprintf(path, sizeof path, SOZAI_TEST_DATA "/configs/%s.ocio", bad[i]);
    library_open(path, &services, NULL, 0);
    if (services) result = SOZAI_ERROR_STATE;
  }
  library_open("/nowhere", &services, NULL, 0);
  library_open("ocio://default", &services, NULL, 0);
  library_factory()->close(services);
  services = NULL;
  library_open(SOZAI_TEST_DATA "/configs/created_raw.ocio", &services, NULL, 0);
  const sozai_display_1 *d = library_factory()->get(services, SOZAI_DISPLAY_1);
  if (d) d->to_display(d->self, "nowhere", NULL, "none", rgb, 1, NULL, 0);
  library_factory()->close(services);
  fflush(NULL);
  dup2(out, 1);
  dup2(err, 2);
  close(out);
  close(err);
  fseek(caught, 0, SEEK_END);
  long printed = ftell(caught);
  fclose(caught);
  assert_int_equal(result, SOZAI_OK);
  assert_int_equal(failing, SOZAI_ERROR_COLOUR);
  assert_int_equal(printed, 0);
}

static void convert_a_little(void) {
  service both = service_open(NULL);
  const sozai_colour_1 *s = both.colour;
  const sozai_display_1 *d = both.display;
  float rgb[3] = {0.5f, 0.5f, 0.5f};
  assert_int_equal(s->to_working(s->self, "sRGB", rgb, 1, NULL, 0), SOZAI_OK);
  assert_float_equal(rgb[1], 0.21404114, 1e-6);
  assert_int_equal(s->to_working(s->self, "ACEScg", rgb, 1, NULL, 0), SOZAI_OK);
  assert_float_equal(rgb[1], 0.21404114, 1e-6);
  assert_int_equal(d->to_display(d->self, NULL, NULL, NULL, rgb, 1, NULL, 0), SOZAI_OK);
  assert_float_equal(rgb[1], 0.5, 1e-5);
  service_close(both);
}

static void environment_stays(void **state) {
  (void)state;
  static const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
  for (size_t i = 0; i < sizeof modes / sizeof *modes; i++) {
    fesetround(modes[i]);
    convert_a_little();
    int after = fegetround();
    fesetround(FE_TONEAREST);
    assert_int_equal(after, modes[i]);
  }
  assert_int_equal(fegetexcept(), 0);
  assert_string_equal(setlocale(LC_ALL, NULL), "C");
}

/* Numbers in a config have points, whatever the host's locale. */
static void comma_locale(void **state) {
  (void)state;
  static const char *const with_comma[] = {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", "ru_RU.UTF-8"};
  for (size_t i = 0; i < sizeof with_comma / sizeof *with_comma; i++)
    if (setlocale(LC_ALL, with_comma[i])) {
      convert_a_little();
      assert_string_equal(setlocale(LC_ALL, NULL), with_comma[i]);
      setlocale(LC_ALL, "C");
      return;
    }
  skip();
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(unknown_space),
      cmocka_unit_test(arguments),
      cmocka_unit_test(message_room),
      cmocka_unit_test(bad_optimisation_flags),
      cmocka_unit_test(only_finite_numbers_come_out),
      cmocka_unit_test(prints_nothing),
      cmocka_unit_test(environment_stays),
      cmocka_unit_test(comma_locale),
  };
  return cmocka_run_group_tests(tests, shipped_setup, shipped_teardown);
}
