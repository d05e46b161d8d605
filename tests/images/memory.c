/* SPDX-License-Identifier: Apache-2.0
 *
 * No more memory than the limit, however much is looked at.
 */
#include "library.h"
#include "places.h"
#include "plain.h"
#include "temp.h"

#include <time.h>

enum { SIDE = 4096, PICTURES = 3, MB = 1 << 20 };

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

static void write_large(const char *path) {
  float *data = malloc(sizeof *data * SIDE * SIDE * 3);
  assert_non_null(data);
  for (size_t i = 0; i < (size_t)SIDE * SIDE * 3; i++) data[i] = (float)(i * 37 % 256) / 255;
  plain_picture picture = {.width = SIDE, .height = SIDE, .channels = 3, .format = "uint8"};
  assert_true(plain_write(path, &picture, data));
  free(data);
}

static long resident_mb(void) {
  long pages = 0;
  FILE *file = fopen("/proc/self/statm", "r");
  assert_non_null(file);
  assert_int_equal(fscanf(file, "%*d %ld", &pages), 1);
  fclose(file);
  return pages * 4096 / MB;
}

static void limited(void **state) {
  (void)state;
  uint64_t used = 0, limit = 0;
  services s = services_open(16 * MB);
  sozai_image *images[PICTURES];
  for (int i = 0; i < PICTURES; i++) {
    char name[32];
    snprintf(name, sizeof name, "large%d.tif", i);
    write_large(temp_path(name));
  }
  long before = resident_mb();
  for (int i = 0; i < PICTURES; i++) {
    char name[32];
    snprintf(name, sizeof name, "large%d.tif", i);
    double begin = seconds();
    sozai_image_request request = file_request(temp_path(name), 3);
    request.colour_space = "sRGB";
    images[i] = open_image(&s, &request);
    print_message("%d x %d opened in %.2f s\n", SIDE, SIDE, seconds() - begin);
  }
  static places at;
  static float out[3][PLACES];
  uint64_t most = 0;
  double begin = seconds();
  for (int round = 0; round < 6; round++) {
    places_make(&at, (uint64_t)round, SIDE, 0, 1);
    assert_int_equal(places_look(&s, images[round % PICTURES], &at, 0, PLACES, out, 3), SOZAI_OK);
    s.images->memory(s.images->self, &used, &limit);
    if (used > most) most = used;
  }
  print_message(
      "%.0f MiB of pictures, limit %.1f MiB: %.1f MiB used at most, process %ld MiB more; "
      "%.1f us a look-up\n",
      PICTURES * 4.0 / 3 * SIDE * SIDE * 3 * sizeof(float) / MB, (double)limit / MB,
      (double)most / MB, resident_mb() - before, (seconds() - begin) / (6 * PLACES) * 1e6);
  assert_int_equal(limit, 16 * MB);
  assert_true(most > 8 * MB);
  assert_true(most <= 17 * MB); /* a tile more may be on its way */
  for (int i = 0; i < PICTURES; i++) close_image(&s, images[i]);
  s.images->memory(s.images->self, &used, &limit);
  print_message("closed: %.2f MiB used\n", (double)used / MB);
  assert_true(used <= MB);
  services_close(&s);
}

static void defaults(void **state) {
  (void)state;
  uint64_t used = 1, limit = 0;
  services s = services_open(0);
  s.images->memory(s.images->self, &used, &limit);
  assert_int_equal(used, 0);
  assert_int_equal(limit, 1024 * (uint64_t)MB);
  services_close(&s);
  s = services_open(1); /* OpenImageIO takes no less than 10 MiB; said as it is */
  s.images->memory(s.images->self, &used, &limit);
  assert_int_equal(limit, 10 * MB);
  services_close(&s);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(limited), cmocka_unit_test(defaults)};
  return cmocka_run_group_tests(tests, library_setup, library_teardown);
}
