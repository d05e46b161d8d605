/* SPDX-License-Identifier: Apache-2.0
 *
 * What a look-up costs beside OpenImageIO's own in the converted picture. Told, and
 * not judged: machines differ. Only a conversion at every look-up would be so dear
 * that the test fails.
 */
#include "library.h"
#include "places.h"
#include "plain.h"
#include "temp.h"

#include <math.h>
#include <time.h>

enum { SIDE = 1024, ROUNDS = 9, MOST = PLACES };

static double nanoseconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec * 1e9 + (double)now.tv_nsec;
}

static double ours(const services *s, const sozai_image *image, const places *p, uint32_t batch) {
  static float out[3][PLACES];
  double begin = nanoseconds();
  for (uint32_t i = 0; i < MOST; i += batch)
    places_look(s, image, p, i, batch < MOST - i ? batch : MOST - i, out, 3);
  return (nanoseconds() - begin) / MOST;
}

static void beside_openimageio(void **state) {
  const services *s = *state;
  float *data = random_pixels((size_t)SIDE * SIDE * 3, 1);
  plain_picture picture = {
      .width = SIDE, .height = SIDE, .channels = 3, .format = "float", .tile = 64};
  assert_true(plain_write(temp_path("speed.tif"), &picture, data));
  free(data);
  sozai_image_request request = file_request(temp_path("speed.tif"), 3);
  request.colour_space = "sRGB";
  sozai_image *image = open_image(s, &request);
  plain *other = plain_open(temp_path("speed.tif"), SOZAI_WRAP_CLAMP);
  static places at;
  const float footprints[] = {0, 1.0f / SIDE, 8.0f / SIDE, 0.1f};
  for (int f = 0; f < 4; f++) {
    places_make(&at, 3, SIDE, 0, 1);
    for (int i = 0; i < MOST; i++) { /* along rows, as a renderer comes by */
      at.s[i] = (float)(i % 100) / 400 + 0.2f;
      at.t[i] = (float)(i / 100) / 400 + 0.2f;
      at.dsdx[i] = at.dtdy[i] = footprints[f];
      at.dtdx[i] = at.dsdy[i] = 0;
    }
    double plain_ns = INFINITY, one = INFINITY, many = INFINITY;
    for (int round = 0; round < ROUNDS; round++) {
      plain_ns = fmin(plain_ns, plain_time(other, MOST, at.s, at.t, footprints[f], 3));
      one = fmin(one, ours(s, image, &at, 1));
      many = fmin(many, ours(s, image, &at, 1024));
    }
    print_message("footprint %5.1f pixels: OpenImageIO %4.0f ns, ours %4.0f (%.2f times) in "
                  "batches of 1024, %4.0f (%.2f) of 1\n",
                  (double)(footprints[f] * SIDE), plain_ns, many, many / plain_ns, one,
                  one / plain_ns);
    assert_true(many < 5 * plain_ns);
  }
  plain_close(other);
  close_image(s, image);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(beside_openimageio)};
  return cmocka_run_group_tests(tests, services_setup, services_teardown);
}
