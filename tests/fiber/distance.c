/* SPDX-License-Identifier: Apache-2.0
 * Row 3: distances and sides against brute force, by what C of a strand is. */
#include <math.h>
#include "fiber.h"

static double brute_sum(const mesh *m, const sozai_curves *c, uint64_t i, uint32_t *inside) {
  double sum = 0;
  *inside = 0;
  for (uint64_t v = c->first[i]; v < c->first[i + 1]; v++) {
    double d = brute_distance(m, c->points + 3 * v);
    int in = fabs(brute_winding(m, c->points + 3 * v)) > 0.5;
    sum += in ? d : -d;
    *inside += (uint32_t)in;
  }
  return sum;
}

/* The mean error of a vertex's distance; sides may differ within 1e-4 mm. */
static double error_of(const mesh *m, const char *values, double *worst) {
  sozai_geometry *g = grow(m, values);
  const sozai_curves *c = curves_of(g);
  sozai_table t = table_of(g, "strands");
  double sum = 0;
  uint32_t n = 0, apart = 0;
  *worst = 0;
  for (uint64_t i = 0; i < c->curve_count; i++) {
    uint32_t inside;
    double brute = brute_sum(m, c, i, &inside), e = fabs(brute - cell(&t, c->ids[i], "sum"));
    uint32_t vertices = (uint32_t)(c->first[i + 1] - c->first[i]);
    apart += (uint32_t)abs((int)inside - (int)cell(&t, c->ids[i], "inside"));
    n += vertices;
    sum += e;
    *worst = fmax(*worst, e / vertices);
  }
  print_message("%s: mean error %.2e mm, worst strand's %.2e, %u of %u sides differ\n", values,
                sum / n, *worst, apart, n);
  assert_true(apart <= n / 2000);
  geometry()->release_curves(c);
  geometry()->release(g);
  return sum / n;
}

static void exact(void **unused) {
  (void)unused;
  double worst;
  failure why;
  mesh m;
  assert_true(hull_make_bunny(&m, 24, &why));
  error_of(&m, "mode=exact count=60 iterations=0", &worst);
  assert_true(worst < 2e-5);
  mesh_free(&m);
  m = box_of(20, 6, 30);
  error_of(&m, "mode=exact count=60 iterations=0", &worst);
  assert_true(worst < 1e-5);
  mesh_free(&m);
}

/* Trilinear between exact nodes: finer cells, smaller errors. */
static void field(void **unused) {
  (void)unused;
  mesh m;
  failure why;
  double worst, coarse, fine;
  assert_true(hull_make_bunny(&m, 24, &why));
  coarse = error_of(&m, "cells=32 count=60 iterations=0", &worst);
  fine = error_of(&m, "cells=128 count=60 iterations=0", &worst);
  assert_true(fine < 0.5 * coarse);
  assert_true(fine < 0.05);
  mesh_free(&m);
}

/* Literally: the nearest of the dense points, by the side of its normal. */
static void literal(void **unused) {
  (void)unused;
  mesh m = hull_of("bunny");
  sozai_buffer b = {.size = sizeof b,
                    .kind = SOZAI_BUFFER_POINTS,
                    .dims = {m.point_count},
                    .points = m.points,
                    .normals = m.normals};
  sozai_geometry *g = NULL;
  assert_int_equal(grow_buffer(NULL, NULL, &b, "mode=literal count=40 iterations=0", &g), SOZAI_OK);
  const sozai_curves *c = curves_of(g);
  sozai_table t = table_of(g, "strands");
  for (uint64_t i = 0; i < c->curve_count; i++) {
    double sum = 0;
    for (uint64_t v = c->first[i]; v < c->first[i + 1]; v++) {
      const float *p = c->points + 3 * v, *q = NULL;
      double best = INFINITY, side = 0;
      size_t which = 0;
      for (size_t k = 0; k < m.point_count; k++) {
        double s = 0;
        q = m.points + 3 * k;
        for (int a = 0; a < 3; a++)
          s += ((double)p[a] - (double)q[a]) * ((double)p[a] - (double)q[a]);
        if (s < best) best = s, which = k;
      }
      for (size_t a = 0; a < 3; a++)
        side += ((double)p[a] - (double)m.points[3 * which + a]) * (double)m.normals[3 * which + a];
      sum += side < 0 ? sqrt(best) : -sqrt(best);
    }
    assert_true(fabs(sum - cell(&t, c->ids[i], "sum")) < 2e-3);
  }
  geometry()->release_curves(c);
  geometry()->release(g);
  mesh_free(&m);
}

/* A hull a kilometre off is as exact as one at the origin. */
static void far_off(void **unused) {
  (void)unused;
  mesh m = box_of(20, 6, 30);
  sozai_geometry *near = grow(&m, "count=50");
  for (uint32_t i = 0; i < m.point_count; i++) m.points[3 * i] += 524288.0f;
  sozai_geometry *far = grow(&m, "count=50");
  sozai_table a = table_of(near, "strands"), b = table_of(far, "strands");
  assert_memory_equal(a.data, b.data, (size_t)a.rows * a.info->column_count * sizeof(float));
  geometry()->release(near);
  geometry()->release(far);
  mesh_free(&m);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(exact), cmocka_unit_test(field),
                                     cmocka_unit_test(literal), cmocka_unit_test(far_off)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
