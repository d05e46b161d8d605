/* SPDX-License-Identifier: Apache-2.0
 * Row 4: the first placement. */
#include <math.h>
#include "fiber.h"

static void middles_inside(void **unused) {
  (void)unused;
  static const char *const modes[] = {"mode=field count=400 iterations=0",
                                      "mode=exact count=100 iterations=0"};
  failure why;
  mesh m;
  assert_true(hull_make_bunny(&m, 30, &why));
  for (int k = 0; k < 2; k++) {
    sozai_geometry *g = grow(&m, modes[k]);
    const sozai_curves *c = curves_of(g);
    for (uint64_t i = 0; i < c->curve_count; i++) {
      const float *p = c->points + 3 * (c->first[i] + 16);
      assert_true(brute_winding(&m, p) > 0.5 || brute_distance(&m, p) < 1e-4);
    }
    geometry()->release_curves(c);
    geometry()->release(g);
  }
  mesh_free(&m);
}

/* Every place inside is as likely: the mean and spread of a box. */
static void uniform(void **unused) {
  (void)unused;
  mesh m = box_of(20, 6, 30);
  const double half[3] = {10, 3, 15};
  sozai_geometry *g = grow(&m, "count=20000 vertices=2 length=0.01 iterations=0");
  const sozai_curves *c = curves_of(g);
  for (int a = 0; a < 3; a++) {
    double sum = 0, square = 0;
    for (uint64_t i = 0; i < c->curve_count; i++) {
      double x = (double)c->points[3 * (2 * i + 1) + (uint64_t)a] / half[a];
      sum += x / 20000, square += x * x / 20000;
    }
    assert_true(fabs(sum) < 0.02);
    assert_true(fabs(square - 1.0 / 3) < 0.01);
  }
  geometry()->release_curves(c);
  geometry()->release(g);
  mesh_free(&m);
}

/* By the literal rule: its own side of the nearest vertex. The paper's rejection
 * takes the number that is wanted. */
static void literal(void **unused) {
  (void)unused;
  mesh m = hull_of("ball");
  sozai_geometry *g = grow(&m, "mode=literal count=500 iterations=0");
  const sozai_curves *c = curves_of(g);
  assert_int_equal(c->curve_count, 500);
  for (uint64_t i = 0; i < c->curve_count; i++) {
    const float *p = c->points + 3 * (c->first[i] + 16);
    double r = sqrt((double)(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]));
    assert_true(r < 20.01);
  }
  geometry()->release_curves(c);
  geometry()->release(g);
  mesh_free(&m);
}

/* The hulls that are made here look outward. */
static void outward(void **unused) {
  (void)unused;
  static const char *const names[] = {"bunny", "serpent", "ball", "lump", "slab"};
  for (int k = 0; k < 5; k++) {
    mesh m = hull_of(names[k]);
    double volume = 0, facing = 0;
    for (size_t i = 0; i < m.triangle_count; i++) {
      const float *p[3];
      for (size_t c = 0; c < 3; c++) p[c] = m.points + 3 * (size_t)m.indices[3 * i + c];
      double n[3];
      for (int a = 0; a < 3; a++) {
        int u = (a + 1) % 3, v = (a + 2) % 3;
        n[a] = (double)(p[1][u] - p[0][u]) * (double)(p[2][v] - p[0][v]) -
               (double)(p[1][v] - p[0][v]) * (double)(p[2][u] - p[0][u]);
        volume += n[a] * (double)p[0][a] / 6;
        facing += n[a] * (double)m.normals[3 * (size_t)m.indices[3 * i] + (size_t)a];
      }
    }
    print_message("%s: %u triangles, %.0f mm3\n", names[k], m.triangle_count, volume);
    assert_true(volume > 100 && facing > 0);
    assert_true(m.triangle_count > 33000 && m.triangle_count < 40000);
    mesh_free(&m);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(middles_inside), cmocka_unit_test(uniform),
                                     cmocka_unit_test(literal), cmocka_unit_test(outward)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
