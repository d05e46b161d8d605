/* SPDX-License-Identifier: Apache-2.0
 *
 * Finishes, domes and holes: the normal is the height's own, by finite differences; and what a
 * footprint averages out of the slopes is the variance that roughness gains.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

enum { STONE_NORMAL = 6, STONE_HEIGHT = 9, STONE_ROUGHNESS = 10, STONE_OCCLUSION = 21 };
enum { FINISHES = 8 };
/* Of a face towards +z; riven ones lie along the cleavage and across it. */
static const char *const finishes[FINISHES] = {"sawn",         "polished",      "honed",
                                               "flamed",       "bush_hammered", "split",
                                               "riven; bed=z", "riven; bed=y"};

/* The slope that an answered point's normal stands on, of a face towards +z. */
static void slope_at(const points *p, unsigned i, double g[2]) {
  double nz = (double)p->out[STONE_NORMAL + 2][i];
  for (int c = 0; c < 2; c++) g[c] = -(double)p->out[STONE_NORMAL + c][i] / nz;
}

/* A point, and both ways along x and y of it; and of those, answered, the heights' slope. */
static void add_cross(points *p, const double x[3], double h, double footprint) {
  points_add(p, x[0], x[1], x[2], footprint);
  for (int k = 0; k < 4; k++) {
    double d = k & 1 ? -h : h;
    points_add(p, k < 2 ? x[0] + d : x[0], k < 2 ? x[1] : x[1] + d, x[2], footprint);
  }
}
static void slope_across(const points *p, unsigned i, double h, double g[2]) {
  const float *a = p->out[STONE_HEIGHT] + i;
  for (int c = 0; c < 2; c++) g[c] = (double)(a[2 * c + 1] - a[2 * c + 2]) / (2 * h);
}

static double variance_at(const points *p, unsigned i) {
  double g[2];
  slope_at(p, i, g);
  return 0.5 * (g[0] * g[0] + g[1] * g[1]);
}

static sozai_texture *make(const char *finish) {
  char text[100];
  snprintf(text, sizeof text, "grain_size=3; finish=%s", finish);
  return stone_make(NULL, text);
}

/* Whether an edge, where slopes jump, passes through the cross. */
static bool creased(const points *p, unsigned i, double h) {
  const float *a = p->out[STONE_HEIGHT] + i;
  for (int c = 0; c < 2; c++) {
    double there = (double)(a[2 * c + 1] - a[0]), back = (double)(a[0] - a[2 * c + 2]);
    if (fabs(there - back) > 0.004 * h) return true;
  }
  return false;
}

static void normal_is_the_heights(void **state) {
  (void)state;
  for (int f = 0; f < FINISHES; f++) {
    sozai_texture *t = make(finishes[f]);
    points p = {0};
    uniform_seed(71);
    const double h = 0.005;
    for (int i = 0; i < 4000; i++) {
      double x[3];
      for (int c = 0; c < 3; c++) x[c] = 60 * (uniform() - 0.5);
      add_cross(&p, x, h, 0);
    }
    points_ask(&p, t);
    double worst = 0, steepest = 0, height = 0;
    unsigned edges = 0, faceted = !strcmp(finishes[f], "split");
    for (unsigned i = 0; i < p.count; i += 5) {
      double d[2], g[2];
      if (faceted && creased(&p, i, h)) {
        edges++;
        continue;
      }
      slope_across(&p, i, h, d);
      slope_at(&p, i, g);
      worst = fmax(worst, hypot(g[0] - d[0], g[1] - d[1]));
      steepest = fmax(steepest, hypot(d[0], d[1]));
      height = fmax(height, fabs((double)p.out[STONE_HEIGHT][i]));
    }
    CHECK(worst <= 0.004 + 0.01 * steepest && steepest > 0 && edges < 0.05 * 4000,
          "%-13s height within +-%.4f mm, slopes to %.4f: off finite differences by %.2g (%u "
          "edges)\n",
          finishes[f], height, steepest, worst, edges);
    points_free(&p);
    textures->destroy(t);
  }
}

/* Bodies' slopes are differences over the footprint, of places that the bends' slopes lead to: in
 * the mean they are the height's. `within`: what heights count. */
