/* SPDX-License-Identifier: Apache-2.0
 * Section 6.1 of the paper on its own preset: spacings, lengths, angles and the
 * parabola of needles; and the cherry's leaves of section 5.1. */
#include <math.h>

#include "tree.h"

static double part(const float *a, const float *b, double d[3]) {
  double sum = 0;
  for (int c = 0; c < 3; c++) d[c] = (double)b[c] - (double)a[c], sum += d[c] * d[c];
  return sqrt(sum);
}

/* Spacings along the straight axis of curve `parent` of the curves from..to on it. */
typedef struct {
  double spacing, length, angle, parabola; /* worst errors */
  uint64_t count;
} worst;

static worst of_order(const sozai_curves *c, const uint64_t *parents, uint64_t from, uint64_t to,
                      double spacing, double longest, int parabola) {
  worst w = {0, 0, 0, 0, to - from};
  uint64_t last = UINT64_MAX;
  double before = 0;
  for (uint64_t i = from; i < to; i++) {
    const float *p = c->points + 3 * c->first[i], *tip = c->points + 3 * (c->first[i + 1] - 1);
    uint64_t parent = parents[i];
    const float *q = c->points + 3 * c->first[parent],
                *end = c->points + 3 * (c->first[parent + 1] - 1);
    double along[3], own[3], off[3];
    double whole = part(q, end, along), length = part(p, tip, own), at = part(q, p, off);
    if (parent != last) before = 0;
    last = parent;
    w.spacing = fmax(w.spacing, fabs(at - before - spacing));
    before = at;
    double dot = 0;
    for (int k = 0; k < 3; k++) dot += along[k] * own[k] / whole / length;
    w.angle = fmax(w.angle, fabs(acos(dot) * 180 / 3.14159265358979 - 80));
    double want = longest * (parabola ? sqrt(fmax(0, 1 - at / whole)) : 1);
    w.length = fmax(w.length, fabs(length - want));
  }
  return w;
}

static void the_papers_sugi(void **unused) {
  (void)unused;
  sozai_geometry *g = grow("sugi_paper", "age=7 foliage=full", NULL);
  const sozai_curves *c = curves_of(g, 0);
  double n1 = statistic(g, "first_order"), n2 = statistic(g, "second_order"),
         n3 = statistic(g, "third_order"), n4 = statistic(g, "fourth_order");
  assert_int_equal(c->curve_count, (uint64_t)(1 + n1 + n2 + n3 + n4));
  /* parents by nearness of numbers: shoots of a branch follow it at once, a
   * needle's id is its shoot's */
  uint64_t *parents = calloc(c->curve_count, sizeof *parents), first = 1 + (uint64_t)n1;
  uint64_t branch = 1, second = first;
  double seconds = 0, thirds = 0, needles = 0, wanted[3] = {0, 0, 0};
  int *order = calloc(c->curve_count, sizeof *order);
  for (uint64_t i = first; i < first + (uint64_t)(n2 + n3); i++) {
    double d[3], off[3];
    const float *p = c->points + 3 * c->first[i];
    double length = part(p, c->points + 3 * (c->first[i + 1] - 1), d);
    if (fabs(length - 200) < 0.01) {
      order[i] = 2;
      second = i;
      /* its place on some branch: the present or a later one */
      for (;; branch++) {
        assert_true(branch < first);
        const float *q = c->points + 3 * c->first[branch],
                    *end = c->points + 3 * (c->first[branch + 1] - 1);
        double whole = part(q, end, d), at = part(q, p, off), miss = 0;
        for (int k = 0; k < 3; k++) miss += fabs(off[k] - at * d[k] / whole);
        if (miss < 0.05 && at > 1) break;
      }
      parents[i] = branch;
      seconds++;
    } else {
      order[i] = 3;
      parents[i] = second;
      thirds++;
    }
  }
  assert_true(seconds == n2 && thirds == n3);
  for (uint64_t i = first + (uint64_t)(n2 + n3); i < c->curve_count; i++) {
    parents[i] = c->ids[i];
    needles++;
    assert_int_equal(order[parents[i]], 3);
  }
  worst w2 = {0}, w3 = {0}, w4 = {0};
  for (uint64_t i = first; i < c->curve_count; i++) {
    uint64_t end = i + 1;
    while (end < c->curve_count && parents[end] == parents[i] && order[end] == order[i]) end++;
    if (order[i] == 2) {
      /* thirds lie between: take the seconds of this branch alone */
      end = i + 1;
    }
    if (order[i] == 2) continue;
    worst w = of_order(c, parents, i, end, order[i] == 3 ? 20 : 3, order[i] == 3 ? 60 : 15, 1);
    worst *to = order[i] == 3 ? &w3 : &w4;
    to->spacing = fmax(to->spacing, w.spacing);
    to->length = fmax(to->length, w.length);
    to->angle = fmax(to->angle, w.angle);
    i = end - 1;
  }
  double before = 0;
  uint64_t on = 0;
  for (uint64_t i = first; i < c->curve_count && order[i]; i++) {
    if (order[i] != 2) continue;
    double off[3];
    double at = part(c->points + 3 * c->first[parents[i]], c->points + 3 * c->first[i], off);
    if (parents[i] != on) before = 0;
    on = parents[i];
    w2.spacing = fmax(w2.spacing, fabs(at - before - 50));
    before = at;
    worst w = of_order(c, parents, i, i + 1, 50, 200, 0);
    w2.length = fmax(w2.length, w.length);
    w2.angle = fmax(w2.angle, w.angle);
  }
  /* as many as fit: below the branch's end, a spacing apart */
  sozai_table t = table_of(g, "branches");
  for (uint64_t i = 1; i < t.rows; i++) wanted[0] += ceil(cell(&t, i, "length") / 50 - 1e-4) - 1;
  print_message("%.0f branches, %.0f second (%.0f fit), %.0f third, %.0f needles\n", n1, n2,
                wanted[0], n3, n4);
  print_message("2nd: spacing off %.3f mm, length %.3f mm, angle %.3f deg\n", w2.spacing, w2.length,
                w2.angle);
  print_message("3rd: %.3f, %.3f, %.3f; needles: %.3f, %.3f, %.3f\n", w3.spacing, w3.length,
                w3.angle, w4.spacing, w4.length, w4.angle);
  assert_true(fabs(n2 - wanted[0]) <= 1);
  assert_true(w2.spacing < 0.05 && w3.spacing < 0.05 && w4.spacing < 0.05);
  assert_true(w2.length < 0.05 && w3.length < 0.05 && w4.length < 0.05);
  assert_true(w2.angle < 0.1 && w3.angle < 0.2 && w4.angle < 1.0);
  free(parents);
  free(order);
  geometry()->release_curves(c);
  geometry()->release(g);
}

