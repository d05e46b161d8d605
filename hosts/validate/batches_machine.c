/* SPDX-License-Identifier: Apache-2.0
 * evaluate: on every instruction set, where denormals are flushed, on a small stack. */
#include "batches.h"

#include <math.h>
#include <pthread.h>
#include <stdlib.h>

#include "control.h"
#include "memory.h"

static const char *const sets[] = {"avx512", "avx2", "sse2", "neon", "scalar"};

static void sets_of(subject *s, const sozai_texture_info *info, const char *preset,
                    sozai_texture *t) {
  for (uint32_t i = 0; i < COUNT_OF(sets) && !enough(); i++) {
    sozai_texture *other = NULL;
    setenv("SOZAI_CPU", sets[i], 1);
    doing("create of %s for %s", texture_name(info, preset), sets[i]);
    int32_t r = s->textures->create(NULL, info->id, preset, NULL, 0, &other);
    unsetenv("SOZAI_CPU");
    EXPECT(r == SOZAI_OK || r == SOZAI_ERROR_UNSUPPORTED, "%s: create for %s gave %s",
           texture_name(info, preset), sets[i], result_name(r));
    if (r != SOZAI_OK) continue;
    batch *b = batch_new(s, info, preset, 400);
    float *was = b ? in_one(s, t, b, 400) : NULL;
    if (b) batch_mark(b);
    if (was && batch_run(s, other, b, sets[i])) batch_all_same(b, was, 0, 400, sets[i]);
    free(was);
    batch_free(b);
    s->textures->destroy(other);
  }
}

/* "same bits whatever the batch, thread or machine"; "UNSUPPORTED for an instruction set that
 * SOZAI_CPU asks for and this machine lacks" */
void batches_instruction_sets(subject *s) { start_each_texture(s, 2, sets_of); }

static void flushed_of(subject *s, const sozai_texture_info *info, const char *preset,
                       sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 600);
  for (uint32_t i = 0; b && i < 600; i += 7) b->in[chance_below(s, BATCH_INPUTS)][i] = 1e-40f;
  float *was = b ? in_one(s, t, b, 600) : NULL;
  if (was) {
    batch_mark(b);
    uint64_t kept = control_flush();
    doing("evaluate of %s, denormals flushed", b->name);
    int32_t r = s->textures->evaluate(t, &b->abi);
    control_restore(kept);
    EXPECT(r == SOZAI_OK, "%s: evaluate gave %s", b->name, result_name(r));
    for (uint32_t c = 0; c < info->component_count; c++)
      for (uint32_t k = 0; k < 600; k++) {
        float *x = &was[batch_place(c, k)], now = b->memory[batch_place(c, k)];
        if (fabsf(*x) < 1.2e-38f) *x = now == 0 ? now : 0; /* of either sign */
      }
    batch_all_same(b, was, 0, 600, "and where denormals are flushed");
  }
  free(was);
  batch_free(b);
}

/* "Where the calling thread flushes denormals to zero, numbers below 1.2e-38 are zero." */
void batches_flushed(subject *s) {
  if (!control_flushes()) {
    skipped("this machine has no flushing of denormals that is known here");
    return;
  }
  start_each_texture(s, 4, flushed_of);
}

/* ---- stack -------------------------------------------------------------------------------- */

typedef struct small {
  subject *s;
  sozai_texture *t;
  batch *b;
  int32_t result;
} small;

static void *on_small_stack(void *context) {
  small *c = context;
  c->result = c->s->textures->evaluate(c->t, &c->b->abi);
  return NULL;
}

static void stack_of(subject *s, const sozai_texture_info *info, const char *preset,
                     sozai_texture *t) {
  small c = {.s = s, .t = t, .b = batch_new(s, info, preset, 1000)};
  pthread_attr_t attributes;
  pthread_t thread;
  if (!c.b) return;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, 512 * 1024);
  doing("evaluate of %s on a thread of 512 KiB stack", c.b->name);
  if (pthread_create(&thread, &attributes, on_small_stack, &c) == 0) {
    pthread_join(thread, NULL);
    EXPECT(c.result == SOZAI_OK, "%s: evaluate gave %s", c.b->name, result_name(c.result));
  }
  pthread_attr_destroy(&attributes);
  batch_free(c.b);
}

/* "Any thread": the smallest stacks that are usual are of 512 KiB. */
void batches_stack(subject *s) {
  if (memory_sanitized()) {
    skipped("a sanitizer's frames are larger");
    return;
  }
  start_each_texture(s, 2, stack_of);
}
