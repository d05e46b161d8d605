/* SPDX-License-Identifier: Apache-2.0
 *
 * Loaded, used and unloaded again and again: nothing is left behind, also by a thread
 * that has looked pictures up and ends only after the library has gone.
 */
#include "library.h"
#include "output.h"
#include "plain.h"
#include "temp.h"
#include "../resident.h"

#include <pthread.h>
#include <semaphore.h>

static char path[256];

typedef struct helper {
  pthread_t thread;
  sem_t go, done;
  const services *s;
  sozai_image *image;
  float found[4];
} helper;

static void *help(void *argument) {
  helper *h = argument;
  sem_wait(&h->go);
  look(h->s, h->image, 0.5f, 0.5f, 1, h->found);
  sem_post(&h->done);
  sem_wait(&h->go); /* until the library has gone */
  return NULL;
}

static void once(void) {
  helper h = {0};
  sem_init(&h.go, 0, 0);
  sem_init(&h.done, 0, 0);
  assert_int_equal(pthread_create(&h.thread, NULL, help, &h), 0);
  library_load();
  services s = services_open(0);
  h.s = &s;
  h.image = open_file(&s, path, 3);
  float found[4];
  look(&s, h.image, 0.5f, 0.5f, 1, found);
  sem_post(&h.go);
  sem_wait(&h.done);
  assert_memory_equal(h.found, found, sizeof(float[3]));
  close_image(&s, h.image);
  services_close(&s);
  library_unload();
  sem_post(&h.go);
  assert_int_equal(pthread_join(h.thread, NULL), 0);
  sem_destroy(&h.go);
  sem_destroy(&h.done);
}

static void rounds(void **state) {
  (void)state;
  int count = getenv("SOZAI_RELOADS") ? atoi(getenv("SOZAI_RELOADS")) : 200;
  for (int i = 0; i < 20; i++) once();
  long before = resident_kib();
  unsigned files = open_files();
  for (int i = 0; i < count; i++) once();
  long grown = resident_kib() - before;
  print_message("%d rounds: %ld KiB more, %.2f a round\n", count, grown, (double)grown / count);
  assert_int_equal(open_files(), files);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  assert_true(grown < 2048);
#endif
}

static int setup(void **state) {
  (void)state;
  unsetenv("OCIO");
  temp_make();
  snprintf(path, sizeof path, "%s", temp_path("some.exr"));
  float data[128 * 128 * 3];
  for (int i = 0; i < 128 * 128 * 3; i++) data[i] = (float)(i % 97);
  plain_picture picture = {.width = 128, .height = 128, .channels = 3, .format = "half"};
  return plain_write(path, &picture, data) ? 0 : -1;
}

static int teardown(void **state) {
  (void)state;
  temp_remove();
  return 0;
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(rounds)};
  return cmocka_run_group_tests(tests, setup, teardown);
}
