/* SPDX-License-Identifier: Apache-2.0
 * "[thread-safe]: any thread, at any time between init and deinit" */
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "batch.h"
#include "groups.h"
#include "make.h"

#define THREADS 8u
#define POINTS 600u

typedef struct share {
  subject *s;
  const sozai_texture_info *info;
  const char *preset;
  sozai_texture *t;
  batch *b;            /* with inputs shared and outputs of its own */
  const float *wanted; /* what one thread alone gave */
  uint32_t index;
  atomic_uint *wrong;
  atomic_bool *stop;
  pthread_barrier_t *begin;
} share;

static bool bits_are(const batch *b, const float *wanted, uint32_t count) {
  for (uint32_t c = 0; c < b->info->component_count; c++)
    if (memcmp(&b->memory[batch_place(c, 0)], &wanted[batch_place(c, 0)], count * sizeof(float)) !=
        0)
      return false;
  return true;
}

static void *evaluate_often(void *context) {
  share *h = context;
  pthread_barrier_wait(h->begin);
  for (uint32_t round = 0; round < 60; round++) {
    uint32_t n = 1 + (h->index * 131 + round * 37) % POINTS;
    batch_from(h->b, 0, n);
    int32_t r = h->s->textures->evaluate(h->t, &h->b->abi);
    if (r != SOZAI_OK || !bits_are(h->b, h->wanted, n)) atomic_fetch_add(h->wrong, 1);
  }
  return NULL;
}

/* Textures made and destroyed meanwhile, and everything asked that can be. */
static void *make_often(void *context) {
  share *h = context;
  subject *s = h->s;
  pthread_barrier_wait(h->begin);
  for (uint32_t round = 0; !atomic_load(h->stop) || round < 3; round++) {
    sozai_texture *t = NULL;
    sozai_value v;
    const sozai_texture_info *info = s->textures->find(h->info->id);
    if (info != h->info) atomic_fetch_add(h->wrong, 1);
    if (s->textures->create(NULL, info->id, h->preset, NULL, 0, &t) != SOZAI_OK)
      atomic_fetch_add(h->wrong, 1);
    batch_from(h->b, 0, 50);
    if (t && (s->textures->evaluate(t, &h->b->abi) != SOZAI_OK || !bits_are(h->b, h->wanted, 50)))
      atomic_fetch_add(h->wrong, 1);
    if (t && info->parameter_count &&
        s->textures->value(t, info->parameters[round % info->parameter_count]->id, &v) != SOZAI_OK)
      atomic_fetch_add(h->wrong, 1);
    if (t && s->textures->info_of(t) != info) atomic_fetch_add(h->wrong, 1);
    s->textures->destroy(t);
    t = NULL;
    if (s->textures->create(NULL, info->id, "validate: none", NULL, 0, &t) == SOZAI_OK)
      atomic_fetch_add(h->wrong, 1);
    if (!*s->textures->last_error()) atomic_fetch_add(h->wrong, 1);
  }
  return NULL;
}

static void run_threads(subject *s, const sozai_texture_info *info, const char *preset,
                        sozai_texture *t, uint32_t makers, const char *what) {
  static share shares[THREADS];
  pthread_t threads[THREADS];
  pthread_barrier_t begin;
  atomic_uint wrong = 0;
  atomic_bool stop = false;
  batch *b = batch_new(s, info, preset, POINTS);
  float *wanted = b && batch_run(s, t, b, "alone") ? batch_answers(b) : NULL;
  if (!wanted) return batch_free(b);
  pthread_barrier_init(&begin, NULL, THREADS);
  for (uint32_t i = 0; i < THREADS; i++) {
    batch *own = batch_new(s, info, preset, POINTS);
    if (!own) return;
    memcpy(own->in[0], b->in[0], (size_t)BATCH_INPUTS * BATCH_MOST * sizeof(float));
    shares[i] = (share){.s = s,
                        .info = info,
                        .preset = preset,
                        .t = t,
                        .b = own,
                        .wanted = wanted,
                        .index = i,
                        .wrong = &wrong,
                        .stop = &stop,
                        .begin = &begin};
  }
  doing("%s, %u threads, %s", b->name, THREADS, what);
  for (uint32_t i = 0; i < THREADS; i++)
    if (pthread_create(&threads[i], NULL, i < makers ? make_often : evaluate_often, &shares[i]) !=
        0) {
      failed("no thread");
      _Exit(1);
    }
  for (uint32_t i = THREADS; i-- > 0;) {
    if (i + 1 == makers) atomic_store(&stop, true);
    pthread_join(threads[i], NULL);
  }
  EXPECT(!atomic_load(&wrong), "%s: %u wrong answers on %u threads, %s", b->name,
         atomic_load(&wrong), THREADS, what);
  for (uint32_t i = 0; i < THREADS; i++) batch_free(shares[i].b);
  pthread_barrier_destroy(&begin);
  free(wanted);
  batch_free(b);
}

