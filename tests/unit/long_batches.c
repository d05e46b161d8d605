/* SPDX-License-Identifier: Apache-2.0
 *
 * kernel_run on batches up to the longest that 32 bits count: every point goes to a kernel once,
 * with the arrays that belong to it, and no kernel is asked to count past the end.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>

#include "core/kernel.h"

enum { STEP = 256 }; /* a kernel's own, at most */

/* Arrays are not read: their places alone are looked at. */
static float *at(uint64_t place) { return (float *)(uintptr_t)(place * sizeof(float)); }
static const uint64_t point = 1ull << 40, footprint = 2ull << 40, second_out = 4ull << 40;
static uint64_t asked, wrong;

static void look(const void *constants, const kernel_io *io, uint32_t from, uint32_t to) {
  (void)constants;
  const sozai_batch *b = io->in;
  wrong += from >= to || to > UINT32_MAX - STEP || to > b->count;
  wrong += b->point[0] + from != at(point + asked) || b->point[1] != NULL;
  wrong += b->footprint + from != at(footprint + asked);
  wrong += b->active != NULL;
  wrong += io->out[1] + from != at(second_out + asked) || io->wanted != 2;
  asked += to - from;
}

/* None is chosen here. */
int32_t cpu_choose(int *out) {
  *out = 0;
  return SOZAI_OK;
}

static void every_point_once(void **unused) {
  (void)unused;
  static const kernel wide = {"wide", 16, look}, narrow = {"narrow", 4, look},
                      single = {"single", 1, look};
  static const kernel_set use = {&wide, &narrow, &single};
  static const uint32_t counts[] = {1,           2,           16,          17,          1000,
                                    1u << 30,    1073741825u, 1073741840u, 1u << 31,    3221225473u,
                                    4026531841u, 4294967280u, 4294967287u, 4294967281u, UINT32_MAX};
  float *const out[] = {NULL, at(second_out)};
  for (size_t k = 0; k < sizeof counts / sizeof *counts; k++) {
    const sozai_batch b = {.size = sizeof b,
                           .count = counts[k],
                           .point = {at(point)},
                           .footprint = at(footprint),
                           .out = out,
                           .out_count = 2};
    const kernel_io io = {&b, out, 2};
    asked = wrong = 0;
    kernel_run(&use, NULL, &io);
    if (wrong || asked != counts[k])
      fail_msg("of %u points %llu were asked, %llu wrong", counts[k], (unsigned long long)asked,
               (unsigned long long)wrong);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(every_point_once)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
