/* SPDX-License-Identifier: Apache-2.0
 * The atlas against every triangle tried in turn. */
#include "atlas.h"

#include <math.h>
#include <stdarg.h>
#include <setjmp.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <cmocka.h>
#include <assimp/cexport.h>
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include "mesh.h"
#include "meshes.h"

#define SIDE 200u /* texels of the pictures compared whole */

/* ---- files --------------------------------------------------------------- */

static char folder[] = "/tmp/sozai-atlas-XXXXXX";

static int make_folder(void **state) {
  (void)state;
  return mkdtemp(folder) ? 0 : -1;
}

static int remove_folder(void **state) {
  (void)state;
  return rmdir(folder);
}

static const char *path_of(const char *name) {
  static char path[256];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  return path;
}

static FILE *begin(const char *name) {
  FILE *file = fopen(path_of(name), "w");
  assert_non_null(file);
  return file;
}

/* Opens what was written, and removes it. */
static atlas *finish(FILE *file, const char *name, mesh *also) {
  failure why;
  atlas *a = NULL;
  assert_int_equal(fclose(file), 0);
  if (!atlas_open(&a, path_of(name), 1, &why)) fail_msg("%s", why.text);
  if (also) assert_true(mesh_read(also, path_of(name), 1, &why));
  assert_int_equal(unlink(path_of(name)), 0);
  return a;
}

static atlas *box(bool udim, mesh *also) {
  FILE *file = begin("box.obj");
  write_box(file, 20, udim);
  return finish(file, "box.obj", also);
}

static atlas *leg(mesh *also) {
  FILE *file = begin("leg.obj");
  write_leg(file, 24, 32);
  return finish(file, "leg.obj", also);
}

/* A mesh of given triangles: nine numbers of points and six of UVs each. */
static atlas *triangles(const float (*t)[15], unsigned count) {
  FILE *file = begin("few.obj");
  for (unsigned i = 0; i < count; i++) {
    for (int k = 0; k < 3; k++)
      fprintf(file, "v %.9g %.9g %.9g\nvt %.9g %.9g\n", (double)t[i][3 * k],
              (double)t[i][3 * k + 1], (double)t[i][3 * k + 2], (double)t[i][9 + 2 * k],
              (double)t[i][10 + 2 * k]);
    fputs("f -3/-3 -2/-2 -1/-1\n", file);
  }
  return finish(file, "few.obj", NULL);
}

static void refused(const char *text, const char *name, const char *const *words) {
  FILE *file = begin(name);
  fputs(text, file);
  assert_int_equal(fclose(file), 0);
  failure why = {0};
  atlas *a = NULL;
  bool opened = atlas_open(&a, path_of(name), 1, &why);
  assert_int_equal(unlink(path_of(name)), 0);
  if (opened) fail_msg("%s was opened", name);
  assert_null(a);
  assert_int_equal(why.exit_code, EXIT_BAD_INPUT);
  for (; *words; words++)
    if (!strstr(why.text, *words)) fail_msg("'%s' is not in: %s", *words, why.text);
}

/* ---- pictures -------------------------------------------------------------- */

typedef struct texels {
  surface_room room;
  uint32_t w, h;
  float *memory;
} texels;

static texels room(uint32_t w, uint32_t h) {
  texels t = {.w = w, .h = h};
  size_t n = (size_t)w * h;
  t.memory = malloc(7 * n * sizeof *t.memory + 1);
  t.room.covered = malloc(n + 1);
  assert_true(t.memory && t.room.covered);
  memset(t.memory, 0x7f, 7 * n * sizeof *t.memory);
  memset(t.room.covered, 0x7f, n);
  for (size_t k = 0; k < 3; k++) {
    t.room.point[k] = t.memory + k * n;
    t.room.normal[k] = t.memory + (3 + k) * n;
  }
  t.room.footprint = t.memory + 6 * n;
  return t;
}

static void forget(texels *t) {
  free(t->memory);
  free(t->room.covered);
}

static texels whole(const atlas *a, int udim, uint32_t w, uint32_t h) {
  texels t = room(w, h);
  assert_true(atlas_texels(a, udim, w, h, 0, 0, w, h, &t.room));
  return t;
}

/* ---- every triangle in turn ------------------------------------------------- */

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

