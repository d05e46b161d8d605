/* SPDX-License-Identifier: Apache-2.0
 *
 * Veins: lengths in mm, areas as their widths, which way they lie, and the same from afar.
 */
#include <math.h>
#include <stdio.h>

#include "cmocka_all.h"
#include "wood.h"

/* White on black: albedo is the veins' share. */
#define WHITE_VEINS                                                                                \
  "grain_variation=0; second_share=0; third_share=0; mottle=0; cleavage=0; turbidity=0; "          \
  "base_colour=0 0 0 @ lin_rec709; vein_colour=1 1 1 @ lin_rec709; "

static sozai_texture *veined(const char *rest) {
  char text[600];
  snprintf(text, sizeof text, WHITE_VEINS "%s", rest);
  return stone_make(NULL, text);
}

static double share_at(const points *p, unsigned i) { return (double)p->out[ALBEDO][i]; }

/* Of a face, in the mean of many places. */
static double area(const sozai_texture *t, double wide, unsigned count, double *afar) {
  points p = {0};
  double sum = 0;
  uniform_seed(81);
  for (unsigned i = 0; i < count; i++) points_add(&p, wide * uniform(), wide * uniform(), 0, 0);
  points_add(&p, 0, 0, 0, 1e6);
  points_ask(&p, t);
  for (unsigned i = 0; i < count; i++) sum += share_at(&p, i) / count;
  *afar = share_at(&p, count);
  points_free(&p);
  return sum;
}

/* All of it twice as large is the same, twice as large. */
static void lengths_are_mm(void **state) {
  (void)state;
  sozai_texture *t[2] = {
      veined("vein_spacing=50; vein_width=7; vein_softness=1.5; vein_warp=0.8; vein_crossing=0.7"),
      veined("vein_spacing=100; vein_width=14; vein_softness=3; vein_warp=0.8; vein_crossing=0.7")};
  points p[2] = {{0}, {0}};
  uniform_seed(82);
  for (int i = 0; i < 20000; i++) {
    double x = 800 * uniform(), y = 800 * uniform(), z = 800 * uniform(), s = 20 * uniform();
    for (int k = 0; k < 2; k++)
      points_add(&p[k], x * (k + 1), y * (k + 1), z * (k + 1), s * (k + 1));
  }
  double most = 0, some = 0;
  for (int k = 0; k < 2; k++) points_ask(&p[k], t[k]);
  for (unsigned i = 0; i < p[0].count; i++) {
    most = fmax(most, fabs(share_at(&p[0], i) - share_at(&p[1], i)));
    some += share_at(&p[0], i) > 0.5;
  }
  CHECK(some > 100 && most < 1e-4, "twice as large: %.2g apart at most (%.0f places in veins)\n",
        most, some);
  for (int k = 0; k < 2; k++) {
    points_free(&p[k]);
    textures->destroy(t[k]);
  }
}

/* The widest that vein_width says; the others are as much narrower. */
static void areas_go_with_width(void **state) {
  (void)state;
  static const char *const crossing[3] = {"0", "0.5", "1"};
  for (int c = 0; c < 3; c++) {
    double share[3], afar;
    for (int k = 0; k < 3; k++) {
      char text[200];
      snprintf(text, sizeof text,
               "vein_spacing=40; vein_width=%g; vein_softness=0; vein_warp=0.7; vein_crossing=%s",
               1.0 * (1 << k), crossing[c]);
      sozai_texture *t = veined(text);
      share[k] = area(t, 12000, 400000, &afar);
      CHECK(fabs(afar - share[k]) < 0.1 * share[k],
            "vein_crossing=%s: %.5f of a face, from afar %.5f\n", crossing[c], share[k], afar);
      textures->destroy(t);
    }
    double twice = share[1] / share[0], again = share[2] / share[1];
    CHECK(fabs(twice - 2) < 0.15 && fabs(again - 2) < 0.15,
          "vein_crossing=%s: widths of 1, 2, 4 mm take %.4f, %.4f, %.4f of a face\n", crossing[c],
          share[0], share[1], share[2]);
  }
}

/* Which way slopes face: their tensor. */
typedef struct {
  double xx, xy, yy;
} facing;

/* between: the points to the right, to the left, above and below. */
static void facing_add(facing *f, const points *p, const unsigned between[4]) {
  double x = share_at(p, between[0]) - share_at(p, between[1]);
  double y = share_at(p, between[2]) - share_at(p, between[3]);
  f->xx += x * x, f->xy += x * y, f->yy += y * y;
}

