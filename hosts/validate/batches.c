/* SPDX-License-Identifier: Apache-2.0
 * evaluate: the same bits whatever the batch. */
#include <fenv.h>
#include <math.h>
#include <pthread.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "batch.h"
#include "control.h"
#include "groups.h"

#define EACH_TEXTURE(s, presets, test)                                                             \
  do {                                                                                             \
    if (!subject_start(s)) break;                                                                  \
    each_texture(s, presets, test);                                                                \
  } while (0)

#define MOST 4097u

/* Answers of the first n points in one call, to compare with; NULL: failed. */
static float *in_one(subject *s, sozai_texture *t, batch *b, uint32_t n) {
  batch_from(b, 0, n);
  batch_mark(b);
  return batch_run(s, t, b, "in one batch") ? batch_answers(b) : NULL;
}

/* "Any size": 1 to 130 one by one, and others up to 4097. */
static void sizes_of(subject *s, const sozai_texture_info *info, const char *preset,
                     sozai_texture *t) {
  batch *b = batch_new(s, info, preset, MOST);
  float *was = b ? in_one(s, t, b, MOST) : NULL;
  for (uint32_t k = 1; was && k <= 170 && !enough(); k++) {
    uint32_t n = k <= 130 ? k : k < 168 ? 131 + chance_below(s, MOST - 132) : MOST + k - 170;
    uint32_t first = chance_below(s, MOST - n + 1);
    batch_from(b, first, n);
    batch_mark(b);
    if (!batch_run(s, t, b, "of another size")) break;
    char what[60];
    snprintf(what, sizeof what, "and in a batch of %u", n);
    batch_all_same(b, was, first, n, what);
  }
  free(was);
  batch_free(b);
}

static void sizes(subject *s) { EACH_TEXTURE(s, 1, sizes_of); }

/* In another order, beside other points. */
static void order_of(subject *s, const sozai_texture_info *info, const char *preset,
                     sozai_texture *t) {
  enum { N = 900 };
  static uint32_t place[N];
  batch *b = batch_new(s, info, preset, N);
  batch *other = batch_new(s, info, preset, N);
  float *was = b && other ? in_one(s, t, b, N) : NULL;
  for (uint32_t i = 0; i < N; i++) place[i] = i;
  for (uint32_t i = N - 1; was && i > 0; i--) {
    uint32_t k = chance_below(s, i + 1), kept = place[i];
    place[i] = place[k];
    place[k] = kept;
  }
  for (uint32_t k = 0; was && k < BATCH_INPUTS; k++)
    for (uint32_t i = 0; i < N; i++) other->in[k][i] = b->in[k][place[i]];
  if (was && batch_run(s, t, other, "in another order"))
    for (uint32_t c = 0; c < info->component_count && !enough(); c++) {
      asked();
      for (uint32_t i = 0; i < N; i++) {
        float x = was[batch_place(c, place[i])], y = other->memory[batch_place(c, i)];
        if (memcmp(&x, &y, sizeof x) == 0) continue;
        failed("%s: %s of a point is %.9g at %u and %.9g at %u of the batch", b->name,
               component_name(info, c), (double)x, place[i], (double)y, i);
        break;
      }
    }
  free(was);
  batch_free(b);
  batch_free(other);
}

static void order(subject *s) { EACH_TEXTURE(s, 2, order_of); }

/* One point in every place. */
static void places_of(subject *s, const sozai_texture_info *info, const char *preset,
                      sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 1);
  for (uint32_t round = 0; b && round < 4 && !enough(); round++) {
    for (uint32_t k = 0; k < BATCH_INPUTS; k++) {
      float x = b->in[k][1 + chance_below(s, 1000)];
      for (uint32_t i = 0; i < 333; i++) b->in[k][i] = x;
    }
    batch_from(b, 0, 333);
    batch_mark(b);
    if (!batch_run(s, t, b, "one point in every place")) break;
    for (uint32_t c = 0; c < info->component_count && !enough(); c++) {
      asked();
      for (uint32_t i = 1; i < 333; i++) {
        const float *x = &b->memory[batch_place(c, 0)];
        if (memcmp(&x[0], &x[i], sizeof *x) == 0) continue;
        failed("%s: %s of the same point is %.9g at 0 and %.9g at %u", b->name,
               component_name(info, c), (double)x[0], (double)x[i], i);
        break;
      }
    }
  }
  batch_free(b);
}

