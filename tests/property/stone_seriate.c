/* SPDX-License-Identifier: Apache-2.0
 *
 * Crystals of several cells: how many there are, and of which sizes; and specks in clots.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "cmocka_all.h"
#include "truth.h"

/* One mineral, of which each crystal has a brightness of its own, within and at its edges. */
#define PLAIN                                                                                      \
  "second_share=0; third_share=0; mottle=0; cleavage=0; turbidity=0; grain_depth=0; "              \
  "grain_blur=0; base_colour=0.5 0.5 0.5 @ lin_rec709; "
#define CRYSTALS PLAIN "grain_variation=0.35; grain_interlock=0; grain_size=2; grain_grading=0.5; "

enum { SIDE = 72, ALL = SIDE * SIDE * SIDE };
#define SIZE 2.0 /* mm */
#define STEP 0.4

typedef struct {
  float albedo;
  int high; /* on one of the cube's upper sides */
} place;

static int by_albedo(const void *a, const void *b) {
  float x = ((const place *)a)->albedo, y = ((const place *)b)->albedo;
  return (x > y) - (x < y);
}

/* Crystals in a cube: how many to a cubic mm, and the mean volume of the one that a place is in,
 * mm^3. Those that reach the upper sides are not counted, as Gundersen counts particles in a
 * section, so that the cube's border neither adds nor takes (Notes on the estimation of the
 * numerical density of arbitrary profiles: the edge effect, J. Microsc. 111, 1977). */
static double count_crystals(double seriate, double *own) {
  static place seen[ALL];
  char text[400];
  snprintf(text, sizeof text, CRYSTALS "grain_seriate=%g", seriate);
  sozai_texture *t = stone_make(NULL, text);
  points p = {0};
  for (int n = 0; n < ALL; n++)
    points_add(&p, STEP * (n % SIDE), STEP * (n / SIDE % SIDE), STEP * (n / SIDE / SIDE), 0);
  points_ask_only(&p, t, ONLY3(ALBEDO));
  for (int n = 0; n < ALL; n++) {
    seen[n].albedo = p.out[ALBEDO][n];
    seen[n].high =
        n % SIDE == SIDE - 1 || n / SIDE % SIDE == SIDE - 1 || n / SIDE / SIDE == SIDE - 1;
  }
  points_free(&p);
  textures->destroy(t);
  qsort(seen, ALL, sizeof *seen, by_albedo);
  int count = 0;
  double sum = 0, square = 0;
  for (int n = 0, next; n < ALL; n = next) {
    int high = 0;
    for (next = n; next < ALL && seen[next].albedo == seen[n].albedo; next++)
      high |= seen[next].high;
    if (high) continue;
    double volume = (next - n) * STEP * STEP * STEP;
    count++;
    sum += volume;
    square += volume * volume;
  }
  *own = square / sum;
  return count / (ALL * STEP * STEP * STEP);
}

/* Of a block of 2^3 cells each axis is whole with the chance g, so that it has (2 - g)^3 crystals
 * in the mean, and a cell is one of (1 + g)^3. The size that is asked for is the mean crystal's. A
 * cell's own volume varies as without. */
static void sizes_range(void **state) {
  (void)state;
  static const double seriate[] = {0, 0.2, 0.4, 0.6};
  double varies = 0;
  for (int k = 0; k < 4; k++) {
    double g = seriate[k], own, mean = cbrt(1 / count_crystals(g, &own));
    double cell = pow(SIZE * (1 - g / 2), 3), cells = pow(1 + g, 3);
    if (k == 0) varies = own / cell - 1;
    double expected = cell * (cells + varies);
    CHECK(fabs(mean / SIZE - 1) < 0.03, "grain_seriate=%g: the mean crystal is %.3f mm, of %g\n", g,
          mean, SIZE);
    CHECK(fabs(own / expected - 1) < 0.1, "the crystal at a place is of %.2f mm^3, of %.2f\n", own,
          expected);
  }
}

/* What specks fill, and how much of what is a speck's size away from a place in one. */
static double clots(double aggregation, double *covered) {
  enum { PLACES = 400000 };
  char text[400];
  snprintf(text, sizeof text,
           PLAIN "grain_variation=0; base_colour=0 0 0; white_colour=1 1 1; speck_size=2; "
                 "white_share=0.1; speck_aggregation=%g",
           aggregation);
  sozai_texture *t = stone_make(NULL, text);
  points p = {0};
  uniform_seed(81);
  for (int n = 0; n < PLACES; n++) {
    double at[3], way[3], length = 0;
    for (int k = 0; k < 3; k++) {
      at[k] = 600 * uniform();
      way[k] = uniform() + uniform() + uniform() + uniform() - 2;
      length += way[k] * way[k];
    }
    length = 2 / sqrt(length);
    points_add(&p, at[0], at[1], at[2], 0);
    points_add(&p, at[0] + way[0] * length, at[1] + way[1] * length, at[2] + way[2] * length, 0);
  }
  points_ask_only(&p, t, ONLY3(ALBEDO));
  double some = 0, both = 0;
  for (unsigned n = 0; n < 2 * PLACES; n += 2) {
    int here = p.out[ALBEDO][n] > 0.5f, there = p.out[ALBEDO][n + 1] > 0.5f;
    some += here + there;
    both += 2 * (here && there);
  }
  points_free(&p);
  textures->destroy(t);
  *covered = some / (2 * PLACES);
  return both / some;
}

/* A share stays what it is, and a speck's next is another more often than one in ten. Were they as
 * far apart in clots as by themselves it would be 0.205 of the last. */
static void specks_gather(void **state) {
  (void)state;
  static const double aggregation[] = {0, 0.45, 0.9};
  double next[3], covered;
  for (int k = 0; k < 3; k++) {
    next[k] = clots(aggregation[k], &covered);
    CHECK(fabs(covered - 0.1) < 0.006, "speck_aggregation=%g: specks fill %.4f, of 0.1\n",
          aggregation[k], covered);
    print_message("a speck's size from one there is %.3f of another\n", next[k]);
  }
  CHECK(next[0] < 0.1 && next[1] > next[0] + 0.05 && next[2] > 0.23,
        "clots are none, some, and many that touch\n");
}

/* Where cells are counted, those of one crystal are as bright as each other. */
static void counted_as_crystals(void **state) {
  (void)state;
  enum { PLACES = 192 };
  sozai_texture *t = stone_make(NULL, CRYSTALS "grain_seriate=0.6");
  points p = {0};
  truth_errors e = {0};
  uniform_seed(82);
  for (int place = 0; place < PLACES; place++) {
    double x = 1000 * uniform(), y = 1000 * uniform();
    truth_ask(&p, t, ONLY3(ALBEDO), x, y, 0, 12);
    truth_add(&e, &p);
  }
  points_free(&p);
  textures->destroy(t);
  CHECK(truth_rms(&e) < 0.01, "under 12 mm, of crystals of 2: RMS %.4f\n", truth_rms(&e));
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(sizes_range), cmocka_unit_test(specks_gather),
                                     cmocka_unit_test(counted_as_crystals)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