static void check_slopes(const char *what, const sozai_texture *t, bool (*within)(float height)) {
  points p = {0};
  uniform_seed(73);
  const double h = 0.003, s = 0.03;
  for (int i = 0; i < 20000; i++) {
    double x = 400 * uniform(), y = 400 * uniform(), z = 60 * (uniform() - 0.5);
    add_cross(&p, (const double[]){x, y, z}, h, s);
  }
  points_ask(&p, t);
  double off = 0, steep = 0;
  unsigned count = 0;
  for (unsigned i = 0; i < p.count; i += 5) {
    if (!within(p.out[STONE_HEIGHT][i])) continue;
    double d[2], g[2];
    slope_across(&p, i, h, d);
    slope_at(&p, i, g);
    off += (g[0] - d[0]) * (g[0] - d[0]) + (g[1] - d[1]) * (g[1] - d[1]);
    steep += d[0] * d[0] + d[1] * d[1];
    count++;
  }
  CHECK(count > 500 && off < 0.01 * steep,
        "in %u places %s slopes of RMS %.3f: off finite differences by %.4f\n", count, what,
        sqrt(steep / count), sqrt(off / count));
  points_free(&p);
}

/* Past the rim, which is spread over the footprint. */
static bool in_hole(float height) { return height <= -0.05f; }
static bool on_dome(float height) { return fabsf(height) >= 0.02f; }

/* Of many travertines, since one face has few large holes. */
static void normal_is_the_holes(void **state) {
  (void)state;
  for (int k = 0; k < 8; k++) {
    const sozai_value v = {.id = "seed", .kind = SOZAI_KIND_INT, .number = {7 + 31 * k}};
    sozai_texture *t;
    assert_int_equal(textures->create(NULL, "stone", "travertino", &v, 1, &t), SOZAI_OK);
    check_slopes("within holes", t, in_hole);
    textures->destroy(t);
  }
}

/* Gravel, in a face that is level but for it. */
static sozai_texture *gravel(double high, double grading) {
  const sozai_value v[] = {
      {.id = "relief", .kind = SOZAI_KIND_FLOAT, .number = {0}},
      {.id = "inclusion_relief", .kind = SOZAI_KIND_FLOAT, .number = {high}},
      {.id = "inclusion_grading", .kind = SOZAI_KIND_FLOAT, .number = {grading}},
  };
  sozai_texture *t;
  assert_int_equal(textures->create(NULL, "stone", "exposed_aggregate", v, 3, &t), SOZAI_OK);
  return t;
}

static void normal_is_the_domes(void **state) {
  (void)state;
  for (int k = 0; k < 2; k++) {
    sozai_texture *t = gravel(k ? -1.5 : 2.2, 0.45);
    check_slopes(k ? "on sunk inclusions" : "on raised ones", t, on_dome);
    textures->destroy(t);
  }
}

/* Inclusions stand as high as was asked, and nothing else; a wide footprint has the mean of the
 * heights, and the variance of their slopes as roughness. */
static void domes_have_their_height(void **state) {
  (void)state;
  static const double high[] = {2.2, -1.5, 0.5}, grading[] = {0.45, 0.45, 0.9};
  for (int g = 0; g < 3; g++) {
    sozai_texture *t = gravel(high[g], grading[g]);
    points p = {0};
    uniform_seed(74);
    enum { N = 40000 };
    for (int i = 0; i < N; i++) points_add(&p, 3000 * uniform(), 3000 * uniform(), 0, 0.05);
    points_add(&p, 0, 0, 0, 5000);
    points_ask(&p, t);
    double low = 0, top = 0, mean = 0, variance = 0, level = 0, below = 0, above = 0, tops = 0;
    for (int i = 0; i < N; i++) {
      double h = (double)p.out[STONE_HEIGHT][i] / high[g];
      low = fmin(low, h);
      top = fmax(top, h);
      mean += h / N;
      double sky = (double)p.out[STONE_OCCLUSION][i] / N;
      level += fabs(h) < 1e-6 ? 1.0 / N : 0;
      below += fabs(h) < 1e-6 ? sky : 0;
      tops += h > 0.95 ? 1.0 / N : 0;
      above += h > 0.95 ? sky : 0;
      variance += variance_at(&p, (unsigned)i) / N;
    }
    double fine = (double)p.out[STONE_ROUGHNESS][0], wide = (double)p.out[STONE_ROUGHNESS][N];
    double gained = (wide * wide - fine * fine) / 2, far = (double)p.out[STONE_HEIGHT][N] / high[g];
    CHECK(low >= 0 && top <= 1 + 1e-6 && top > 0.95 && level > 0.2,
          "relief %4.1f mm, grading %.2f: of it heights have %.3f to %.3f, %.3f of the face none\n",
          high[g], grading[g], low, top, level);
    /* what is higher sees more of the sky */
    double less = high[g] > 0 ? below / level : above / tops;
    double more = high[g] > 0 ? above / tops : below / level;
    CHECK(less < more - 0.02, "  of the sky %.3f is seen low down, %.3f high up\n", less, more);
    CHECK(fabs(far - mean) < 0.02, "  mean %.4f, under 5 m %.4f\n", mean, far);
    CHECK(wide > 0.999 || fabs(gained - variance) <= 0.15 * variance,
          "  slope variance %.5f, roughness %.3f to %.3f: gained %.5f (ratio %.3f)\n", variance,
          fine, wide, gained, gained / variance);
    points_free(&p);
    textures->destroy(t);
  }
}