static void places(subject *s) { EACH_TEXTURE(s, 2, places_of); }

static void repeats_of(subject *s, const sozai_texture_info *info, const char *preset,
                       sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 100);
  float *was = b ? in_one(s, t, b, 100) : NULL;
  for (uint32_t round = 0; was && round < 100 && !enough(); round++) {
    batch_mark(b);
    if (!batch_run(s, t, b, "repeated") || !batch_all_same(b, was, 0, 100, "and repeated")) break;
  }
  free(was);
  batch_free(b);
}

static void repeats(subject *s) { EACH_TEXTURE(s, 2, repeats_of); }

/* "Arrays need the alignment of a float, no more." */
static void aligned_of(subject *s, const sozai_texture_info *info, const char *preset,
                       sozai_texture *t) {
  enum { N = 70 };
  batch *b = batch_new(s, info, preset, N + 16);
  float *was = b ? in_one(s, t, b, N + 16) : NULL;
  float *room = malloc((BATCH_INPUTS + 1) * (size_t)(N + 32) * sizeof *room);
  for (uint32_t k = 0; was && room && k < 16 && !enough(); k++) {
    batch_from(b, k, N); /* outputs k floats further on */
    const float *in[BATCH_INPUTS];
    for (uint32_t j = 0; j < BATCH_INPUTS; j++) {
      uint32_t by = chance_below(s, 16); /* and each input by another number */
      float *to = room + (size_t)j * (N + 32) + by;
      memcpy(to, b->in[j] + k, N * sizeof *to);
      in[j] = to;
    }
    for (uint32_t c = 0; c < 3; c++) {
      b->abi.point[c] = in[c];
      b->abi.normal[c] = in[3 + c];
      b->abi.light[c] = in[6 + c];
      b->abi.light_colour[c] = in[9 + c];
      b->abi.view[c] = in[12 + c];
    }
    b->abi.footprint = in[15];
    batch_mark(b);
    if (batch_run(s, t, b, "arrays aligned as floats are"))
      batch_all_same(b, was, k, N, "and of arrays aligned otherwise");
  }
  free(room);
  free(was);
  batch_free(b);
}

static void alignment(subject *s) { EACH_TEXTURE(s, 1, aligned_of); }

/* "Outputs may not overlap inputs or one another": inputs may be one another. */
static void shared_of(subject *s, const sozai_texture_info *info, const char *preset,
                      sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 90);
  if (!b) return;
  for (uint32_t k = 3; k < BATCH_INPUTS; k++) memcpy(b->in[k], b->in[k % 3], 90 * sizeof(float));
  float *was = in_one(s, t, b, 90);
  for (uint32_t c = 0; c < 3; c++)
    b->abi.normal[c] = b->abi.light[c] = b->abi.light_colour[c] = b->abi.view[c] = b->abi.point[c];
  b->abi.footprint = b->abi.point[15 % 3];
  batch_mark(b);
  if (was && batch_run(s, t, b, "one array for all inputs"))
    batch_all_same(b, was, 0, 90, "and with one array for all inputs");
  free(was);
  batch_free(b);
}

static void shared(subject *s) { EACH_TEXTURE(s, 1, shared_of); }

/* "count: from 0 up" */
static void none_of(subject *s, const sozai_texture_info *info, const char *preset,
                    sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 0);
  if (b && batch_run(s, t, b, "no points"))
    for (uint32_t c = 0; c < info->component_count; c++)
      batch_untouched(b, c, 0, 0, "of no points");
  if (b) {
    batch_from(b, 0, 50);
    b->abi.out_count = 0;
    if (batch_run(s, t, b, "nothing wanted"))
      for (uint32_t c = 0; c < info->component_count; c++)
        batch_untouched(b, c, 0, 0, "and nothing wanted");
  }
  batch_free(b);
}