/* At twice the angle of the way that more of them face, how much more: 0 to 1. */
static double facing_way(const facing *f, double way[2]) {
  way[0] = (f->xx - f->yy) / (f->xx + f->yy);
  way[1] = 2 * f->xy / (f->xx + f->yy);
  return hypot(way[0], way[1]);
}

/* How much more borders face one way than the other. */
static double one_way(const sozai_texture *t) {
  enum { SIDE = 300 };
  const double step = 2;
  points p = {0};
  for (int j = 0; j < SIDE; j++) {
    for (int i = 0; i < SIDE; i++) points_add(&p, step * i, step * j, 0, step);
  }
  points_ask(&p, t);
  facing f = {0};
  double way[2];
  for (unsigned j = 1; j + 1 < SIDE; j++) {
    for (unsigned i = 1; i + 1 < SIDE; i++) {
      unsigned at = j * SIDE + i;
      facing_add(&f, &p, (unsigned[4]){at + 1, at - 1, at + SIDE, at - SIDE});
    }
  }
  points_free(&p);
  return facing_way(&f, way);
}

static void crossing_is_other_ways(void **state) {
  (void)state;
  enum { SEEDS = 8 };
  static const double crossing[3] = {0, 0.5, 1};
  double mean[3] = {0, 0, 0};
  for (int k = 0; k < 3; k++) {
    for (int seed = 0; seed < SEEDS; seed++) {
      char text[200];
      snprintf(text, sizeof text,
               "seed=%d; vein_spacing=40; vein_width=5; vein_softness=1; vein_warp=0.4; "
               "vein_crossing=%g",
               seed + 1, crossing[k]);
      sozai_texture *t = veined(text);
      mean[k] += one_way(t) / SEEDS;
      textures->destroy(t);
    }
  }
  CHECK(mean[0] > 0.6 && mean[0] > mean[1] + 0.1 && mean[1] > mean[2] + 0.03,
        "vein_crossing 0, 0.5, 1: veins lie one way by %.3f, %.3f, %.3f of 1\n", mean[0], mean[1],
        mean[2]);
}

/* More warp, longer veins; without any they are straight: a line keeps its share along them. */
static void warp_bends(void **state) {
  (void)state;
  static const double warp[3] = {0, 0.5, 1};
  double mean[3] = {0, 0, 0};
  for (int k = 0; k < 3; k++) {
    for (int seed = 0; seed < 6; seed++) {
      char text[200];
      snprintf(text, sizeof text,
               "seed=%d; vein_spacing=40; vein_width=5; vein_softness=1; vein_warp=%g; "
               "vein_crossing=0",
               seed + 1, warp[k]);
      sozai_texture *t = veined(text);
      mean[k] += one_way(t) / 6;
      textures->destroy(t);
    }
  }
  CHECK(mean[0] > 0.8 && mean[0] > mean[1] + 0.05 && mean[1] > mean[2] + 0.05,
        "vein_warp 0, 0.5, 1: veins lie one way by %.3f, %.3f, %.3f of 1\n", mean[0], mean[1],
        mean[2]);
}

/* What the streaks leave of veins, in the mean of many places, and between which bounds. */
static void streaks_leave_their_part(void **state) {
  (void)state;
  static const double variation[] = {0.3, 0.7, 1};
  enum { COUNT = 400000 };
  const char *plain = "vein_spacing=100; vein_width=30; vein_softness=0; vein_warp=0.7; "
                      "vein_crossing=0.5; vein_variation=%g";
  points p = {0}, q = {0};
  uniform_seed(84);
  for (int i = 0; i < COUNT; i++) {
    double x = 30000 * uniform(), y = 30000 * uniform();
    points_add(&p, x, y, 0, 0);
    points_add(&q, x, y, 0, 0);
  }
  char text[200];
  snprintf(text, sizeof text, plain, 0.0);
  sozai_texture *even = veined(text);
  points_ask(&p, even);
  for (int k = 0; k < 3; k++) {
    snprintf(text, sizeof text, plain, variation[k]);
    sozai_texture *t = veined(text);
    points_ask(&q, t);
    double sum = 0, all = 0, least = 1, most = 0;
    for (unsigned i = 0; i < COUNT; i++) {
      double a = share_at(&p, i), b = share_at(&q, i);
      all += a;
      sum += b;
      if (a < 0.9999) continue;
      least = fmin(least, b);
      most = fmax(most, b);
    }
    double expected = 1 - 0.5 * variation[k];
    CHECK(all > 0.01 * COUNT && fabs(sum / all - expected) < 0.02 &&
              least >= 1 - variation[k] - 1e-5 && least < 1 - 0.9 * variation[k] && most > 0.99,
          "vein_variation=%g: %.4f of the veins is left (%.4f), from %.4f to %.4f of a place\n",
          variation[k], sum / all, expected, least, most);
    textures->destroy(t);
  }
  textures->destroy(even);
  points_free(&p);
  points_free(&q);
}

