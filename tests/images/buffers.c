/* SPDX-License-Identifier: Apache-2.0
 *
 * Pictures in the host's memory, and requests that make no sense.
 */
#include "library.h"
#include "temp.h"

#include <float.h>
#include <math.h>

enum { W = 16, H = 8 };

static sozai_buffer buffer_of(const float *data, uint64_t channels, const char *space) {
  return (sozai_buffer){.size = sizeof(sozai_buffer),
                        .kind = SOZAI_BUFFER_IMAGE,
                        .dims = {H, W, channels},
                        .data = data,
                        .colour_space = space};
}

static sozai_image_request request_of(const sozai_buffer *buffer, uint32_t channels) {
  return (sozai_image_request){
      .size = sizeof(sozai_image_request), .channels = channels, .buffer = buffer};
}

static void flat(float *data, int channels, const float *colour) {
  for (int i = 0; i < W * H * channels; i++) data[i] = colour[i % channels];
}

/* What a flat buffer of given channels looks like, of as many as are asked for. */
static void expect(const services *s, int given, const char *space, uint32_t first, uint32_t asked,
                   const float *want) {
  static const float colour[] = {0.5f, 0.25f, 0.125f, 0.5f};
  float data[W * H * 4], found[4];
  flat(data, given, colour);
  sozai_buffer buffer = buffer_of(data, (uint64_t)given, space);
  sozai_image_request request = request_of(&buffer, asked);
  request.first_channel = first;
  sozai_image *image = open_image(s, &request);
  memset(data, 0, sizeof data); /* it was copied */
  look(s, image, 0.5f, 0.5f, 0, found);
  close_image(s, image);
  print_message("%d channels as %s, %u+%u:", given, space ? space : "data", first, asked);
  for (uint32_t c = 0; c < asked; c++) {
    print_message(" %g", (double)found[c]);
    assert_float_equal(found[c], want[c], 1e-6f);
  }
  print_message("\n");
}

static void channels(void **state) {
  expect(*state, 1, NULL, 0, 1, (const float[]){0.5f});
  expect(*state, 1, NULL, 0, 2, (const float[]){0.5f, 0.5f});
  expect(*state, 1, NULL, 0, 4, (const float[]){0.5f, 0.5f, 0.5f, 1});
  expect(*state, 2, NULL, 0, 2, (const float[]){0.5f, 0.25f});
  expect(*state, 2, NULL, 1, 1, (const float[]){0.25f});
  expect(*state, 2, NULL, 0, 4, (const float[]){0.5f, 0.25f, 0.25f, 1});
  expect(*state, 3, NULL, 0, 4, (const float[]){0.5f, 0.25f, 0.125f, 1});
  expect(*state, 3, "data", 2, 1, (const float[]){0.125f});
  expect(*state, 4, NULL, 0, 4, (const float[]){0.5f, 0.25f, 0.125f, 0.5f});
  expect(*state, 4, NULL, 3, 1, (const float[]){0.5f});
}

static void spaces(void **state) {
  const float one = 0.2140411f, two = 0.0508761f, three = 0.0143499f;
  expect(*state, 3, "sRGB", 0, 3, (const float[]){one, two, three});
  expect(*state, 3, "srgb_texture", 0, 4, (const float[]){one, two, three, 1});
  expect(*state, 3, "matte_paint", 0, 3, (const float[]){one, two, three}); /* a role */
  expect(*state, 1, "sRGB", 0, 3, (const float[]){one, one, one});
  expect(*state, 3, "sRGB", 0, 2, (const float[]){0.5f, 0.25f}); /* two are no colour */
  expect(*state, 3, "Non-Color", 0, 3, (const float[]){0.5f, 0.25f, 0.125f});
  expect(*state, 3, "scene_linear", 0, 3, (const float[]){0.5f, 0.25f, 0.125f});
  /* (1, 0.5, 0.25) times 0.5 */
  expect(*state, 4, "sRGB", 0, 4, (const float[]){0.5f, one / 2, two / 2, 0.5f});
}

static void not_finite(void **state) {
  float data[W * H * 3], found[4];
  for (int i = 0; i < W * H * 3; i++) data[i] = 1;
  for (int i = 0; i < W * H * 3; i += 6) {
    data[i] = NAN;
    data[i + 1] = INFINITY;
    data[i + 2] = -INFINITY;
  }
  sozai_buffer buffer = buffer_of(data, 3, "sRGB");
  sozai_image_request request = request_of(&buffer, 3);
  sozai_image *image = open_image(*state, &request);
  look(*state, image, 0.5f, 0.5f, 2, found);
  for (int c = 0; c < 3; c++) assert_float_equal(found[c], 0.5f, 1e-6f); /* read as 0 */
  close_image(*state, image);

  for (int i = 0; i < W * H * 3; i++) data[i] = i % 2 ? FLT_MAX : -FLT_MAX;
  const char *const some[] = {"ACEScct", "sRGB", "ACES2065-1", "data"};
  for (size_t k = 0; k < 4; k++) {
    buffer = buffer_of(data, 3, some[k]);
    image = open_image(*state, &request);
    for (float at = 0; at < 1; at += 0.01f) {
      look(*state, image, at, 1 - at, at / 4, found);
      for (int c = 0; c < 3; c++) assert_true(isfinite(found[c]));
    }
    close_image(*state, image);
  }
}