static void evaluate_test(subject *s, const sozai_texture_info *info, const char *preset,
                          sozai_texture *t) {
  run_threads(s, info, preset, t, 0, "evaluating");
}

static void create_test(subject *s, const sozai_texture_info *info, const char *preset,
                        sozai_texture *t) {
  run_threads(s, info, preset, t, 4, "half of them making and destroying");
}

/* evaluate: "any thread, any number at once ... same bits whatever the batch, thread" */
static void evaluate(subject *s) { start_each_texture(s, 2, evaluate_test); }

/* create, value, info_of, find, last_error: [thread-safe] */
static void create(subject *s) { start_each_texture(s, 1, create_test); }

/* ---- a thread that ends ------------------------------------------------------------- */

static void *make_here(void *context) {
  share *h = context;
  if (h->s->textures->create(NULL, h->info->id, h->preset, NULL, 0, &h->t) != SOZAI_OK) h->t = NULL;
  return NULL;
}

static void *drop_here(void *context) {
  share *h = context;
  h->s->textures->destroy(h->t);
  return NULL;
}

static void outlives(subject *s, const sozai_texture_info *info, const char *preset,
                     sozai_texture *t) {
  share h = {.s = s, .info = info, .preset = preset};
  pthread_t thread;
  doing("create of %s on a thread that ends", info->id);
  if (pthread_create(&thread, NULL, make_here, &h) != 0) return;
  pthread_join(thread, NULL);
  if (!EXPECT(h.t, "%s: create on another thread failed", info->id)) return;
  same_bits(s, info, t, h.t, "of a texture made on a thread that has ended");
  doing("destroy of %s on another thread", info->id);
  if (pthread_create(&thread, NULL, drop_here, &h) == 0) pthread_join(thread, NULL);
}

/* "[exclusive]: not while another call on the same object is under way", on whatever thread. */
static void elsewhere(subject *s) { start_each_texture(s, 1, outlives); }

/* ---- descriptions ---------------------------------------------------------------------- */

static void *describe_often(void *context) {
  share *h = context;
  const subject *s = h->s;
  pthread_barrier_wait(h->begin);
  for (uint32_t round = 0; round < 300; round++)
    for (uint32_t i = 0; i < s->textures->count(); i++) {
      const sozai_texture_info *info = s->textures->info(i);
      if (!info || s->textures->find(info->id) != info) atomic_fetch_add(h->wrong, 1);
      if (s->entry->get_factory(SOZAI_TEXTURES_1) != s->textures) atomic_fetch_add(h->wrong, 1);
    }
  return NULL;
}

/* The first calls of all, by threads at once: what is made when it is first asked for. */
static void describe(subject *s) {
  static share shares[THREADS];
  pthread_t threads[THREADS];
  pthread_barrier_t begin;
  atomic_uint wrong = 0;
  if (!subject_start(s)) return;
  if (!s->textures) return skipped("it has no texture");
  pthread_barrier_init(&begin, NULL, THREADS);
  doing("count, info, find and get_factory on %u threads", THREADS);
  for (uint32_t i = 0; i < THREADS; i++) {
    shares[i] = (share){.s = s, .wrong = &wrong, .begin = &begin};
    if (pthread_create(&threads[i], NULL, describe_often, &shares[i]) != 0) {
      failed("no thread");
      _Exit(1);
    }
  }
  for (uint32_t i = 0; i < THREADS; i++) pthread_join(threads[i], NULL);
  EXPECT(!atomic_load(&wrong), "info, find or get_factory gave another answer %u times",
         atomic_load(&wrong));
  pthread_barrier_destroy(&begin);
}

CHECKS(threads, //
       {"threads.evaluate", "evaluate.answers", "8 threads on one texture give the bits of one",
        evaluate},
       {"threads.create", "evaluate.answers", "so they do while others make and destroy", create},
       {"threads.elsewhere", "evaluate.answers",
        "a texture outlives its thread, and is destroyed on another", elsewhere},
       {"threads.describe", "describe.listed", "descriptions are the same from 8 threads at once",
        describe});
