/* SPDX-License-Identifier: Apache-2.0
 *
 * Paving of stone: joints as wide as they are said to be, wandering as far, no
 * repeat; each stone from a place of its own; and normals, moss, water, shadow.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

enum {
  S_NORMAL = 6,
  S_HEIGHT = 9,
  S_ROUGHNESS,
  S_GRAIN = 13,
  S_JOINT,
  S_ID,
  S_U,
  S_V,
  S_EDGE,
  S_MOSS,
  S_WET,
  S_OCCLUSION
};

static double at(const points *p, int what, unsigned i) { return (double)p->out[what][i]; }

static sozai_texture *make(const char *preset, const char *parameters) {
  return stone_make(preset, parameters);
}

/* The joint's share of the plane, from its width; and each stone's area, by
 * counting places. */
static void joints_are_as_wide(void **state) {
  (void)state;
  sozai_texture *t =
      make(NULL, "layout=chidori; stone_length=300; stone_width=150; joint_width=12");
  sozai_texture *round = make(NULL, "layout=chidori; stone_length=300; stone_width=150; "
                                    "joint_width=12; corner_radius=40");
  points p = {0};
  uniform_seed(11);
  enum { N = 400000 };
  for (int i = 0; i < N; i++) points_add(&p, 30000 * uniform(), 30000 * uniform(), 0, 0);
  double share[2];
  sozai_texture *both[2] = {t, round};
  for (int k = 0; k < 2; k++) {
    points_ask(&p, both[k]);
    share[k] = 0;
    for (unsigned i = 0; i < N; i++) share[k] += (p.out[S_EDGE][i] < 0) / (double)N;
  }
  double square = 1 - (1 - 12 / 300.0) * (1 - 12 / 150.0);
  double corners = (4 - 3.14159265358979) * 40 * 40 / (300.0 * 150.0);
  CHECK(fabs(share[0] - square) < 0.002 && fabs(share[1] - square - corners) < 0.003,
        "joints take %.4f of the plane (%.4f), %.4f more with corners rounded by 40 mm (%.4f)\n",
        share[0], square, share[1] - share[0], corners);
  points_free(&p);
  textures->destroy(t);
  textures->destroy(round);
}

/* Where courses meet, along x: how far the joint strays, and how wide it is. */
static void joints_wander(void **state) {
  (void)state;
  sozai_texture *t = make(NULL, "layout=stack; stone_length=200; stone_width=200; joint_width=10; "
                                "joint_wander=0.06; joint_divisions=4");
  double most = 0, square = 0, width = 0;
  int n = 0;
  points p = {0};
  uniform_seed(12);
  for (int line = 0; line < 400; line++) {
    double x = 4000 * uniform(), y = 200 * floor(20 * uniform());
    points_clear(&p);
    for (int i = 0; i < 1200; i++) points_add(&p, x, y + 0.05 * (i - 600), 0, 0);
    points_ask(&p, t);
    double low = 1e9, high = -1e9;
    for (int i = 0; i < 1200; i++) {
      if (p.out[S_EDGE][i] >= 0) continue;
      double d = 0.05 * (i - 600);
      low = fmin(low, d);
      high = fmax(high, d);
    }
    if (high - low > 25 || high < low) continue; /* along a joint across */
    double middle = 0.5 * (low + high);
    most = fmax(most, fabs(middle));
    square += middle * middle;
    width += high - low;
    n++;
  }
  /* uniform within +-12 mm at the division points, smooth between */
  CHECK(n > 250 && most > 8 && most <= 12.5 && sqrt(square / n) > 3.5 && sqrt(square / n) < 7 &&
            fabs(width / n - 10) < 0.8,
        "%d crossings: strays by %.2f mm at most (6 %% of 200: 12), %.2f RMS; %.2f mm wide on "
        "average (10)\n",
        n, most, sqrt(square / n), width / n);
  points_free(&p);
  textures->destroy(t);
}

