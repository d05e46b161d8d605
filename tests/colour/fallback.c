/* SPDX-License-Identifier: Apache-2.0
 *
 * Configs that do not say what scene-linear numbers are.
 */
#include "library.h"

#include <math.h>
#include <string.h>

#define CONFIG(name) SOZAI_TEST_DATA "/configs/" name ".ocio"

/* Opened, with a warning that has those parts. */
static service open_warned(const char *config, const char *part, const char *other) {
  service s = {0};
  char message[512] = "x";
  assert_int_equal(library_open(config, &s.handle, message, sizeof message), SOZAI_OK);
  print_message("%s\n", message);
  assert_contains(message, config);
  assert_contains(message, part);
  assert_contains(message, other);
  s.colour = library_factory()->get(s.handle, SOZAI_COLOUR_1);
  s.display = library_factory()->get(s.handle, SOZAI_DISPLAY_1);
  /* It fits in no room at all, too. */
  sozai_services *again = NULL;
  assert_int_equal(library_open(config, &again, NULL, 0), SOZAI_OK);
  library_factory()->close(again);
  return s;
}

static double srgb_decode(double v) {
  return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

static void sound_ones_do_not_warn(void **state) {
  (void)state;
  static const char *const configs[] = {NULL, CONFIG("acescg"), CONFIG("p3d65"), CONFIG("raw")};
  for (size_t i = 0; i < sizeof configs / sizeof *configs; i++) {
    sozai_services *services = NULL;
    char message[512] = "x";
    assert_int_equal(library_open(configs[i], &services, message, sizeof message), SOZAI_OK);
    assert_string_equal(message, "");
    library_factory()->close(services);
  }
}

/* Another role says what is linear; neither the role that comes after it, nor a
 * space that is called scene_linear. */
static void rendering(void **state) {
  (void)state;
  service s = open_warned(CONFIG("rendering"), "no role scene_linear", "rendering");
  const sozai_colour_1 *c = s.colour;
  assert_string_equal(c->working_space(c->self), "lin_rec709");
  float rgb[3] = {0.5f, 0.25f, 0.75f};
  const float before[3] = {0.5f, 0.25f, 0.75f};
  assert_int_equal(c->to_working(c->self, "lin_rec709", rgb, 1, NULL, 0), SOZAI_OK);
  assert_memory_equal(rgb, before, sizeof rgb);
  assert_int_equal(c->to_working(c->self, "sRGB", rgb, 1, NULL, 0), SOZAI_OK);
  for (int i = 0; i < 3; i++) assert_float_equal(rgb[i], srgb_decode(before[i]), 1e-6);
  /* A config that knows colours is not helped out by formula. */
  assert_int_equal(c->has_space(c->self, "srgb_texture"), 0);
  assert_int_equal(c->to_working(c->self, "srgb_texture", rgb, 1, NULL, 0), SOZAI_ERROR_COLOUR);
  service_close(s);
}

/* Nothing is converted but what everyone knows. */
static void raw(void **state) {
  (void)state;
  service s = open_warned(CONFIG("created_raw"), "no role scene_linear", "not converted");
  const sozai_colour_1 *c = s.colour;
  const sozai_display_1 *d = s.display;
  assert_string_equal(c->working_space(c->self), "raw");
  const float before[3] = {0.5f, -0.25f, 0.02f};
  static const char *const unchanged[] = {"raw",      "default",     "lin_rec709", "Linear Rec.709",
                                          "lin_srgb", "scene_linear"};
  for (size_t i = 0; i < sizeof unchanged / sizeof *unchanged; i++) {
    float rgb[3] = {0.5f, -0.25f, 0.02f};
    assert_int_equal(c->has_space(c->self, unchanged[i]), 1);
    assert_int_equal(c->to_working(c->self, unchanged[i], rgb, 1, NULL, 0), SOZAI_OK);
    assert_int_equal(c->from_working(c->self, unchanged[i], rgb, 1, NULL, 0), SOZAI_OK);
    assert_memory_equal(rgb, before, sizeof rgb);
  }
  static const char *const srgb[] = {"sRGB", "sRGB - Texture", "srgb_texture",
                                     "Utility - sRGB - Texture"};
  for (size_t i = 0; i < sizeof srgb / sizeof *srgb; i++) {
    float rgb[3] = {0.5f, -0.25f, 0.02f};
    assert_int_equal(c->has_space(c->self, srgb[i]), 1);
    assert_int_equal(c->to_working(c->self, srgb[i], rgb, 1, NULL, 0), SOZAI_OK);
    for (int k = 0; k < 3; k++)
      assert_float_equal(rgb[k], copysign(srgb_decode(fabsf(before[k])), before[k]), 1e-6);
    assert_int_equal(c->from_working(c->self, srgb[i], rgb, 1, NULL, 0), SOZAI_OK);
    for (int k = 0; k < 3; k++) assert_float_equal(rgb[k], before[k], 1e-6);
  }
  static const char *const unknown[] = {"ACEScg", "SRGB", "", "Linear P3-D65"};
  for (size_t i = 0; i < sizeof unknown / sizeof *unknown; i++) {
    float rgb[3] = {0.5f, -0.25f, 0.02f};
    char message[512] = "";
    assert_int_equal(c->has_space(c->self, unknown[i]), 0);
    assert_int_equal(c->to_working(c->self, unknown[i], rgb, 1, message, sizeof message),
                     SOZAI_ERROR_COLOUR);
    assert_contains(message, unknown[i]);
    assert_memory_equal(rgb, before, sizeof rgb);
  }
  float shown[3] = {0.5f, 2, -1};
  const float cut[3] = {0.5f, 1, 0};
  assert_int_equal(d->to_display(d->self, NULL, NULL, NULL, shown, 1, NULL, 0), SOZAI_OK);
  assert_memory_equal(shown, cut, sizeof shown);
  service_close(s);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(sound_ones_do_not_warn),
                                     cmocka_unit_test(rendering), cmocka_unit_test(raw)};
  return cmocka_run_group_tests(tests, library_setup, library_teardown);
}
