/* SPDX-License-Identifier: Apache-2.0
 * Charts of an atlas: any rectangle shows the same, seams close, dilation reaches
 * its width, and tiles are those that charts reach. */
#include "atlases.h"

#include <math.h>
#include "meshes.h"

#define SIDE 200u /* texels of the pictures compared whole */

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
  texels all = texels_of(a, udim, w, h);
  for (int n = 0; n < 60; n++) {
    uint32_t x = below(w), y = below(h), rw = 1 + below(w - x), rh = 1 + below(h - y);
    if (n < 20) rw = rh = 1;
    texels part = texels_room(rw, rh);
    assert_true(atlas_texels(a, udim, w, h, x, y, rw, rh, &part.room));
    for (uint32_t row = 0; row < rh; row++)
      for (uint32_t column = 0; column < rw; column++)
        same_texel(&all, (size_t)(y + row) * w + x + column, &part, (size_t)row * rw + column);
    texels_free(&part);
  }
  texels_free(&all);
}

static void texels_do_not_depend_on_the_rectangle(void **state) {
  (void)state;
  atlas *a = leg_atlas(NULL), *b = box_atlas(true, NULL);
  check_rectangles(a, 1001, SIDE, SIDE);
  check_rectangles(a, 1001, 33, 70);
  check_rectangles(b, 1012, SIDE, SIDE / 2);
  atlas_close(a);
  atlas_close(b);
  FILE *file = begin_mesh("blob.obj"); /* many triangles to a block */
  write_blob(file, 150);
  a = open_mesh(file, "blob.obj", NULL);
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
  atlas *a = leg_atlas(NULL);
  for (uint32_t side = 512; side >= 128; side /= 2) {
    texels t = texels_of(a, 1001, side, side);
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
    texels_free(&t);
  }
  atlas_close(a);
}

/* Every texel within reach of a chart is on it: no look-up of any level meets
 * what is far. */
static void dilation_reaches_its_width_at_every_level(void **state) {
  (void)state;
  const float t[1][15] = {
      {0, 0, 0, 100, 0, 0, 0, 100, 0, 0.25f, 0.25f, 0.75f, 0.25f, 0.25f, 0.75f}};
  atlas *a = atlas_of(t, 1);
  for (uint32_t side = 1024; side >= 1; side /= 2) {
    texels p = texels_of(a, 1001, side, side);
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
    texels_free(&p);
  }
  atlas_close(a);
}

/* ---- tiles -------------------------------------------------------------------- */

static void tiles_are_those_that_charts_reach(void **state) {
  (void)state;
  static const int wanted[] = {1001, 1002, 1003, 1004, 1011, 1012};
  atlas *a = box_atlas(true, NULL);
  assert_int_equal(atlas_udim_count(a), 6);
  for (uint32_t k = 0; k < 6; k++) assert_int_equal(atlas_udim(a, k), wanted[k]);
  assert_int_equal(atlas_udim(a, 6), 0);
  texels one = texels_room(1, 1);
  assert_false(atlas_texels(a, 1005, 8, 8, 0, 0, 1, 1, &one.room));
  assert_false(atlas_texels(a, 0, 8, 8, 0, 0, 1, 1, &one.room));
  assert_false(atlas_texels(a, 1001, 8, 8, 8, 0, 1, 1, &one.room));
  assert_false(atlas_texels(a, 1001, 8, 8, 0, 7, 1, 2, &one.room));
  assert_false(atlas_texels(a, 1001, 8, 8, 4294967295u, 0, 2, 1, &one.room));
  assert_false(atlas_texels(a, 1001, 1u << 21, 8, 0, 0, 1, 1, &one.room));
  assert_int_equal(one.room.covered[0], 0x7f);
  texels_free(&one);
  atlas_close(a);

  /* A square of exactly tile 1001: borders touch 1002 and 1011 and are not in them. */
  const float square[2][15] = {{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1, 0, 1, 1},
                               {0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1}};
  a = atlas_of(square, 2);
  assert_int_equal(atlas_udim_count(a), 1);
  texels t = texels_of(a, 1001, 16, 16);
  for (int i = 0; i < 256; i++) {
    assert_int_equal(t.room.covered[i], 1);
    assert_true(fabsf(t.room.point[0][i] - (float)(i % 16 + 0.5) / 16) < 1e-6f);
    assert_true(fabsf(t.room.point[1][i] - (float)(15.5 - i / 16) / 16) < 1e-6f);
    assert_true(fabsf(t.room.footprint[i] - 1 / 16.0f) < 1e-6f);
  }
  texels_free(&t);
  atlas_close(a);

  /* What only touches a tile from beside shows nothing in it. */
  const float touching[2][15] = {{0, 0, 0, 1, 0, 0, 1, 1, 0, 0.5f, 0, 1, 0, 1, 1},
                                 {0, 0, 9, 1, 0, 9, 1, 1, 9, 1.8f, 0.8f, 1.9f, 0.8f, 1.9f, 0.9f}};
  a = atlas_of(touching, 2);
  assert_int_equal(atlas_udim_count(a), 2);
  t = texels_of(a, 1002, 100, 100);
  for (int row = 0; row < 100; row++) assert_int_equal(t.room.covered[row * 100], 0);
  texels_free(&t);
  atlas_close(a);

  /* One triangle across four tiles is in each of them, and joins. */
  const float across[1][15] = {{0, 0, 0, 20, 0, 0, 0, 20, 0, 0.5f, 0.5f, 2.5f, 0.5f, 0.5f, 2.5f}};
  a = atlas_of(across, 1);
  assert_int_equal(atlas_udim_count(a), 6); /* and 1003, 1021 */
  assert_int_equal(atlas_udim(a, 5), 1021);
  t = texels_of(a, 1012, 10, 10);
  assert_int_equal(t.room.covered[90], 1); /* u 1.05, v 1.05 */
  assert_true(fabsf(t.room.point[0][90] - 5.5f) < 1e-5f &&
              fabsf(t.room.point[1][90] - 5.5f) < 1e-5f);
  assert_int_not_equal(t.room.covered[9], 1); /* u 1.95, v 1.95 */
  texels_free(&t);
  atlas_close(a);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(texels_do_not_depend_on_the_rectangle),
      cmocka_unit_test(both_sides_of_a_seam_show_the_same_point),
      cmocka_unit_test(dilation_reaches_its_width_at_every_level),
      cmocka_unit_test(tiles_are_those_that_charts_reach),
  };
  return cmocka_run_group_tests(tests, atlas_folder, atlas_no_folder);
}