/* The same place within its stone, in two stones: another part of the block. */
static void each_stone_is_its_own(void **state) {
  (void)state;
  sozai_texture *t = make("inada", "layout=stack; stone_length=200; stone_width=200");
  points p = {0};
  uniform_seed(13);
  enum { N = 20000 };
  for (int i = 0; i < N; i++) {
    double x = 20 + 160 * uniform(), y = 20 + 160 * uniform();
    double dx = 200 * floor(1 + 499 * uniform()), dy = 200 * floor(499 * uniform());
    points_add(&p, x, y, 0, 0);
    points_add(&p, x + dx, y + dy, 0, 0);
  }
  points_ask(&p, t);
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  int same = 0;
  for (unsigned i = 0; i < p.count; i += 2) {
    double x = at(&p, 0, i), y = at(&p, 0, i + 1);
    a += x / N, b += y / N, aa += x * x / N, bb += y * y / N, ab += x * y / N;
    same += p.out[S_ID][i] == p.out[S_ID][i + 1];
  }
  double r = (ab - a * b) / sqrt((aa - a * a) * (bb - b * b));
  CHECK(fabs(r) < 0.03 && !same,
        "lags of whole stones up to 100 m: albedo correlates by %.4f, %d ids the same\n", r, same);
  points_free(&p);
  textures->destroy(t);
}

/* Albedo over a square of 200 mm, the sum of how it differs between two sets of values. */
static double apart(const char *one, const char *other) {
  sozai_texture *t[2] = {make("sandstone", one), make("sandstone", other)};
  points p[2] = {{0}, {0}};
  double sum = 0;
  for (int k = 0; k < 2; k++) {
    for (int i = 0; i < 400; i++) points_add(&p[k], 10 * (i % 20), 10 * (i / 20), 0, 0);
    points_ask(&p[k], t[k]);
  }
  for (unsigned i = 0; i < p[0].count; i++) sum += fabs(at(&p[0], 1, i) - at(&p[1], 1, i));
  for (int k = 0; k < 2; k++) {
    points_free(&p[k]);
    textures->destroy(t[k]);
  }
  return sum;
}

/* What is laid shows the bed, as flags are split; what is not shows the beds' edges. */
static void laid_stones_show_the_bed(void **state) {
  (void)state;
  double flags = apart("layout=crazy", "layout=crazy; bed=z"), block = apart("", "bed=y"),
         edges = apart("layout=crazy", "layout=crazy; bed=y");
  CHECK(
      flags == 0 && block == 0 && edges > 1,
      "flags differ by %g from those split along the bed and by %.1f from others, a block by %g\n",
      flags, edges, block);
}

/* Along courses of 200 m, which of course repeat across: footprints of 20 mm
 * against themselves, shifted by every lag from two stones up to 100 m. */
static void no_visible_repeat(void **state) {
  (void)state;
  sozai_texture *t = make("shirakawa", "layout=ashlar; tone_spread=0.1; moss=0.4; grime=0.3");
  enum { N = 10000, LAGS = 5000, LINES = 24 };
  points p = {0};
  static double x[N], sum[LAGS];
  double variance = 0, worst = 0;
  for (int line = 0; line < LINES; line++) {
    points_clear(&p);
    for (int i = 0; i < N; i++) points_add(&p, 20.0 * i, 3300 * line + 60, 0, 20);
    points_ask(&p, t);
    double mean = 0;
    for (int i = 0; i < N; i++) mean += at(&p, 1, (unsigned)i) / N;
    for (int i = 0; i < N; i++) {
      x[i] = at(&p, 1, (unsigned)i) - mean;
      variance += x[i] * x[i] / N / LINES;
    }
    for (int lag = 60; lag < LAGS; lag++) {
      double all = 0;
      for (int i = 0; i + lag < N; i++) all += x[i] * x[i + lag];
      sum[lag] += all / (N - lag) / LINES;
    }
  }
  int where = 0;
  for (int lag = 60; lag < LAGS; lag++) {
    double r = sum[lag] / variance;
    if (r > worst) {
      worst = r;
      where = lag;
    }
  }
  CHECK(variance > 1e-5 && worst < 0.15,
        "autocorrelation along 24 lines of 200 m, lags of 1.2 to 100 m: %.3f at most, at %.1f m\n",
        worst, where * 0.02);
  points_free(&p);
  textures->destroy(t);
}

typedef struct {
  const char *name, *parameters;
  double most; /* of slope, that 99 of 100 places are within */
} sloped;

