/* SPDX-License-Identifier: Apache-2.0
 * Field tables: node positions, thickness, round trips, and every kind of
 * malformed line. */
#include <math.h>
#include <stdio.h>

#include "tree.h"

#define RAD (3.14159265358979323846 / 180)

static const char measured[] = "# a small tree\n"
                               "trunk\n"
                               "50 10 88 6\n"
                               "40, 200, 85, 5.5\r\n"
                               "\n"
                               "30 0 90 -\n"
                               "B100   # the lowest\n"
                               "0\n"
                               "35 45 20 2\n"
                               "25 50 30\n"
                               "B110\n"
                               "0\n0\n"
                               "15 90 0 0.8\n"
                               "B200\n0\n0\n"
                               "28 300 -10\n";

/* x = l sin(theta) cos(phi), y = l cos(theta) cos(phi), z = l sin(phi); here +y
 * is up and z south. */
static void node_sums(void **unused) {
  (void)unused;
  sozai_geometry *g = grow("cherry_paper", "orders=3", measured);
  const sozai_curves *c = curves_of(g, 0);
  static const double rows[4][4][3] = {{{50, 10, 88}, {40, 200, 85}, {30, 0, 90}},
                                       {{35, 45, 20}, {25, 50, 30}},
                                       {{15, 90, 0}},
                                       {{28, 300, -10}}};
  static const int counts[4] = {3, 2, 1, 1}, parents[4] = {0, 0, 1, 0}, nodes[4] = {0, 1, 1, 2};
  double at[4][4][3] = {{{0}}}, worst = 0;
  assert_int_equal(c->curve_count, 4);
  for (int b = 0; b < 4; b++) {
    for (int k = 0; b && k < 3; k++) at[b][0][k] = at[parents[b]][nodes[b]][k];
    assert_int_equal(c->first[b + 1] - c->first[b], counts[b] + 1);
    for (int i = 0; i <= counts[b]; i++) {
      const float *p = c->points + 3 * (c->first[b] + (uint64_t)i);
      for (int k = 0; k < 3; k++) worst = fmax(worst, fabs((double)p[k] - at[b][i][k]));
      if (i == counts[b]) break;
      const double *r = rows[b][i];
      at[b][i + 1][0] = at[b][i][0] + 10 * r[0] * sin(r[1] * RAD) * cos(r[2] * RAD);
      at[b][i + 1][1] = at[b][i][1] + 10 * r[0] * sin(r[2] * RAD);
      at[b][i + 1][2] = at[b][i][2] - 10 * r[0] * cos(r[1] * RAD) * cos(r[2] * RAD);
    }
  }
  print_message("nodes off by %.2g mm at most\n", worst);
  assert_true(worst < 1e-3);
  /* thickness: as measured; a cone between; and from the parent where missing */
  assert_true(fabs((double)c->radii[0] - 30) < 1e-4);
  assert_true(fabs((double)c->radii[1] - 27.5) < 1e-4);
  assert_true(c->radii[2] < 27.5f && c->radii[2] > 2.0f);
  assert_true(fabs((double)c->radii[c->first[1]] - 10) < 1e-4);
  sozai_value thickest = {0};
  assert_int_equal(geometry()->value(g, "thickest", &thickest), SOZAI_OK);
  double parent = (double)c->radii[2];
  assert_true(fabs((double)c->radii[c->first[3]] - thickest.number[0] * parent) < 1e-3);
  geometry()->release_curves(c);
  geometry()->release(g);
}

static void round_trip(void **unused) {
  (void)unused;
  sozai_geometry *g = grow("sugi", "age=9 orders=1", NULL);
  char *text = field_text(g);
  sozai_geometry *again = grow("sugi", "age=9 orders=1", text);
  char *twice = field_text(again);
  sozai_geometry *third = grow("sugi", "age=9 orders=1", twice);
  char *thrice = field_text(third);
  assert_string_equal(text, twice);
  assert_string_equal(twice, thrice);
  sozai_table a = table_of(g, "branches"), b = table_of(again, "branches");
  const sozai_curves *c = curves_of(g, 0), *d = curves_of(again, 0);
  double worst = 0;
  assert_int_equal(a.rows, b.rows);
  for (uint64_t i = 1; i < a.rows; i++)
    for (int k = 0; k < 3; k++)
      worst = fmax(worst, fabs((double)c->points[3 * c->first[i] + (uint64_t)k] -
                               (double)d->points[3 * d->first[i] + (uint64_t)k]));
  print_message("%llu branches through a field table: bases off by %.3f mm at most\n",
                (unsigned long long)a.rows - 1, worst);
  assert_true(worst < 0.5);
  geometry()->release_curves(c);
  geometry()->release_curves(d);
  free(text);
  free(twice);
  free(thrice);
  geometry()->release(g);
  geometry()->release(again);
  geometry()->release(third);
}

