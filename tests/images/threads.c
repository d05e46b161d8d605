/* SPDX-License-Identifier: Apache-2.0
 *
 * Many threads get what one gets, to the bit.
 */
#include "library.h"
#include "places.h"
#include "plain.h"
#include "temp.h"

#include <pthread.h>

enum { THREADS = 16, PICTURES = 4, SIDE = 1024, BATCH = 250, ROUNDS = 200 };

static places at;
static float want[PICTURES][3][PLACES];
static char names[PICTURES][256];

typedef struct worker {
  pthread_t thread;
  const services *s;
  sozai_image *const *images;
  unsigned number, wrong;
} worker;

/* cmocka's assertions belong to its own thread: the workers only count. */
static void *hammer(void *argument) {
  worker *w = argument;
  float(*out)[PLACES] = malloc(sizeof(float[3][PLACES]));
  for (unsigned i = 0; i < ROUNDS; i++) {
    uint32_t which = (w->number + i * 7) % PICTURES, count = 1 + (w->number * 31 + i * 17) % BATCH;
    uint32_t first = (w->number * 977 + i * 131) % (PLACES - BATCH);
    if (places_look(w->s, w->images[which], &at, first, count, out, 3) != SOZAI_OK) w->wrong++;
    for (int c = 0; c < 3; c++)
      if (memcmp(out[c] + first, want[which][c] + first, count * sizeof(float)) != 0) w->wrong++;
    uint64_t used, limit;
    w->s->images->memory(w->s->images->self, &used, &limit);
    if (limit != 10u << 20) w->wrong++;
  }
  free(out);
  return NULL;
}

static void *open_and_close(void *argument) {
  worker *w = argument;
  float(*out)[PLACES] = malloc(sizeof(float[3][PLACES]));
  for (unsigned i = 0; i < 6; i++) {
    uint32_t which = (w->number + i) % PICTURES;
    sozai_image_request request = file_request(names[which], 3);
    sozai_image *image = NULL;
    if (w->s->images->open(w->s->images->self, &request, &image, NULL, 0) != SOZAI_OK) {
      w->wrong++;
      continue;
    }
    if (places_look(w->s, image, &at, 0, BATCH, out, 3) != SOZAI_OK) w->wrong++;
    for (int c = 0; c < 3; c++)
      if (memcmp(out[c], want[which][c], BATCH * sizeof(float)) != 0) w->wrong++;
    w->s->images->close(w->s->images->self, image);
    request.path = "/nowhere.png";
    if (w->s->images->open(w->s->images->self, &request, &image, NULL, 0) != SOZAI_ERROR_FILE)
      w->wrong++;
  }
  free(out);
  return NULL;
}

static void run(void *(*body)(void *), const services *s, sozai_image *const *images) {
  worker workers[THREADS];
  for (unsigned i = 0; i < THREADS; i++) {
    workers[i] = (worker){.s = s, .images = images, .number = i};
    assert_int_equal(pthread_create(&workers[i].thread, NULL, body, &workers[i]), 0);
  }
  unsigned wrong = 0;
  for (unsigned i = 0; i < THREADS; i++) {
    pthread_join(workers[i].thread, NULL);
    wrong += workers[i].wrong;
  }
  print_message("%u threads: %u wrong\n", THREADS, wrong);
  assert_int_equal(wrong, 0);
}

static int setup(void **state) {
  library_setup(state);
  places_make(&at, 11, SIDE, -0.5f, 1.5f);
  services s = services_open(0);
  for (unsigned i = 0; i < PICTURES; i++) {
    float *data = random_pixels((size_t)SIDE * SIDE * 3, i);
    plain_picture picture = {
        .width = SIDE, .height = SIDE, .channels = 3, .format = i % 2 ? "uint8" : "half"};
    char name[32];
    snprintf(name, sizeof name, "picture%u.%s", i, i % 2 ? "png" : "exr");
    snprintf(names[i], sizeof names[i], "%s", temp_path(name));
    assert_true(plain_write(names[i], &picture, data));
    free(data);
    sozai_image *image = open_file(&s, names[i], 3);
    assert_int_equal(places_look(&s, image, &at, 0, PLACES, want[i], 3), SOZAI_OK);
    close_image(&s, image);
  }
  services_close(&s);
  return 0;
}

/* 64 MiB of pictures in a cache of 10. */
static void many_pictures(void **state) {
  (void)state;
  services s = services_open(10 << 20);
  sozai_image *images[PICTURES];
  for (unsigned i = 0; i < PICTURES; i++) images[i] = open_file(&s, names[i], 3);
  run(hammer, &s, images);
  uint64_t used = 0;
  s.images->memory(s.images->self, &used, NULL);
  print_message("%.1f MiB used\n", (double)used / (1 << 20));
  assert_true(used < 13 << 20);
  for (unsigned i = 0; i < PICTURES; i++) close_image(&s, images[i]);
  services_close(&s);
}

static void opening(void **state) {
  (void)state;
  services s = services_open(0);
  run(open_and_close, &s, NULL);
  services_close(&s);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(many_pictures), cmocka_unit_test(opening)};
  return cmocka_run_group_tests(tests, setup, library_teardown);
}
