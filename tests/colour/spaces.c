/* SPDX-License-Identifier: Apache-2.0
 *
 * The shipped config's spaces against their definitions.
 */
#include "colorimetry.h"
#include "library.h"

#include <math.h>
#include <string.h>

static const char *const spaces[] = {"Linear Rec.709", "ACEScg",          "ACES2065-1",
                                     "Linear P3-D65",  "Linear Rec.2020", "CIE XYZ D65",
                                     "sRGB",           "ACEScct",         "Raw"};
#define SPACES (sizeof spaces / sizeof *spaces)

static void to_working(const sozai_colour_1 *s, const char *space, float *rgb, uint64_t count) {
  char message[256] = "";
  if (s->to_working(s->self, space, rgb, count, message, sizeof message) != SOZAI_OK)
    fail_msg("%s", message);
}

static void from_working(const sozai_colour_1 *s, const char *space, float *rgb, uint64_t count) {
  char message[256] = "";
  if (s->from_working(s->self, space, rgb, count, message, sizeof message) != SOZAI_OK)
    fail_msg("%s", message);
}

static double srgb_decode(double v) {
  return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

static void srgb_is_its_formula(void **state) {
  const sozai_colour_1 *s = colour_of(state);
  double worst = 0;
  for (int i = 0; i <= 4096; i++) {
    float v = (float)i / 4096, rgb[3] = {v, 1 - v, v * v};
    const double want[3] = {srgb_decode(rgb[0]), srgb_decode(rgb[1]), srgb_decode(rgb[2])};
    to_working(s, "sRGB", rgb, 1);
    for (int c = 0; c < 3; c++) worst = fmax(worst, fabs(rgb[c] - want[c]));
  }
  print_message("sRGB to working: off by %.2g at most\n", worst);
  assert_true(worst < 2e-6);
}

/* Between 2^-10 and 2^4, where scenes are; grey, primaries and mixtures. */
static void sample_colour(int i, float rgb[3]) {
  uint32_t hash = 2654435761u * (uint32_t)(i + 1);
  for (int c = 0; c < 3; c++) {
    hash = (hash ^ (hash >> 15)) * 2246822519u;
    rgb[c] = exp2f(-10.0f + 14.0f * (float)(hash >> 8) / 16777216.0f);
  }
}

static void check_matrix(const sozai_colour_1 *s, const char *space, matrix want) {
  const matrix back = inverse(want);
  double worst = 0;
  for (int i = 0; i < 1000; i++) {
    float there[3], here[3];
    sample_colour(i, there);
    memcpy(here, there, sizeof here);
    const double in[3] = {there[0], there[1], there[2]};
    double out_there[3], out_here[3];
    transform(want, in, out_there);
    transform(back, in, out_here);
    to_working(s, space, there, 1);
    from_working(s, space, here, 1);
    double scale = fmax(in[0], fmax(in[1], in[2]));
    for (int c = 0; c < 3; c++) {
      worst = fmax(worst, fabs(there[c] - out_there[c]) / scale);
      worst = fmax(worst, fabs(here[c] - out_here[c]) / scale);
    }
  }
  print_message("%s: off by %.2g of the largest channel at most\n", space, worst);
  assert_true(worst < 2e-6);
}

static void matrices_follow_from_chromaticities(void **state) {
  const sozai_colour_1 *s = colour_of(state);
  check_matrix(s, "ACEScg", rgb_to_rgb(aces_ap1, rec709));
  check_matrix(s, "ACES2065-1", rgb_to_rgb(aces_ap0, rec709));
  check_matrix(s, "Linear P3-D65", rgb_to_rgb(p3_d65, rec709));
  check_matrix(s, "Linear Rec.2020", rgb_to_rgb(rec2020, rec709));
  check_matrix(s, "CIE XYZ D65", inverse(rgb_to_xyz(rec709)));
  check_matrix(s, "CIE XYZ D65 - Display", inverse(rgb_to_xyz(rec709)));
}

static void white_stays_white(void **state) {
  const sozai_colour_1 *s = colour_of(state);
  for (size_t i = 0; i < SPACES; i++) {
    float rgb[3] = {1, 1, 1};
    if (strstr(spaces[i], "XYZ") || strcmp(spaces[i], "ACEScct") == 0) continue;
    to_working(s, spaces[i], rgb, 1);
    for (int c = 0; c < 3; c++) assert_float_equal(rgb[c], 1, 1e-6);
  }
}

static void acescct_is_its_formula(void **state) {
  const sozai_colour_1 *s = colour_of(state);
  for (int i = -100; i <= 100; i++) {
    float grey = exp2f((float)i / 10) - 0.001f, rgb[3] = {grey, grey, grey};
    double want = grey <= 0.0078125 ? 10.5402377416545 * grey + 0.0729055341958355
                                    : (log2(grey) + 9.72) / 17.52;
    from_working(s, "ACEScct", rgb, 1);
    for (int c = 0; c < 3; c++) assert_float_equal(rgb[c], want, 2e-6);
  }
}

static void there_and_back(void **state) {
  const sozai_colour_1 *s = colour_of(state);
  for (size_t i = 0; i < SPACES; i++) {
    double worst = 0;
    for (int k = 0; k < 1000; k++) {
      float rgb[3], before[3];
      sample_colour(k, before);
      memcpy(rgb, before, sizeof rgb);
      from_working(s, spaces[i], rgb, 1);
      to_working(s, spaces[i], rgb, 1);
      float largest = fmaxf(before[0], fmaxf(before[1], before[2]));
      for (int c = 0; c < 3; c++) worst = fmax(worst, fabsf(rgb[c] - before[c]) / largest);
    }
    print_message("%s and back: off by %.2g of the largest channel at most\n", spaces[i], worst);
    assert_true(worst < 1e-5);
  }
}

static void names_roles_and_aliases(void **state) {
  const sozai_colour_1 *s = colour_of(state);
  static const char *const same[][2] = {
      {"sRGB", "srgb"},
      {"sRGB", "sRGB - Texture"},
      {"sRGB", "srgb_texture"},
      {"sRGB", "color_picking"},
      {"Linear Rec.709", "lin_srgb"},
      {"Linear Rec.709", "lin_rec709"},
      {"Linear Rec.709", "Linear Rec.709 (sRGB)"},
      {"Linear Rec.709", "linear Rec.709"},
      {"Linear Rec.709", "scene_linear"},
      {"ACEScg", "lin_ap1"},
      {"ACEScg", "ACES - ACEScg"},
      {"ACES2065-1", "aces_interchange"},
      {"Linear P3-D65", "lin_p3d65"},
      {"Linear Rec.2020", "lin_rec2020"},
      {"ACEScct", "compositing_log"},
      {"Raw", "data"},
      {"Raw", "Non-Color"},
  };
  for (size_t i = 0; i < sizeof same / sizeof *same; i++) {
    float a[3] = {0.2f, 0.4f, 0.8f}, b[3] = {0.2f, 0.4f, 0.8f};
    assert_int_equal(s->has_space(s->self, same[i][1]), 1);
    to_working(s, same[i][0], a, 1);
    to_working(s, same[i][1], b, 1);
    assert_memory_equal(a, b, sizeof a);
  }
  static const char *const strangers[] = {"", "sRGB ", "Filmic", "sozai", "\xC3\xA9", "$OCIO"};
  for (size_t i = 0; i < sizeof strangers / sizeof *strangers; i++)
    assert_int_equal(s->has_space(s->self, strangers[i]), 0);
  assert_int_equal(s->has_space(s->self, NULL), 0);
}

static void data_and_the_working_space_are_left_alone(void **state) {
  const sozai_colour_1 *s = colour_of(state);
  static const char *const identities[] = {"data", "scene_linear"};
  const float before[6] = {-3, 0.5f, 1e30f, 0, 65504, 1e-30f};
  for (size_t i = 0; i < 2; i++) {
    float rgb[6];
    memcpy(rgb, before, sizeof rgb);
    to_working(s, identities[i], rgb, 2);
    from_working(s, identities[i], rgb, 2);
    assert_memory_equal(rgb, before, sizeof rgb);
  }
}

/* One by one or all at once: the same bits. */
static void batches_do_not_matter(void **state) {
  const sozai_colour_1 *s = colour_of(state);
  enum { COUNT = 1001 };
  float all[COUNT][3], one[COUNT][3];
  for (int i = 0; i < COUNT; i++) sample_colour(i, all[i]);
  memcpy(one, all, sizeof one);
  to_working(s, "ACEScct", all[0], COUNT);
  for (int i = 0; i < COUNT; i++) to_working(s, "ACEScct", one[i], 1);
  assert_memory_equal(all, one, sizeof one);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(srgb_is_its_formula),
      cmocka_unit_test(matrices_follow_from_chromaticities),
      cmocka_unit_test(white_stays_white),
      cmocka_unit_test(acescct_is_its_formula),
      cmocka_unit_test(there_and_back),
      cmocka_unit_test(names_roles_and_aliases),
      cmocka_unit_test(data_and_the_working_space_are_left_alone),
      cmocka_unit_test(batches_do_not_matter),
  };
  return cmocka_run_group_tests(tests, shipped_setup, shipped_teardown);
}
