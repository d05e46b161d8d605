/* SPDX-License-Identifier: Apache-2.0
 *
 * A caller's ceiling refuses a picture before a row of it is read or room taken for it;
 * a caller's progress sees it being read, and stops it. Neither leaves anything.
 */
#define _GNU_SOURCE
#include "library.h"
#include "output.h"
#include "plain.h"
#include "temp.h"

#include <dirent.h>
#include <limits.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

enum { WIDTH = 1024, HEIGHT = 1280, PIXELS = WIDTH * HEIGHT };

static char exr[256], png[256];

static int setup(void **state) {
  (void)state;
  library_setup(state);
  assert_int_equal(setenv("TMPDIR", temp_path("spool"), 1), 0);
  assert_int_equal(mkdir(getenv("TMPDIR"), 0700), 0);
  float *data = calloc((size_t)PIXELS * 3, sizeof *data);
  assert_non_null(data);
  for (size_t i = 0; i < (size_t)PIXELS * 3; i++) data[i] = (float)(i % 251) / 251;
  plain_picture picture = {.width = WIDTH, .height = HEIGHT, .channels = 3, .format = "half"};
  snprintf(exr, sizeof exr, "%s", temp_path("some.exr"));
  assert_true(plain_write(exr, &picture, data));
  picture.format = "uint8";
  snprintf(png, sizeof png, "%s", temp_path("some.png"));
  assert_true(plain_write(png, &picture, data));
  free(data);
  return 0;
}

/* Bytes of the service's file for pictures; -1: there is none. */
static long long spooled(void) {
  long long bytes = -1;
  DIR *folder = opendir("/proc/self/fd");
  assert_non_null(folder);
  for (struct dirent *e; (e = readdir(folder));) {
    char to[PATH_MAX];
    struct stat status;
    ssize_t length = readlinkat(dirfd(folder), e->d_name, to, sizeof to - 1);
    if (length < 0 || fstatat(dirfd(folder), e->d_name, &status, 0) != 0) continue;
    to[length] = '\0';
    if (strncmp(to, getenv("TMPDIR"), strlen(getenv("TMPDIR"))) == 0)
      bytes = (long long)status.st_size;
  }
  closedir(folder);
  return bytes;
}

/* A caller's progress. */
typedef struct {
  unsigned calls, stop_at; /* 0: never */
  float last;
  bool wrong;
  pthread_t thread;
  const services *s; /* not NULL: what to open meanwhile, and to close */
  const char *path;
  sozai_image *opened;
} caller;

static int32_t watch(void *user, float fraction) {
  caller *c = user;
  c->calls++;
  if (!(fraction >= c->last && fraction <= 1)) c->wrong = true;
  if (!pthread_equal(c->thread, pthread_self())) c->wrong = true;
  c->last = fraction;
  if (c->s && !c->opened) c->opened = open_file(c->s, c->path, 3);
  return c->calls == c->stop_at ? 7 : 0;
}

static sozai_image_request watched(const char *path, caller *c) {
  c->thread = pthread_self();
  sozai_image_request request = file_request(path, 3);
  request.user = c;
  request.progress = watch;
  return request;
}

/* Refused, without a row read or a byte of room taken; the message has both parts. */
static void above(const services *s, sozai_image_request request, const char *named,
                  const char *why) {
  char message[512] = "";
  sozai_image *image = (sozai_image *)(uintptr_t)1;
  caller c = {.thread = pthread_self()};
  request.user = &c;
  request.progress = watch;
  unsigned files = open_files();
  long long before = spooled();
  int32_t r = s->images->open(s->images->self, &request, &image, message, sizeof message);
  print_message("%s\n", message);
  assert_int_equal(r, SOZAI_ERROR_LIMIT);
  assert_null(image);
  assert_contains(message, named);
  assert_contains(message, why);
  assert_int_equal(c.calls, 0);
  assert_int_equal(open_files(), files);
  assert_true(spooled() == before);
}

