/* SPDX-License-Identifier: Apache-2.0
 * The atlas against every triangle tried in turn. */
#include "atlases.h"

#include <math.h>
#include <stdlib.h>

typedef struct flat {
  long double x[3], y[3], area;
} flat;

static flat flat_of(const mesh *m, uint32_t t, int udim, uint32_t w, uint32_t h) {
  flat f;
  for (int k = 0; k < 3; k++) {
    const float *uv = m->uvs + 2 * m->indices[3 * t + (uint32_t)k];
    f.x[k] = ((long double)uv[0] - (udim - 1001) % 10) * w;
    f.y[k] = h - ((long double)uv[1] - (udim - 1001) / 10) * h;
  }
  f.area = (f.x[1] - f.x[0]) * (f.y[2] - f.y[0]) - (f.x[2] - f.x[0]) * (f.y[1] - f.y[0]);
  return f;
}

static void weights(const flat *f, long double x, long double y, long double b[3]) {
  for (int k = 0; k < 3; k++) {
    int i = (k + 1) % 3, j = (k + 2) % 3;
    b[k] = ((f->x[j] - f->x[i]) * (y - f->y[i]) - (f->y[j] - f->y[i]) * (x - f->x[i])) / f->area;
  }
}

static long double distance(const flat *f, long double x, long double y, long double at[2]) {
  long double best = INFINITY;
  for (int k = 0; k < 3; k++) {
    int j = (k + 1) % 3;
    long double ex = f->x[j] - f->x[k], ey = f->y[j] - f->y[k];
    long double t = ((x - f->x[k]) * ex + (y - f->y[k]) * ey) / (ex * ex + ey * ey);
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    long double px = f->x[k] + t * ex, py = f->y[k] + t * ey;
    long double d = hypotl(x - px, y - py);
    if (d < best) best = d, at[0] = px, at[1] = py;
  }
  return best;
}

static void blend(const mesh *m, const float *of, uint32_t t, const long double b[3],
                  long double out[3]) {
  for (uint32_t k = 0; k < 3; k++) {
    out[k] = 0;
    for (uint32_t c = 0; c < 3; c++)
      out[k] += b[c] * (long double)of[3 * m->indices[3 * t + c] + k];
  }
}

static bool near3(float *const *array, size_t i, const long double want[3], long double tolerance) {
  for (size_t k = 0; k < 3; k++)
    if (!(fabsl((long double)array[k][i] - want[k]) <= tolerance)) return false;
  return true;
}

static long double footprint_of(const mesh *m, uint32_t t, const flat *f) {
  long double p[3][3];
  for (uint32_t c = 0; c < 3; c++)
    for (uint32_t k = 0; k < 3; k++)
      p[c][k] = (long double)m->points[3 * m->indices[3 * t + c] + k];
  long double n[3], a[3], b[3];
  for (int k = 0; k < 3; k++) a[k] = p[1][k] - p[0][k], b[k] = p[2][k] - p[0][k];
  for (int k = 0; k < 3; k++)
    n[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
  return sqrtl(sqrtl(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / fabsl(f->area));
}

static void unit(long double n[3]) {
  long double l = sqrtl(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (int k = 0; k < 3; k++) n[k] /= l;
}

static bool agrees(const mesh *m, const flat *faces, uint32_t t, const texels *got, size_t i,
                   long double x, long double y, const long double at[2], long double d) {
  long double b[3], point[3], normal[3];
  long double share = d > 2 ? 2 / d : 1;
  weights(&faces[t], at[0] + share * (x - at[0]), at[1] + share * (y - at[1]), b);
  blend(m, m->points, t, b, point);
  weights(&faces[t], at[0], at[1], b);
  blend(m, m->normals, t, b, normal);
  unit(normal);
  long double f = footprint_of(m, t, &faces[t]);
  return near3(got->room.point, i, point, 1e-4L) && near3(got->room.normal, i, normal, 1e-5L) &&
         fabsl((long double)got->room.footprint[i] - f) <= 1e-4L * f;
}

/* One texel: which triangles contain it or are nearest, to within rounding,
 * and whether the answer is one of theirs. */
static void check_texel(const mesh *m, const flat *faces, const texels *got, uint32_t column,
                        uint32_t row) {
  size_t i = (size_t)row * got->w + column;
  long double x = column + 0.5L, y = row + 0.5L, nearest = INFINITY, at[2];
  bool clear = true; /* not on any triangle's side */
  uint32_t first = UINT32_MAX;
  for (uint32_t t = 0; t < m->triangle_count; t++) {
    long double b[3];
    weights(&faces[t], x, y, b);
    long double least = fminl(b[0], fminl(b[1], b[2])), d = distance(&faces[t], x, y, at);
    if (d < 1e-6L) clear = false;
    if (least >= 0 && first == UINT32_MAX) first = t;
    nearest = fminl(nearest, least >= 0 ? 0 : d);
  }
  if (first != UINT32_MAX && clear) {
    at[0] = x, at[1] = y;
    assert_int_equal(got->room.covered[i], 1);
    if (!agrees(m, faces, first, got, i, x, y, at, 0))
      fail_msg("texel %u %u differs from triangle %u", column, row, first);
    return;
  }
  if (first == UINT32_MAX && clear)
    assert_int_equal(got->room.covered[i], nearest <= ATLAS_DILATION ? 2 : 0);
  if (got->room.covered[i] == 0) {
    assert_true(got->room.footprint[i] == 1e4f);
    return;
  }
  for (uint32_t t = 0; t < m->triangle_count; t++) {
    long double d = distance(&faces[t], x, y, at);
    if (d <= nearest + 1e-6L && agrees(m, faces, t, got, i, x, y, at, d)) return;
  }
  fail_msg("texel %u %u, %.9Lg from its chart, shows no nearest triangle", column, row, nearest);
}

static void check_picture(atlas *a, mesh *m, int udim, uint32_t w, uint32_t h) {
  texels got = texels_of(a, udim, w, h);
  flat *faces = malloc(m->triangle_count * sizeof *faces);
  assert_non_null(faces);
  for (uint32_t t = 0; t < m->triangle_count; t++) faces[t] = flat_of(m, t, udim, w, h);
  for (uint32_t row = 0; row < h; row++)
    for (uint32_t column = 0; column < w; column++) check_texel(m, faces, &got, column, row);
  free(faces);
  texels_free(&got);
}

static void points_are_those_of_every_triangle_in_turn(void **state) {
  (void)state;
  mesh m;
  atlas *a = leg_atlas(&m);
  check_picture(a, &m, 1001, 64, 64);
  check_picture(a, &m, 1001, 48, 29);
  check_picture(a, &m, 1001, 8, 8);
  check_picture(a, &m, 1001, 1, 1);
  atlas_close(a);
  mesh_free(&m);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(points_are_those_of_every_triangle_in_turn),
  };
  return cmocka_run_group_tests(tests, atlas_folder, atlas_no_folder);
}
