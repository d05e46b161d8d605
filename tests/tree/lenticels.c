/* SPDX-License-Identifier: Apache-2.0
 * Lenticels: as many, as long and as high as asked for, as dark, and none where periderm is gone.
 */
#include <stdio.h>

#include "stem_rings.h"

/* A straight stem, all of it periderm. */
#define SMOOTH                                                                                     \
  "age=60 orders=1 sway=0 butt=0 diameter_max=500 bark_depth=0 periderm_age=0 rhytidome_from=900 " \
  "bark_colour=0.5,0.6,0.7 "
/* Places that hang together, in rows of as many. */
typedef struct {
  double count, length, height;
} bars;

static void count_bars(const rings *r, uint64_t rows, uint64_t from, bars *out) {
  unsigned char *in = calloc(rows * r->sides, 1);
  uint64_t *stack = malloc(rows * r->sides * sizeof *stack);
  assert_true(in && stack);
  for (uint64_t i = 0; i < rows; i++)
    for (uint64_t k = 0; k < r->sides; k++) in[i * r->sides + k] = mark(r, from + i, k) > 0.2;
  for (uint64_t at = 0; at < rows * r->sides; at++) {
    if (!in[at]) continue;
    uint64_t depth = 0, low = at / r->sides, high = low;
    int64_t first = (int64_t)(at % r->sides), left = 0, right = 0, sides = (int64_t)r->sides;
    stack[depth++] = at;
    in[at] = 0;
    while (depth) {
      uint64_t q = stack[--depth], i = q / r->sides, k = q % r->sides;
      int64_t off = ((int64_t)k - first + sides + sides / 2) % sides - sides / 2;
      left = off < left ? off : left, right = off > right ? off : right;
      low = i < low ? i : low, high = i > high ? i : high;
      const uint64_t beside[4] = {i * r->sides + (k + 1) % r->sides,
                                  i * r->sides + (k + r->sides - 1) % r->sides, q - r->sides,
                                  q + r->sides};
      for (int d = 0; d < 4; d++) {
        if ((d == 2 && i == 0) || (d == 3 && i + 1 == rows) || !in[beside[d]]) continue;
        in[beside[d]] = 0;
        stack[depth++] = beside[d];
      }
    }
    out->count++;
    out->length += (double)(right - left + 1) * 6.2831853 * out_of(r, from, 0) / (double)sides;
    out->height += height_of(r, from + high + 1) - height_of(r, from + low);
  }
  free(in);
  free(stack);
}

static void as_many_as_asked(void **unused) {
  (void)unused;
  static const struct {
    double density, length, height;
  } cases[] = {{2, 30, 5}, {6, 20, 3}, {0.5, 80, 8}};
  for (int c = 0; c < 3; c++) {
    char values[400];
    snprintf(values, sizeof values,
             SMOOTH "lenticel_density=%g lenticel_length=%g lenticel_height=%g lenticel_shade=0.5",
             cases[c].density, cases[c].length, cases[c].height);
    sozai_geometry *g = grow("sugi", values, NULL);
    const sozai_mesh *m = mesh_of(g, 0);
    rings r = rings_of(m);
    uint64_t from = 0, end = 0;
    while (height_of(&r, from) < ROOTS) from++;
    while (height_of(&r, end) < 2900) end++;
    double sum = 0, count = 0, darkest = 0, area = 0;
    for (uint64_t i = from; i < end; i++)
      for (uint64_t k = 0; k < r.sides; k++) {
        darkest = fmax(darkest, mark(&r, i, k));
        sum += mark(&r, i, k), count++;
        area += 6.2831853 * out_of(&r, i, k) / (double)r.sides *
                (height_of(&r, i + 1) - height_of(&r, i)) * 1e-4;
      }
    bars b = {0};
    count_bars(&r, end - from, from, &b);
    print_message("%g/dm2 of %g x %g mm: %.2f of %.1f x %.1f mm, darkest %.3f, mean %.4f\n",
                  cases[c].density, cases[c].length, cases[c].height, b.count / area,
                  b.length / b.count, b.height / b.count, darkest, sum / count);
    assert_true(fabs(b.count / area / cases[c].density - 1) < 0.2);
    /* of discs half to all as wide, cut anywhere: 0.75 pi / 4 */
    assert_true(fabs(b.length / b.count / cases[c].length - 0.59) < 0.15);
    assert_true(b.height / b.count > 0.4 * cases[c].height);
    assert_true(b.height / b.count < cases[c].height);
    assert_true(darkest > 0.95 && darkest < 1.0 && fabs(sum / count) < 0.005);
    geometry()->release_mesh(m);
    geometry()->release(g);
  }
}

static void where_they_are(void **unused) {
  (void)unused;
  sozai_geometry *g =
      grow("sugi", SMOOTH "lenticel_density=3 lenticel_shade=0.5 bark_reach=7.5", NULL);
  const sozai_mesh *m = mesh_of(g, 0);
  rings r = rings_of(m);
  assert_true(range_of(&r, 0, 1500, NULL) > 0.9 && range_of(&r, 2200, 2300, NULL) < 0.6);
  assert_true(range_of(&r, 3001, 5000, NULL) < 1e-5);
  geometry()->release_mesh(m);
  m = mesh_of(g, 1);
  r = rings_of(m);
  assert_true(range_of(&r, 0, 5000, NULL) < 1e-5);
  geometry()->release_mesh(m);
  geometry()->release(g);
  /* none on rhytidome */
  g = grow("sugi",
           "age=60 orders=1 sway=0 butt=0 bark_depth=0 rhytidome_from=0 rhytidome_age=0 "
           "rhytidome_colour=0.5,0.6,0.7 lenticel_density=3",
           NULL);
  m = mesh_of(g, 0);
  r = rings_of(m);
  assert_true(range_of(&r, 0, 5000, NULL) < 1e-5);
  geometry()->release_mesh(m);
  geometry()->release(g);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(as_many_as_asked),
                                     cmocka_unit_test(where_they_are)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
