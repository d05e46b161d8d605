/* SPDX-License-Identifier: Apache-2.0
 *
 * What a config offers, as listed.
 */
#include "library.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define CONFIG(name) SOZAI_TEST_DATA "/configs/" name ".ocio"
#define BLENDER blender_config()

/* "name=detail|" of each. */
static const char *listed(const sozai_display_1 *d, uint32_t list, const char *display) {
  static char text[8192];
  size_t used = 0;
  uint32_t count = d->count(d->self, list, display);
  text[0] = '\0';
  for (uint32_t i = 0; i < count; i++) {
    const char *name = NULL, *detail = NULL;
    assert_int_equal(d->item(d->self, list, display, i, &name, &detail), SOZAI_OK);
    assert_non_null(name);
    assert_non_null(detail);
    used += (size_t)snprintf(text + used, sizeof text - used, "%s=%s|", name, detail);
    assert_true(used < sizeof text);
  }
  return text;
}

static void shipped(void **state) {
  const sozai_display_1 *d = display_of(state);
  assert_string_equal(listed(d, SOZAI_LIST_DISPLAYS, NULL), "sRGB=|");
  assert_string_equal(listed(d, SOZAI_LIST_VIEWS, NULL), "sozai=|Standard=|Raw=|");
  assert_string_equal(listed(d, SOZAI_LIST_VIEWS, "sRGB"), "sozai=|Standard=|Raw=|");
  assert_string_equal(listed(d, SOZAI_LIST_LOOKS, NULL), "");
  const char *spaces = listed(d, SOZAI_LIST_SPACES, NULL);
  assert_contains(spaces, "Linear Rec.709=scene-linear|");
  assert_contains(spaces, "sRGB - Display=sdr-video|");
  assert_contains(spaces, "|Raw=|");
  const char *roles = listed(d, SOZAI_LIST_ROLES, NULL);
  assert_contains(roles, "scene_linear=Linear Rec.709|");
  assert_contains(roles, "aces_interchange=ACES2065-1|");
}

/* The defaults first though the config has them elsewhere; what is hidden, not. */
static void acescg(void **state) {
  (void)state;
  service s = service_open(CONFIG("acescg"));
  const sozai_display_1 *d = s.display;
  assert_string_equal(listed(d, SOZAI_LIST_DISPLAYS, NULL), "sRGB - Display=|Other=|");
  const char *views = "ACES 1.0 - SDR Video=|Un-tone-mapped=|Warm=warm|Raw=|";
  assert_string_equal(listed(d, SOZAI_LIST_VIEWS, NULL), views);
  assert_string_equal(listed(d, SOZAI_LIST_VIEWS, "sRGB - Display"), views);
  assert_string_equal(listed(d, SOZAI_LIST_VIEWS, "Other"), "Raw=|");
  assert_string_equal(listed(d, SOZAI_LIST_LOOKS, NULL), "warm=ACEScct|dim=ACEScg|");
  const char *spaces = listed(d, SOZAI_LIST_SPACES, NULL);
  assert_contains(spaces, "ACEScct=log|");
  assert_null(strstr(spaces, "CIE-XYZ-D65"));
  assert_contains(listed(d, SOZAI_LIST_ROLES, NULL), "cie_xyz_d65_interchange=CIE-XYZ-D65|");
  service_close(s);
}

static void blender(void **state) {
  (void)state;
  if (access(BLENDER, R_OK) != 0) skip();
  service s = service_open(BLENDER);
  assert_contains(listed(s.display, SOZAI_LIST_DISPLAYS, NULL), "sRGB=|");
  assert_contains(listed(s.display, SOZAI_LIST_VIEWS, "sRGB"), "Standard=|Filmic=|");
  assert_contains(listed(s.display, SOZAI_LIST_LOOKS, NULL), "High Contrast=Filmic Log|");
  assert_contains(listed(s.display, SOZAI_LIST_ROLES, NULL), "scene_linear=Linear|");
  service_close(s);
}

static void what_there_is_not(void **state) {
  const sozai_display_1 *d = display_of(state);
  const uint32_t lists[] = {0, 6, UINT32_MAX};
  const char *name = "", *detail = "";
  for (size_t i = 0; i < 3; i++) {
    assert_int_equal(d->count(d->self, lists[i], NULL), 0);
    assert_int_equal(d->item(d->self, lists[i], NULL, 0, &name, &detail), SOZAI_ERROR_UNKNOWN);
    assert_true(!name && !detail);
  }
  assert_int_equal(d->count(NULL, SOZAI_LIST_SPACES, NULL), 0);
  assert_int_equal(d->item(NULL, SOZAI_LIST_SPACES, NULL, 0, &name, &detail), SOZAI_ERROR_UNKNOWN);
  assert_int_equal(d->count(d->self, SOZAI_LIST_VIEWS, "Oscilloscope"), 0);
  assert_int_equal(d->item(d->self, SOZAI_LIST_VIEWS, NULL, 3, NULL, NULL), SOZAI_ERROR_UNKNOWN);
  assert_int_equal(d->item(d->self, SOZAI_LIST_VIEWS, NULL, 2, NULL, NULL), SOZAI_OK);
}

/* Every name that is listed is one that the functions take. */
static void what_is_listed_works(const char *config) {
  service s = service_open(config);
  const sozai_display_1 *d = s.display;
  unsigned spaces = 0, views = 0, looks = 0;
  char message[512] = "";
  const char *name, *view;
  for (uint32_t i = 0; d->item(d->self, SOZAI_LIST_SPACES, NULL, i, &name, NULL) == 0; i++) {
    assert_int_equal(s.colour->has_space(s.colour->self, name), 1);
    spaces++;
  }
  for (uint32_t i = 0; d->item(d->self, SOZAI_LIST_ROLES, NULL, i, &name, NULL) == 0; i++)
    assert_int_equal(s.colour->has_space(s.colour->self, name), 1);
  for (uint32_t i = 0; d->item(d->self, SOZAI_LIST_DISPLAYS, NULL, i, &name, NULL) == 0; i++)
    for (uint32_t k = 0; d->item(d->self, SOZAI_LIST_VIEWS, name, k, &view, NULL) == 0; k++) {
      float rgb[3] = {0.1f, 0.2f, 0.3f};
      if (d->to_display(d->self, name, view, NULL, rgb, 1, message, sizeof message) != SOZAI_OK)
        fail_msg("%s", message);
      views++;
    }
  for (uint32_t i = 0; d->item(d->self, SOZAI_LIST_LOOKS, NULL, i, &name, NULL) == 0; i++) {
    float rgb[3] = {0.1f, 0.2f, 0.3f};
    if (d->to_display(d->self, NULL, NULL, name, rgb, 1, message, sizeof message) != SOZAI_OK)
      fail_msg("%s", message);
    looks++;
  }
  print_message("%s: %u spaces, %u views, %u looks\n", s.colour->config_name(s.colour->self),
                spaces, views, looks);
  service_close(s);
}

static void names_work(void **state) {
  (void)state;
  what_is_listed_works(NULL);
  what_is_listed_works(CONFIG("acescg"));
  what_is_listed_works(CONFIG("p3d65"));
  what_is_listed_works(CONFIG("created_raw"));
  if (access(BLENDER, R_OK) == 0) what_is_listed_works(BLENDER);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(shipped),           cmocka_unit_test(acescg),     cmocka_unit_test(blender),
      cmocka_unit_test(what_there_is_not), cmocka_unit_test(names_work),
  };
  return cmocka_run_group_tests(tests, shipped_setup, shipped_teardown);
}