static void refuse(const services *s, const sozai_image_request *request, int32_t want,
                   const char *part) {
  char message[256] = "unwritten";
  sozai_image *image = (sozai_image *)(uintptr_t)1;
  int32_t result = s->images->open(s->images->self, request, &image, message, sizeof message);
  print_message("%d: %s\n", (int)result, message);
  assert_int_equal(result, want);
  assert_null(image);
  assert_contains(message, part);
}

static void senseless(void **state) {
  const services *s = *state;
  float data[W * H * 4] = {0};
  sozai_buffer buffer = buffer_of(data, 3, NULL), wrong = buffer;
  sozai_image_request fine = request_of(&buffer, 3), r = fine;

  refuse(s, NULL, SOZAI_ERROR_ARGUMENT, "NULL");
  r.size = 0;
  refuse(s, &r, SOZAI_ERROR_ARGUMENT, "size");
  r = fine, r.channels = 0;
  refuse(s, &r, SOZAI_ERROR_ARGUMENT, "channels");
  r = fine, r.channels = 5;
  refuse(s, &r, SOZAI_ERROR_ARGUMENT, "channels");
  r = fine, r.wrap_t = 17;
  refuse(s, &r, SOZAI_ERROR_ARGUMENT, "wrap");
  r = fine, r.buffer = NULL;
  refuse(s, &r, SOZAI_ERROR_ARGUMENT, "neither");
  r = fine, r.first_channel = 3;
  refuse(s, &r, SOZAI_ERROR_FILE, "channel 3");
  r = fine, r.first_channel = UINT32_MAX;
  refuse(s, &r, SOZAI_ERROR_ARGUMENT, "first_channel");
  r = fine, r.colour_space = "Utopia RGB";
  refuse(s, &r, SOZAI_ERROR_COLOUR, "Utopia RGB");

  r = fine, r.buffer = &wrong;
  wrong = buffer, wrong.size = 0;
  refuse(s, &r, SOZAI_ERROR_ARGUMENT, "size");
  wrong = buffer, wrong.kind = SOZAI_BUFFER_TABLE;
  refuse(s, &r, SOZAI_ERROR_ARGUMENT, "no image");
  wrong = buffer, wrong.data = NULL;
  refuse(s, &r, SOZAI_ERROR_ARGUMENT, "neither data nor a path");
  wrong = buffer, wrong.dims[0] = 0;
  refuse(s, &r, SOZAI_ERROR_FILE, "x 0 pixels");
  wrong = buffer, wrong.dims[0] = UINT64_MAX;
  refuse(s, &r, SOZAI_ERROR_FILE, "pixels");
  wrong = buffer, wrong.dims[0] = wrong.dims[1] = 1u << 17;
  refuse(s, &r, SOZAI_ERROR_FILE, "pixels");
  wrong = buffer, wrong.dims[2] = 0;
  refuse(s, &r, SOZAI_ERROR_ARGUMENT, "channels");
  wrong = buffer, wrong.dims[2] = UINT64_MAX;
  refuse(s, &r, SOZAI_ERROR_ARGUMENT, "channels");

  close_image(s, NULL);
  sozai_image *image = open_image(s, &fine);
  assert_int_equal(s->images->resolution(s->images->self, image, NULL, NULL), SOZAI_OK);
  assert_int_equal(s->images->resolution(s->images->self, NULL, NULL, NULL), SOZAI_ERROR_ARGUMENT);
  assert_int_equal(
      s->images->sample(s->images->self, image, 1, NULL, NULL, NULL, NULL, NULL, NULL, NULL),
      SOZAI_ERROR_ARGUMENT);
  assert_int_equal(
      s->images->sample(s->images->self, image, 0, NULL, NULL, NULL, NULL, NULL, NULL, NULL),
      SOZAI_OK);
  s->images->memory(s->images->self, NULL, NULL);
  close_image(s, image);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(channels), cmocka_unit_test(spaces),
                                     cmocka_unit_test(not_finite), cmocka_unit_test(senseless)};
  return cmocka_run_group_tests(tests, services_setup, services_teardown);
}
