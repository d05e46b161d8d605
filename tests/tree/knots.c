/* SPDX-License-Identifier: Apache-2.0
 * The stem's rings, and the knots in them. */
#include <math.h>

#include "tree.h"

static void rings_never_cross(void **unused) {
  (void)unused;
  static const char *const kinds[] = {"sugi", "akamatsu", "cherry", "keyaki"};
  for (int s = 0; s < 4; s++) {
    sozai_geometry *g = grow(kinds[s], "age=60 orders=1", NULL);
    sozai_table t = table_of(g, "rings");
    assert_int_equal(t.rows, 60 * 33);
    for (uint64_t i = 33; i < t.rows; i++)
      assert_true(cell(&t, i, "radius") >= cell(&t, i - 33, "radius"));
    for (uint64_t i = t.rows - 32; i < t.rows; i++)
      assert_true(cell(&t, i, "radius") <= cell(&t, i - 1, "radius"));
    geometry()->release(g);
  }
}

/* Each knot is a branch: the same height, azimuth and years; born when the tip
 * was there; thinner than the stem; growing until it dies. */
static void knots_are_branches(void **unused) {
  (void)unused;
  sozai_geometry *g = grow("akamatsu", "age=45 orders=1", NULL);
  sozai_table k = table_of(g, "knots"), b = table_of(g, "branches"),
              radii = table_of(g, "knot_radii");
  const sozai_curves *c = curves_of(g, 0);
  double dead = 0, shed = 0, off = 0, rows = 0;
  for (uint64_t i = 0; i < k.rows; i++) {
    double row = cell(&k, i, "branch"), height = cell(&k, i, "height");
    uint64_t first = (uint64_t)cell(&k, i, "first"), count = (uint64_t)cell(&k, i, "count");
    assert_true(first == (uint64_t)rows);
    rows += (double)count;
    for (uint64_t n = first; n < first + count; n++) {
      assert_true(cell(&radii, n, "knot") == (double)i);
      if (n > first) {
        assert_true(cell(&radii, n, "radius") >= cell(&radii, n - 1, "radius"));
        assert_true(cell(&radii, n, "year") == cell(&radii, n - 1, "year") + 1);
      }
      assert_true(cell(&radii, n, "year") >= cell(&k, i, "birth"));
    }
    dead += cell(&k, i, "death") >= 0;
    shed += cell(&k, i, "shed") >= 0;
    if (cell(&k, i, "shed") >= 0) {
      assert_true(row == -1);
      continue;
    }
    double turn = cell(&k, i, "azimuth") * 180 / 3.14159265358979 + 90;
    double azimuth = cell(&b, (uint64_t)row, "azimuth");
    assert_true(fabs(remainder(turn - azimuth, 360)) < 1e-3);
    assert_true(fabs(cell(&b, (uint64_t)row, "at") - height) < 0.01);
    assert_true(cell(&b, (uint64_t)row, "birth") == cell(&k, i, "birth"));
    assert_true(fabs(2 * cell(&k, i, "radius") - cell(&b, (uint64_t)row, "diameter")) <
                0.2 + 0.02 * cell(&k, i, "radius"));
  }
  /* where the branch that is drawn leaves the stem */
  for (uint64_t i = 1; i < c->curve_count; i++) {
    if (cell(&b, c->ids[i], "parent") != 0) continue; /* an arm of a branch's */
    const float *p = c->points + 3 * c->first[i];
    off = fmax(off, fabs((double)p[1] - cell(&b, c->ids[i], "at")));
    const float *q = p + 3;
    double turn =
        atan2((double)q[0] - (double)p[0], (double)p[2] - (double)q[2]) * 180 / 3.14159265358979;
    assert_true(fabs(remainder(turn - cell(&b, c->ids[i], "azimuth"), 360)) < 0.1);
  }
  print_message("%llu knots, %.0f dead, %.0f of them shed; curves off by %.3f mm at most\n",
                (unsigned long long)k.rows, dead, shed, off);
  assert_true(off < 0.5);
  assert_true(dead > 20 && shed > 5 && dead > shed);
  geometry()->release_curves(c);
  geometry()->release(g);
}

/* The knot table of a tree of 30 is a beginning of the same tree's at 31. */
static void years_only_add(void **unused) {
  (void)unused;
  sozai_geometry *young = grow("akamatsu", "age=30 orders=1", NULL),
                 *old = grow("akamatsu", "age=31 orders=1", NULL);
  sozai_table a = table_of(young, "knots"), b = table_of(old, "knots");
  assert_true(b.rows > a.rows);
  for (uint64_t i = 0; i < a.rows; i++) {
    assert_true(cell(&a, i, "height") == cell(&b, i, "height"));
    assert_true(cell(&a, i, "azimuth") == cell(&b, i, "azimuth"));
    assert_true(fabs(cell(&a, i, "birth") - cell(&b, i, "birth")) < 1e-4);
    if (cell(&a, i, "death") >= 0)
      assert_true(fabs(cell(&a, i, "death") - cell(&b, i, "death")) < 1e-3);
  }
  geometry()->release(young);
  geometry()->release(old);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(rings_never_cross),
                                     cmocka_unit_test(knots_are_branches),
                                     cmocka_unit_test(years_only_add)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