/* Slope variance along an axis at a point, against what a footprint wide enough
 * to flatten all of it adds: alpha^2 = 2 variance. */
static void lost_slopes_are_roughness(void **state) {
  (void)state;
  for (int f = 0; f < FINISHES; f++) {
    sozai_texture *t = make(finishes[f]);
    points p = {0};
    uniform_seed(72);
    enum { N = 400000 };
    for (int i = 0; i < N; i++) {
      double x[3];
      for (int c = 0; c < 3; c++) x[c] = 20000 * (uniform() - 0.5);
      points_add(&p, x[0], x[1], x[2], 0);
    }
    points_add(&p, 0, 0, 0, 5000);
    points_ask(&p, t);
    double variance = 0;
    for (int i = 0; i < N; i++) {
      variance += variance_at(&p, (unsigned)i) / N;
    }
    double fine = (double)p.out[STONE_ROUGHNESS][0], wide = (double)p.out[STONE_ROUGHNESS][N];
    double gained = (wide * wide - fine * fine) / 2;
    /* full roughness cannot grow */
    CHECK(wide > 0.999 || fabs(gained - variance) <= 0.06 * variance + 1e-9,
          "%-13s slope variance %.6f, roughness %.3f to %.3f: gained %.6f (ratio %.3f)\n",
          finishes[f], variance, fine, wide, gained, gained / variance);
    points_free(&p);
    textures->destroy(t);
  }
}

/* How slopes of places so far apart along x differ: RMS, and in what part of them by less than a
 * twentieth of what slopes are; *steep: their RMS along x, and along y. */
static double alike(const char *parameters, double apart, double steep[2], double *differ) {
  enum { N = 40000 };
  sozai_texture *t = stone_make("inada", parameters);
  points p = {0};
  uniform_seed(79);
  for (int i = 0; i < N; i++) {
    double x = 4000 * uniform(), y = 4000 * uniform();
    points_add(&p, x, y, 0, 0);
    points_add(&p, x + apart, y, 0, 0);
  }
  points_ask(&p, t);
  double sum[2] = {0, 0}, off = 0, same = 0;
  for (unsigned i = 0; i < 2 * N; i += 2) {
    double a[2], b[2];
    slope_at(&p, i, a);
    slope_at(&p, i + 1, b);
    for (int c = 0; c < 2; c++) sum[c] += a[c] * a[c] / N;
    off += ((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])) / N;
  }
  for (int c = 0; c < 2; c++) steep[c] = sqrt(sum[c]);
  for (unsigned i = 0; i < 2 * N; i += 2) {
    double a[2], b[2];
    slope_at(&p, i, a);
    slope_at(&p, i + 1, b);
    same += hypot(a[0] - b[0], a[1] - b[1]) < 0.05 * hypot(steep[0], steep[1]);
  }
  *differ = sqrt(off);
  points_free(&p);
  textures->destroy(t);
  return same / N;
}

/* Split stone has planes that meet in edges: places near each other mostly lie on one, and where
 * they do not they differ as places far apart do. */
static void split_is_faceted(void **state) {
  (void)state;
  double steep[2], near, far, part = alike("finish=split", 0.2, steep, &near);
  (void)alike("finish=split", 300, steep, &far);
  CHECK(part > 0.55 && near > 0.2 * far,
        "split: %.3f of places 0.2 mm apart lie on one plane; RMS %.3f, of any %.3f\n", part, near,
        far);
}

/* Riven stone has terraces along its cleavage, steep every way, and across it sheets' edges,
 * which run along it. */
static void riven_along_its_cleavage(void **state) {
  (void)state;
  double top[2], side[2], differ;
  (void)alike("finish=riven; bed=z", 1, top, &differ);
  (void)alike("finish=riven; bed=y", 1, side, &differ);
  CHECK(top[0] > 0.5 * top[1] && top[0] < 2 * top[1] && side[1] > 4 * side[0],
        "slopes along and across: of terraces %.3f and %.3f, of edges %.3f and %.3f\n", top[0],
        top[1], side[0], side[1]);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(normal_is_the_heights),     cmocka_unit_test(normal_is_the_holes),
      cmocka_unit_test(normal_is_the_domes),       cmocka_unit_test(domes_have_their_height),
      cmocka_unit_test(lost_slopes_are_roughness), cmocka_unit_test(split_is_faceted),
      cmocka_unit_test(riven_along_its_cleavage)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