/* Of straight veins: they differ across, not along. */
static void streaks_go_along(void **state) {
  (void)state;
  enum { SIDE = 700 };
  const char *plain = "vein_spacing=200; vein_width=100; vein_softness=0; vein_warp=0; "
                      "vein_crossing=0; vein_variation=%g";
  points p[2] = {{0}, {0}};
  for (int k = 0; k < 2; k++) {
    char text[200];
    snprintf(text, sizeof text, plain, 1.0 * k);
    sozai_texture *t = veined(text);
    for (int j = 0; j < SIDE; j++)
      for (int i = 0; i < SIDE; i++) points_add(&p[k], 2 * i, 2 * j, 0, 0);
    points_ask(&p[k], t);
    textures->destroy(t);
  }
  facing f[2] = {{0, 0, 0}, {0, 0, 0}}; /* the veins' own borders, and streaks within */
  for (unsigned j = 1; j + 1 < SIDE; j++) {
    for (unsigned i = 1; i + 1 < SIDE; i++) {
      unsigned at = j * SIDE + i, between[4] = {at + 1, at - 1, at + SIDE, at - SIDE};
      int within = 1;
      for (int m = 0; m < 4; m++) within &= share_at(&p[0], between[m]) > 0.9999;
      facing_add(&f[within], &p[within], between);
    }
  }
  double way[2][2], veins = facing_way(&f[0], way[0]), streaks = facing_way(&f[1], way[1]);
  double alike = (way[0][0] * way[1][0] + way[0][1] * way[1][1]) / (streaks * veins);
  CHECK(streaks > 0.6 && veins > 0.6 && alike > 0.95,
        "streaks lie one way by %.3f of 1, veins by %.3f, and that way is the same by %.3f of 1\n",
        streaks, veins, alike);
  for (int k = 0; k < 2; k++) points_free(&p[k]);
}

/* How long a line on a face is in a vein, in the mean of all ways that it may run. axis: of the
 * face square to it. */
static double in_a_vein(const sozai_texture *t, int axis) {
  enum { N = 60000 };
  const double step = 0.4;
  points p = {0};
  uniform_seed(85);
  for (int i = 0; i < N; i++) {
    double at[3] = {3000 * uniform(), 3000 * uniform(), 3000 * uniform()},
           way = 6.283185307 * uniform();
    points_add(&p, at[0], at[1], at[2], 0);
    at[(axis + 1) % 3] += step * cos(way);
    at[(axis + 2) % 3] += step * sin(way);
    points_add(&p, at[0], at[1], at[2], 0);
  }
  points_ask(&p, t);
  double in = 0, borders = 0;
  for (unsigned i = 0; i < 2 * N; i += 2) {
    int a = share_at(&p, i) > 0.5, b = share_at(&p, i + 1) > 0.5;
    in += a + b;
    borders += a != b;
  }
  points_free(&p);
  return in * step / borders;
}

/* A block is sawn across its veins: whatever the seed, no face of a cuboid has them as blots, which
 * a vein that lies along it makes. */
static void faces_are_sawn_across(void **state) {
  (void)state;
  enum { SEEDS = 40 };
  double mean = 0, most = 0;
  for (int seed = 1; seed <= SEEDS; seed++) {
    char text[200];
    snprintf(text, sizeof text,
             "seed=%d; vein_spacing=60; vein_width=20; vein_softness=0; vein_warp=0.15; "
             "vein_crossing=0",
             seed);
    sozai_texture *t = veined(text);
    for (int axis = 0; axis < 3; axis++) {
      double length = in_a_vein(t, axis);
      mean += length / (3 * SEEDS);
      most = fmax(most, length);
    }
    textures->destroy(t);
  }
  CHECK(most < 2 * mean, "a line is in a vein for %.2f mm, on the worst of %d faces %.2f mm\n",
        mean, 3 * SEEDS, most);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(lengths_are_mm),           cmocka_unit_test(areas_go_with_width),
      cmocka_unit_test(crossing_is_other_ways),   cmocka_unit_test(warp_bends),
      cmocka_unit_test(streaks_leave_their_part), cmocka_unit_test(streaks_go_along),
      cmocka_unit_test(faces_are_sawn_across)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