static void ceiling(void **state) {
  (void)state;
  services s = services_open(0);
  close_image(&s, NULL);
  const char *const files[] = {exr, png};
  /* the libraries are loaded, and with them whatever they keep open */
  sozai_image_request request = file_request(exr, 3);
  request.most_pixels = 1;
  assert_int_equal(s.images->open(s.images->self, &request, &(sozai_image *){NULL}, NULL, 0),
                   SOZAI_ERROR_LIMIT);
  for (int i = 0; i < 2; i++) {
    request = file_request(files[i], 3);
    request.most_pixels = PIXELS - 1;
    above(&s, request, files[i], ": 1310720 is above the ceiling image_pixels, 1310719");
  }
  assert_true(spooled() == -1); /* not even the file is there */

  static const float grey[12 * 3];
  const sozai_buffer buffer = {
      .size = sizeof buffer, .kind = SOZAI_BUFFER_IMAGE, .dims = {3, 4, 3}, .data = grey};
  request = (sozai_image_request){.size = sizeof request, .channels = 3, .buffer = &buffer};
  request.most_pixels = 11;
  above(&s, request, "the buffer", ": 12 is above the ceiling image_pixels, 11");
  request.most_pixels = 12;
  close_image(&s, open_image(&s, &request));

  /* at the ceiling; and one that is open already is as large as it was */
  request = file_request(exr, 3);
  request.most_pixels = PIXELS;
  sozai_image *image = open_image(&s, &request);
  print_message("%.1f bytes a pixel on disk\n", (double)spooled() / PIXELS);
  assert_in_range(spooled(), 16 * PIXELS, 17 * PIXELS);
  request.most_pixels = PIXELS - 1;
  above(&s, request, exr, "1310719");
  close_image(&s, image);
  assert_true(spooled() == 0);
  services_close(&s);
}

/* What costs time is the window that has pixels, however little of it is seen. */
static void windows(void **state) {
  (void)state;
  services s = services_open(0);
  static const float data[64 * 64 * 3];
  const char *path = temp_path("windows.exr");
  plain_picture picture = {.width = 64,
                           .height = 64,
                           .channels = 3,
                           .format = "half",
                           .windowed = true,
                           .full_width = 4,
                           .full_height = 4};
  assert_true(plain_write(path, &picture, data));
  sozai_image_request request = file_request(path, 3);
  request.most_pixels = 4095;
  above(&s, request, path, ": 4096 is");
  request.most_pixels = 4096;
  close_image(&s, open_image(&s, &request));
  picture.width = picture.height = 2;
  picture.full_width = picture.full_height = 80;
  assert_true(plain_write(path, &picture, data));
  above(&s, request, path, ": 6400 is");
  services_close(&s);
}

/* Whose request ends earlier: what is behind it is not looked at. */
static void an_older_caller(void **state) {
  (void)state;
  services s = services_open(0);
  caller c = {0};
  sozai_image_request request = watched(exr, &c);
  request.size = offsetof(sozai_image_request, most_pixels);
  request.most_pixels = 1;
  close_image(&s, open_image(&s, &request));
  assert_int_equal(c.calls, 0);
  services_close(&s);
}

static void stop(const services *s, const char *path, unsigned at) {
  char message[512] = "";
  sozai_image *image = (sozai_image *)(uintptr_t)1;
  caller c = {.stop_at = at};
  sozai_image_request request = watched(path, &c);
  int32_t r = s->images->open(s->images->self, &request, &image, message, sizeof message);
  assert_int_equal(r, SOZAI_ERROR_CANCELLED);
  assert_null(image);
  assert_contains(message, "cancelled");
  assert_int_equal(c.calls, at); /* not asked again */
  assert_true(spooled() == 0);
}

static void progress(void **state) {
  (void)state;
  services s = services_open(0);
  const char *const files[] = {exr, png};
  for (int i = 0; i < 2; i++) {
    caller c = {0};
    sozai_image_request request = watched(files[i], &c);
    close_image(&s, open_image(&s, &request));
    print_message("%s: %u calls\n", files[i], c.calls);
    assert_in_range(c.calls, 4, 100);
    assert_true(c.last == 1);
    assert_false(c.wrong);
    unsigned open = open_files();
    for (unsigned at = 1; at <= c.calls; at++) stop(&s, files[i], at);
    assert_int_equal(open_files(), open);
    close_image(&s, open_file(&s, files[i], 3)); /* read anew */
  }
  services_close(&s);
}

/* Progress that opens the very picture which is being read: no waiting for itself. */
static void from_within(void **state) {
  (void)state;
  services s = services_open(0);
  caller c = {.s = &s, .path = exr};
  sozai_image_request request = watched(exr, &c);
  alarm(60); /* rather killed than waiting for ever */
  sozai_image *image = open_image(&s, &request);
  alarm(0);
  float outer[4], inner[4];
  look(&s, image, 0.3f, 0.6f, 0.01f, outer);
  look(&s, c.opened, 0.3f, 0.6f, 0.01f, inner);
  assert_memory_equal(outer, inner, sizeof(float[3]));
  close_image(&s, image);
  close_image(&s, c.opened);
  services_close(&s);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(ceiling), cmocka_unit_test(windows),
                                     cmocka_unit_test(an_older_caller), cmocka_unit_test(progress),
                                     cmocka_unit_test(from_within)};
  return cmocka_run_group_tests(tests, setup, library_teardown);
}