/* The normal is the height's, on edges and in joints, under moss and by water. */
static void normals_are_slopes(void **state) {
  (void)state;
/* grains so large that their outlines, at which slopes change, are few: property.stone_sand has
 * their slopes */
#define LAID "joint_width=14; joint_depth=5; joint_grain=6; finish=polished; layout="
  static const sloped cases[] = {
      {"edges", LAID "stack; bevel=6; edge_round=14; edge_drop=4; corner_radius=20", 0.01},
      {"wander", LAID "chidori; edge_round=10; edge_drop=3; joint_wander=0.06", 0.01},
      {"chips", LAID "stack; edge_round=14; edge_drop=5; edge_chipping=0.8", 0.03},
      {"lie", LAID "hexagon; tilt=3; crown=5; settle=6; undulation=8", 0.01},
      {"fan", LAID "fan; joint_width=8; edge_round=10; edge_drop=4; crown=3", 0.03},
      {"worn", LAID "ashlar; wear=1", 0.01},
      {"flamed",
       "layout=crazy; joint_width=14; joint_depth=5; joint_grain=6; finish=flamed; wear=0.5", 0.05},
      {"moss", LAID "chidori; moss=0.7; moss_height=2", 0.05},
      {"water", LAID "chidori; tilt=4; settle=8; undulation=10; water_level=-2; wet=0.4", 0.03},
  };
  for (unsigned k = 0; k < sizeof cases / sizeof *cases; k++) {
    sozai_texture *t = make(NULL, cases[k].parameters);
    points p = {0};
    uniform_seed(14 + k);
    const double h = 0.02;
    enum { N = 8000 };
    for (int i = 0; i < N; i++) {
      /* near the origin, where floats are fine enough for differences */
      double x = 900 * (uniform() - 0.5), y = 900 * (uniform() - 0.5);
      for (int c = 0; c < 5; c++) {
        points_add(&p, x + h * ((c == 1) - (c == 2)), y + h * ((c == 3) - (c == 4)), 0, 0);
      }
    }
    points_ask(&p, t);
    int off = 0, seen = 0, steep = 0;
    double square = 0;
    for (unsigned i = 0; i < p.count; i += 5) {
      double e = at(&p, S_EDGE, i), creased = 0;
      /* not where two edges are as near, nor across a joint's middle */
      for (unsigned c = 1; c < 5; c += 2) {
        creased = fmax(creased, fabs(at(&p, S_EDGE, i + c) + at(&p, S_EDGE, i + c + 1) - 2 * e));
      }
      if (creased > 2e-4 || e < -6.9) continue;
      double gx = (at(&p, S_HEIGHT, i + 1) - at(&p, S_HEIGHT, i + 2)) / (2 * h);
      double gy = (at(&p, S_HEIGHT, i + 3) - at(&p, S_HEIGHT, i + 4)) / (2 * h);
      double nz = at(&p, S_NORMAL + 2, i);
      double d = hypot(at(&p, S_NORMAL, i) / nz + gx, at(&p, S_NORMAL + 1, i) / nz + gy);
      double slope = hypot(gx, gy);
      steep += slope > 0.2;
      off += d > cases[k].most * (1 + slope);
      square += d * d;
      seen++;
    }
    CHECK(seen > N * 8 / 10 && off * 100 <= seen,
          "%-7s %d places, %d of them steep: %d off the height's slope by more than %g (1 + "
          "slope); %.4f RMS\n",
          cases[k].name, seen, steep, off, cases[k].most, sqrt(square / seen));
    points_free(&p);
    textures->destroy(t);
  }
}

/* More of it covers more, joints first; standing water is level. */
/* Where moss covers all, the steps from stone to stone beneath it are not seen: it goes from one's
 * height to the other's over what it spreads. */
