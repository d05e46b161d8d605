/* SPDX-License-Identifier: Apache-2.0
 *
 * Looks: a view's own, one in its place, none.
 */
#include "library.h"

#include <math.h>
#include <string.h>

#define CONFIG(name) SOZAI_TEST_DATA "/configs/" name ".ocio"

enum { COLOURS = 8 };
static const float colours[COLOURS * 3] = {0.18f, 0.18f, 0.18f, 0.27f, 0.15f, 0.073f, 0.02f, 0.3f,
                                           0.9f,  1.5f,  0.7f,  0.2f,  0,     0,      0,     0.4f,
                                           0.31f, 0.19f, 4,     5,     3,     0.01f,  0.8f,  0.01f};

typedef struct {
  float rgb[COLOURS * 3];
} shown;

static const sozai_display_1 *display;

static shown show(const char *view, const char *look, float exposure) {
  shown s;
  char message[512] = "";
  for (int i = 0; i < COLOURS * 3; i++) s.rgb[i] = colours[i] * exposure;
  if (display->to_display(display->self, NULL, view, look, s.rgb, COLOURS, message,
                          sizeof message) != SOZAI_OK)
    fail_msg("%s", message);
  return s;
}

static double difference(shown a, shown b) {
  double worst = 0;
  for (int i = 0; i < COLOURS * 3; i++) worst = fmax(worst, fabsf(a.rgb[i] - b.rgb[i]));
  return worst;
}

#define ACES "ACES 1.0 - SDR Video"
#define PLAIN "Un-tone-mapped"

static void by_their_definition(void **state) {
  (void)state;
  /* dim halves the light in the working space. */
  assert_true(difference(show(PLAIN, "dim", 1), show(PLAIN, NULL, 0.5f)) < 1e-6);
  assert_true(difference(show(PLAIN, "-dim", 1), show(PLAIN, NULL, 2)) < 1e-6);
  assert_true(difference(show(PLAIN, "dim, dim", 1), show(PLAIN, NULL, 0.25f)) < 1e-6);
  assert_true(difference(show(PLAIN, "+dim:-dim", 1), show(PLAIN, NULL, 1)) < 1e-6);
  assert_true(difference(show(PLAIN, "dim", 1), show(PLAIN, NULL, 1)) > 0.1);
}

static void in_place_of_the_views_own(void **state) {
  (void)state;
  assert_true(difference(show("Warm", NULL, 1), show(ACES, NULL, 1)) > 0.01);
  assert_true(difference(show("Warm", NULL, 1), show(ACES, "warm", 1)) < 1e-6);
  assert_true(difference(show("Warm", "", 1), show(ACES, NULL, 1)) < 1e-6);
  assert_true(difference(show("Warm", "dim", 1), show(ACES, "dim", 1)) < 1e-6);
  assert_true(difference(show("Warm", "warm", 1), show("Warm", NULL, 1)) < 1e-6);
  /* Only blanks and commas: none. */
  assert_true(difference(show("Warm", " , ", 1), show(ACES, NULL, 1)) < 1e-6);
  /* The second where the first is dimmed before: order matters. */
  assert_true(difference(show(ACES, "warm, dim", 1), show(ACES, "dim, warm", 1)) > 1e-4);
}

/* Data is shown as it is. */
static void not_on_data(void **state) {
  (void)state;
  assert_true(difference(show("Raw", "dim", 1), show("Raw", NULL, 1)) == 0);
}

static void hidden_views_can_be_named(void **state) {
  (void)state;
  assert_true(difference(show("Hidden", NULL, 1), show(PLAIN, NULL, 1)) == 0);
}

static void refused(const char *of_display, const char *view, const char *look,
                    const char *const parts[3]) {
  float rgb[3] = {0.1f, 0.2f, 0.3f};
  const float before[3] = {0.1f, 0.2f, 0.3f};
  char message[512] = "";
  assert_int_equal(
      display->to_display(display->self, of_display, view, look, rgb, 1, message, sizeof message),
      SOZAI_ERROR_COLOUR);
  print_message("%s\n", message);
  for (int i = 0; i < 3; i++) assert_contains(message, parts[i]);
  assert_memory_equal(rgb, before, sizeof rgb);
}

/* What is wrong, and what there is. */
static void unknown_names(void **state) {
  (void)state;
  refused(NULL, NULL, "sepia", (const char *const[]){"look \"sepia\"", "acescg.ocio", "warm, dim"});
  refused(NULL, NULL, "dim, -sepia", (const char *const[]){"\"sepia\"", "acescg.ocio", "dim"});
  refused(NULL, "Sepia", NULL, (const char *const[]){"view \"Sepia\"", "sRGB - Display", "Warm"});
  refused("Other", "Warm", NULL, (const char *const[]){"view \"Warm\"", "\"Other\"", "has Raw"});
  refused("Slide", NULL, NULL, (const char *const[]){"display \"Slide\"", "acescg.ocio", "Other"});
  refused("", NULL, NULL, (const char *const[]){"display \"\"", "acescg.ocio", "Other"});
  refused(NULL, "", NULL, (const char *const[]){"view \"\"", "acescg.ocio", "Warm"});
}

static service opened;

static int setup(void **state) {
  if (library_setup(state) != 0) return -1;
  opened = service_open(CONFIG("acescg"));
  display = opened.display;
  return 0;
}

static int teardown(void **state) {
  service_close(opened);
  return library_teardown(state);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(by_their_definition), cmocka_unit_test(in_place_of_the_views_own),
      cmocka_unit_test(not_on_data),         cmocka_unit_test(hidden_views_can_be_named),
      cmocka_unit_test(unknown_names),
  };
  return cmocka_run_group_tests(tests, setup, teardown);
}
