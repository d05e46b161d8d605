/* SPDX-License-Identifier: Apache-2.0
 * Row 14: hulls that are wrong: one clear line, or the inside that the header
 * promises. */
#include <math.h>
#include <stdio.h>
#include "fiber.h"

static void refused(const sozai_buffer *b, const char *values, int32_t code, const char *words) {
  sozai_geometry *g = (sozai_geometry *)(uintptr_t)1;
  int32_t r = grow_buffer(NULL, NULL, b, values, &g);
  const char *why = r ? geometry()->last_error() : "it grew";
  print_message("  %s\n", why);
  assert_int_equal(r, code);
  assert_null(g);
  assert_non_null(strstr(why, words));
  assert_null(strchr(why, '\n'));
}

static void messages(void **unused) {
  (void)unused;
  float p[12] = {0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10};
  uint32_t t[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  sozai_buffer b = {
      .size = sizeof b, .kind = SOZAI_BUFFER_MESH, .dims = {4, 4}, .points = p, .indices = t};
  refused(NULL, "count=5", SOZAI_ERROR_ARGUMENT, "hull: none is given");
  sozai_buffer none = b;
  none.dims[0] = none.dims[1] = 0;
  refused(&none, "count=5", SOZAI_ERROR_RANGE, "hull: a mesh of 0 points and 0 triangles");
  sozai_buffer one = b;
  one.dims[1] = 1;
  refused(&one, "count=5", SOZAI_ERROR_RANGE, "hull:");
  refused(&one, "count=5 mode=exact", SOZAI_ERROR_RANGE, "enclose");
  const float wrong[] = {NAN, INFINITY, -INFINITY, 1e30f, -2e6f};
  for (int i = 0; i < 5; i++) {
    p[4] = wrong[i];
    refused(&b, "count=5", SOZAI_ERROR_RANGE, "hull: y of point 1 is");
    refused(&b, "count=5 mode=literal", SOZAI_ERROR_RANGE, "hull: y of point 1 is");
  }
  p[4] = 0;
  float line[12] = {0, 0, 0, 10, 0, 0, 5, 0, 0, 2, 0, 0},
        same[12] = {3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3};
  b.points = line;
  refused(&b, "count=5", SOZAI_ERROR_RANGE, "none of its 4 triangles has any area");
  refused(&b, "count=5 mode=literal", SOZAI_ERROR_RANGE, "none of its 4 triangles has any area");
  b.points = same;
  refused(&b, "count=5", SOZAI_ERROR_RANGE, "the longest side of its box is 0 mm");
  b.points = p;
  t[4] = 4;
  refused(&b, "count=5", SOZAI_ERROR_RANGE, "index 4 is not below the 4 points");
  t[4] = 1;
  b.kind = SOZAI_BUFFER_TABLE;
  refused(&b, "count=5", SOZAI_ERROR_KIND, "hull:");
  b.kind = SOZAI_BUFFER_POINTS;
  refused(&b, "count=5 mode=literal", SOZAI_ERROR_RANGE, "normals are missing");
  b.normals = p;
  refused(&b, "count=5", SOZAI_ERROR_RANGE, "hull_points: goes with mode=literal");
  b.kind = SOZAI_BUFFER_MESH;
  refused(&b, "mode=literal count=0", SOZAI_ERROR_RANGE, "count: 0");
  refused(&b, "count=50000000 vertices=1024", SOZAI_ERROR_LIMIT, "count: 50000000 strands");
  refused(&b, "mode=literal spacing=1e-5 count=3", SOZAI_ERROR_LIMIT, "spacing: 1e-05 mm asks for");
  refused(&b, "count=-1", SOZAI_ERROR_RANGE, "count: -1 is outside");
  refused(&b, "length=nan", SOZAI_ERROR_RANGE, "length: nan is outside");
  refused(&b, "diameter=1e30", SOZAI_ERROR_RANGE, "diameter: 1e+30 is outside");
  refused(&b, "mode=fast", SOZAI_ERROR_RANGE, "mode: \"fast\" is none of");
}

/* How many of the middles are where `in` says. */
static double share(const mesh *m, const char *values, int (*in)(const float p[3])) {
  sozai_geometry *g = grow(m, values);
  const sozai_curves *c = curves_of(g);
  uint32_t n = 0;
  for (uint64_t i = 0; i < c->curve_count; i++) n += (uint32_t)in(c->points + 3 * (2 * i + 1));
  double r = (double)n / (double)c->curve_count;
  geometry()->release_curves(c);
  geometry()->release(g);
  return r;
}

#define DOTS "count=3000 vertices=2 length=0.001 iterations=0"

static int in_box(const float p[3]) {
  return fabsf(p[0]) <= 10.001f && fabsf(p[1]) <= 5.001f && fabsf(p[2]) <= 10.001f;
}

static int left_half(const float p[3]) { return p[0] < 0; }

static void turn_over(mesh *m, uint32_t from, uint32_t to) {
  for (size_t i = from; i < to; i++) {
    uint32_t keep = m->indices[3 * i + 1];
    m->indices[3 * i + 1] = m->indices[3 * i + 2];
    m->indices[3 * i + 2] = keep;
  }
}

static void inverted(void **unused) {
  (void)unused;
  mesh m = box_of(20, 10, 20);
  turn_over(&m, 0, 12);
  assert_true(share(&m, DOTS, in_box) == 1);
  assert_true(share(&m, DOTS " mode=exact", in_box) == 1);
  /* and every other face: closed, of no direction */
  turn_over(&m, 0, 5);
  sozai_geometry *g = grow(&m, DOTS);
  assert_true(statistic(g, "hull_rule") == 1);
  geometry()->release(g);
  assert_true(share(&m, DOTS, in_box) == 1);
  mesh_free(&m);
}

/* A box without its lid: closed by the vote, all of it and nothing else. */
static void open_box(void **unused) {
  (void)unused;
  for (uint32_t face = 0; face < 6; face++) {
    mesh m = box_of(20, 10, 20);
    memmove(m.indices + 6 * face, m.indices + 6 * (face + 1), (5 - face) * 6 * sizeof *m.indices);
    m.triangle_count = 10;
    sozai_geometry *g = grow(&m, DOTS);
    assert_true(statistic(g, "hull_rule") == 2);
    assert_true(fabs(statistic(g, "hull_volume") / 4000 - 1) < 0.05);
    geometry()->release(g);
    assert_true(share(&m, DOTS, in_box) == 1);
    double left = share(&m, DOTS, left_half);
    assert_true(fabs(left - 0.5) < 0.04);
    mesh_free(&m);
  }
}

/* Two meshes as one; the second moved by x. */
static mesh joined(const mesh *a, const mesh *b, float x) {
  mesh m;
  failure why;
  assert_true(mesh_allocate(&m, a->point_count + b->point_count,
                            a->triangle_count + b->triangle_count, &why));
  memcpy(m.points, a->points, a->point_count * 12);
  memcpy(m.points + 3 * a->point_count, b->points, b->point_count * 12);
  for (size_t i = 0; i < b->point_count; i++) m.points[3 * (a->point_count + i)] += x;
  memcpy(m.indices, a->indices, a->triangle_count * 12);
  for (size_t i = 0; i < 3 * (size_t)b->triangle_count; i++)
    m.indices[3 * a->triangle_count + i] = b->indices[i] + a->point_count;
  return m;
}

static int in_two(const float p[3]) {
  return fabsf(p[1]) <= 5.001f && fabsf(p[2]) <= 10.001f &&
         (fabsf(p[0]) <= 10.001f || fabsf(p[0] - 30) <= 10.001f);
}

static int in_long(const float p[3]) {
  return fabsf(p[1]) <= 5.001f && fabsf(p[2]) <= 10.001f && p[0] >= -10.001f && p[0] <= 18.001f;
}

static int overlap(const float p[3]) { return p[0] >= -2 && p[0] <= 10; }

static void two(void **unused) {
  (void)unused;
  mesh a = box_of(20, 10, 20), b = box_of(20, 10, 20);
  mesh apart = joined(&a, &b, 30), crossing = joined(&a, &b, 8);
  assert_true(share(&apart, DOTS, in_two) == 1);
  assert_true(fabs(share(&apart, DOTS, in_box) - 0.5) < 0.04);
  /* where they cross is inside like the rest */
  assert_true(share(&crossing, DOTS, in_long) == 1);
  assert_true(fabs(share(&crossing, DOTS, overlap) - 12.0 / 28) < 0.04);
  mesh_free(&apart);
  mesh_free(&crossing);
  /* a cavity */
  mesh small = box_of(10, 5, 10);
  turn_over(&small, 0, 12);
  mesh hollow = joined(&a, &small, 0);
  sozai_geometry *g = grow(&hollow, DOTS);
  assert_true(fabs(statistic(g, "hull_volume") / 3500 - 1) < 0.02);
  geometry()->release(g);
  mesh_free(&hollow);
  mesh_free(&small);
  mesh_free(&a);
  mesh_free(&b);
}

/* Zero-area triangles among good ones, points there twice, triangles there
 * twice: no matter. */
static void dirty(void **unused) {
  (void)unused;
  mesh m, a = box_of(20, 10, 20);
  failure why;
  assert_true(mesh_allocate(&m, a.point_count, a.triangle_count + 3, &why));
  memcpy(m.points, a.points, a.point_count * 12);
  memcpy(m.indices, a.indices, a.triangle_count * 12);
  const uint32_t bad[9] = {0, 0, 1, 2, 2, 2, 3, 1, 3};
  memcpy(m.indices + 3 * a.triangle_count, bad, sizeof bad);
  assert_true(share(&m, DOTS, in_box) == 1);
  mesh_free(&m);
  mesh twice = joined(&a, &a, 0);
  assert_true(share(&twice, DOTS, in_box) == 1);
  mesh_free(&twice);
  mesh_free(&a);
}

/* A needle's and a sheet's hull: something, or one line; and soon. */
static void thin(void **unused) {
  (void)unused;
  const double sizes[][3] = {
      {100, 1e-4, 100}, {1e-4, 1e-4, 100}, {1e-2, 1e-2, 1e-2}, {1e6, 1e6, 1e6}};
  for (int k = 0; k < 4; k++) {
    mesh m = box_of(sizes[k][0], sizes[k][1], sizes[k][2]);
    sozai_geometry *g = NULL;
    int32_t r = grow_code(NULL, &m, "count=50 attempts=20000", &g);
    print_message("  %s\n", r ? geometry()->last_error() : "grew");
    assert_true(r == SOZAI_OK || r == SOZAI_ERROR_RANGE);
    geometry()->release(g);
    mesh_free(&m);
  }
}

/* Triangles at random. */
static void soup(void **unused) {
  (void)unused;
  mesh m;
  failure why;
  assert_true(mesh_allocate(&m, 900, 300, &why));
  uint32_t h = 1;
  for (uint32_t i = 0; i < 2700; i++) {
    h = h * 747796405u + 2891336453u;
    m.points[i] = (float)(h >> 8) / 838860.8f;
  }
  for (uint32_t i = 0; i < 900; i++) m.indices[i] = i;
  sozai_geometry *g = NULL;
  static const char *const values[] = {"count=50", "count=50 mode=exact", "count=50 mode=literal"};
  for (int k = 0; k < 3; k++) {
    int32_t r = grow_code(NULL, &m, values[k], &g);
    assert_true(r == SOZAI_OK || r == SOZAI_ERROR_RANGE);
    geometry()->release(g);
  }
  mesh_free(&m);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(messages), cmocka_unit_test(inverted),
                                     cmocka_unit_test(open_box), cmocka_unit_test(two),
                                     cmocka_unit_test(dirty),    cmocka_unit_test(thin),
                                     cmocka_unit_test(soup)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