static bool near3(const texels *t, float *const *array, size_t i, const long double want[3],
                  long double tolerance) {
  (void)t;
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
  return near3(got, got->room.point, i, point, 1e-4L) &&
         near3(got, got->room.normal, i, normal, 1e-5L) &&
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
  texels got = whole(a, udim, w, h);
  flat *faces = malloc(m->triangle_count * sizeof *faces);
  assert_non_null(faces);
  for (uint32_t t = 0; t < m->triangle_count; t++) faces[t] = flat_of(m, t, udim, w, h);
  for (uint32_t row = 0; row < h; row++)
    for (uint32_t column = 0; column < w; column++) check_texel(m, faces, &got, column, row);
  free(faces);
  forget(&got);
}

static void points_are_those_of_every_triangle_in_turn(void **state) {
  (void)state;
  mesh m;
  atlas *a = leg(&m);
  check_picture(a, &m, 1001, 64, 64);
  check_picture(a, &m, 1001, 48, 29);
  check_picture(a, &m, 1001, 8, 8);
  check_picture(a, &m, 1001, 1, 1);
  atlas_close(a);
  mesh_free(&m);
}

/* ---- rectangles ------------------------------------------------------------- */

static uint32_t random_state = 1;

static uint32_t below(uint32_t limit) {
  random_state = random_state * 1664525u + 1013904223u;
  return (random_state >> 8) % limit;
}

static void same_texel(const texels *a, size_t i, const texels *b, size_t j) {
  for (int k = 0; k < 3; k++) {
    assert_memory_equal(&a->room.point[k][i], &b->room.point[k][j], sizeof(float));
    assert_memory_equal(&a->room.normal[k][i], &b->room.normal[k][j], sizeof(float));
  }
  assert_memory_equal(&a->room.footprint[i], &b->room.footprint[j], sizeof(float));
  assert_int_equal(a->room.covered[i], b->room.covered[j]);
}

static void check_rectangles(const atlas *a, int udim, uint32_t w, uint32_t h) {
  texels all = whole(a, udim, w, h);
  for (int n = 0; n < 60; n++) {
    uint32_t x = below(w), y = below(h), rw = 1 + below(w - x), rh = 1 + below(h - y);
    if (n < 20) rw = rh = 1;
    texels part = room(rw, rh);
    assert_true(atlas_texels(a, udim, w, h, x, y, rw, rh, &part.room));
    for (uint32_t row = 0; row < rh; row++)
      for (uint32_t column = 0; column < rw; column++)
        same_texel(&all, (size_t)(y + row) * w + x + column, &part, (size_t)row * rw + column);
    forget(&part);
  }
  forget(&all);
}

static void texels_do_not_depend_on_the_rectangle(void **state) {
  (void)state;
  atlas *a = leg(NULL), *b = box(true, NULL);
  check_rectangles(a, 1001, SIDE, SIDE);
  check_rectangles(a, 1001, 33, 70);
  check_rectangles(b, 1012, SIDE, SIDE / 2);
  atlas_close(a);
  atlas_close(b);
  FILE *file = begin("blob.obj"); /* many triangles to a block */
  write_blob(file, 150);
  a = finish(file, "blob.obj", NULL);
  check_rectangles(a, 1001, 64, 64);
  atlas_close(a);
}

/* ---- seams ------------------------------------------------------------------- */

/* What a bilinear look-up gives for the point at a place in a picture. */
static void look_up(const texels *t, double u, double v, double p[3]) {
  double x = u * t->w - 0.5, y = (1 - v) * t->h - 0.5;
  int x0 = (int)floor(x), y0 = (int)floor(y);
  for (int k = 0; k < 3; k++) {
    p[k] = 0;
    for (int c = 0; c < 4; c++) {
      int cx = x0 + c % 2, cy = y0 + c / 2;
      assert_true(cx >= 0 && cy >= 0 && cx < (int)t->w && cy < (int)t->h);
      double share = (c % 2 ? x - x0 : 1 - (x - x0)) * (c / 2 ? y - y0 : 1 - (y - y0));
      p[k] += share * (double)t->room.point[k][(size_t)cy * t->w + (size_t)cx];
    }
  }
}

/* The leg is cut open along a line: its two borders are the same points of it,
 * and a look-up at either gives them, at each level. */
