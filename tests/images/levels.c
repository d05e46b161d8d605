/* SPDX-License-Identifier: Apache-2.0
 *
 * Coarser levels: of linear numbers, and with the picture's mean at every size.
 */
#include "library.h"
#include "places.h"
#include "plain.h"
#include "temp.h"

#include <math.h>

static double linear(double v) { return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4); }

/* Black and white pixels in turn. Encoded, their mean is 0.5; linear 0.5 is 0.735 encoded, and
 * whoever filters before the curve gets 0.214. */
static void write_checker(const char *path, int side, int tile) {
  float *data = malloc((size_t)(side * side) * 3 * sizeof *data);
  for (int i = 0; i < side * side * 3; i++) data[i] = (float)((i / 3 % side + i / 3 / side) % 2);
  plain_picture picture = {
      .width = side, .height = side, .channels = 3, .format = "uint8", .tile = tile};
  assert_true(plain_write(path, &picture, data));
  free(data);
}

static void expect_half(const services *s, const char *path) {
  sozai_image_request request = file_request(path, 3);
  request.colour_space = "sRGB";
  sozai_image *image = open_image(s, &request);
  const float footprints[] = {0.125f, 0.25f, 1, 4};
  for (int i = 0; i < 4; i++) {
    float rgb[4];
    look(s, image, 0.5f, 0.5f, footprints[i], rgb);
    print_message("  footprint %g: %.7f\n", (double)footprints[i], (double)rgb[0]);
    for (int c = 0; c < 3; c++) assert_float_equal(rgb[c], 0.5f, 1e-6f);
  }
  close_image(s, image);
}

static void linear_before_filtered(void **state) {
  write_checker(temp_path("checker.png"), 64, 0);
  expect_half(*state, temp_path("checker.png"));
  write_checker(temp_path("checker.tif"), 128, 64); /* one that has tiles */
  expect_half(*state, temp_path("checker.tif"));
}

/* A file with levels of its own, made before the curve: they are not to be used. */
static void own_levels_unused(void **state) {
  write_checker(temp_path("base.png"), 256, 0);
  char command[600];
  snprintf(command, sizeof command, "maketx '%s' -o '%s'", temp_path("base.png"),
           temp_path("mipped.tx"));
  if (system(command) != 0) skip();
  expect_half(*state, temp_path("mipped.tx"));
}

/* The whole picture in one look-up is its mean, whatever its size. */
static void mean_at_any_size(void **state) {
  static const int sizes[][2] = {{1, 1},   {2, 2},     {3, 3},    {5, 7},     {64, 64},   {100, 75},
                                 {65, 63}, {301, 257}, {1, 1000}, {16384, 1}, {1023, 511}};
  for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
    int w = sizes[i][0], h = sizes[i][1];
    size_t count = (size_t)w * (size_t)h * 3;
    float *data = random_pixels(count, i);
    plain_picture picture = {.width = w, .height = h, .channels = 3, .format = "uint8"};
    const char *path = temp_path("sized.png");
    assert_true(plain_write(path, &picture, data));
    double mean = 0;
    for (size_t k = 0; k < count; k += 3)
      mean += linear(round((double)data[k] * 255) / 255) / ((double)count / 3);
    free(data);
    sozai_image *image = open_file(*state, path, 3);
    uint32_t width = 0, height = 0;
    const services *s = *state;
    assert_int_equal(s->images->resolution(s->images->self, image, &width, &height), SOZAI_OK);
    assert_int_equal(width, w);
    assert_int_equal(height, h);
    float rgb[4];
    look(s, image, 0.5f, 0.5f, 3, rgb);
    close_image(s, image);
    print_message("%5dx%-5d mean %.6f, looked up %.6f\n", w, h, mean, (double)rgb[0]);
    assert_float_equal(rgb[0], (float)mean, 2e-6f);
  }
}

/* At a pixel's middle, with no footprint, a flat area's own number. */
static void finest_level(void **state) {
  float data[8 * 8 * 3];
  for (int i = 0; i < 8 * 8 * 3; i++) data[i] = i / 3 % 8 < 4 ? 0.25f : 0.75f;
  plain_picture picture = {.width = 8, .height = 8, .channels = 3, .format = "half"};
  assert_true(plain_write(temp_path("flat.exr"), &picture, data));
  sozai_image *image = open_file(*state, temp_path("flat.exr"), 3);
  float left[4], right[4], edge[4];
  look(*state, image, 1.5f / 8, 0.5f, 0, left);
  look(*state, image, 6.5f / 8, 0.5f, 0, right);
  look(*state, image, 0.5f, 0.5f, 0, edge);
  close_image(*state, image);
  assert_float_equal(left[0], 0.25f, 1e-6f);
  assert_float_equal(right[0], 0.75f, 1e-6f);
  assert_float_equal(edge[0], 0.5f, 1e-6f); /* between: interpolated */
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(linear_before_filtered), cmocka_unit_test(own_levels_unused),
      cmocka_unit_test(mean_at_any_size), cmocka_unit_test(finest_level)};
  return cmocka_run_group_tests(tests, services_setup, services_teardown);
}
