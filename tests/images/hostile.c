/* SPDX-License-Identifier: Apache-2.0
 *
 * What is no picture gives a message that names it, and leaves the process as it was.
 */
#include "library.h"
#include "output.h"
#include "plain.h"
#include "temp.h"

#include <errno.h>
#include <fenv.h>
#include <locale.h>
#include <math.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

static const char *good; /* a picture */

static int setup(void **state) {
  services_setup(state);
  static char path[256];
  snprintf(path, sizeof path, "%s", temp_path("good.png"));
  good = path;
  float data[64 * 48 * 3];
  for (size_t i = 0; i < sizeof data / sizeof data[0]; i++) data[i] = (float)(i % 256) / 255;
  plain_picture picture = {.width = 64, .height = 48, .channels = 3, .format = "uint8"};
  assert_true(plain_write(good, &picture, data));
  return 0;
}

static void still_works(const services *s) {
  sozai_image *image = open_file(s, good, 3);
  float rgb[4];
  look(s, image, 0.5f, 0.5f, 2, rgb);
  assert_true(rgb[0] > 0.2f && rgb[0] < 0.4f);
  close_image(s, image);
}

/* Every signal's handler, in short. */
static uint64_t handlers(void) {
  uint64_t sum = 0;
  for (int number = 1; number < 32; number++) {
    struct sigaction action;
    if (sigaction(number, NULL, &action) == 0)
      sum = sum * 31 + (uint64_t)(uintptr_t)action.sa_handler + (uint64_t)action.sa_flags;
  }
  return sum;
}

/* Open it, and watch. The message, until the next call. */
static const char *watch(const services *s, const char *path, int32_t *result,
                         sozai_image **image) {
  static char message[1024];
  still_works(s);
  unsigned files = open_files();
  uint64_t signals = handlers();
  uint64_t used = 0, used_after = 0;
  s->images->memory(s->images->self, &used, NULL);
  sozai_image_request request = file_request(path, 3);
  output_catch();
  alarm(60); /* rather killed than waiting for ever */
  *result = s->images->open(s->images->self, &request, image, message, sizeof message);
  alarm(0);
  const char *printed = output_caught();
  print_message("%s\n", message);
  if (*printed) fail_msg("it printed: %s", printed);
  s->images->memory(s->images->self, &used_after, NULL);
  if (*result != SOZAI_OK) {
    assert_null(*image);
    assert_int_equal(used_after, used);
    assert_int_equal(open_files(), files);
  }
  assert_true(handlers() == signals);
  assert_int_equal(fegetround(), FE_TONEAREST);
  assert_string_equal(setlocale(LC_ALL, NULL), "C");
  still_works(s);
  return message;
}

static void refused(const services *s, const char *path, const char *named, const char *why) {
  sozai_image *image = NULL;
  int32_t result = 0;
  const char *message = watch(s, path, &result, &image);
  assert_int_equal(result, SOZAI_ERROR_FILE);
  assert_contains(message, named);
  assert_contains(message, why);
}

static void accepted(const services *s, const char *path) {
  sozai_image *image = NULL;
  int32_t result = 0;
  const char *message = watch(s, path, &result, &image);
  assert_int_equal(result, SOZAI_OK);
  assert_string_equal(message, "");
  for (float at = -1; at < 2; at += 0.1f) {
    float rgb[4];
    look(s, image, at, 1 - at, at < 0 ? 0 : at, rgb);
    for (int c = 0; c < 3; c++) assert_true(isfinite(rgb[c]));
  }
  close_image(s, image);
}

static void no_files(void **state) {
  refused(*state, temp_path("nowhere.png"), "nowhere.png", strerror(ENOENT));
  refused(*state, "", "picture", strerror(ENOENT));
  refused(*state, temp_path("."), "/.", strerror(EISDIR));
  refused(*state, "/dev/zero", "/dev/zero", "not a file");
  const char *fifo = temp_path("fifo.png"), *loop = temp_path("loop.png");
  assert_int_equal(mkfifo(fifo, 0600), 0);
  refused(*state, fifo, fifo, "not a file");
  assert_int_equal(symlink(loop, loop), 0);
  refused(*state, loop, loop, strerror(ELOOP));
  char name[6000];
  memset(name, 'x', sizeof name - 1);
  name[sizeof name - 1] = '\0';
  refused(*state, name, "xxx", "xxx");
}