static void malformed(void **unused) {
  (void)unused;
  static const struct {
    const char *text, *where, *what;
  } wrong[] = {
      {"", NULL, NULL}, /* no field at all */
      {"# nothing\n", "line 2, column 1", "no trunk"},
      {"50 0 90 3\n", "line 1, column 1", "before the heading"},
      {"trunk\n", "line 2, column 1", "has no segment"},
      {"trunk\nB100\n", "line 2, column 1", "trunk above has no segment"},
      {"trunk\n0\n", "line 2, column 1", "no empty node"},
      {"trunk\n50 0\n", "line 2, column 1", "2 values"},
      {"trunk\n7\n", "line 2, column 1", "1 value:"},
      {"trunk\n50 0 90 3 9\n", "line 2, column 11", "fifth"},
      {"trunk\n50 x 90\n", "line 2, column 4", "\"x\" is no number, wanted is azimuth in deg"},
      {"trunk\n5o 0 90\n", "line 2, column 1", "\"5o\" is no number, wanted is length in cm"},
      {"trunk\n- 0 90\n", "line 2, column 1", "\"-\" is no number"},
      {"trunk\nnan 0 90\n", "line 2, column 1", "length nan is outside 0.01 to 20000 cm"},
      {"trunk\ninf 0 90\n", "line 2, column 1", "length inf is outside"},
      {"trunk\n1e30 0 90\n", "line 2, column 1", "length 1e+30 is outside 0.01 to 20000 cm"},
      {"trunk\n-5 0 90\n", "line 2, column 1", "length -5 is outside"},
      {"trunk\n50 361 90\n", "line 2, column 4", "azimuth 361 is outside 0 to 360 deg"},
      {"trunk\n50 0 91\n", "line 2, column 6", "elevation 91 is outside -90 to 90 deg"},
      {"trunk\n50 0 90 -1\n", "line 2, column 9", "diameter -1 is outside 0 to 2000 cm"},
      {"trunk now\n", "line 1, column 7", "\"now\""},
      {"trunk\n50 0 90\ntrunk\n50 0 90\n", "line 3, column 1", "stands twice"},
      {"B100\n0\n5 0 0\n", "line 1, column 1", "before the trunk"},
      {"trunk\n50 0 90\nB110\n0\n5 0 0\n", "line 3, column 1", "before its parent B1"},
      {"trunk\n50 0 90\nB100\n0\n5 0 0\nB1\n0\n5 0 0\n", "line 6, column 1", "B1 stands twice"},
      {"trunk\n50 0 90\nBx\n", "line 3, column 2", "no branch's name"},
      {"trunk\n50 0 90\nB\n", "line 3, column 1", "B100"},
      {"trunk\n50 0 90\nB000\n", "line 3, column 1", "all its numbers are 0"},
      {"trunk\n50 0 90\nB101\n", "line 3, column 4", "1 after a 0"},
      {"trunk\n50 0 90\nB1.\n", "line 3, column 3", "missing after the dot"},
      {"trunk\n50 0 90\nB1111\n", "line 3, column 5", "order 4 is beyond 3"},
      {"trunk\n50 0 90\nB100\n0\n0\n5 0 0\n", "line 6, column 1",
       "node 2, but trunk has the nodes 0 to 1"},
      {"trunk\n50 0 90\n50 0 90\nB100\n0\n5 0 0\nB110\n0\n3 0 0\n", "line 9, column 1",
       "node 1, but B1 has the nodes 2 to 2"},
      {"trunk\n50 0 90\nB100\n0\n5 0 0\n0\n", "line 6, column 1", "0 within B1"},
      {"trunk\n50 0 90\nB100\n0\nB200\n", "line 5, column 1", "B1 above has no segment"}};
  for (size_t i = 1; i < sizeof wrong / sizeof *wrong; i++) {
    sozai_geometry *g = (sozai_geometry *)(uintptr_t)1;
    int32_t r = grow_code(NULL, "sugi", "orders=1", wrong[i].text, &g);
    const char *message = geometry()->last_error();
    if (r != SOZAI_ERROR_FILE || !strstr(message, wrong[i].where) ||
        !strstr(message, wrong[i].what))
      fail_msg("%s\n  wanted %s, %s; got %d: %s", wrong[i].text, wrong[i].where, wrong[i].what, r,
               message);
    assert_null(g);
    assert_null(strchr(message, '\n'));
  }
  /* too little to fit */
  sozai_geometry *g = NULL;
  assert_int_equal(grow_code(NULL, "sugi", "resample=sibling", measured, &g), SOZAI_ERROR_FILE);
  assert_non_null(strstr(geometry()->last_error(), "2 first-order branches are too few"));
  /* bytes that nobody would type */
  char text[300];
  srand(3);
  for (int i = 0; i < 3000; i++) {
    static const char letters[] = "trunkB109.- \n\t#,e+x\r\x80\xff";
    size_t n = (size_t)rand() % (sizeof text - 1);
    for (size_t k = 0; k < n; k++) text[k] = letters[(size_t)rand() % (sizeof letters - 1)];
    text[n] = 0;
    if (i & 1) memcpy(text, "trunk\n9 9 9\nB", n < 13 ? n : 13);
    int32_t r = grow_code(NULL, "sugi", "orders=1", text, &g);
    if (r == SOZAI_OK)
      geometry()->release(g);
    else
      assert_int_equal(r, SOZAI_ERROR_FILE);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(node_sums), cmocka_unit_test(round_trip),
                                     cmocka_unit_test(malformed)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
