/* SPDX-License-Identifier: Apache-2.0
 *
 * Which config is opened, and what becomes of unfit ones.
 */
#include "library.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define CONFIG(name) SOZAI_TEST_DATA "/configs/" name ".ocio"

/* Opening fails so, and the reason, one line, tells of part. */
static void refuses(const char *config, int32_t want, const char *part) {
  char message[1024] = "";
  sozai_services *services = (void *)message;
  int32_t result = library_open(config, &services, message, sizeof message);
  print_message("%s\n", message);
  assert_int_equal(result, want);
  assert_null(services);
  assert_contains(message, part);
  assert_null(strchr(message, '\n'));
  if (config) assert_contains(message, config);
}

static void missing_or_unreadable(void **state) {
  (void)state;
  refuses("/nowhere/config.ocio", SOZAI_ERROR_FILE, "No such file");
  refuses("", SOZAI_ERROR_FILE, "No such file");
  refuses(SOZAI_TEST_DATA, SOZAI_ERROR_FILE, "directory");
  refuses(SOZAI_TEST_DATA "/configs.c", SOZAI_ERROR_FILE, "configs.c");
  refuses(CONFIG("malformed"), SOZAI_ERROR_FILE, "malformed.ocio");
  refuses("/dev/null", SOZAI_ERROR_FILE, "/dev/null");
}

static void unfit(void **state) {
  (void)state;
  refuses(CONFIG("no_linear"), SOZAI_ERROR_COLOUR, "scene_linear");
  refuses(CONFIG("unfit"), SOZAI_ERROR_COLOUR, "nowhere");
}

static void arguments(void **state) {
  (void)state;
  assert_int_equal(library_factory()->open(NULL, NULL, NULL, 0), SOZAI_ERROR_ARGUMENT);
  library_factory()->close(NULL);
}

static void environment_is_honoured(void **state) {
  (void)state;
  setenv("OCIO", CONFIG("doubled"), 1);
  service opened = service_open(NULL);
  const sozai_colour_1 *s = opened.colour;
  assert_string_equal(s->config_name(s->self), CONFIG("doubled"));
  assert_string_equal(s->working_space(s->self), "linear light");
  assert_int_equal(s->has_space(s->self, "sRGB"), 0);
  float rgb[3] = {2, 4, 6};
  assert_int_equal(s->to_working(s->self, "doubled", rgb, 1, NULL, 0), SOZAI_OK);
  const float halved[3] = {1, 2, 3};
  assert_memory_equal(rgb, halved, sizeof rgb);
  service_close(opened);

  /* A config that is named comes first. */
  opened = service_open(CONFIG("raw"));
  s = opened.colour;
  assert_string_equal(s->config_name(s->self), CONFIG("raw"));
  service_close(opened);

  /* A wrong one is not passed over in silence. */
  setenv("OCIO", "/nowhere/config.ocio", 1);
  refuses(NULL, SOZAI_ERROR_FILE, "/nowhere/config.ocio");

  setenv("OCIO", "", 1);
  opened = service_open(NULL);
  s = opened.colour;
  assert_contains(s->config_name(s->self), "/sozai.ocio");
  service_close(opened);
  unsetenv("OCIO");
}

/* Two configs at once do not see one another. */
static void services_are_apart(void **state) {
  (void)state;
  service shipped = service_open(NULL), raw = service_open(CONFIG("raw"));
  const sozai_colour_1 *a = shipped.colour, *b = raw.colour;
  float x[3] = {0.5f, 0.5f, 0.5f}, y[3] = {0.5f, 0.5f, 0.5f};
  assert_int_equal(a->to_working(a->self, "sRGB", x, 1, NULL, 0), SOZAI_OK);
  assert_int_equal(b->to_working(b->self, "sRGB", y, 1, NULL, 0), SOZAI_OK);
  assert_float_equal(x[0], 0.21404114, 1e-6);
  assert_true(y[0] == 0.5f);
  service_close(shipped);
  assert_int_equal(b->from_working(b->self, "sRGB", y, 1, NULL, 0), SOZAI_OK);
  service_close(raw);
}

static void missing_table(void **state) {
  (void)state;
  service opened = service_open(CONFIG("doubled"));
  const sozai_colour_1 *s = opened.colour;
  const sozai_display_1 *d = opened.display;
  const float before[3] = {0.1f, 0.2f, 0.3f};
  float rgb[3] = {0.1f, 0.2f, 0.3f};
  char message[1024] = "";
  assert_int_equal(s->has_space(s->self, "lost"), 1);
  assert_int_equal(s->to_working(s->self, "lost", rgb, 1, message, sizeof message),
                   SOZAI_ERROR_COLOUR);
  print_message("%s\n", message);
  assert_contains(message, "lost");
  assert_contains(message, "nowhere.spi1d");
  assert_int_equal(s->from_working(s->self, "lost", rgb, 1, message, sizeof message),
                   SOZAI_ERROR_COLOUR);
  assert_int_equal(d->to_display(d->self, "Monitor", "Lost", NULL, rgb, 1, message, sizeof message),
                   SOZAI_ERROR_COLOUR);
  assert_memory_equal(rgb, before, sizeof rgb);
  service_close(opened);
}

static void blender(void **state) {
  (void)state;
  const char *path = blender_config();
  if (access(path, R_OK) != 0) skip();
  service opened = service_open(path);
  const sozai_colour_1 *s = opened.colour;
  const sozai_display_1 *d = opened.display;
  print_message("%s: working space %s\n", path, s->working_space(s->self));
  float rgb[3] = {0.5f, 0.25f, 0.75f};
  assert_int_equal(s->to_working(s->self, "sRGB", rgb, 1, NULL, 0), SOZAI_OK);
  const double linear[3] = {0.21404114, 0.05087609, 0.52252155};
  for (int c = 0; c < 3; c++) assert_float_equal(rgb[c], linear[c], 1e-4);
  assert_int_equal(s->from_working(s->self, "sRGB", rgb, 1, NULL, 0), SOZAI_OK);
  assert_float_equal(rgb[0], 0.5, 1e-4);

  float grey[3] = {0.18f, 0.18f, 0.18f}, filmic[3] = {0.18f, 0.18f, 0.18f};
  assert_int_equal(d->to_display(d->self, NULL, NULL, NULL, grey, 1, NULL, 0), SOZAI_OK);
  char message[1024] = "";
  if (d->to_display(d->self, "sRGB", "Filmic", NULL, filmic, 1, message, sizeof message) !=
      SOZAI_OK)
    fail_msg("%s", message);
  for (int c = 0; c < 3; c++) assert_true(filmic[c] > 0.3f && filmic[c] < 0.7f);
  service_close(opened);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(missing_or_unreadable),
      cmocka_unit_test(unfit),
      cmocka_unit_test(arguments),
      cmocka_unit_test(environment_is_honoured),
      cmocka_unit_test(services_are_apart),
      cmocka_unit_test(missing_table),
      cmocka_unit_test(blender),
  };
  return cmocka_run_group_tests(tests, library_setup, library_teardown);
}