static void not_allowed(void **state) {
  size_t size;
  unsigned char *data = temp_read(good, &size);
  const char *path = temp_path("private.png");
  temp_write(path, data, size);
  free(data);
  assert_int_equal(chmod(path, 0), 0);
  assert_int_equal(chmod(temp_path("."), 0755), 0);
  bool root = geteuid() == 0;
  if (root) assert_int_equal(seteuid(65534), 0);
  refused(*state, path, path, strerror(EACCES));
  if (root) assert_int_equal(seteuid(0), 0);
}

static void no_pictures(void **state) {
  static const char *const names[] = {"text.exr", "text.png", "text.jpg", "text.tif", "text.hdr",
                                      "text.tga", "text.psd", "text.dpx", "text.xyz", "text"};
  const char text[] = "This is a text, and long enough to be taken for the head of something.\n";
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    const char *path = temp_path(names[i]);
    temp_write(path, "", 0);
    refused(*state, path, names[i], "empty");
    temp_write(path, text, sizeof text);
    refused(*state, path, names[i], path);
  }
}

/* All kinds, cut at many places. */
static void cut(void **state) {
  static const char *const kinds[] = {"png", "exr", "tif", "jpg", "hdr", "bmp", "tga"};
  float data[64 * 48 * 3];
  for (size_t i = 0; i < sizeof data / sizeof data[0]; i++) data[i] = (float)(i * 7 % 256) / 255;
  for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
    char name[32], part[32];
    snprintf(name, sizeof name, "whole.%s", kinds[k]);
    plain_picture picture = {.width = 64,
                             .height = 48,
                             .channels = 3,
                             .format = strcmp(kinds[k], "exr") == 0 ? "half" : "uint8"};
    assert_true(plain_write(temp_path(name), &picture, data));
    accepted(*state, temp_path(name));
    size_t size;
    unsigned char *bytes = temp_read(temp_path(name), &size);
    for (int i = 0; i < 20; i++) {
      size_t keep = i < 8 ? (size_t)1 << i : size * (size_t)(i - 7) / 13;
      snprintf(part, sizeof part, "cut.%s", kinds[k]);
      temp_write(temp_path(part), bytes, keep);
      refused(*state, temp_path(part), part, part);
    }
    free(bytes);
  }
}

static void damaged(void **state) {
  size_t size;
  unsigned char *bytes = temp_read(good, &size);
  bytes[size / 2] ^= 1;
  temp_write(temp_path("flipped.png"), bytes, size);
  free(bytes);
  refused(*state, temp_path("flipped.png"), "flipped.png", "check sum");
  /* what libpng would print of: four bytes of the signature right, another wrong */
  for (size_t i = 4; i < 8; i++) {
    bytes = temp_read(good, &size);
    bytes[i] ^= 0xcd;
    temp_write(temp_path("signed.png"), bytes, size);
    free(bytes);
    refused(*state, temp_path("signed.png"), "signed.png", "signature");
  }
}

/* An EXR whose windows are changed to 1e9 x 1e9 pixels. */
static void huge(void **state) {
  float data[16 * 16 * 3] = {0};
  plain_picture picture = {.width = 16, .height = 16, .channels = 3, .format = "half"};
  const char *path = temp_path("huge.exr");
  assert_true(plain_write(path, &picture, data));
  size_t size;
  unsigned char *bytes = temp_read(path, &size);
  const int32_t window[4] = {0, 0, 999999999, 999999999};
  unsigned changed = 0;
  for (size_t i = 0; i + 40 < size; i++)
    if (memcmp(bytes + i, "Window\0box2i", 13) == 0) {
      memcpy(bytes + i + 17, window, sizeof window);
      changed++;
    }
  assert_int_equal(changed, 2);
  temp_write(path, bytes, size);
  free(bytes);
  refused(*state, path, "huge.exr", "huge.exr");
}