static void moss_levels(void **state) {
  (void)state;
  sozai_texture *t = make("inada", "finish=sawn; layout=chidori; joint_width=12; joint_depth=6; "
                                   "settle=10; moss=1; moss_height=0");
  enum { N = 8000, LINES = 12 };
  const double step = 0.5;
  points p = {0};
  double steepest = 0;
  int covered = 0;
  for (int line = 0; line < LINES; line++) {
    points_clear(&p);
    for (int i = 0; i < N; i++) points_add(&p, step * i, 137.0 * line, 0, 0);
    points_ask(&p, t);
    for (unsigned i = 1; i < N; i++) {
      if (at(&p, S_MOSS, i) < 0.999 || at(&p, S_MOSS, i - 1) < 0.999) continue;
      covered += p.out[S_EDGE][i] < 0;
      steepest = fmax(steepest, fabs(at(&p, S_HEIGHT, i) - at(&p, S_HEIGHT, i - 1)) / step);
    }
  }
  CHECK(covered > 500 && steepest < 1,
        "moss over stones that are sunk by up to 10 mm rises by %.2f a mm at most, %d places in "
        "joints\n",
        steepest, covered);
  points_free(&p);
  textures->destroy(t);
}

static void moss_and_water(void **state) {
  (void)state;
  static const char *const amounts[] = {"0", "0.25", "0.5", "0.75", "1"};
  double joint[5], stone[5];
  for (int k = 0; k < 5; k++) {
    char text[128];
    snprintf(text, sizeof text, "layout=chidori; joint_width=12; moss=%s", amounts[k]);
    sozai_texture *t = make("shirakawa", text);
    points p = {0};
    uniform_seed(15);
    int n[2] = {0, 0};
    double sum[2] = {0, 0};
    for (int i = 0; i < 40000; i++) points_add(&p, 9000 * uniform(), 9000 * uniform(), 0, 0);
    points_ask(&p, t);
    for (unsigned i = 0; i < p.count; i++) {
      int on = p.out[S_EDGE][i] > 25;
      if (!on && p.out[S_EDGE][i] > 0) continue;
      sum[on] += at(&p, S_MOSS, i);
      n[on]++;
    }
    joint[k] = sum[0] / n[0];
    stone[k] = sum[1] / n[1];
    points_free(&p);
    textures->destroy(t);
  }
  int grows = joint[0] == 0 && stone[0] == 0;
  for (int k = 1; k < 5; k++) grows &= joint[k] > joint[k - 1] && stone[k] >= stone[k - 1];
  CHECK(grows && joint[2] > 0.5 && stone[2] < 0.3 && stone[4] > 0.2,
        "moss of 0, 1/4, 1/2, 3/4, 1 covers %.2f %.2f %.2f %.2f %.2f of joints and %.2f %.2f %.2f "
        "%.2f %.2f of stones\n",
        joint[0], joint[1], joint[2], joint[3], joint[4], stone[0], stone[1], stone[2], stone[3],
        stone[4]);

  sozai_texture *dry =
      make("inada", "finish=sawn; layout=chidori; joint_width=12; joint_depth=6; settle=6");
  sozai_texture *t =
      make("inada", "finish=sawn; layout=chidori; joint_width=12; joint_depth=6; settle=6; "
                    "water_level=-2");
  points p = {0}, q = {0};
  uniform_seed(16);
  for (int i = 0; i < 40000; i++) {
    double x = 5000 * uniform(), y = 5000 * uniform();
    points_add(&p, x, y, 0, 0);
    points_add(&q, x, y, 0, 0);
  }
  points_ask(&p, t);
  points_ask(&q, dry);
  int under = 0, wrong = 0, stones = 0;
  double darker = 0;
  for (unsigned i = 0; i < p.count; i++) {
    double h = at(&q, S_HEIGHT, i);
    if (h > -1.8) {
      wrong += fabs(at(&p, S_HEIGHT, i) - h) > 1e-4;
    } else if (h < -2.2) {
      under++;
      stones += p.out[S_EDGE][i] > 5;
      darker += at(&p, 1, i) / at(&q, 1, i);
      wrong += fabs(at(&p, S_HEIGHT, i) + 2) > 1e-4 || at(&p, S_NORMAL + 2, i) < 0.999999 ||
               at(&p, S_WET, i) < 0.9999 || at(&p, S_ROUGHNESS, i) > 0.03;
    }
  }
  CHECK(under > 2000 && stones > 500 && !wrong && darker / under < 0.8,
        "%d places under water, %d of them on settled stones, albedo %.2f of dry; %d not level or "
        "not as they were\n",
        under, stones, darker / under, wrong);
  points_free(&p);
  points_free(&q);
  textures->destroy(t);
  textures->destroy(dry);
}

/* A low sun leaves joints dark that lie across it, a high one lights them; what
 * a joint sees of the sky is less, the deeper it is. */
