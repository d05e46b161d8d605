/* SPDX-License-Identifier: Apache-2.0
 *
 * Boards in layouts: how long they are and where they end, their bevels and
 * cupping, and what of it is refused. Through wood's channels.
 */
#include <math.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

/* Ends of neighbouring courses keep apart. */
static void strip_staggers(void **state) {
  (void)state;
  enum { N = 60000 };
  const double length = 1000, width = 90;
  sozai_texture *t = wood_make(NULL, "layout=strip; board_length=1000; board_width=90; "
                                     "board_length_variation=0.2; stagger=0.3; joint_width=1");
  double least = 1e9, shortest = 1e9, longest = 0, last[2000];
  int lasts = 0;
  for (int row = 0; row < 40; row++) {
    points p = {0};
    for (int i = 0; i < N; i++) points_add(&p, -(row + 0.5) * width, i - N / 2.0, 0, 0);
    points_ask(&p, t);
    double ends[2000];
    int n = 0;
    for (unsigned i = 1; i < p.count; i++) {
      if (p.out[BOARD_ID][i] != p.out[BOARD_ID][i - 1]) ends[n++] = i;
    }
    for (int i = 1; i < n; i++) {
      shortest = fmin(shortest, ends[i] - ends[i - 1]);
      longest = fmax(longest, ends[i] - ends[i - 1]);
    }
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < lasts; j++) least = fmin(least, fabs(ends[i] - last[j]));
    }
    memcpy(last, ends, sizeof last);
    lasts = n;
    points_free(&p);
  }
  CHECK(least >= (0.3 - 0.2) * length - 2 && shortest >= 0.8 * length - 2 &&
            longest <= 1.2 * length + 2 && longest > 1.1 * length && shortest < 0.9 * length,
        "strip: ends of neighbouring courses at least %.0f mm apart (100), lengths %.0f to %.0f mm "
        "(800 to 1200)\n",
        least, shortest, longest);
  textures->destroy(t);
}

/* The normal is the one given but on bevels, where it leans by their angle
 * away from the unit; heights follow the same profile. */
static void bevels(void **state) {
  (void)state;
  sozai_texture *t = wood_make(NULL, "layout=running; board_length=600; board_width=90; "
                                     "joint_width=1; bevel=2; bevel_angle=30; joint_depth=3");
  points p = {0};
  uniform_seed(81);
  for (int i = 0; i < 200000; i++) {
    points_add(&p, 1000 * (uniform() - 0.5), 1000 * (uniform() - 0.5), 0, 0);
  }
  points_ask(&p, t);
  double flat = 0, lean = 0, length = 0, height = 0;
  int on = 0;
  for (unsigned i = 0; i < p.count; i++) {
    double n[3], edge = points_value(&p, BOARD_EDGE, i), h = points_value(&p, HEIGHT, i);
    for (int c = 0; c < 3; c++) n[c] = points_value(&p, NORMAL + c, i);
    length = fmax(length, fabs(sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) - 1));
    double foot = -2 * tan(30 * 0.01745329252);
    if (edge > 2.02 || (edge < -0.02 && edge > -0.48)) {
      flat = fmax(flat, hypot(n[0], n[1]));
      height = fmax(height, fabs(h - (edge > 0 ? 0 : foot - 3)));
    }
    if (edge > 0.02 && edge < 1.98) {
      on++;
      lean = fmax(lean, fabs(acos(n[2]) / 0.01745329252 - 30));
      height = fmax(height, fabs(h - foot * (1 - edge / 2)));
    }
  }
  CHECK(on > 1000 && flat == 0 && lean < 0.05 && length < 1e-6 && height < 2e-3,
        "%d places on bevels lean by 30 degrees to %.3f, others by %.1g; unit to %.1g; heights to "
        "%.1g mm\n",
        on, lean, flat, length, height);
  points_free(&p);
  textures->destroy(t);
}

