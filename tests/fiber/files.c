/* SPDX-License-Identifier: Apache-2.0
 * Row 12: what `sozai grow fiber` writes is what the plugin grew. */
#include <math.h>
#include <stdio.h>
#include <unistd.h>
#include "fiber.h"
#include "readers.h"

#define TEXT "count=60 length=6 vertices=12 diameter=90 taper=0.4 share_2=0.3 length_spread=0.2"
static const char *const options =
    "-p count=60 -p length=6 -p vertices=12 -p diameter=90 -p taper=0.4 "
    "-p share_2=0.3 -p length_spread=0.2";

static void written(const char *path) {
  char command[2048];
  snprintf(command, sizeof command, "%s grow fiber --hull ball -o %s %s", SOZAI_TEST_COMMAND, path,
           options);
  assert_int_equal(system(command), 0);
}

static void compare(const strands_read *s, const sozai_curves *c, bool widths, double linear) {
  assert_int_equal(s->curves, c->curve_count);
  assert_int_equal(s->points, c->point_count);
  for (uint64_t i = 0; i < c->curve_count; i++) {
    assert_int_equal(s->counts[i], c->first[i + 1] - c->first[i]);
    if (s->ids) assert_int_equal(s->ids[i], c->ids[i]);
  }
  for (uint64_t i = 0; i < 3 * c->point_count; i++)
    assert_true(fabsf(s->at[i] - c->points[i]) < 2e-6f);
  /* a width is a diameter */
  for (uint64_t i = 0; widths && i < c->point_count; i++)
    assert_true(fabsf(s->widths[i] - 2 * c->radii[i]) < 1e-6f);
  for (int k = 0; widths && k < 3; k++) {
    double x = (double)c->parts[0].colour[k];
    if (linear > 0) x = x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4);
    assert_true(fabs(x - (double)s->colour[k]) < 1e-4);
  }
}

static void round_trips(void **unused) {
  (void)unused;
  char folder[] = "/tmp/sozai-fiber-XXXXXX", path[256];
  assert_non_null(mkdtemp(folder));
  mesh m = hull_of("ball");
  sozai_geometry *g = grow(&m, TEXT);
  const sozai_curves *c = curves_of(g);
  assert_int_equal(c->part_count, 2);
  assert_int_equal(c->parts[0].count + c->parts[1].count, 60);
  strands_read s;
  snprintf(path, sizeof path, "%s/a.hair", folder);
  written(path);
  assert_true(read_hair(&s, path));
  compare(&s, c, true, 0);
  strands_read_free(&s);
  unlink(path);
  snprintf(path, sizeof path, "%s/a.usda", folder);
  written(path);
  assert_true(read_usd(&s, path));
  compare(&s, c, true, 1);
  strands_read_free(&s);
  unlink(path);
  snprintf(path, sizeof path, "%s/a.obj", folder);
  written(path);
  assert_true(read_obj(&s, path));
  compare(&s, c, false, 0);
  strands_read_free(&s);
  unlink(path);
  rmdir(folder);
  geometry()->release_curves(c);
  geometry()->release(g);
  mesh_free(&m);
}

/* Levels: about half each, both ends kept; tubes closed and as thick as they
 * should be. */
static void levels(void **unused) {
  (void)unused;
  mesh m = hull_of("ball");
  sozai_geometry *g = grow(&m, TEXT);
  const sozai_curves *all = curves_of(g);
  for (uint32_t level = 1; level <= 8; level++) {
    const sozai_detail detail = {.size = sizeof detail, .level = level};
    const sozai_curves *c = NULL;
    assert_int_equal(geometry()->curves(g, &detail, &c), SOZAI_OK);
    assert_true(c->curve_count >= 1 && c->point_count >= 2 * c->curve_count);
    if (level == 1) assert_int_equal(c->point_count, 60 * 7);
    if (c->curve_count == 60)
      for (uint64_t i = 0; i < 60; i++) {
        assert_memory_equal(c->points + 3 * c->first[i], all->points + 3 * all->first[i], 12);
        assert_memory_equal(c->points + 3 * (c->first[i + 1] - 1),
                            all->points + 3 * (all->first[i + 1] - 1), 12);
      }
    geometry()->release_curves(c);
  }
  const sozai_mesh *t = NULL;
  assert_int_equal(geometry()->mesh(g, NULL, &t), SOZAI_OK);
  double volume = 0, expected = 0;
  for (uint64_t i = 0; i < t->triangle_count; i++) {
    const float *p = t->points + 3 * (size_t)t->indices[3 * i],
                *q = t->points + 3 * (size_t)t->indices[3 * i + 1],
                *r = t->points + 3 * (size_t)t->indices[3 * i + 2];
    volume += ((double)p[0] * ((double)q[1] * (double)r[2] - (double)q[2] * (double)r[1]) +
               (double)p[1] * ((double)q[2] * (double)r[0] - (double)q[0] * (double)r[2]) +
               (double)p[2] * ((double)q[0] * (double)r[1] - (double)q[1] * (double)r[0])) /
              6;
  }
  for (uint64_t i = 0; i < all->curve_count; i++)
    for (uint64_t v = all->first[i]; v + 1 < all->first[i + 1]; v++) {
      double l = 0, a = (double)all->radii[v], b = (double)all->radii[v + 1];
      for (uint64_t d = 0; d < 3; d++)
        l += pow((double)all->points[3 * v + 3 + d] - (double)all->points[3 * v + d], 2);
      expected += sqrt(l) * (a * a + a * b + b * b) / 3 * 3 * sqrt(3) / 2; /* six sides */
    }
  print_message("tubes: %.4f mm3, hexagons of the curves: %.4f\n", volume, expected);
  assert_true(fabs(volume / expected - 1) < 0.03);
  geometry()->release_mesh(t);
  geometry()->release_curves(all);
  geometry()->release(g);
  mesh_free(&m);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(round_trips), cmocka_unit_test(levels)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
