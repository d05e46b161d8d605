/* SPDX-License-Identifier: Apache-2.0
 *
 * Sample points are Sobol's (0, 2)-sequence, scrambled: of the first 2^k, and of the next, and so
 * on, one lies in each of the 2^k boxes of any proportions that are powers of two. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "samples.h"

enum { MOST = 8 };

static unsigned crowded(uint32_t pixel, uint32_t pair, unsigned k, unsigned across, unsigned from) {
  unsigned count = 1u << k, wide = 1u << across, high = count / wide, bad = 0;
  unsigned char taken[1 << MOST] = {0};
  for (unsigned i = 0; i < count; i++) {
    float u, v;
    sample_pair(pixel, from * count + i, pair, &u, &v);
    assert_true(u >= 0 && u < 1 && v >= 0 && v < 1);
    unsigned at = (unsigned)(u * (float)wide) + wide * (unsigned)(v * (float)high);
    bad += taken[at]++;
  }
  return bad;
}

static void one_to_a_box(void **state) {
  (void)state;
  unsigned bad = 0, boxes = 0;
  for (uint32_t pixel = 0; pixel < 50; pixel++)
    for (uint32_t pair = 0; pair < 3; pair++)
      for (unsigned k = 0; k <= MOST; k++)
        for (unsigned across = 0; across <= k; across++)
          for (unsigned from = 0; from < 3; from++) {
            bad += crowded(pixel * 7919, pair, k, across, from);
            boxes += 1u << k;
          }
  print_message("%u boxes, %u points too many\n", boxes, bad);
  assert_int_equal(bad, 0);
}

/* Neighbours and pairs of dimensions have patterns of their own. */
static void scrambled_apart(void **state) {
  (void)state;
  double sum[2] = {0};
  enum { PIXELS = 20000 };
  for (uint32_t pixel = 0; pixel < PIXELS; pixel++) {
    float u[3], v[3];
    sample_pair(pixel, 0, 0, &u[0], &v[0]);
    sample_pair(pixel + 1, 0, 0, &u[1], &v[1]);
    sample_pair(pixel, 0, 1, &u[2], &v[2]);
    for (int k = 0; k < 2; k++) sum[k] += 12 * ((double)u[0] - 0.5) * ((double)u[k + 1] - 0.5);
  }
  print_message("correlation of neighbours %.4f, of pairs %.4f\n", sum[0] / PIXELS,
                sum[1] / PIXELS);
  for (int k = 0; k < 2; k++) assert_true(sum[k] / PIXELS < 0.03 && sum[k] / PIXELS > -0.03);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(one_to_a_box),
                                     cmocka_unit_test(scrambled_apart)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