static void both_sides_of_a_seam_show_the_same_point(void **state) {
  (void)state;
  atlas *a = leg(NULL);
  for (uint32_t side = 512; side >= 128; side /= 2) {
    texels t = whole(a, 1001, side, side);
    for (int i = 1; i < 400; i++) {
      double v = 0.02 + 0.96 * i / 400.0, left[3], right[3];
      look_up(&t, 0.03, v, left);
      look_up(&t, 0.58, v, right);
      double texel = 300 / 0.96 / side, y = 300 * (v - 0.02) / 0.96;
      for (int k = 0; k < 3; k++) /* bends of the leg within a texel or two are all that is left */
        if (!(fabs(left[k] - right[k]) < 0.25 * texel))
          fail_msg("%u texels, v %g: %g and %g", side, v, left[k], right[k]);
      if (!(fabs(left[1] - y) < 0.1 * texel)) fail_msg("%u: height %g, not %g", side, left[1], y);
    }
    forget(&t);
  }
  atlas_close(a);
}

/* Every texel within reach of a chart is on it: no look-up of any level meets
 * what is far. */
static void dilation_reaches_its_width_at_every_level(void **state) {
  (void)state;
  const float t[1][15] = {
      {0, 0, 0, 100, 0, 0, 0, 100, 0, 0.25f, 0.25f, 0.75f, 0.25f, 0.25f, 0.75f}};
  atlas *a = triangles(t, 1);
  for (uint32_t side = 1024; side >= 1; side /= 2) {
    texels p = whole(a, 1001, side, side);
    for (uint32_t row = 0; row < side; row++)
      for (uint32_t column = 0; column < side; column++) {
        double x = (column + 0.5) / side, y = 1 - (row + 0.5) / side;
        double left = 0.25 - x, under = 0.25 - y, past = (x + y - 1) / sqrt(2);
        double d = fmax(left, fmax(under, past)) * side; /* a bound from below */
        int covered = p.room.covered[(size_t)row * side + column];
        if (d <= -1e-9) assert_int_equal(covered, 1);
        if (d > 1e-9 && covered == 1) fail_msg("%u: %u %u is outside", side, column, row);
        if (d > ATLAS_DILATION) assert_int_equal(covered, 0);
        bool beside = y > 0.25 && y < 0.75; /* where left is how far it is */
        if (beside && left > 0 && left * side < ATLAS_DILATION - 0.01) assert_int_equal(covered, 2);
      }
    forget(&p);
  }
  atlas_close(a);
}

/* ---- tiles -------------------------------------------------------------------- */

static void tiles_are_those_that_charts_reach(void **state) {
  (void)state;
  static const int wanted[] = {1001, 1002, 1003, 1004, 1011, 1012};
  atlas *a = box(true, NULL);
  assert_int_equal(atlas_udim_count(a), 6);
  for (uint32_t k = 0; k < 6; k++) assert_int_equal(atlas_udim(a, k), wanted[k]);
  assert_int_equal(atlas_udim(a, 6), 0);
  texels one = room(1, 1);
  assert_false(atlas_texels(a, 1005, 8, 8, 0, 0, 1, 1, &one.room));
  assert_false(atlas_texels(a, 0, 8, 8, 0, 0, 1, 1, &one.room));
  assert_false(atlas_texels(a, 1001, 8, 8, 8, 0, 1, 1, &one.room));
  assert_false(atlas_texels(a, 1001, 8, 8, 0, 7, 1, 2, &one.room));
  assert_false(atlas_texels(a, 1001, 8, 8, 4294967295u, 0, 2, 1, &one.room));
  assert_false(atlas_texels(a, 1001, 1u << 21, 8, 0, 0, 1, 1, &one.room));
  assert_int_equal(one.room.covered[0], 0x7f);
  forget(&one);
  atlas_close(a);

  /* A square of exactly tile 1001: borders touch 1002 and 1011 and are not in them. */
  const float square[2][15] = {{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1, 0, 1, 1},
                               {0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1}};
  a = triangles(square, 2);
  assert_int_equal(atlas_udim_count(a), 1);
  texels t = whole(a, 1001, 16, 16);
  for (int i = 0; i < 256; i++) {
    assert_int_equal(t.room.covered[i], 1);
    assert_true(fabsf(t.room.point[0][i] - (float)(i % 16 + 0.5) / 16) < 1e-6f);
    assert_true(fabsf(t.room.point[1][i] - (float)(15.5 - i / 16) / 16) < 1e-6f);
    assert_true(fabsf(t.room.footprint[i] - 1 / 16.0f) < 1e-6f);
  }
  forget(&t);
  atlas_close(a);

  /* What only touches a tile from beside shows nothing in it. */
  const float touching[2][15] = {{0, 0, 0, 1, 0, 0, 1, 1, 0, 0.5f, 0, 1, 0, 1, 1},
                                 {0, 0, 9, 1, 0, 9, 1, 1, 9, 1.8f, 0.8f, 1.9f, 0.8f, 1.9f, 0.9f}};
  a = triangles(touching, 2);
  assert_int_equal(atlas_udim_count(a), 2);
  t = whole(a, 1002, 100, 100);
  for (int row = 0; row < 100; row++) assert_int_equal(t.room.covered[row * 100], 0);
  forget(&t);
  atlas_close(a);

  /* One triangle across four tiles is in each of them, and joins. */
  const float across[1][15] = {{0, 0, 0, 20, 0, 0, 0, 20, 0, 0.5f, 0.5f, 2.5f, 0.5f, 0.5f, 2.5f}};
  a = triangles(across, 1);
  assert_int_equal(atlas_udim_count(a), 6); /* and 1003, 1021 */
  assert_int_equal(atlas_udim(a, 5), 1021);
  t = whole(a, 1012, 10, 10);
  assert_int_equal(t.room.covered[90], 1); /* u 1.05, v 1.05 */
  assert_true(fabsf(t.room.point[0][90] - 5.5f) < 1e-5f &&
              fabsf(t.room.point[1][90] - 5.5f) < 1e-5f);
  assert_int_not_equal(t.room.covered[9], 1); /* u 1.95, v 1.95 */
  forget(&t);
  atlas_close(a);
}

