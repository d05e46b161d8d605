/* SPDX-License-Identifier: Apache-2.0
 * Row 9: strands kept apart, and the count that fills a hull. */
#include <math.h>
#include "fiber.h"

#define STRANDS 250
#define TEXT "count=250 length=8 diameter=250 vertices=16 theta_max=20 seed=3 "

static double clearance(const sozai_curves *c, uint64_t i, uint64_t k) {
  double best = INFINITY;
  for (uint64_t a = c->first[i]; a + 1 < c->first[i + 1]; a++)
    for (uint64_t b = c->first[k]; b + 1 < c->first[k + 1]; b++) {
      const float *p = c->points + 3 * a, *q = c->points + 3 * b;
      double gap = 0; /* what cannot touch is not worth a bisection */
      for (int d = 0; d < 3; d++) gap = fmax(gap, fabs((double)p[d] - (double)q[d]));
      if (gap < 1.8)
        best = fmin(best, brute_segments(p, q) - (double)c->radii[a] - (double)c->radii[b]);
    }
  return best;
}

static double deepest(const sozai_geometry *g) {
  const sozai_curves *c = curves_of(g);
  double least = INFINITY;
  for (uint64_t i = 0; i < c->curve_count; i++)
    for (uint64_t k = 0; k < i; k++) least = fmin(least, clearance(c, i, k));
  geometry()->release_curves(c);
  return -least;
}

static void apart(void **unused) {
  (void)unused;
  mesh m = hull_of("ball");
  static const char *const ways[] = {TEXT "contact=off", TEXT "contact=rigid rounds=300",
                                     TEXT "contact=bend rounds=300"};
  for (int k = 0; k < 3; k++) {
    sozai_geometry *g = grow(&m, ways[k]);
    double deep = deepest(g);
    print_message("%s: deepest overlap %.4f mm, contacts %.0f of %.0f, %.0f rounds, inside %.4f\n",
                  ways[k], deep, statistic(g, "contacts"), statistic(g, "contacts_first"),
                  statistic(g, "contact_rounds"), statistic(g, "inside"));
    if (k == 0) {
      assert_true(deep > 0.1); /* there is something to do */
    } else {
      assert_true(statistic(g, "contacts_first") > 50);
      assert_true(statistic(g, "contacts") == 0);
      assert_true(deep < 1e-4);
      assert_true(statistic(g, "inside") > 0.97);
    }
    geometry()->release(g);
  }
  mesh_free(&m);
}

/* Lengths stay either way; moved whole, shapes too; bent, the bends' statistics. */
static void kept(void **unused) {
  (void)unused;
  mesh m = hull_of("ball");
  sozai_geometry *before = grow(&m, TEXT "contact=off");
  static const char *const ways[] = {TEXT "contact=rigid", TEXT "contact=bend"};
  for (int k = 0; k < 2; k++) {
    sozai_geometry *after = grow(&m, ways[k]);
    const sozai_curves *a = curves_of(before), *b = curves_of(after);
    double shape = 0, stretch = 0, mean[2] = {0, 0};
    for (uint64_t i = 0; i < a->curve_count; i++) {
      for (int w = 0; w < 2; w++) {
        const float *p = (w ? b : a)->points + 48 * i;
        for (int v = 0; v + 2 < 16; v++) {
          double dot = 0, l[2] = {0, 0};
          for (int d = 0; d < 3; d++) {
            double x = (double)(p[3 * v + 3 + d] - p[3 * v + d]),
                   y = (double)(p[3 * v + 6 + d] - p[3 * v + 3 + d]);
            dot += x * y, l[0] += x * x, l[1] += y * y;
          }
          mean[w] += acos(fmin(1, dot / sqrt(l[0] * l[1])));
          if (w) stretch = fmax(stretch, fabs(sqrt(l[0]) - 8.0 / 15));
        }
        double e = 0;
        for (int d = 0; d < 3; d++) e += (double)(p[45 + d] - p[d]) * (double)(p[45 + d] - p[d]);
        if (w == 0)
          shape = sqrt(e);
        else if (k == 0)
          assert_true(fabs(sqrt(e) - shape) < 5e-5);
      }
    }
    print_message("%s: mean bend %.4f before, %.4f after; segments off by %.1e mm\n", ways[k],
                  mean[0] / (250 * 14), mean[1] / (250 * 14), stretch);
    assert_true(stretch < 5e-6);
    assert_true(fabs(mean[1] / mean[0] - 1) < (k ? 0.1 : 1e-3));
    geometry()->release_curves(a);
    geometry()->release_curves(b);
    geometry()->release(after);
  }
  geometry()->release(before);
  mesh_free(&m);
}

