/* SPDX-License-Identifier: Apache-2.0
 *
 * The shipped config's display and views.
 */
#include "library.h"

#include <math.h>
#include <string.h>

static void show(void **state, const char *view, float *rgb, uint64_t count) {
  const sozai_display_1 *s = display_of(state);
  char message[256] = "";
  if (s->to_display(s->self, "sRGB", view, NULL, rgb, count, message, sizeof message) != SOZAI_OK)
    fail_msg("%s", message);
}

static double srgb_encode(double v) {
  return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1 / 2.4) - 0.055;
}

/* The curve of the view sozai, as sozai.ocio words it. */
static double shoulder(double x) {
  const double a = 0.4, r = 0.6030362646096468, t = (x - a) / r;
  return x <= a ? x : fmin(1, a + r * t / pow(1 + pow(t, 1.5), 2 / 3.0));
}

static float light(int step) { return exp2f(-12.0f + (float)step / 64); }
enum { STEPS = 64 * 18 }; /* up to 2^6 */

static void standard_is_srgb(void **state) {
  for (int i = 0; i <= STEPS; i++) {
    float v = light(i), rgb[3] = {v, v / 2, v / 4};
    const double want[3] = {srgb_encode(v), srgb_encode(v / 2), srgb_encode(v / 4)};
    show(state, "Standard", rgb, 1);
    for (int c = 0; c < 3; c++) assert_float_equal(rgb[c], fmin(1, want[c]), 1e-5);
  }
}

static void sozai_is_its_formula(void **state) {
  double worst = 0, worst_below = 0;
  for (int i = 0; i <= STEPS; i++) {
    float v = light(i), rgb[3] = {v, v / 2, v / 4};
    const double x[3] = {v, v / 2, v / 4};
    show(state, "sozai", rgb, 1);
    for (int c = 0; c < 3; c++) {
      double error = fabs(rgb[c] - srgb_encode(shoulder(x[c])));
      worst = fmax(worst, error);
      if (x[c] <= 0.4) worst_below = fmax(worst_below, error);
    }
  }
  print_message("view sozai: off by %.2g at most, below the shoulder by %.2g\n", worst,
                worst_below);
  assert_true(worst < 0.5 / 255);
  assert_true(worst_below < 2e-5);
}

/* Woods in daylight look the same in both views. Linear Rec.709. */
static void wood_is_faithful(void **state) {
  static const float woods[][3] = {
      {0.047f, 0.027f, 0.018f}, /* walnut */
      {0.270f, 0.150f, 0.073f}, /* oak */
      {0.360f, 0.205f, 0.098f}, /* larch */
      {0.400f, 0.310f, 0.190f}, /* ash */
  };
  for (size_t i = 0; i < sizeof woods / sizeof *woods; i++) {
    float ours[3], plain[3];
    memcpy(ours, woods[i], sizeof ours);
    memcpy(plain, woods[i], sizeof plain);
    show(state, "sozai", ours, 1);
    show(state, "Standard", plain, 1);
    for (int c = 0; c < 3; c++) assert_float_equal(ours[c], plain[c], 2e-5);
  }
}

static void views_are_monotone_and_neutral(void **state) {
  static const char *const views[] = {"sozai", "Standard", "Raw"};
  for (size_t k = 0; k < 3; k++) {
    float last = 0;
    for (int i = 0; i <= STEPS; i++) {
      float v = light(i), rgb[3] = {v, v, v};
      show(state, views[k], rgb, 1);
      assert_float_equal(rgb[0], rgb[1], 2e-6);
      assert_float_equal(rgb[0], rgb[2], 2e-6);
      assert_true(rgb[1] >= last);
      /* Strictly, while there is white to spare. */
      if (v < 0.9f) assert_true(rgb[1] > last);
      last = rgb[1];
    }
    assert_float_equal(last, 1, 1e-5);
    float black[3] = {0, 0, 0};
    show(state, views[k], black, 1);
    for (int c = 0; c < 3; c++) assert_float_equal(black[c], 0, 1e-6);
  }
}

static void sozai_keeps_highlights_apart(void **state) {
  float rgb[3] = {1, 4, 16};
  show(state, "sozai", rgb, 1);
  assert_true(rgb[0] < 0.92f && rgb[0] > 0.85f);
  assert_true(rgb[1] < 0.995f && rgb[1] > 0.97f);
  assert_true(rgb[2] > 254.5f / 255);
}

static void defaults(void **state) {
  const sozai_display_1 *s = display_of(state);
  float rgb[3] = {0.9f, 2, 0.1f}, named[3] = {0.9f, 2, 0.1f};
  assert_int_equal(s->to_display(s->self, NULL, NULL, NULL, rgb, 1, NULL, 0), SOZAI_OK);
  show(state, "sozai", named, 1);
  assert_memory_equal(rgb, named, sizeof rgb);

  float standard[3] = {0.9f, 2, 0.1f}, of_default[3] = {0.9f, 2, 0.1f};
  show(state, "Standard", standard, 1);
  assert_int_equal(s->to_display(s->self, NULL, "Standard", NULL, of_default, 1, NULL, 0),
                   SOZAI_OK);
  assert_memory_equal(of_default, standard, sizeof standard);
}

static void never_beyond_the_display(void **state) {
  static const char *const views[] = {"sozai", "Standard", "Raw"};
  const float hard[] = {NAN, INFINITY, -INFINITY, 3e38f, -3e38f, -0.5f, 1e-42f, 0.5f, 1e6f};
  const int n = sizeof hard / sizeof *hard;
  for (size_t k = 0; k < 3; k++)
    for (int i = 0; i < n * n * n; i++) {
      float rgb[3] = {hard[i % n], hard[i / n % n], hard[i / n / n]};
      show(state, views[k], rgb, 1);
      for (int c = 0; c < 3; c++) assert_true(rgb[c] >= 0 && rgb[c] <= 1);
    }
}

static void unknown_names(void **state) {
  const sozai_display_1 *s = display_of(state);
  const float before[3] = {0.1f, 0.2f, 0.3f};
  float rgb[3] = {0.1f, 0.2f, 0.3f};
  char message[512];
  assert_int_equal(s->to_display(s->self, "sRGB", "Sepia", NULL, rgb, 1, message, sizeof message),
                   SOZAI_ERROR_COLOUR);
  assert_contains(message, "Sepia");
  assert_contains(message, "sozai.ocio");
  assert_int_equal(
      s->to_display(s->self, "Oscilloscope", NULL, NULL, rgb, 1, message, sizeof message),
      SOZAI_ERROR_COLOUR);
  assert_contains(message, "Oscilloscope");
  assert_memory_equal(rgb, before, sizeof rgb);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(standard_is_srgb),
      cmocka_unit_test(sozai_is_its_formula),
      cmocka_unit_test(wood_is_faithful),
      cmocka_unit_test(views_are_monotone_and_neutral),
      cmocka_unit_test(sozai_keeps_highlights_apart),
      cmocka_unit_test(defaults),
      cmocka_unit_test(never_beyond_the_display),
      cmocka_unit_test(unknown_names),
  };
  return cmocka_run_group_tests(tests, shipped_setup, shipped_teardown);
}