static void none(subject *s) { EACH_TEXTURE(s, 1, none_of); }

/* ---- the struct's size -------------------------------------------------------------- */

/* "A struct that may grow begins with `size` ... Members past the size given are taken as
 * zero": what a newer host appended is not looked at. */
static void larger_of(subject *s, const sozai_texture_info *info, const char *preset,
                      sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 40);
  float *was = b ? in_one(s, t, b, 40) : NULL;
  struct {
    sozai_batch abi;
    unsigned char later[512];
  } grown;
  for (uint32_t k = 0; was && k < 3; k++) {
    memset(&grown, k == 0 ? 0 : k == 1 ? 0xff : 0x5a, sizeof grown);
    grown.abi = b->abi;
    grown.abi.size = sizeof grown;
    batch_mark(b);
    doing("evaluate of %s, a larger struct", b->name);
    int32_t r = s->textures->evaluate(t, &grown.abi);
    EXPECT(r == SOZAI_OK, "%s: a batch of size %u gave %s", b->name, grown.abi.size,
           result_name(r));
    if (r == SOZAI_OK) batch_all_same(b, was, 0, 40, "and of a struct that has grown");
  }
  free(was);
  batch_free(b);
}

static void larger(subject *s) { EACH_TEXTURE(s, 0, larger_of); }

/* A smaller one: of an older host. What is past its end is marked, as what follows it in
 * memory would be. */
static void smaller_of(subject *s, const sozai_texture_info *info, const char *preset,
                       sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 40);
  float *was = b ? in_one(s, t, b, 40) : NULL;
  static const uint32_t cuts[] = {offsetof(sozai_batch, reserved), offsetof(sozai_batch, out_count),
                                  offsetof(sozai_batch, out), offsetof(sozai_batch, active)};
  for (uint32_t k = 0; was && k < COUNT_OF(cuts); k++) {
    unsigned char bytes[sizeof(sozai_batch)];
    sozai_batch cut;
    memset(bytes, 0xa5, sizeof bytes);
    memcpy(bytes, &b->abi, cuts[k]);
    memcpy(&cut, bytes, sizeof cut);
    cut.size = cuts[k];
    batch_mark(b);
    doing("evaluate of %s, a struct of %u bytes", b->name, cuts[k]);
    int32_t r = s->textures->evaluate(t, &cut);
    EXPECT(r == SOZAI_OK, "%s: a batch of size %u gave %s", b->name, cuts[k], result_name(r));
    if (r != SOZAI_OK) continue;
    if (k == 0)
      batch_all_same(b, was, 0, 40, "and of a struct without its last member");
    else /* no out_count, nothing wanted */
      for (uint32_t c = 0; c < info->component_count; c++)
        batch_untouched(b, c, 0, 0, "of a struct that ends before out_count");
  }
  if (b) {
    batch_from(b, 0, 40);
    b->abi.size = 0;
    doing("evaluate of %s, a struct of 0 bytes", b->name);
    int32_t r = s->textures->evaluate(t, &b->abi);
    EXPECT(r == SOZAI_ERROR_ARGUMENT, "%s: a batch of size 0 gave %s", b->name, result_name(r));
  }
  free(was);
  batch_free(b);
}

static void smaller(subject *s) { EACH_TEXTURE(s, 0, smaller_of); }

/* "length of out: components past it are not wanted, and pointers past component_count are not
 * read" */
static void out_count_of(subject *s, const sozai_texture_info *info, const char *preset,
                         sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 40);
  float *was = b ? in_one(s, t, b, 40) : NULL;
  uint32_t n = info->component_count;
  float **longer = calloc((size_t)n + 64, sizeof *longer);
  for (uint32_t k = 0; was && longer && k < n; k++) {
    b->abi.out_count = k;
    batch_mark(b);
    if (!batch_run(s, t, b, "fewer outputs")) break;
    for (uint32_t c = 0; c < n; c++) {
      if (c < k)
        batch_same(b, was, c, 0, 40, "and with a shorter out");
      else
        batch_untouched(b, c, 0, 0, "past out_count");
    }
  }
  if (was && longer) {
    memset(longer, 0x55, ((size_t)n + 64) * sizeof *longer);
    memcpy(longer, b->out, n * sizeof *longer);
    b->abi.out = longer;
    b->abi.out_count = n + 64;
    batch_mark(b);
    if (batch_run(s, t, b, "more outputs than components"))
      batch_all_same(b, was, 0, 40, "and with a longer out");
  }
  free(longer);
  free(was);
  batch_free(b);
}