/* An upright branch has no level direction of its own: the paper's Y = -(x/y)X
 * divides by zero there. Ellipses stand 5 cm out, at sites 6 cm apart. */
static void cherry_leaves(void **unused) {
  (void)unused;
  static const char *const fields[] = {"trunk\n100 0 90 5\n100 0 90 4\nB100\n0\n61 90 0 1\n",
                                       "trunk\n100 0 90 5\n100 0 90 4\nB100\n0\n61 0 90 1\n",
                                       "trunk\n100 0 90 5\n100 0 90 4\nB100\n0\n61 180 30 1\n"};
  for (int k = 0; k < 3; k++) {
    sozai_geometry *g = grow("cherry_paper", "", fields[k]);
    /* 61 cm: ten sites of three */
    double leaves = statistic(g, "fourth_order");
    const sozai_mesh *m = mesh_of(g, 0);
    const sozai_part *leaf = &m->parts[m->part_count - 1];
    assert_string_equal(leaf->id, "leaf");
    assert_int_equal(leaf->count, (uint64_t)leaves * 10);
    double far = 0, near = 1e9;
    uint32_t last = UINT32_MAX;
    for (uint64_t i = 3 * leaf->first; i < 3 * (leaf->first + leaf->count); i++) {
      uint32_t p = m->indices[i];
      if (p == last) continue;
      last = p;
      for (int c = 0; c < 3; c++) assert_true(isfinite(m->points[3 * p + (uint32_t)c]));
      if (m->owner[p] != 1) continue;
    }
    /* an ellipse's middle lies between its first point and its seventh */
    for (uint64_t i = 0; i < (uint64_t)leaves; i++) {
      uint32_t p = m->indices[3 * (leaf->first + 10 * i)];
      if (m->owner[p] != 1) continue;
      double middle[3], d2 = 0, along = 0;
      double t = k == 0 ? 0 : k == 1 ? 90 : 30, east = k == 0, south = k == 2;
      t *= 3.14159265358979 / 180;
      double axis[3] = {east * cos(t), sin(t), south * cos(t)};
      for (uint32_t c = 0; c < 3; c++)
        middle[c] = 0.5 * ((double)m->points[3 * p + c] + (double)m->points[3 * (p + 6) + c]) -
                    (c == 1 ? 1000 : 0);
      for (int c = 0; c < 3; c++) d2 += middle[c] * middle[c], along += middle[c] * axis[c];
      double out = sqrt(fmax(0, d2 - along * along));
      far = fmax(far, out);
      near = fmin(near, out);
    }
    print_message("case %d: %.0f leaves, %.3f to %.3f mm from the branch\n", k, leaves, near, far);
    assert_int_equal((int)leaves % 3, 0);
    assert_true(leaves >= 30);
    assert_true(fabs(near - 50) < 0.05 && fabs(far - 50) < 0.05);
    geometry()->release_mesh(m);
    geometry()->release(g);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(the_papers_sugi),
                                     cmocka_unit_test(cherry_leaves)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