/* Felt's crimp where nearly every strand overlaps others: bent, it stays, and little overlaps. */
static double mean_bend(const sozai_geometry *g) {
  const sozai_curves *c = curves_of(g);
  double sum = 0;
  uint64_t joints = 0;
  for (uint64_t i = 0; i < c->curve_count; i++)
    for (uint64_t v = c->first[i]; v + 2 < c->first[i + 1]; v++, joints++) {
      const float *p = c->points + 3 * v;
      double dot = 0, l[2] = {0, 0};
      for (int d = 0; d < 3; d++) {
        double x = (double)(p[3 + d] - p[d]), y = (double)(p[6 + d] - p[3 + d]);
        dot += x * y, l[0] += x * x, l[1] += y * y;
      }
      sum += acos(fmin(1, dot / sqrt(l[0] * l[1]))) * 180 / 3.14159265;
    }
  geometry()->release_curves(c);
  return sum / (double)joints;
}

#define FELT                                                                                       \
  "count=0 packing=0.05 diameter=150 length=6 phi_min=-90 phi_max=90 theta_min=-14 theta_max=26 "

static void crimp_stays(void **unused) {
  (void)unused;
  mesh m = box_of(14, 14, 14);
  sozai_geometry *before = grow(&m, FELT "contact=off"), *after = grow(&m, FELT "contact=bend");
  double bend[2] = {mean_bend(before), mean_bend(after)};
  print_message("felt, packing 0.05: mean bend %.2f degrees before, %.2f after; contacts %.0f of "
                "%.0f, of %.0f strands of %.0f\n",
                bend[0], bend[1], statistic(after, "contacts"), statistic(after, "contacts_first"),
                statistic(after, "contact_strands"), statistic(after, "strands"));
  assert_true(fabs(bend[1] / bend[0] - 1) < 0.05);
  assert_true(statistic(after, "contacts") < 0.01 * statistic(after, "contacts_first"));
  geometry()->release(before);
  geometry()->release(after);
  mesh_free(&m);
}

/* count=0: so many that their volume is the packing's share of the hull's. */
static void packed(void **unused) {
  (void)unused;
  mesh m = box_of(20, 10, 30);
  sozai_geometry *g =
      grow(&m, "count=0 packing=0.02 diameter=80 length=6 diameter_spread=0.2 taper=0.5");
  const sozai_curves *c = curves_of(g);
  double volume = 0;
  for (uint64_t i = 0; i < c->curve_count; i++)
    for (uint64_t v = c->first[i]; v + 1 < c->first[i + 1]; v++) {
      double l = 0, r = (double)c->radii[v], s = (double)c->radii[v + 1];
      for (int d = 0; d < 3; d++) {
        double x =
            (double)c->points[3 * v + 3 + (uint64_t)d] - (double)c->points[3 * v + (uint64_t)d];
        l += x * x;
      }
      volume += 3.14159265 * (r * r + r * s + s * s) / 3 * sqrt(l);
    }
  print_message("packing asked 0.02, measured %.5f, its table says %.5f; hull %.1f mm3\n",
                volume / 6000, statistic(g, "packing"), statistic(g, "hull_volume"));
  assert_true(fabs(statistic(g, "hull_volume") / 6000 - 1) < 0.01);
  assert_true(fabs(volume / 6000 / 0.02 - 1) < 0.02);
  assert_true(fabs(statistic(g, "packing") / 0.02 - 1) < 0.02);
  geometry()->release_curves(c);
  geometry()->release(g);
  mesh_free(&m);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(apart), cmocka_unit_test(kept),
                                     cmocka_unit_test(crimp_stays), cmocka_unit_test(packed)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