static void out_count(subject *s) { EACH_TEXTURE(s, 0, out_count_of); }

/* "ARGUMENT: a NULL, a wrong size, a missing input" */
static void null_of(subject *s, const sozai_texture_info *info, const char *preset,
                    sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 4);
  if (!b) return;
  doing("evaluate of %s, the batch NULL", b->name);
  int32_t r = s->textures->evaluate(t, NULL);
  EXPECT(r == SOZAI_ERROR_ARGUMENT, "%s: a batch NULL gave %s", b->name, result_name(r));
  doing("evaluate, the texture NULL");
  r = s->textures->evaluate(NULL, &b->abi);
  EXPECT(r == SOZAI_ERROR_ARGUMENT, "a texture NULL gave %s", result_name(r));
  b->abi.out = NULL;
  doing("evaluate of %s, out NULL", b->name);
  r = s->textures->evaluate(t, &b->abi);
  EXPECT(r == SOZAI_ERROR_ARGUMENT, "%s: out NULL with out_count %u gave %s", b->name,
         b->abi.out_count, result_name(r));
  batch_free(b);
}

static void null(subject *s) { EACH_TEXTURE(s, 0, null_of); }

/* ---- machines ------------------------------------------------------------------------- */

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
static void instruction_sets(subject *s) { EACH_TEXTURE(s, 2, sets_of); }

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
    for (size_t i = 0; i < (size_t)info->component_count; i++)
      for (uint32_t k = 0; k < 600; k++) {
        float *x = &was[batch_place((uint32_t)i, k)];
        if (fabsf(*x) < 1.2e-38f)
          *x = b->memory[batch_place((uint32_t)i, k)] == 0 ? b->memory[batch_place((uint32_t)i, k)]
                                                           : 0;
      }
    batch_all_same(b, was, 0, 600, "and where denormals are flushed");
  }
  free(was);
  batch_free(b);
}

/* "Where the calling thread flushes denormals to zero, numbers below 1.2e-38 are zero." */
static void flushed(subject *s) {
  if (!control_flushes()) {
    skipped("this machine has no flushing of denormals that is known here");
    return;
  }
  EACH_TEXTURE(s, 4, flushed_of);
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
static void stack(subject *s) { EACH_TEXTURE(s, 2, stack_of); }

CHECKS(batches, //
       {"batches.sizes", "evaluate.answers", "batches of 1 to 4097 points give the same bits",
        sizes},
       {"batches.order", "evaluate.answers", "so do points in another order", order},
       {"batches.places", "evaluate.answers", "a point has the same answer in every place", places},
       {"batches.repeats", "evaluate.answers", "a hundred times the same", repeats},
       {"batches.alignment", "evaluate.answers", "arrays need the alignment of a float, no more",
        alignment},
       {"batches.shared-inputs", "evaluate.answers", "one array may be given for several inputs",
        shared},
       {"batches.none", "evaluate.answers",
        "no points, or no outputs: SOZAI_OK and nothing written", none},
       {"batches.larger-struct", "evaluate.answers", "a struct of a newer host is taken", larger},
       {"batches.smaller-struct", "evaluate.answers",
        "members past the size given are taken as zero, size 0 refused", smaller},
       {"batches.out-count", "evaluate.answers", "out may be shorter or longer than the components",
        out_count},
       {"batches.null", "evaluate.answers",
        "a NULL for texture, batch or out is refused as ARGUMENT", null},
       {"batches.instruction-sets", "evaluate.answers", "every instruction set gives the same bits",
        instruction_sets},
       {"batches.flushed", "evaluate.answers",
        "where denormals are flushed only they differ, and are zero", flushed},
       {"batches.stack", "evaluate.answers", "a stack of 512 KiB is enough", stack});
