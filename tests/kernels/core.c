/* SPDX-License-Identifier: Apache-2.0
 *
 * The core's functions give the same bits on every instruction set and width
 * as on one plain lane. With --bench: how long each takes, in ns for one lane.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <cmocka.h>

#include "core_kernels.h"

#define CHUNK 4096u
#define CHUNKS 256u /* about a million inputs to a function */

static float input[CORE_INPUTS][CHUNK], expected[CORE_OUTPUTS][CHUNK], got[CORE_OUTPUTS][CHUNK];
static const float *const in[CORE_INPUTS] = {input[0], input[1], input[2], input[3]};
static float *const want[CORE_OUTPUTS] = {expected[0], expected[1], expected[2], expected[3]};
static float *const out[CORE_OUTPUTS] = {got[0], got[1], got[2], got[3]};

static void fill(const core_description *d, uint32_t chunk, uint64_t *state) {
  for (uint32_t k = 0; k < d->inputs; k++) {
    for (uint32_t i = 0; i < CHUNK; i++) {
      uint32_t at = chunk * CHUNK + i;
      input[k][i] = core_input(d->domain[k], k & 1 ? at / 60u : at, state);
    }
  }
}

/* 0: the same. */
static int compare(const core_description *d, const core_kernels *k) {
  for (uint32_t o = 0; o < d->outputs; o++) {
    if (memcmp(expected[o], got[o], sizeof got[o]) == 0) continue;
    uint32_t i = 0;
    while (core_bits(expected[o][i]) == core_bits(got[o][i])) i++;
    print_error("%s, %s x %u, output %u: %.9g [%08x], not %.9g [%08x], for", d->name, k->isa,
                k->lanes, o, (double)got[o][i], core_bits(got[o][i]), (double)expected[o][i],
                core_bits(expected[o][i]));
    for (uint32_t n = 0; n < d->inputs; n++) {
      print_error(" %.9g [%08x]", (double)input[n][i], core_bits(input[n][i]));
    }
    print_error("\n");
    return 1;
  }
  return 0;
}

static void same_bits(void **unused) {
  (void)unused;
  const core_kernels *others[8];
  uint32_t n = core_available(others);
  int failures = 0;
  for (uint32_t f = 0; f < CORE_FUNCTION_COUNT; f++) {
    const core_description *d = &core_descriptions[f];
    uint64_t state = f + 1;
    int bad[8] = {0};
    for (uint32_t c = 0; c < CHUNKS; c++) {
      fill(d, c, &state);
      core_scalar_1.run[f](CHUNK, in, want);
      for (uint32_t k = 0; k < n; k++) {
        if (bad[k]) continue;
        memset(got, 0xab, sizeof got);
        others[k]->run[f](CHUNK, in, out);
        bad[k] = compare(d, others[k]);
        failures += bad[k];
      }
    }
  }
  print_message("%d functions, %u inputs each, on", (int)CORE_FUNCTION_COUNT, CHUNK * CHUNKS);
  for (uint32_t k = 0; k < n; k++) print_message(" %s x %u", others[k]->isa, others[k]->lanes);
  print_message("\n");
  assert_int_equal(failures, 0);
}

static double seconds(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* The best of several tries: what the machine can do when nobody disturbs it. */
static double nanoseconds(core_run *run) {
  double best = 1e9;
  for (int t = 0; t < 7; t++) {
    double before = seconds();
    for (int r = 0; r < 20; r++) run(CHUNK, in, out);
    double took = seconds() - before;
    if (took < best) best = took;
  }
  return best * 1e9 / (20.0 * CHUNK);
}

static void bench(void) {
  const core_kernels *list[9] = {&core_scalar_1};
  uint32_t n = 1 + core_available(list + 1);
  printf("%-20s", "ns for one lane");
  for (uint32_t k = 0; k < n; k++) printf(" %7s x%-2u", list[k]->isa, list[k]->lanes);
  printf("\n");
  for (uint32_t f = 0; f < CORE_FUNCTION_COUNT; f++) {
    uint64_t state = f + 1;
    for (uint32_t k = 0; k < core_descriptions[f].inputs; k++) {
      for (uint32_t i = 0; i < CHUNK; i++) {
        input[k][i] = core_ordinary(core_descriptions[f].domain[k], &state);
      }
    }
    printf("%-20s", core_descriptions[f].name);
    for (uint32_t k = 0; k < n; k++) printf(" %11.3f", nanoseconds(list[k]->run[f]));
    printf("\n");
  }
}

int main(int argc, char **argv) {
  if (argc == 2 && strcmp(argv[1], "--bench") == 0) {
    bench();
    return 0;
  }
  const struct CMUnitTest tests[] = {cmocka_unit_test(same_bits)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