/* The normal leans as the height falls: bevels and cupping together. */
static void normals_are_slopes(void **state) {
  (void)state;
  static const char *const some[] = {"strip",   "herringbone", "versailles",
                                     "hexagon", "crazy",       "circles"};
  for (unsigned k = 0; k < 6; k++) {
    char text[256];
    snprintf(text, sizeof text,
             "layout=%s; joint_width=1; bevel=6; bevel_angle=20; cupping=1.5; "
             "layout_rotation=33",
             some[k]);
    sozai_texture *t = wood_make(NULL, text);
    points p = {0};
    uniform_seed(83);
    for (int i = 0; i < 20000; i++) {
      double x = 2000 * (uniform() - 0.5), y = 2000 * (uniform() - 0.5);
      points_add(&p, x, y, 0, 0);
      for (int c = 0; c < 4; c++) {
        points_add(&p, x + 0.25 * ((c == 0) - (c == 1)), y + 0.25 * ((c == 2) - (c == 3)), 0, 0);
      }
    }
    points_ask(&p, t);
    double square = 0, most = 0;
    int n = 0;
    for (unsigned i = 0; i < p.count; i += 5) {
      double edge = points_value(&p, BOARD_EDGE, i);
      int smooth = edge > 0.4 && fabs(edge - 6) > 0.4;
      /* not where two edges are as near */
      double ex = points_value(&p, BOARD_EDGE, i + 1) - points_value(&p, BOARD_EDGE, i + 2);
      double ey = points_value(&p, BOARD_EDGE, i + 3) - points_value(&p, BOARD_EDGE, i + 4);
      if (!smooth || hypot(ex, ey) < 0.4995) continue;
      double sx = (points_value(&p, HEIGHT, i + 1) - points_value(&p, HEIGHT, i + 2)) / 0.5;
      double sy = (points_value(&p, HEIGHT, i + 3) - points_value(&p, HEIGHT, i + 4)) / 0.5;
      double nz = points_value(&p, NORMAL + 2, i);
      double off =
          hypot(points_value(&p, NORMAL, i) / nz + sx, points_value(&p, NORMAL + 1, i) / nz + sy);
      square += off * off;
      most = fmax(most, off);
      n++;
    }
    double rms = sqrt(square / n);
    CHECK(n > 9000 && rms < 0.004 && most < 0.05,
          "%s: %d places, normal off the height's slope by %.4f RMS, %.4f at most\n", some[k], n,
          rms, most);
    points_free(&p);
    textures->destroy(t);
  }
}

/* Nothing of it without a layout. */
static void none(void **state) {
  (void)state;
  sozai_texture *t = wood_make(NULL, "bevel=2; cupping=1");
  points p = {0};
  for (int i = 0; i < 100; i++) points_add(&p, 13 * i, 7 * i, 0, 0);
  points_ask(&p, t);
  double sum = 0;
  for (unsigned i = 0; i < p.count; i++) {
    for (int c = BOARD_ID; c <= HEIGHT; c++) {
      sum += fabs(points_value(&p, c, i) - (c == NORMAL + 2 ? 1 : 0));
    }
  }
  CHECK(sum == 0, "layout = none: the channels are 0, the normal as given\n");
  points_free(&p);
  textures->destroy(t);
}

static void refused(void **state) {
  (void)state;
  /* parameters, and what the message has to name */
  static const char *const bad[][4] = {
      {"layout=parquet", "layout", "parquet", "herringbone"},
      {"layout=herringbone; board_length=50; board_width=70", "board_length", "50", "70 to 1400"},
      {"layout=versailles; board_length=500; board_width=90", "board_length", "500", "630"},
      {"layout=strip; joint_width=80", "joint_width", "80", "0 to 40.5"},
      {"layout=strip; bevel=60", "bevel", "60", "0 to 44.8"},
      {"layout=strip; boards_flat=0; boards_rift=0; boards_quarter=0", "boards_flat", "0", "1"},
      {"layout=chevron; chevron_angle=80", "chevron_angle", "80", "75"},
      {"layout=strip; stagger=0.7", "stagger", "0.7", "0.5"}};
  for (unsigned i = 0; i < sizeof bad / sizeof *bad; i++) {
    const char *why = wood_refused(bad[i][0]);
    CHECK(why && strstr(why, bad[i][1]) && strstr(why, bad[i][2]) && strstr(why, bad[i][3]),
          "%s: %s\n", bad[i][0], why ? why : "taken");
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(strip_staggers),
      cmocka_unit_test(bevels),
      cmocka_unit_test(normals_are_slopes),
      cmocka_unit_test(none),
      cmocka_unit_test(refused),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