/* 8 x 8 pixels. */
static void cmyk(void **state) {
  static const unsigned char jpeg[] = {
      0xff, 0xd8, 0xff, 0xee, 0x00, 0x0e, 0x41, 0x64, 0x6f, 0x62, 0x65, 0x00, 0x64, 0x00, 0x00,
      0x00, 0x00, 0x00, 0xff, 0xdb, 0x00, 0x43, 0x00, 0x50, 0x37, 0x3c, 0x46, 0x3c, 0x32, 0x50,
      0x46, 0x41, 0x46, 0x5a, 0x55, 0x50, 0x5f, 0x78, 0xc8, 0x82, 0x78, 0x6e, 0x6e, 0x78, 0xf5,
      0xaf, 0xb9, 0x91, 0xc8, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff,
      0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff,
      0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xc0, 0x00,
      0x14, 0x08, 0x00, 0x08, 0x00, 0x08, 0x04, 0x43, 0x11, 0x00, 0x4d, 0x11, 0x00, 0x59, 0x11,
      0x00, 0x4b, 0x11, 0x00, 0xff, 0xc4, 0x00, 0x15, 0x00, 0x01, 0x01, 0x00, 0x00, 0x00, 0x00,
      0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x02, 0xff, 0xc4, 0x00,
      0x14, 0x10, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
      0x00, 0x00, 0x00, 0x00, 0xff, 0xda, 0x00, 0x0e, 0x04, 0x43, 0x00, 0x4d, 0x00, 0x59, 0x00,
      0x4b, 0x00, 0x00, 0x3f, 0x00, 0x80, 0x56, 0xff, 0xd9};
  temp_write(temp_path("cmyk.jpg"), jpeg, sizeof jpeg);
  refused(*state, temp_path("cmyk.jpg"), "cmyk.jpg", "CMYK");
}

static void not_flat(void **state) {
  assert_true(plain_write_deep(temp_path("deep.exr")));
  refused(*state, temp_path("deep.exr"), "deep.exr", "deep, and only flat");
}

/* Odd, but pictures. */
static void odd_pictures(void **state) {
  float nan[4 * 4 * 3];
  for (int i = 0; i < 4 * 4 * 3; i++) nan[i] = i % 3 == 0 ? NAN : i % 3 == 1 ? INFINITY : -INFINITY;
  plain_picture picture = {.width = 4, .height = 4, .channels = 3, .format = "float"};
  assert_true(plain_write(temp_path("nan.exr"), &picture, nan));
  accepted(*state, temp_path("nan.exr"));

  static float row[16384 * 3];
  picture = (plain_picture){.width = 16384, .height = 1, .channels = 3, .format = "uint8"};
  assert_true(plain_write(temp_path("row.png"), &picture, row));
  accepted(*state, temp_path("row.png"));
  picture = (plain_picture){.width = 1, .height = 1, .channels = 3, .format = "uint8"};
  assert_true(plain_write(temp_path("one.png"), &picture, row));
  accepted(*state, temp_path("one.png"));
}

static void odd_names(void **state) {
  /* and as messages have them: a line, in UTF-8 */
  static const char *const names[][2] = {
      {"new\nline.png", "new line.png"},
      {"\xff\xfe.png", "??.png"},
      {"why?.png", "why?.png"},
      {"a.<UDIM>.png", "a.<UDIM>.png"},
      {"100%s%n.png", "100%s%n.png"},
      {"it's \"it\".png", "it's \"it\".png"},
      {"no_extension", "no_extension"},
      {"wrong.exr", "wrong.exr"},
      {"a\x7f"
       "b.png",
       "a b.png"},
      {"c1\xc2\x80-\xc2\x85-\xc2\x9f.png", "c1 - - .png"},
      {"\xe2\x80\xa8-\xe2\x80\xa9.png", " - .png"},
      {"\xc2\xa0\xe2\x80\xa7\xe2\x80\xaa.png", "\xc2\xa0\xe2\x80\xa7\xe2\x80\xaa.png"}};
  size_t size;
  unsigned char *bytes = temp_read(good, &size);
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    temp_write(temp_path(names[i][0]), bytes, size);
    accepted(*state, temp_path(names[i][0]));
    temp_write(temp_path(names[i][0]), bytes, size / 2);
    refused(*state, temp_path(names[i][0]), names[i][1], "cut off");
  }
  free(bytes);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(no_files),     cmocka_unit_test(not_allowed),
                                     cmocka_unit_test(no_pictures),  cmocka_unit_test(cut),
                                     cmocka_unit_test(damaged),      cmocka_unit_test(huge),
                                     cmocka_unit_test(cmyk),         cmocka_unit_test(not_flat),
                                     cmocka_unit_test(odd_pictures), cmocka_unit_test(odd_names)};
  return cmocka_run_group_tests(tests, setup, services_teardown);
}
