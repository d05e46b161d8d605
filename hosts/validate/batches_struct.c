/* SPDX-License-Identifier: Apache-2.0
 * evaluate: a batch of another size than ours, more or fewer outputs, and NULLs. */
#include "batches.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

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

void batches_larger(subject *s) { start_each_texture(s, 0, larger_of); }

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

void batches_smaller(subject *s) { start_each_texture(s, 0, smaller_of); }

/* "length of out: components past it are not wanted, and pointers past component_count are not
 * read" */
static void out_count_of(subject *s, const sozai_texture_info *info, const char *preset,
                         sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 40);
  float *was = b ? in_one(s, t, b, 40) : NULL;
  uint32_t n = info->component_count;
  float **longer = calloc((size_t)n + 64, sizeof *longer);
  if (!longer) failed("out of memory");
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

void batches_out_count(subject *s) { start_each_texture(s, 0, out_count_of); }

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

void batches_null(subject *s) { start_each_texture(s, 0, null_of); }
