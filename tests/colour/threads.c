/* SPDX-License-Identifier: Apache-2.0
 *
 * One service, many threads: the answers of one.
 */
#include "library.h"

#include <pthread.h>
#include <string.h>

enum { THREADS = 8, ROUNDS = 400, COLOURS = 32, JOBS = 20 };

typedef struct batch {
  float rgb[COLOURS][3];
} batch;

static const char *const spaces[] = {
    "sRGB",    "ACEScg", "ACES2065-1",   "Linear P3-D65",  "Linear Rec.2020", "CIE XYZ D65",
    "ACEScct", "Raw",    "srgb_texture", "sRGB - Display", "scene_linear"};

/* Job 0 to 19 on fixed colours: SOZAI_OK and its answer. */
static int32_t job(const service *both, unsigned which, batch *b) {
  const sozai_colour_1 *s = both->colour;
  const sozai_display_1 *d = both->display;
  for (int i = 0; i < COLOURS * 3; i++) b->rgb[i / 3][i % 3] = (float)(i * 37 % 97) / 48;
  if (which == 0) return d->to_display(d->self, NULL, NULL, NULL, b->rgb[0], COLOURS, NULL, 0);
  if (which == 1)
    return d->to_display(d->self, "sRGB", "Standard", NULL, b->rgb[0], COLOURS, NULL, 0);
  if (which < 11) return s->to_working(s->self, spaces[which - 2], b->rgb[0], COLOURS, NULL, 0);
  return s->from_working(s->self, spaces[which - 11], b->rgb[0], COLOURS, NULL, 0);
}

typedef struct worker {
  pthread_t thread;
  const service *service;
  const batch *want;
  unsigned number, wrong;
} worker;

/* cmocka's assertions belong to its own thread: the workers only count. */
static void *hammer(void *argument) {
  worker *w = argument;
  const sozai_colour_1 *s = w->service->colour;
  for (unsigned i = 0; i < ROUNDS; i++) {
    unsigned which = (w->number * 7 + i) % JOBS;
    batch b;
    if (job(w->service, which, &b) != SOZAI_OK) w->wrong++;
    if (memcmp(&b, &w->want[which], sizeof b) != 0) w->wrong++;

    char message[128] = "";
    float rgb[3] = {0};
    if (s->to_working(s->self, "Utopia RGB", rgb, 1, message, sizeof message) !=
            SOZAI_ERROR_COLOUR ||
        !strstr(message, "Utopia RGB"))
      w->wrong++;
    if (s->has_space(s->self, "sRGB") != 1) w->wrong++;

    const sozai_display_1 *d = w->service->display;
    const char *view = NULL;
    float xy[8];
    if (d->item(d->self, SOZAI_LIST_VIEWS, NULL, i % 3, &view, NULL) != SOZAI_OK) w->wrong++;
    if (d->to_display(d->self, NULL, view, "", rgb, 1, NULL, 0) != SOZAI_OK) w->wrong++;
    if (d->chromaticities(d->self, "ACEScg", xy, NULL, 0) != SOZAI_OK ||
        !(xy[0] > 0.7129f && xy[0] < 0.7131f))
      w->wrong++;
  }
  return NULL;
}

static void run(void *(*body)(void *), const service *opened, const batch *want) {
  worker workers[THREADS];
  for (unsigned i = 0; i < THREADS; i++) {
    workers[i] = (worker){.service = opened, .want = want, .number = i};
    assert_int_equal(pthread_create(&workers[i].thread, NULL, body, &workers[i]), 0);
  }
  unsigned wrong = 0;
  for (unsigned i = 0; i < THREADS; i++) {
    pthread_join(workers[i].thread, NULL);
    wrong += workers[i].wrong;
  }
  assert_int_equal(wrong, 0);
}

static void one_service(void **state) {
  (void)state;
  batch want[JOBS];
  service s = service_open(NULL);
  for (unsigned i = 0; i < JOBS; i++) assert_int_equal(job(&s, i, &want[i]), SOZAI_OK);
  service_close(s);

  s = service_open(NULL); /* afresh, so that the threads make the processors */
  run(hammer, &s, want);
  service_close(s);
}

static void *open_and_close(void *argument) {
  worker *w = argument;
  for (unsigned i = 0; i < 10; i++) {
    sozai_services *services = NULL;
    const sozai_colour_1 *s = NULL;
    float rgb[3] = {1, 1, 1};
    if (library_open(NULL, &services, NULL, 0) == SOZAI_OK)
      s = library_factory()->get(services, SOZAI_COLOUR_1);
    if (!s || s->to_working(s->self, "ACEScg", rgb, 1, NULL, 0) != SOZAI_OK) w->wrong++;
    library_factory()->close(services);
    if (library_open("/nowhere", &services, NULL, 0) != SOZAI_ERROR_FILE) w->wrong++;
  }
  return NULL;
}

static void many_services(void **state) {
  (void)state;
  run(open_and_close, NULL, NULL);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(one_service),
                                     cmocka_unit_test(many_services)};
  return cmocka_run_group_tests(tests, library_setup, library_teardown);
}