/* ---- UVs of no use -------------------------------------------------------------- */

static void useless_uvs_are_counted_and_left_out(void **state) {
  (void)state;
  const float t[7][15] = {
      {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.1f, 0.1f, 0.4f, 0.1f, 0.1f, 0.4f},     /* good */
      {0, 0, 5, 1, 0, 5, 0, 1, 5, 0.1f, 0.1f, 0.4f, 0.1f, 0.1f, 0.4f},     /* over it */
      {0, 0, 6, 1, 0, 6, 0, 1, 6, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f},     /* a point */
      {0, 0, 7, 1, 0, 7, 0, 1, 7, 0.5f, 0.5f, 0.6f, 0.6f, 0.7f, 0.7f},     /* a line */
      {0, 0, 8, 1, 0, 8, 0, 1, 8, -0.5f, -0.5f, -0.1f, -0.5f, -0.5f, 0},   /* below 0 */
      {0, 0, 9, 1, 0, 9, 0, 1, 9, 10.5f, 0.5f, 10.9f, 0.5f, 10.5f, 0.9f},  /* past u 10 */
      {0, 0, 4, 1, 0, 4, 0, 1, 4, 1e30f, 0.5f, 10.9f, 0.5f, 10.5f, 1e30f}, /* nowhere */
  };
  atlas *a = triangles(t, 7);
  const atlas_counts *c = atlas_counts_of(a);
  assert_int_equal(c->triangles, 7);
  assert_int_equal(c->hidden, 1);
  assert_int_equal(c->degenerate, 2);
  assert_int_equal(c->outside, 2);
  assert_int_equal(c->without, 1);
  assert_int_equal(atlas_udim_count(a), 1);
  char text[256];
  assert_true(atlas_warning(a, text, sizeof text));
  assert_non_null(strstr(text, "of 7 triangles 1 without UVs"));
  texels p = whole(a, 1001, 20, 20);
  for (int i = 0; i < 400; i++)
    if (p.room.covered[i]) assert_true(p.room.point[2][i] == 0); /* the first of the two */
  forget(&p);
  atlas_close(a);
  a = leg(NULL);
  assert_false(atlas_warning(a, text, sizeof text));
  atlas_close(a);
}

