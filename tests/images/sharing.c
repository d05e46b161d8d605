/* SPDX-License-Identifier: Apache-2.0
 *
 * A picture that is open twice is there once; one that changed is another.
 */
#include "library.h"
#include "places.h"
#include "plain.h"
#include "temp.h"

#include <unistd.h>

enum { SIDE = 512 };

static void write_flat(const char *path, float value) {
  float *data = malloc(sizeof *data * SIDE * SIDE * 3);
  for (int i = 0; i < SIDE * SIDE * 3; i++) data[i] = value;
  plain_picture picture = {.width = SIDE, .height = SIDE, .channels = 3, .format = "half"};
  assert_true(plain_write(path, &picture, data));
  free(data);
}

/* Bytes in use after looking all over it. */
static uint64_t used_after(const services *s, const sozai_image *image) {
  static places at;
  static float out[4][PLACES];
  uint64_t used = 0;
  places_make(&at, 5, SIDE, 0, 1);
  assert_int_equal(places_look(s, image, &at, 0, PLACES, out, 3), SOZAI_OK);
  s->images->memory(s->images->self, &used, NULL);
  return used;
}

static void once(void **state) {
  const services *s = *state;
  const char *path = temp_path("shared.exr"), *link = temp_path("link.exr");
  write_flat(path, 0.5f);
  assert_int_equal(symlink(path, link), 0);
  sozai_image_request request = file_request(path, 3);
  sozai_image *first = open_image(s, &request);
  uint64_t one = used_after(s, first);

  request.wrap_s = SOZAI_WRAP_MIRROR; /* how it is looked up is no part of it */
  sozai_image *second = open_image(s, &request);
  request.path = link;
  sozai_image *third = open_image(s, &request);
  request.colour_space = "scene_linear"; /* what the file rules give */
  sozai_image *same_space = open_image(s, &request);
  uint64_t two = used_after(s, second), three = used_after(s, third);
  uint64_t four = used_after(s, same_space);
  print_message("used: %lu, %lu, %lu, %lu bytes\n", one, two, three, four);
  assert_int_equal(two, one);
  assert_int_equal(three, one);
  assert_int_equal(four, one);

  request.colour_space = "data"; /* the same numbers, but of another kind */
  sozai_image *other = open_image(s, &request);
  print_message("and as data: %lu\n", used_after(s, other));
  assert_int_equal(used_after(s, other), 2 * one);

  /* The others hold when one goes. */
  close_image(s, first);
  float found[4];
  look(s, second, 0.5f, 0.5f, 0, found);
  assert_float_equal(found[0], 0.5f, 0);
  close_image(s, second);
  close_image(s, third);
  close_image(s, same_space);
  close_image(s, other);
  uint64_t used = 1;
  s->images->memory(s->images->self, &used, NULL);
  print_message("all closed: %lu\n", used);
  assert_true(used <= 200000); /* a thread may keep the last tiles it has seen */
}

static void changed(void **state) {
  const services *s = *state;
  const char *path = temp_path("changing.exr");
  write_flat(path, 0.25f);
  sozai_image *before = open_file(s, path, 3);
  float found[4];
  look(s, before, 0.5f, 0.5f, 0, found);
  assert_float_equal(found[0], 0.25f, 0);

  usleep(20000); /* the clock of files may be coarse */
  write_flat(path, 0.75f);
  sozai_image *after = open_file(s, path, 3);
  look(s, after, 0.5f, 0.5f, 0, found);
  assert_float_equal(found[0], 0.75f, 0);
  /* What is open stays what it was, also where it was not looked at before. */
  look(s, before, 0.9f, 0.9f, 0, found);
  assert_float_equal(found[0], 0.25f, 0);
  assert_int_equal(unlink(path), 0);
  look(s, after, 0.1f, 0.1f, 0, found);
  assert_float_equal(found[0], 0.75f, 0);
  close_image(s, before);
  close_image(s, after);
}

/* Names, places in the store and tiles are used again: never with old numbers. */
static void again_and_again(void **state) {
  const services *s = *state;
  float data[100 * 3], found[4];
  sozai_buffer buffer = {.size = sizeof buffer, .kind = SOZAI_BUFFER_IMAGE, .data = data};
  sozai_image_request request = {.size = sizeof request, .channels = 3, .buffer = &buffer};
  for (int i = 0; i < 500; i++) {
    uint64_t w = 1 + (uint64_t)i % 10;
    for (uint64_t k = 0; k < 100 * 3; k++) data[k] = (float)i;
    buffer.dims[0] = 10, buffer.dims[1] = w, buffer.dims[2] = 3;
    sozai_image *image = open_image(s, &request);
    look(s, image, 0.3f, 0.3f, 0.1f, found);
    assert_float_equal(found[0], (float)i, 1e-3f);
    close_image(s, image);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(once), cmocka_unit_test(changed),
                                     cmocka_unit_test(again_and_again)};
  return cmocka_run_group_tests(tests, services_setup, services_teardown);
}
