/* SPDX-License-Identifier: Apache-2.0
 *
 * Alpha: colours are converted without it, and filtered and handed out with it.
 */
#include "library.h"
#include "plain.h"
#include "temp.h"

#include <math.h>

static double linear(double v) { return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4); }

static void write_flat(const char *path, const char *format, bool unassociated, int channels,
                       const float *colour) {
  float data[16 * 4];
  for (int i = 0; i < 16 * channels; i++) data[i] = colour[i % channels];
  plain_picture picture = {.width = 4,
                           .height = 4,
                           .channels = channels,
                           .format = format,
                           .unassociated = unassociated};
  assert_true(plain_write(path, &picture, data));
}

static void expect(const services *s, const char *path, const char *space, uint32_t channels,
                   const double *want) {
  sozai_image_request request = file_request(path, channels);
  request.colour_space = space;
  sozai_image *image = open_image(s, &request);
  float found[4];
  look(s, image, 0.5f, 0.5f, 0, found);
  close_image(s, image);
  for (uint32_t c = 0; c < channels; c++) {
    print_message("%g ", (double)found[c]);
    assert_float_equal(found[c], (float)want[c], 2e-6f);
  }
  print_message("\n");
}

static void colours(void **state) {
  const float straight[] = {0.8f, 0.4f, 0.2f, 0.6f}; /* whole 255ths */
  const double product[] = {linear(0.8) * 0.6, linear(0.4) * 0.6, linear(0.2) * 0.6, 0.6};
  write_flat(temp_path("straight.png"), "uint8", true, 4, straight);
  expect(*state, temp_path("straight.png"), NULL, 4, product);
  expect(*state, temp_path("straight.png"), NULL, 3, product);

  /* The same, multiplied before it was written. */
  const float multiplied[] = {0.48f, 0.24f, 0.12f, 0.6f};
  write_flat(temp_path("multiplied.tif"), "float", false, 4, multiplied);
  expect(*state, temp_path("multiplied.tif"), "sRGB", 4, product);

  /* Linear already: multiplied, and else as it is. */
  const double as_is[] = {0.8 * 0.6, 0.4 * 0.6, 0.2 * 0.6, 0.6};
  expect(*state, temp_path("straight.png"), "lin_rec709", 4, as_is);
}

static void data(void **state) {
  const float straight[] = {0.8f, 0.4f, 0.2f, 0.6f};
  const double raw[] = {0.8, 0.4, 0.2, 0.6};
  write_flat(temp_path("data.png"), "uint8", true, 4, straight);
  expect(*state, temp_path("data.png"), "data", 4, raw);
  expect(*state, temp_path("data.png"), NULL, 2, raw); /* two are no colour */
}

/* What is not there glows: its colour stays. */
static void no_alpha(void **state) {
  const float glow[] = {0.5f, 0.5f, 0.5f, 0};
  const double want[] = {linear(0.5), linear(0.5), linear(0.5), 0};
  write_flat(temp_path("glow.exr"), "float", false, 4, glow);
  expect(*state, temp_path("glow.exr"), "sRGB", 4, want);
}

static void fewer_channels(void **state) {
  const float grey[] = {0.4f}, grey_alpha[] = {0.4f, 0.6f}, rgb[] = {0.8f, 0.4f, 0.2f};
  const double from_grey[] = {linear(0.4), linear(0.4), linear(0.4), 1};
  const double from_alpha[] = {linear(0.4) * 0.6, linear(0.4) * 0.6, linear(0.4) * 0.6, 0.6};
  const double from_rgb[] = {linear(0.8), linear(0.4), linear(0.2), 1};
  write_flat(temp_path("grey.png"), "uint8", false, 1, grey);
  expect(*state, temp_path("grey.png"), NULL, 3, from_grey);
  expect(*state, temp_path("grey.png"), NULL, 4, from_grey);
  write_flat(temp_path("ya.png"), "uint8", true, 2, grey_alpha);
  expect(*state, temp_path("ya.png"), NULL, 4, from_alpha);
  write_flat(temp_path("rgb.png"), "uint8", false, 3, rgb);
  expect(*state, temp_path("rgb.png"), NULL, 4, from_rgb);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(colours), cmocka_unit_test(data),
                                     cmocka_unit_test(no_alpha), cmocka_unit_test(fewer_channels)};
  return cmocka_run_group_tests(tests, services_setup, services_teardown);
}