/* UVs that are no numbers are in binary files only: a PLY of three corners. */
static void nan_uvs_are_left_out(void **state) {
  (void)state;
  const float corners[15] = {0, 0, 0, NAN, 0, 1, 0, 0, 1, NAN, 0, 1, 0, INFINITY, 1};
  const int32_t face[3] = {0, 1, 2};
  FILE *file = begin("nan.ply");
  fputs("ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\nproperty float s\nproperty float t\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n",
        file);
  fwrite(corners, sizeof corners, 1, file);
  fputc(3, file);
  fwrite(face, sizeof face, 1, file);
  assert_int_equal(fclose(file), 0);
  failure why;
  atlas *a = NULL;
  bool opened = atlas_open(&a, path_of("nan.ply"), 1, &why);
  assert_int_equal(unlink(path_of("nan.ply")), 0);
  assert_false(opened);
  if (!strstr(why.text, "1 without UVs")) fail_msg("%s", why.text);
}

static void meshes_of_no_use_are_refused(void **state) {
  (void)state;
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "bare.obj",
          (const char *const[]){"bare.obj", "no UVs", NULL});
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvt 2 2\nf 1/1 2/2 3/3\n", "line.obj",
          (const char *const[]){"line.obj", "1 without area", NULL});
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt -1 -1\nvt -1 -2\nvt -2 -2\nf 1/1 2/2 3/3\n", "under.obj",
          (const char *const[]){"under.obj", "outside every UDIM tile", NULL});
  refused("", "empty.obj", (const char *const[]){"empty.obj", NULL});
  refused("ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n0",
          "huge.ply", (const char *const[]){"huge.ply", "4000000000", NULL});
  refused("{\"asset\":{\"version\":\"2.0\"},\"meshes\":[{", "cut.gltf",
          (const char *const[]){"cut.gltf", NULL});
  refused("Kaydara FBX Binary  ", "cut.fbx", (const char *const[]){"cut.fbx", NULL});
  failure why;
  atlas *a = NULL;
  assert_false(atlas_open(&a, "/nowhere/at.obj", 1, &why));
  assert_non_null(strstr(why.text, "/nowhere/at.obj"));
}

/* ---- formats ---------------------------------------------------------------------- */

static void export(const char *from, const char *to, const char *format) {
  const struct aiScene *scene = aiImportFile(from, aiProcess_Triangulate);
  assert_non_null(scene);
  assert_int_equal(aiExportScene(scene, format, to, 0), AI_SUCCESS);
  aiReleaseImport(scene);
}

/* Each way through a file gives the same points. */
static void formats_agree(void **state) {
  (void)state;
  static const char *const formats[][2] = {
      {"plyb", "box.ply"}, {"glb2", "box.glb"}, {"fbxa", "box.fbx"}};
  atlas *a = box(false, NULL);
  FILE *file = begin("box.obj");
  write_box(file, 20, false);
  assert_int_equal(fclose(file), 0);
  texels want = whole(a, 1001, SIDE, SIDE);
  for (int i = 0; i < 3; i++) {
    char from[256];
    snprintf(from, sizeof from, "%s", path_of("box.obj"));
    export(from, path_of(formats[i][1]), formats[i][0]);
    failure why;
    atlas *b = NULL;
    if (!atlas_open(&b, path_of(formats[i][1]), 1, &why)) fail_msg("%s", why.text);
    texels got = whole(b, 1001, SIDE, SIDE);
    for (size_t k = 0; k < (size_t)SIDE * SIDE; k++) {
      if (want.room.covered[k] != 1) continue;
      for (int c = 0; c < 3; c++)
        if (!(fabsf(want.room.point[c][k] - got.room.point[c][k]) < 1e-3f))
          fail_msg("%s: texel %zu: %g, not %g", formats[i][1], k, (double)got.room.point[c][k],
                   (double)want.room.point[c][k]);
    }
    forget(&got);
    atlas_close(b);
    assert_int_equal(unlink(path_of(formats[i][1])), 0);
  }
  forget(&want);
  atlas_close(a);
  assert_int_equal(unlink(path_of("box.obj")), 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(points_are_those_of_every_triangle_in_turn),
      cmocka_unit_test(texels_do_not_depend_on_the_rectangle),
      cmocka_unit_test(both_sides_of_a_seam_show_the_same_point),
      cmocka_unit_test(dilation_reaches_its_width_at_every_level),
      cmocka_unit_test(tiles_are_those_that_charts_reach),
      cmocka_unit_test(useless_uvs_are_counted_and_left_out),
      cmocka_unit_test(nan_uvs_are_left_out),
      cmocka_unit_test(meshes_of_no_use_are_refused),
      cmocka_unit_test(formats_agree),
  };
  return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
