/* SPDX-License-Identifier: Apache-2.0
 *
 * The chromaticities that the service finds in a config, against the standards'.
 */
#include "colorimetry.h"
#include "library.h"

#include <math.h>
#include <string.h>
#include <unistd.h>

#define CONFIG(name) SOZAI_TEST_DATA "/configs/" name ".ocio"
#define BLENDER blender_config()

static void check(const sozai_display_1 *d, const char *space, const primaries *want) {
  char message[512] = "";
  float xy[8];
  if (d->chromaticities(d->self, space, xy, message, sizeof message) != SOZAI_OK)
    fail_msg("%s", message);
  const double *const corners[] = {want->red, want->green, want->blue, want->white};
  double worst = 0;
  for (int i = 0; i < 8; i++) worst = fmax(worst, fabs(xy[i] - corners[i / 2][i % 2]));
  print_message("%s: R %.5f %.5f G %.5f %.5f B %.5f %.5f W %.5f %.5f, off by %.1g at most\n",
                space ? space : "working space", xy[0], xy[1], xy[2], xy[3], xy[4], xy[5], xy[6],
                xy[7], worst);
  assert_true(worst < 1e-4);
}

static void shipped(void **state) {
  const sozai_display_1 *d = display_of(state);
  check(d, NULL, &rec709);
  check(d, "lin_srgb", &rec709);
  check(d, "Linear Rec.2020", &rec2020);
  check(d, "Linear P3-D65", &p3_d65);
  check(d, "ACEScg", &aces_ap1);
  check(d, "aces_interchange", &aces_ap0);
  /* Its own axes, and of equal numbers the equal-energy white. */
  const primaries axes = {{1, 0}, {0, 1}, {0, 0}, {1.0 / 3, 1.0 / 3}};
  check(d, "CIE XYZ D65", &axes);
  check(d, "CIE XYZ D65 - Display", &axes);
}

static void others(void **state) {
  (void)state;
  service s = service_open(CONFIG("acescg"));
  check(s.display, NULL, &aces_ap1);
  check(s.display, "ACES2065-1", &aces_ap0);
  check(s.display, "lin_rec709", &rec709);
  service_close(s);
  s = service_open(CONFIG("p3d65"));
  check(s.display, NULL, &p3_d65);
  check(s.display, "lin_rec709", &rec709);
  check(s.display, "ACES2065-1", &aces_ap0);
  service_close(s);
  s = service_open(CONFIG("primaries"));
  const primaries dci = {{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {0.314, 0.351}};
  const primaries romm = {
      {0.734699, 0.265301}, {0.159597, 0.840403}, {0.036598, 0.000105}, {0.3457, 0.3585}};
  const primaries unheard_of = {{0.60, 0.35}, {0.25, 0.65}, {0.16, 0.09}, {0.3127, 0.3290}};
  check(s.display, "p3-dci", &dci);
  check(s.display, "romm", &romm);
  check(s.display, "unheard-of", &unheard_of);
  service_close(s);
}

static void blender(void **state) {
  (void)state;
  if (access(BLENDER, R_OK) != 0) skip();
  service s = service_open(BLENDER);
  check(s.display, NULL, &rec709);
  check(s.display, "Linear ACEScg", &aces_ap1);
  service_close(s);
}

static void refuses(const sozai_display_1 *d, const char *space, const char *part) {
  char message[512] = "";
  float xy[8] = {1, 2, 3, 4, 5, 6, 7, 8};
  assert_int_equal(d->chromaticities(d->self, space, xy, message, sizeof message),
                   SOZAI_ERROR_COLOUR);
  print_message("%s\n", message);
  assert_contains(message, part);
  for (int i = 0; i < 8; i++) assert_true(xy[i] == (float)(i + 1));
}

static void refusals(void **state) {
  const sozai_display_1 *d = display_of(state);
  refuses(d, "sRGB", "not linear");
  refuses(d, "sRGB - Display", "not linear");
  refuses(d, "ACEScct", "not linear");
  refuses(d, "Raw", "data");
  refuses(d, "Utopia RGB", "Utopia RGB");
  float xy[8];
  assert_int_equal(d->chromaticities(d->self, NULL, NULL, NULL, 0), SOZAI_ERROR_ARGUMENT);
  assert_int_equal(d->chromaticities(NULL, NULL, xy, NULL, 0), SOZAI_ERROR_ARGUMENT);

  service s = service_open(CONFIG("doubled"));
  refuses(s.display, NULL, "aces_interchange");
  service_close(s);
  s = service_open(CONFIG("created_raw"));
  refuses(s.display, NULL, "data");
  service_close(s);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(shipped),
      cmocka_unit_test(others),
      cmocka_unit_test(blender),
      cmocka_unit_test(refusals),
  };
  return cmocka_run_group_tests(tests, shipped_setup, shipped_teardown);
}
