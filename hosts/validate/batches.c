/* SPDX-License-Identifier: Apache-2.0
 * evaluate: the same bits whatever the batch. What the struct says of itself is in
 * batches_struct.c, what the machine does in batches_machine.c. */
#include "batches.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "groups.h"

#define MOST 4097u

float *in_one(subject *s, sozai_texture *t, batch *b, uint32_t n) {
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

static void sizes(subject *s) { start_each_texture(s, 1, sizes_of); }

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

static void order(subject *s) { start_each_texture(s, 2, order_of); }

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

static void places(subject *s) { start_each_texture(s, 2, places_of); }

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

static void repeats(subject *s) { start_each_texture(s, 2, repeats_of); }

/* "Arrays need the alignment of a float, no more." */
static void aligned_of(subject *s, const sozai_texture_info *info, const char *preset,
                       sozai_texture *t) {
  enum { N = 70 };
  batch *b = batch_new(s, info, preset, N + 16);
  float *was = b ? in_one(s, t, b, N + 16) : NULL;
  float *room = malloc((BATCH_INPUTS + 1) * (size_t)(N + 32) * sizeof *room);
  if (!room) failed("out of memory");
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

static void alignment(subject *s) { start_each_texture(s, 1, aligned_of); }

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

static void shared(subject *s) { start_each_texture(s, 1, shared_of); }

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

static void none(subject *s) { start_each_texture(s, 1, none_of); }

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
       {"batches.larger-struct", "evaluate.answers", "a struct of a newer host is taken",
        batches_larger},
       {"batches.smaller-struct", "evaluate.answers",
        "members past the size given are taken as zero, size 0 refused", batches_smaller},
       {"batches.out-count", "evaluate.answers", "out may be shorter or longer than the components",
        batches_out_count},
       {"batches.null", "evaluate.answers",
        "a NULL for texture, batch or out is refused as ARGUMENT", batches_null},
       {"batches.instruction-sets", "evaluate.answers", "every instruction set gives the same bits",
        batches_instruction_sets},
       {"batches.flushed", "evaluate.answers",
        "where denormals are flushed only they differ, and are zero", batches_flushed},
       {"batches.stack", "evaluate.answers", "a stack of 512 KiB is enough", batches_stack});
