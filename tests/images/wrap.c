/* SPDX-License-Identifier: Apache-2.0
 *
 * Beyond the edges.
 */
#include "library.h"
#include "places.h"
#include "plain.h"
#include "temp.h"

#include <float.h>
#include <math.h>

enum { SIDE = 256 };

static sozai_image *open_wrapped(const services *s, uint32_t wrap_s, uint32_t wrap_t) {
  sozai_image_request request = file_request(temp_path("wrap.exr"), 3);
  request.wrap_s = wrap_s;
  request.wrap_t = wrap_t;
  return open_image(s, &request);
}

static int setup(void **state) {
  services_setup(state);
  plain_picture picture = {.width = SIDE, .height = SIDE, .channels = 3, .format = "float"};
  float *data = random_pixels(SIDE * SIDE * 3, 3);
  assert_true(plain_write(temp_path("wrap.exr"), &picture, data));
  free(data);
  return 0;
}

static void as_openimageio(void **state) {
  for (uint32_t wrap = SOZAI_WRAP_DEFAULT; wrap <= SOZAI_WRAP_MIRROR; wrap++) {
    sozai_image *image = open_wrapped(*state, wrap, wrap);
    plain *other = plain_open(temp_path("wrap.exr"), wrap);
    static places at;
    static float found[3][PLACES];
    places_make(&at, wrap, SIDE, -2, 3);
    assert_int_equal(places_look(*state, image, &at, 0, PLACES, found, 3), SOZAI_OK);
    double worst = 0;
    for (int i = 0; i < PLACES; i++) {
      float want[3];
      assert_true(plain_look(other, at.s[i], at.t[i], at.dsdx[i], at.dtdx[i], at.dsdy[i],
                             at.dtdy[i], 3, want));
      for (int c = 0; c < 3; c++) worst = fmax(worst, fabs((double)(found[c][i] - want[c])));
    }
    print_message("wrap %u: worst %.2g\n", wrap, worst);
    assert_true(worst <= 1e-6);
    plain_close(other);
    close_image(*state, image);
  }
}

static float red(const services *s, const sozai_image *image, float at_s, float at_t) {
  float rgb[4];
  look(s, image, at_s, at_t, 0, rgb);
  return rgb[0];
}

static void by_definition(void **state) {
  const services *s = *state;
  sozai_image *black = open_wrapped(s, SOZAI_WRAP_BLACK, SOZAI_WRAP_BLACK);
  sozai_image *clamp = open_wrapped(s, SOZAI_WRAP_CLAMP, SOZAI_WRAP_CLAMP);
  sozai_image *periodic = open_wrapped(s, SOZAI_WRAP_PERIODIC, SOZAI_WRAP_PERIODIC);
  sozai_image *mirror = open_wrapped(s, SOZAI_WRAP_MIRROR, SOZAI_WRAP_MIRROR);
  sozai_image *mixed = open_wrapped(s, SOZAI_WRAP_PERIODIC, SOZAI_WRAP_BLACK);
  for (int i = 0; i < 50; i++) {
    float at = ((float)i + 0.5f) / 64, v = 0.3125f; /* exact in binary, as is what is added */
    assert_float_equal(red(s, black, at + 2, v), 0, 0);
    assert_float_equal(red(s, clamp, at + 2, v), red(s, clamp, 3, v), 0);
    assert_float_equal(red(s, periodic, at + 2, v), red(s, periodic, at, v), 1e-5f);
    assert_float_equal(red(s, mirror, 2 - at, v), red(s, mirror, at, v), 1e-5f);
    assert_float_equal(red(s, mixed, at + 2, v), red(s, periodic, at, v), 1e-5f);
    assert_float_equal(red(s, mixed, at, v + 2), 0, 0);
    assert_float_equal(red(s, periodic, at + 0x1p40f, v), red(s, periodic, 0, v), 1e-5f);
  }
  close_image(s, black);
  close_image(s, clamp);
  close_image(s, periodic);
  close_image(s, mirror);
  close_image(s, mixed);
}

/* Any numbers at all: finite answers, alone as in a batch. */
static void any_numbers(void **state) {
  static const float odd[] = {0,        -0.0f,   1,         NAN,   INFINITY, -INFINITY, FLT_MAX,
                              -FLT_MAX, FLT_MIN, 0x1p-149f, 1e10f, -1e10f,   1e20f,     65536};
  enum { ODD = sizeof odd / sizeof odd[0] };
  const services *s = *state;
  for (uint32_t wrap = SOZAI_WRAP_BLACK; wrap <= SOZAI_WRAP_MIRROR; wrap++) {
    sozai_image *image = open_wrapped(s, wrap, wrap);
    static places at;
    static float found[3][PLACES], alone[3][PLACES];
    uint64_t seed = wrap;
    for (int i = 0; i < PLACES; i++) {
      float *to[] = {at.s, at.t, at.dsdx, at.dtdx, at.dsdy, at.dtdy};
      for (int k = 0; k < 6; k++) {
        float ordinary = random_unit(&seed);
        to[k][i] = random_unit(&seed) < 0.5f ? odd[(int)(random_unit(&seed) * ODD)] : ordinary;
      }
    }
    assert_int_equal(places_look(s, image, &at, 0, PLACES, found, 3), SOZAI_OK);
    for (uint32_t i = 0; i < PLACES; i++) {
      assert_int_equal(places_look(s, image, &at, i, 1, alone, 3), SOZAI_OK);
      for (int c = 0; c < 3; c++) {
        assert_true(isfinite(found[c][i]));
        assert_true(found[c][i] >= -1e-6f && found[c][i] <= 1.001f);
      }
    }
    assert_memory_equal(found, alone, sizeof found);
    close_image(s, image);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(as_openimageio),
                                     cmocka_unit_test(by_definition),
                                     cmocka_unit_test(any_numbers)};
  return cmocka_run_group_tests(tests, setup, services_teardown);
}