static void joints_lie_in_shadow(void **state) {
  (void)state;
  double lit[3], sky[2];
  for (int deep = 0; deep < 2; deep++) {
    char text[160];
    snprintf(text, sizeof text,
             "layout=stack; stone_length=400; stone_width=200; joint_width=8; joint_depth=%d; "
             "edge_round=0; edge_drop=0",
             deep ? 12 : 1);
    sozai_texture *t = make("basalt", text);
    points p = {0};
    for (int k = 0; k < 3; k++) {
      double elevation = (k == 1 ? 80 : 20) * 0.01745329252;
      for (int i = 0; i < 400; i++) {
        unsigned j = points_add(&p, 40 + 0.7 * i, 200 * 3 + 0.5, 0, 0);
        p.light[k == 2 ? 0 : 1][j] = (float)cos(elevation);
        p.light[k == 2 ? 1 : 0][j] = 0;
        p.light[2][j] = (float)sin(elevation);
      }
    }
    points_ask(&p, t);
    for (int k = 0; k < 3; k++) {
      double sum = 0, all = 0;
      for (unsigned i = 400u * (unsigned)k; i < 400u * (unsigned)(k + 1); i++) {
        sum += at(&p, 4, i) / at(&p, 1, i) / (double)p.light[2][i] / 400;
        all += at(&p, S_OCCLUSION, i) / 400;
      }
      if (deep) lit[k] = sum;
      sky[deep] = all;
    }
    points_free(&p);
    textures->destroy(t);
  }
  CHECK(lit[0] < 0.2 && lit[1] > 0.5 && lit[2] > 0.5 && sky[1] < 0.5 && sky[0] > 0.7,
        "a joint 12 mm deep: %.2f of a sun at 20 degrees across it, %.2f at 80, %.2f at 20 along "
        "it; of the sky %.2f, and %.2f where it is 1 mm deep\n",
        lit[0], lit[1], lit[2], sky[1], sky[0]);
}

static void none_without_a_layout(void **state) {
  (void)state;
  sozai_texture *t = make("inada", "bevel=3; tilt=4");
  points p = {0};
  for (int i = 0; i < 200; i++) points_add(&p, 13 * i, 7 * i, 0, 0);
  points_ask(&p, t);
  double sum = 0;
  for (unsigned i = 0; i < p.count; i++) {
    for (int c = S_JOINT; c <= S_WET; c++) sum += fabs(at(&p, c, i));
  }
  CHECK(sum == 0, "layout = none: joint, stone_id, u, v, edge, moss and wet are 0\n");
  points_free(&p);
  textures->destroy(t);
}

static void refused(void **state) {
  (void)state;
  static const char *const bad[][3] = {
      {"layout=bricks", "layout", "chidori"},
      {"layout=stack; joint_width=300", "joint_width", "0 to 180"},
      {"layout=stack; bevel=300", "bevel", "0 to 198.5"},
      {"layout=stack; corner_radius=300", "corner_radius", "0 to 198.5"},
      {"layout=stack; edge_round=300", "edge_round", "0 to 198.5"},
      {"layout=stack; joint_wander=0.15; joint_divisions=4", "joint_wander", "0 to 0.075"},
      {"layout=herringbone; stone_length=50; stone_width=70", "stone_length", "70 to 1400"},
      {"moss=2", "moss", "1"},
      {"water_level=1e30", "water_level", "1000"}};
  for (unsigned i = 0; i < sizeof bad / sizeof *bad; i++) {
    const char *why = stone_refused(bad[i][0]);
    CHECK(why && strstr(why, bad[i][1]) && strstr(why, bad[i][2]), "%s: %s\n", bad[i][0],
          why ? why : "taken");
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(joints_are_as_wide),
      cmocka_unit_test(joints_wander),
      cmocka_unit_test(each_stone_is_its_own),
      cmocka_unit_test(no_visible_repeat),
      cmocka_unit_test(laid_stones_show_the_bed),
      cmocka_unit_test(normals_are_slopes),
      cmocka_unit_test(moss_levels),
      cmocka_unit_test(moss_and_water),
      cmocka_unit_test(joints_lie_in_shadow),
      cmocka_unit_test(none_without_a_layout),
      cmocka_unit_test(refused),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
