/* SPDX-License-Identifier: Apache-2.0
 *
 * A picture is looked up as it is seen: turned as its file says, and in its window.
 */
#include "library.h"
#include "plain.h"
#include "temp.h"

enum { W = 6, H = 4 };

/* Which stored pixel is seen at (x, y), after EXIF 2.3's table of orientations. */
static int stored(int orientation, int x, int y) {
  switch (orientation) {
  case 2:
    return y * W + (W - 1 - x);
  case 3:
    return (H - 1 - y) * W + (W - 1 - x);
  case 4:
    return (H - 1 - y) * W + x;
  case 5: /* row 0 is seen at the left, column 0 at the top */
    return x * W + y;
  case 6: /* row 0 at the right, column 0 at the top */
    return (H - 1 - x) * W + y;
  case 7: /* row 0 at the right, column 0 at the bottom */
    return (H - 1 - x) * W + (W - 1 - y);
  case 8: /* row 0 at the left, column 0 at the bottom */
    return x * W + (W - 1 - y);
  default:
    return y * W + x;
  }
}

/* Each pixel 8 x 8 large, so that its middle is flat. */
static void as_seen(void **state) {
  const services *s = *state;
  for (int orientation = 1; orientation <= 8; orientation++) {
    float data[W * H * 64];
    for (int i = 0; i < W * H * 64; i++)
      data[i] = (float)(i / (W * 64) * W + i % (W * 8) / 8) / (W * H);
    plain_picture picture = {.width = W * 8,
                             .height = H * 8,
                             .channels = 1,
                             .format = "float",
                             .orientation = orientation};
    assert_true(plain_write(temp_path("turned.tif"), &picture, data));
    sozai_image *image = open_file(s, temp_path("turned.tif"), 1);
    uint32_t width = 0, height = 0;
    assert_int_equal(s->images->resolution(s->images->self, image, &width, &height), SOZAI_OK);
    int seen_w = orientation < 5 ? W : H, seen_h = orientation < 5 ? H : W;
    assert_int_equal(width, seen_w * 8);
    assert_int_equal(height, seen_h * 8);
    for (int y = 0; y < seen_h; y++)
      for (int x = 0; x < seen_w; x++) {
        float found[4];
        look(s, image, ((float)x + 0.5f) / (float)seen_w, ((float)y + 0.5f) / (float)seen_h, 0,
             found);
        assert_float_equal(found[0], (float)stored(orientation, x, y) / (W * H), 1e-5f);
      }
    /* The footprint is turned, too: wide across is the mean of a row as it is seen. */
    float row = 0, found;
    for (int x = 0; x < seen_w; x++)
      row += (float)stored(orientation, x, 0) / (W * H) / (float)seen_w;
    float at_s = 0.5f, at_t = 0.5f / (float)seen_h, across = 1, none = 0, *to[] = {&found};
    assert_int_equal(s->images->sample(s->images->self, image, 1, &at_s, &at_t, &across, &none,
                                       &none, &none, to),
                     SOZAI_OK);
    print_message("orientation %d: a row's mean %.4f, looked up %.4f\n", orientation, (double)row,
                  (double)found);
    assert_float_equal(found, row, 0.06f);
    close_image(s, image);
  }
}

/* Pixels that fill a part of the window, or stick out of it. */
static void windows(void **state) {
  const services *s = *state;
  float data[64 * 64 * 3];
  for (size_t i = 0; i < sizeof data / sizeof data[0]; i++) data[i] = 1;
  plain_picture picture = {.width = 64,
                           .height = 64,
                           .channels = 3,
                           .format = "half",
                           .windowed = true,
                           .x = 32,
                           .y = 64,
                           .full_width = 128,
                           .full_height = 256};
  assert_true(plain_write(temp_path("window.exr"), &picture, data));
  sozai_image *image = open_file(s, temp_path("window.exr"), 3);
  uint32_t width = 0, height = 0;
  assert_int_equal(s->images->resolution(s->images->self, image, &width, &height), SOZAI_OK);
  assert_int_equal(width, 128);
  assert_int_equal(height, 256);
  float inside[4], outside[4], all[4];
  look(s, image, 0.5f, 0.375f, 0, inside);
  look(s, image, 0.5f, 0.75f, 0, outside);
  look(s, image, 0.5f, 0.5f, 3, all);
  assert_float_equal(inside[0], 1, 1e-6f);
  assert_float_equal(outside[0], 0, 0);
  assert_float_equal(all[0], 0.125f, 1e-6f);
  close_image(s, image);

  picture.x = picture.y = -32; /* three quarters are out of sight */
  picture.full_width = picture.full_height = 32;
  assert_true(plain_write(temp_path("overscan.exr"), &picture, data));
  image = open_file(s, temp_path("overscan.exr"), 3);
  look(s, image, 0.5f, 0.5f, 3, all);
  assert_float_equal(all[0], 1, 1e-6f);
  close_image(s, image);

  picture.x = picture.y = 1000; /* all are */
  assert_true(plain_write(temp_path("away.exr"), &picture, data));
  image = open_file(s, temp_path("away.exr"), 3);
  look(s, image, 0.5f, 0.5f, 3, all);
  assert_float_equal(all[0], 0, 0);
  close_image(s, image);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(as_seen), cmocka_unit_test(windows)};
  return cmocka_run_group_tests(tests, services_setup, services_teardown);
}
